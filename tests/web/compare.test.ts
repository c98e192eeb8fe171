/** Comparisons over the real core, in workers that are none. */
import { beforeEach, describe, expect, test } from 'vitest';
import { Beside } from '../../web/src/compare/beside';
import { Comparer } from '../../web/src/compare/comparer';
import { tableCsv, tracesCsv } from '../../web/src/compare/csv';
import { canShow, type Comparison, newRun, type RunPlan, startLength } from '../../web/src/compare/run';
import { styleOf } from '../../web/src/comparison/results';
import { freshScene } from '../../web/src/document/defaults';
import type { View, ViewEvents } from '../../web/src/view/view';
import type { FrameData, OpenedNet } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';
import { FakeWorker } from './fake_worker';

const core = await load();
const recipe = 'vault:vertices=300';
const reference = core.openRecipe(recipe);
const handles = Array.from(reference.suggestedHandles, (vertex, i) => {
  const [x = NaN, y = NaN, z = NaN] = reference.restPositions.subarray(3 * vertex, 3 * vertex + 3);
  const isLast = i === reference.suggestedHandles.length - 1;
  return { vertex, target: [x, y, z - (isLast ? 1 : 0)] as [number, number, number], anchor: !isLast };
});
const scene = { ...freshScene({ recipe }), handles, options: { max_iterations: 60 } };
const plan = (method: string, change: Partial<RunPlan['scene']> = {}): RunPlan => ({
  label: method,
  style: 0,
  scene: { ...scene, method, ...change },
  threshold: 1e-6,
  net: null,
});
const plans = (...methods: string[]): RunPlan[] => methods.map((method) => plan(method));

let workers: FakeWorker[];
let seen: Comparison | null;
let comparer: Comparer;
let changed: (comparison: Comparison) => void;

beforeEach(() => {
  workers = [];
  seen = null;
  changed = () => {};
  const spawn = () => {
    const worker = new FakeWorker(core);
    workers.push(worker);
    return worker;
  };
  comparer = new Comparer(spawn, (comparison) => {
    seen = comparison;
    changed(comparison);
  });
});

const comparison = (): Comparison => seen ?? expect.fail('no news');
const states = () => comparison().runs.map(({ state }) => state);

test('each method starts alike and ends with numbers', async () => {
  await comparer.start(plans('li2022', 'arap', 'li2022'));
  expect(comparison().running).toBe(false);
  expect(states()).toEqual(['ended', 'ended', 'ended']);
  expect(workers.map(({ terminated }) => terminated)).toEqual([true]);
  const [first, other, again] = comparison().runs;
  expect(new Set(comparison().runs.map(({ startDeviation }) => startDeviation)).size).toBe(1);
  expect(again?.frame?.positions).toEqual(first?.frame?.positions);
  expect(other?.frame?.positions).not.toEqual(first?.frame?.positions);
  for (const { trace, frame, measures } of comparison().runs) {
    expect(trace.map(({ iteration }) => iteration)).toEqual(trace.map((_, i) => i + 1));
    expect(trace).toHaveLength(frame?.iterations ?? NaN);
    expect(measures).toMatchObject({ handleError: 0 });
  }
});

test('a net is as far from the first as its vertices are', async () => {
  const other = plan('li2022', { net: { recipe: 'dome:vertices=300' }, handles: 'suggested' });
  await comparer.start([...plans('li2022', 'arap'), other]);
  const [first, arap, dome] = comparison().runs;
  const [a, b] = [first!.frame!.positions, arap!.frame!.positions];
  const squares = a.reduce((sum, x, i) => sum + (x - b[i]!) ** 2, 0) / (a.length / 3);
  expect(first?.distance).toBe(0);
  expect(arap?.distance).toBeCloseTo(Math.sqrt(squares) / reference.info.meanLength, 12);
  expect(arap?.distance).toBeGreaterThan(0);
  expect(dome?.distance).toBeNull();
});

test('a run begins with the iterations of its initialisation', async () => {
  await comparer.start([plan('li2022'), plan('li2022', { initialisation: 'arap:5' })]);
  const [naive, arap] = comparison().runs;
  expect([naive, arap].map((run) => startLength(run!))).toEqual([0, 5]);
  expect(arap?.trace.map(({ iteration }) => iteration)).toEqual(arap?.trace.map((_, i) => i - 4));
  expect(arap?.frame?.iterations).toBe(arap!.trace.length - 5);
  expect(arap?.startDeviation).toBe(naive?.startDeviation);
});

test('a method that fails does not keep the others from running', async () => {
  await comparer.start(plans('magic', 'li2022'));
  expect(states()).toEqual(['failed', 'ended']);
  expect(comparison().runs[0]?.fault).toMatch(/magic/);
  expect(workers.map(({ terminated }) => terminated)).toEqual([true, true]);
});

test('a method that knows no soft handles says so; the others soften them', async () => {
  const soft = handles.map((handle) => (handle.anchor ? handle : { ...handle, weight: 1 }));
  await comparer.start(['li2022', 'projection', 'arap'].map((method) => plan(method, { handles: soft })));
  expect(states()).toEqual(['failed', 'ended', 'failed']);
  const [li, projection, arap] = comparison().runs;
  for (const run of [li, arap]) expect(run?.fault).toMatch(/handle \d+ is soft/);
  expect(projection?.frame?.status).toBe('converged');
});

describe('cancelled', () => {
  test('it stops at once and says no more', async () => {
    changed = ({ runs }) => {
      if (runs[1]?.frame) setTimeout(() => comparer.cancel());
    };
    await comparer.start(plans('li2022', 'arap', 'lbfgs'));
    expect(states()).toEqual(['ended', 'cancelled', 'cancelled']);
    expect(workers.map(({ terminated }) => terminated)).toEqual([true]);
    seen = null;
    await new Promise((done) => setTimeout(done, 50));
    expect(seen).toBeNull();
  });

  test('by the next one', async () => {
    const before = comparer.start(plans('arap'));
    await comparer.start(plans('li2022'));
    await before;
    expect(states()).toEqual(['ended']);
    expect(workers.map(({ terminated }) => terminated)).toEqual([true, true]);
  });
});

test('a run is shown in the place of the net it is of, also opened anew, and no other', () => {
  const net = { net: { recipe }, numbering: 2 };
  const run = { ...newRun({ ...plan('li2022'), net }), frame: {} as FrameData };
  expect(canShow(run, { ...net })).toBe(true);
  expect(canShow(run, { ...net, numbering: 1 })).toBe(false);
  expect(canShow(run, { ...net, net: { recipe: 'dome' } })).toBe(false);
  expect(canShow({ ...run, frame: null }, net)).toBe(false);
  expect(canShow({ ...run, net: null }, null)).toBe(false);
});

test('tables for other programs are whole', async () => {
  await comparer.start([
    plan('li2022', { initialisation: 'arap:2', options: { max_iterations: 60, p_end: 20 } }),
    ...plans('magic'),
  ]);
  const cells = (csv: string) =>
    csv
      .trim()
      .split('\n')
      .map((line) => line.split(','));
  const [header, li, magic] = cells(tableCsv(comparison()));
  const { frame, trace } = comparison().runs[0]!;
  expect(header).toHaveLength(12);
  expect(li?.slice(0, 5)).toEqual(['li2022', 'li2022', 'arap:2', 'max_iterations=60 p_end=20', 'converged']);
  expect(li?.slice(5, 8)).toEqual([frame?.iterations, frame?.milliseconds, frame?.maxDeviation].map(String));
  expect(magic).toEqual(['magic', 'magic', 'naive', 'max_iterations=60', 'failed', ...Array(7).fill('')]);

  const traces = cells(tracesCsv(comparison()));
  expect(new Set(traces.map(({ length }) => length))).toEqual(new Set([13]));
  expect(traces.slice(1).map(([run, iteration]) => [run, Number(iteration)])).toEqual(
    [-2, ...trace.map(({ iteration }) => iteration)].map((iteration) => ['li2022', iteration]),
  );
  expect(Number(traces.at(-1)?.[3])).toBe(trace.at(-1)?.maxDeviation);
});

test('a name with a comma is one cell', async () => {
  await comparer.start([{ ...plan('magic'), label: 'Li, "again"' }]);
  expect(tableCsv(comparison()).split('\n')[1]).toMatch(/^"Li, ""again""",magic,/);
});

test('no two methods are drawn alike', () => {
  const styles = core.methods().map((_, style) => styleOf({ style }));
  expect(new Set(styles.map(({ colour, line }) => `${colour} ${line}`)).size).toBe(styles.length);
});

test('views beside the other that fit their nets to another up axis are not taken for turned by hand', () => {
  type Camera = Parameters<ViewEvents['cameraMoved']>[0];
  const [own, fitted, byHand] = [1, 2, 3].map((at): Camera => ({ position: [at, 0, 0], target: [0, 0, 0] }));
  const moved: Camera[] = [];
  const cameras: Camera[] = [];
  let events!: ViewEvents;
  const view = {
    setAppearance: () => events.cameraMoved(fitted!),
    setCamera: (camera: Camera) => cameras.push(camera),
    setNet() {},
    setFrame() {},
    setHandles() {},
  };
  const create = (given: ViewEvents): View => {
    events = given;
    return view as unknown as View;
  };
  const beside = new Beside(create, (camera) => moved.push(camera));
  const look = freshScene({ recipe }).view;
  beside.show({} as OpenedNet, [{ handles: [] } as unknown as FrameData], look);
  beside.setAppearance(look, () => own!);
  expect(moved).toEqual([]);
  expect(cameras).toEqual([own]);
  events.cameraMoved(byHand!);
  expect(moved).toEqual([byHand]);
});

/** Comparisons over the real core, in workers that are none. */
import { beforeEach, describe, expect, test } from 'vitest';
import { Comparer } from '../../web/src/compare/comparer';
import { tableCsv, tracesCsv } from '../../web/src/compare/csv';
import type { Comparison } from '../../web/src/compare/run';
import { freshScene } from '../../web/src/document/defaults';
import type { WorkerLike } from '../../web/src/worker/client';
import type { Request, Response } from '../../web/src/worker/protocol';
import { Session } from '../../web/src/worker/session';
import { load } from '../wasm/load';

const core = await load();
const recipe = 'vault:vertices=300';
const reference = core.openRecipe(recipe);
const handles = Array.from(reference.suggestedHandles, (vertex, i) => {
  const [x = NaN, y = NaN, z = NaN] = reference.restPositions.subarray(3 * vertex, 3 * vertex + 3);
  const isLast = i === reference.suggestedHandles.length - 1;
  return { vertex, target: [x, y, z - (isLast ? 1 : 0)] as [number, number, number], anchor: !isLast };
});
const scene = { ...freshScene({ recipe }), handles, options: { max_iterations: 60 } };

class FakeWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  terminated = false;
  readonly #session = new Session(core, {
    post: (response) => this.#later(() => this.onmessage?.({ data: response } as MessageEvent<Response>)),
    soon: (task) => this.#later(task),
    now: () => performance.now(),
    wholeCore: () => Promise.resolve(core),
  });

  postMessage(request: Request): void {
    this.#later(() => this.#session.handle(request));
  }

  terminate(): void {
    this.terminated = true;
  }

  #later(task: () => void): void {
    setTimeout(() => this.terminated || task());
  }
}

let workers: FakeWorker[];
let seen: Comparison | null;
let comparer: Comparer;
let changed: (comparison: Comparison) => void;

beforeEach(() => {
  workers = [];
  seen = null;
  changed = () => {};
  const spawn = () => {
    const worker = new FakeWorker();
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
  await comparer.start(scene, 1e-6, ['li2022', 'arap', 'li2022']);
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

test('a method that fails does not keep the others from running', async () => {
  await comparer.start(scene, 1e-6, ['magic', 'li2022']);
  expect(states()).toEqual(['failed', 'ended']);
  expect(comparison().runs[0]?.fault).toMatch(/magic/);
  expect(workers.map(({ terminated }) => terminated)).toEqual([true, true]);
});

test('a method that knows no soft handles says so; the others soften them', async () => {
  const soft = handles.map((handle) => (handle.anchor ? handle : { ...handle, weight: 1 }));
  await comparer.start({ ...scene, handles: soft }, 1e-6, ['li2022', 'projection', 'arap']);
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
    await comparer.start(scene, 1e-6, ['li2022', 'arap', 'lbfgs']);
    expect(states()).toEqual(['ended', 'cancelled', 'cancelled']);
    expect(workers.map(({ terminated }) => terminated)).toEqual([true]);
    seen = null;
    await new Promise((done) => setTimeout(done, 50));
    expect(seen).toBeNull();
  });

  test('by the next one', async () => {
    const before = comparer.start(scene, 1e-6, ['arap']);
    await comparer.start(scene, 1e-6, ['li2022']);
    await before;
    expect(states()).toEqual(['ended']);
    expect(workers.map(({ terminated }) => terminated)).toEqual([true, true]);
  });
});

test('tables for other programs are whole', async () => {
  await comparer.start(scene, 1e-6, ['li2022', 'magic']);
  const cells = (csv: string) => csv.trim().split('\n').map((line) => line.split(','));
  const [header, li, magic] = cells(tableCsv(comparison()));
  const { frame, trace } = comparison().runs[0]!;
  expect(header).toHaveLength(8);
  expect(li?.slice(0, 5)).toEqual(['li2022', 'converged', ...[frame?.iterations, frame?.milliseconds, frame?.maxDeviation].map(String)]);
  expect(magic).toEqual(['magic', 'failed', '', '', '', '', '', '']);

  const traces = cells(tracesCsv(comparison()));
  expect(new Set(traces.map(({ length }) => length))).toEqual(new Set([13]));
  expect(traces.slice(1).map(([method, iteration]) => [method, Number(iteration)])).toEqual(
    [0, ...trace.map(({ iteration }) => iteration)].map((iteration) => ['li2022', iteration]),
  );
  expect(Number(traces.at(-1)?.[3])).toBe(trace.at(-1)?.maxDeviation);
});

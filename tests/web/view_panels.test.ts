import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { ShapeInfo, TraceRow } from '../../wasm/chebnet';
import { longestMove } from '../../web/src/document/longest_move';
import { withPoint } from '../../web/src/elements/number_input';
import type { HistoryView } from '../../web/src/document/undo';
import type { Choice } from '../../web/src/handles/commands';
import { Convergence } from '../../web/src/net/convergence';
import type { Panel } from '../../web/src/panels';
import { Narrator } from '../../web/src/sidebar/narrator';
import { PanelList } from '../../web/src/sidebar/panel_list';
import { SLIDER_STEPS, formatRecipe, fromSlider, parseRecipe, toSlider } from '../../web/src/sidebar/recipe';
import { edgeLayers, project } from '../../web/src/elements/thumbnail';
import { coordinate, milliseconds, small } from '../../web/src/language/numbers';
import { standing } from '../../web/src/sidebar/status';
import { StageNames } from '../../web/src/sidebar/stage_names';
import type { FrameData, OpenedNet } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';

const core = await load();

const parameter = (name: string, value: number, smallest: number, largest: number) => ({
  name,
  value,
  smallest,
  largest,
  sentence: '',
});
const VERTICES = parameter('vertices', 2000, 100, 100000);
const RISE = parameter('rise', 0.3, 0.02, 0.6);
const STEPS = parameter('steps', 4, 2, 10);
const VAULT: ShapeInfo = {
  name: 'vault',
  title: 'Vault',
  sentence: '',
  parameters: [VERTICES, RISE, STEPS],
  offered: 'vault',
};

describe('recipes', () => {
  test('are read', () => {
    expect(parseRecipe('dome')).toEqual({ name: 'dome', values: {} });
    expect(parseRecipe('vault: vertices=4000, rise=0.4')).toEqual({
      name: 'vault',
      values: { vertices: 4000, rise: 0.4 },
    });
  });
  test('are written without defaults', () => {
    expect(formatRecipe({ name: 'vault', values: { vertices: 2000, rise: 0.4 } }, VAULT)).toBe('vault:rise=0.4');
    expect(formatRecipe({ name: 'vault', values: {} }, VAULT)).toBe('vault');
  });
  test.each([VERTICES, RISE, STEPS])('the slider of $name reaches both ends and stays in range', (each) => {
    expect(fromSlider(each, 0)).toBe(each.smallest);
    expect(fromSlider(each, SLIDER_STEPS)).toBe(each.largest);
    for (let at = 0; at <= SLIDER_STEPS; at++) {
      const value = fromSlider(each, at);
      expect(value).toBeGreaterThanOrEqual(each.smallest);
      expect(value).toBeLessThanOrEqual(each.largest);
      expect(Math.abs(fromSlider(each, toSlider(each, value)) - value)).toBeLessThan(0.03 * value);
    }
  });
  test('counts stay whole, numbers of vertices round', () => {
    for (let at = 0; at <= SLIDER_STEPS; at++) {
      expect(fromSlider(STEPS, at) % 1).toBe(0);
      expect(Number(fromSlider(VERTICES, at).toPrecision(2))).toBe(fromSlider(VERTICES, at));
    }
  });
});

function rows(...solve: [stage: number, maxDeviation: number][]): TraceRow[] {
  return solve.map(([stage, maxDeviation], i) => {
    const zero = {
      p: 2,
      energy: 0,
      gradientNorm: 0,
      step: 1,
      freeVertices: 0,
      assemblyMs: 0,
      factorisationMs: 0,
      lineSearchMs: 0,
    };
    return { ...zero, iteration: i + 1, stage, maxDeviation, totalMs: 10 * (i + 1) };
  });
}

const named = (stage: number) => `stage ${stage}`;

describe('the record of convergence', () => {
  test('counts iterations and marks where stages begin', () => {
    const record = new Convergence();
    record.add(rows([1, 1e-1], [1, 1e-2], [2, 1e-4], [3, 1e-7]), named);
    expect(record.curve(false)).toEqual({
      x: [1, 2, 3, 4],
      y: [-1, -2, -4, -7],
      stageStarts: [
        { x: 1, stage: 'stage 1' },
        { x: 3, stage: 'stage 2' },
        { x: 4, stage: 'stage 3' },
      ],
    });
    expect(record.curve(true).x).toEqual([10, 20, 30, 40]);
  });
  test('puts solves one after another, a gap between', () => {
    const record = new Convergence();
    record.add(rows([1, 1e-1], [1, 1e-2]), named);
    record.add(rows([1, 1e-3]), named);
    expect(record.curve(false)).toMatchObject({ x: [1, 2, 2, 3], y: [-1, -2, null, -3] });
  });
  test('goes on with a solve that comes in pieces', () => {
    const record = new Convergence();
    const [first, second] = rows([1, 1e-1], [2, 1e-2]);
    record.add([first!], named);
    record.rest();
    record.add([second!], named);
    expect(record.curve(false).y).toEqual([-1, -2]);
  });
  test('at rest keeps the last solve, and then begins anew', () => {
    const record = new Convergence();
    record.add(rows([1, 1e-1]), named);
    record.add(rows([1, 1e-2], [2, 1e-3]), named);
    record.rest();
    expect(record.curve(false).y).toEqual([-2, -3]);
    record.add(rows([1, 1e-4]), named);
    expect(record.curve(false).y).toEqual([-4]);
  });
  test('rolls on by whole solves, but never cuts the last one', () => {
    const record = new Convergence();
    for (let k = 0; k < 30; k++) record.add(rows([1, 1e-1], [1, 1e-2], [1, 1e-3], [1, 1e-4]), named);
    expect(record.curve(false).x.length).toBeLessThan(100);
    expect(record.curve(false).y[0]).toBe(-1);
    record.add(rows(...Array.from({ length: 200 }, (): [number, number] => [1, 1e-5])), named);
    expect(record.curve(false).y).toHaveLength(200);
  });
  test('has no place for what is not finite', () => {
    const record = new Convergence();
    record.add(rows([1, Infinity], [1, 0]), named);
    expect(record.curve(false).y).toEqual([null, -16]);
  });
});

describe('thumbnails', () => {
  const net = {
    edges: Int32Array.from([0, 1, 2, 3]),
    positions: Float32Array.from([0, -9, 0, 1, -9, 0, 0, 9, 0, 1, 9, 4]),
  };
  test('fit their box', () => {
    const flat = project(net, 100, 60);
    for (let i = 0; i < flat.length; i += 2) {
      expect(flat[i]).toBeGreaterThanOrEqual(0);
      expect(flat[i]).toBeLessThanOrEqual(100);
      expect(flat[i + 1]).toBeGreaterThanOrEqual(0);
      expect(flat[i + 1]).toBeLessThanOrEqual(60);
    }
  });
  test('draw what is far first', () => {
    expect([...edgeLayers(net)]).toEqual([2, 0]);
  });
});

test('numbers are put in words', () => {
  expect([0, 1e-30, 4.23e-7, 0.68, 12, 291.93, Infinity].map(small)).toEqual([
    '0',
    '< 1e-16',
    '4.2e-7',
    '0.68',
    '12',
    '292',
    '∞',
  ]);
  // As the energy of what hangs.
  expect([-0.684, -4.23e-7, -1e-30].map(small)).toEqual(['-0.68', '-4.2e-7', '< 1e-16']);
  expect([0.04, 9.96, 152.4].map(milliseconds)).toEqual(['0.0', '10.0', '152']);
  expect([coordinate(1.23456789, 0.1), coordinate(-1234.5678, 30), coordinate(2, 1)]).toEqual([
    '1.23457',
    '-1234.568',
    '2',
  ]);
});

test('a comma is a decimal point, but for thousands', () => {
  expect(['0,5', '-,25', '1,250', '0,250', '1,5e-7', '1,250E+3', '3', '1e-3', 'x'].map(withPoint)).toEqual([
    '0.5',
    '-.25',
    '1,250',
    '0.250',
    '1.5e-7',
    '1.250E+3',
    '3',
    '1e-3',
    'x',
  ]);
});

test('a solve that has ended stands as it ended, one under way as its edges and its handles are', () => {
  const handle = { vertex: 1, target: [1, 0, 0] as [number, number, number], anchor: false };
  const frame = {
    status: 'running' as const,
    iterations: 1,
    maxDeviation: 0.1,
    holdsBack: false,
    positions: Float64Array.of(0, 0, 0, 1, 0, 0),
    handles: [handle],
  } satisfies Parameters<typeof standing>[0];
  expect(standing(frame, true)).toBe('running');
  expect(standing({ ...frame, maxDeviation: 1e-9 }, true)).toBe('settling');
  const away = [{ ...handle, target: [1, 0, 0.5] as [number, number, number] }];
  expect(standing({ ...frame, maxDeviation: 1e-9, handles: away }, true)).toBe('running');
  const soft = away.map((each) => ({ ...each, weight: 1 }));
  expect(standing({ ...frame, maxDeviation: 1e-9, handles: soft }, true)).toBe('settling');
  expect(standing(frame, false)).toBe('stopped');
  expect(standing({ ...frame, iterations: 0 }, false)).toBe('unsolved');
  expect(standing({ ...frame, status: 'exact' }, false)).toBe('exact');
  const beyond = { ...frame, maxDeviation: 1e-9, holdsBack: true };
  expect(standing(beyond, true)).toBe('held_back');
  expect(standing({ ...beyond, status: 'converged' }, false)).toBe('held_back');
});

test('a stage is called as the core calls it, by the method it is one of', () => {
  const names = new StageNames();
  names.setTables({ methods: core.methods() });
  expect(names.of('li2022', 2)).toBe('Large exponent');
  expect(names.of('projection', 2)).toBe('Springs');
  expect(names.of('equilibrium', 2)).toBe('To the handles');
  expect(names.of('equilibrium', 0)).toBe('Start');
});

test('the longest move is that of the vertex that went farthest', () => {
  expect(longestMove(Float64Array.of(0, 0, 0, 1, 1, 1), Float64Array.of(0, 0, 1, 4, 5, 1))).toBe(5);
});

describe('panels that come after the first', () => {
  const panel = (heard: string[]): Panel => ({
    element: null as never,
    setNet: () => heard.push('net'),
    setFrame: ({ maxDeviation }) => heard.push(`frame ${maxDeviation}`),
  });
  const net = {} as OpenedNet;
  const frame = (maxDeviation: number) => ({ maxDeviation }) as FrameData;

  test('are told the latest news', () => {
    const list = new PanelList([]);
    list.tell('setNet', net);
    list.tell('setFrame', frame(1), 60, true);
    list.tell('setFrame', frame(2), 60, false);
    const heard: string[] = [];
    list.join(panel(heard));
    list.tell('setFrame', frame(3), 60, false);
    expect(heard).toEqual(['net', 'frame 2', 'frame 3']);
  });
  test('are not told frames of the net before', () => {
    const list = new PanelList([]);
    list.tell('setNet', net);
    list.tell('setFrame', frame(1), 60, false);
    list.tell('setNet', net);
    const heard: string[] = [];
    list.join(panel(heard));
    expect(heard).toEqual(['net']);
  });
});

describe('screen readers', () => {
  const atRest = {
    status: 'converged',
    iterations: 1,
    maxDeviation: 0,
    holdsBack: false,
    handles: [] as FrameData['handles'],
  } as FrameData;
  const underWay = { ...atRest, status: 'running' } as FrameData;
  beforeEach(() => {
    vi.useFakeTimers();
    const element = () => ({ setAttribute: () => {}, append: () => {}, textContent: '' });
    vi.stubGlobal('document', { createElement: element });
  });
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.useRealTimers();
  });

  test('are told what came of a change once the solver has answered, not how the net was before', () => {
    let isChanging = false;
    const narrator = new Narrator(() => isChanging);
    const frameComes = (frame: FrameData): string | null => {
      narrator.onFrame(frame);
      narrator.setFrame(frame);
      return narrator.element.textContent;
    };
    const isDone = (revision: number): void => {
      const names = [['reset'], ['solve']] as HistoryView['names'];
      narrator.setHistory({ names, present: 1, revision } as HistoryView);
      vi.runAllTimers();
    };
    frameComes(atRest);
    isDone(1);
    isChanging = true;
    isDone(2);
    expect(narrator.element.textContent).toBe('');
    expect(frameComes({ ...underWay, maxDeviation: 0.1 })).toBe('');
    expect(frameComes(underWay)).toMatch(/\. Every edge keeps its length; settling\.$/);
    const whatIsHeard = narrator.element.textContent;
    expect(frameComes(underWay)).toBe(whatIsHeard);
    isChanging = false;
    const howItEnds = whatIsHeard!.replace('; settling', '');
    expect(frameComes(atRest)).toBe(howItEnds);
    isChanging = true;
    expect(frameComes(underWay)).toBe(howItEnds);
    // What needs no solve is told at once.
    isChanging = false;
    narrator.onFrame(atRest);
    isDone(3);
    expect(narrator.element.textContent).toMatch(/\. Every edge keeps its length\.$/);
  });

  test('hear of a selection once: from the narrator, unless the title counts it', () => {
    const narrator = new Narrator(() => false);
    narrator.setFrame(atRest);
    const said = (choice: Pick<Choice, 'selection' | 'selecting'>): string | null => {
      narrator.setHandles([], choice as Choice);
      vi.runAllTimers();
      return narrator.element.textContent;
    };
    said({ selection: [], selecting: false });
    expect(said({ selection: [1, 2], selecting: true })).toBe('');
    expect(said({ selection: [1, 2, 3], selecting: false })).toMatch(/^Selected: 3 handles/);
  });
});

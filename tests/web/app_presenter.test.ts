/** What view and panels are shown, and how often. */
import { beforeEach, expect, test, vi } from 'vitest';
import { Presenter } from '../../web/src/app/presenter';
import { State } from '../../web/src/app/state';
import type { NetOrigin, Run } from '../../web/src/compare/run';
import { defaultScene } from '../../web/src/document/defaults';
import type { HandleData } from '../../web/src/document/document';
import type { PanelEvents, Panels } from '../../web/src/panels';
import type { View, ViewEvents } from '../../web/src/view/view';
import type { Opened } from '../../web/src/worker/client';
import type { FrameData } from '../../web/src/worker/protocol';

type Call = [method: string, ...given: unknown[]];

let calls: Call[];
let state: State;
let presenter: Presenter;
let isSolving: boolean;

const named = (name: string) => calls.filter(([method]) => method === name);
const names = () => calls.map(([method]) => method);
/** When the task under way is over. */
const afterwards = () => Promise.resolve();
/** Has every method, and notes who calls it. */
const recorder = (): unknown =>
  new Proxy(
    {},
    {
      get:
        (_, method: string) =>
        (...given: unknown[]) =>
          void calls.push([method, ...given]),
    },
  );

function frameAt(x: number, change: Partial<FrameData> = {}): FrameData {
  const frame: Partial<FrameData> = {
    positions: Float64Array.of(x, 0, 0),
    handles: [{ vertex: 0, target: [x, 0, 0] }],
    unreachable: [],
    ...change,
  };
  return frame as FrameData;
}

const runAt = (x: number, net: NetOrigin = state.opening!.document) =>
  ({ label: 'run', net, frame: frameAt(x) }) as unknown as Run;

beforeEach(() => {
  calls = [];
  isSolving = true;
  state = new State(() => false, {
    document: () => {},
    presentation: () => presenter.schedule(),
    handles: () => presenter.presentHandles(),
  });
  presenter = new Presenter(
    {
      createView: () => recorder() as View,
      createBeside: () => recorder() as View,
      createPanels: () => recorder() as Panels,
    },
    {} as ViewEvents,
    {} as PanelEvents,
    {
      state,
      choice: () => ({ selection: [], selecting: false, mode: 'translate', onBoundary: false, lines: 0 }),
      solving: () => isSolving,
      guide: () => Promise.resolve(null),
    },
  );
  state.open(defaultScene(), { net: { numbering: 1 }, frame: frameAt(0) } as Opened);
  presenter.presentNet();
});

test('panels are there before the view fits a net to the room they leave', () => {
  expect(names().indexOf('setDocument')).toBeLessThan(names().indexOf('setNet'));
});

test('what changes in one task is presented once, after it', async () => {
  await afterwards();
  calls = [];
  state.history.record(state.snapshot()!, ['reset']);
  state.change({ method: 'li2022' });
  state.change({ locality: 3 });
  expect(calls).toEqual([]);
  await afterwards();
  expect(names().sort()).toEqual(['setDocument', 'setHandles', 'setHistory', 'setSymmetry']);
  expect(named('setDocument')[0]![1]).toMatchObject({ method: 'li2022', locality: 3 });
});

test('a drag is presented at once, and nothing else with it', async () => {
  await afterwards();
  calls = [];
  state.drag([{ vertex: 0, target: [1, 2, 3], anchor: false }]);
  presenter.presentHandles();
  expect(names()).toEqual(['setHandles', 'setHandles']);
  await afterwards();
  expect(calls).toHaveLength(2);
});

test('handles that slide are presented with each frame that moves them, and nothing else with them', async () => {
  state.change({ handles: [{ vertex: 0, target: [0, 0, 0], anchor: false, slides: 'xy' }] });
  await afterwards();
  calls = [];
  state.takeFrame(frameAt(1), false);
  await afterwards();
  expect(names()).toEqual(['setHandles', 'setHandles']);
  expect(state.handles[0]!.target).toEqual([1, 0, 0]);
  const { handles } = state;
  state.takeFrame(frameAt(1), true);
  await afterwards();
  expect(state.handles).toBe(handles);
  expect(calls).toHaveLength(2);
});

test('numbers of a net that goes on moving follow its picture, each frame once, and those of one at rest come at once', async () => {
  const pictures: (() => void)[] = [];
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => pictures.push(draw));
  // The view is told of the frame alone.
  const said = () =>
    calls.filter(([method, ...given]) => method === 'setFrame' && given.length > 1).map(([, frame]) => frame);
  const frames = [0, 1, 2, 3, 4].map((x) => frameAt(x));
  isSolving = true;
  calls = [];
  presenter.presentFrame(frames[0]!);
  expect(names()).toEqual(['setFrame']);
  pictures.shift()!();
  await vi.waitFor(() => expect(said()).toEqual(frames.slice(0, 1)));
  presenter.presentFrame(frames[1]!);
  presenter.presentFrame(frames[2]!);
  expect(said()).toEqual(frames.slice(0, 3));
  presenter.presentFrame(frames[3]!);
  isSolving = false;
  presenter.presentFrame(frames[4]!);
  expect(said()).toEqual(frames);
  for (const draw of pictures) draw();
  await new Promise((resume) => setTimeout(resume, 5));
  expect(said()).toEqual(frames);
  vi.unstubAllGlobals();
});

test('a run of a net that is not open any more is not shown', () => {
  calls = [];
  const other = { net: { recipe: 'dome' }, numbering: 1 };
  presenter.showRun(runAt(7, other));
  presenter.showBeside([runAt(7, other)]);
  expect(calls).toEqual([]);
});

test('undo brings back the net of a run, which is shown again', () => {
  const run = runAt(7);
  const scene = { ...state.opening!.document };
  state.open(defaultScene(), { net: { numbering: 1 }, frame: frameAt(0) } as Opened);
  presenter.showRun(run);
  expect(named('setRuns')).toEqual([]);
  state.open(scene, { net: { numbering: 1 }, frame: frameAt(0) } as Opened);
  presenter.showRun(run);
  expect(named('setRuns').at(-1)![1]).toBe(run);
});

test('a run has its net and handles shown until the own net moves', async () => {
  state.change({ handles: [{ vertex: 0, target: [0, 0, 0], anchor: true, name: 'foot' }] });
  presenter.showRun(runAt(7));
  await afterwards();
  expect((named('setFrame').at(-1)![1] as FrameData).positions[0]).toBe(7);
  const shown = named('setHandles').at(-1)![1] as HandleData[];
  expect(shown).toEqual([{ vertex: 0, target: [7, 0, 0], anchor: true, name: 'foot' }]);
  state.takeFrame(frameAt(1), false);
  isSolving = false;
  presenter.presentFrame(frameAt(1));
  expect(named('setRuns').at(-1)![1]).toBeNull();
  await afterwards();
  expect(named('setHandles').at(-1)![1]).toEqual([{ vertex: 0, target: [0, 0, 0], anchor: true, name: 'foot' }]);
});

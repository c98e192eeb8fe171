/** Opening nets and going through the history, with a solver that answers when a test says so. */
import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Opener, type OpenerClient } from '../../web/src/app/opener';
import { State } from '../../web/src/app/state';
import { defaultScene, usualMethod } from '../../web/src/document/defaults';
import type { CameraPlace, Scene } from '../../web/src/document/document';
import type { Project } from '../../web/src/document/project';
import type { Entry } from '../../web/src/document/undo';
import type { Opened } from '../../web/src/worker/client';
import { ROOT } from '../wasm/load';

interface Asked {
  recipe: string;
  answer(handles?: number): void;
  refuse(): void;
}

let asked: Asked[];
let told: string[];
let restored: number;
let isChanging: boolean;
let isReturning: boolean;
let state: State;
let opener: Opener;

const sceneOf = (recipe: string): Scene => ({ ...defaultScene(), net: { recipe } });
const recipeNow = () => (state.opening!.document.net as { recipe: string }).recipe;
const openedWith = (handles: number) =>
  ({
    net: { numbering: 1 },
    frame: {
      positions: new Float64Array(3),
      handles: Array.from({ length: handles }, (_, vertex) => ({ vertex, target: [0, 0, 0] })),
    },
  }) as unknown as Opened;

/** Opens a net and waits until it is there. */
async function open(recipe: string): Promise<void> {
  const opening = opener.openScene(sceneOf(recipe));
  asked.at(-1)!.answer();
  await opening;
}

beforeEach(() => {
  vi.useFakeTimers();
  [asked, told, restored] = [[], [], 0];
  const client: OpenerClient = {
    open: ({ net }) =>
      new Promise((resolve, reject) =>
        asked.push({
          recipe: (net as { recipe: string }).recipe,
          answer: (handles = 1) => resolve(openedWith(handles)),
          refuse: () => reject(new Error('refused')),
        }),
      ),
    cancelOpening: () => asked.at(-1)!.refuse(),
    restore: async () => void (restored += 1),
    get returning() {
      return isReturning;
    },
  };
  [isChanging, isReturning] = [false, false];
  state = new State(() => isChanging, { document: () => {}, presentation: () => {}, handles: () => {} });
  opener = new Opener(client, state, {
    leaving: () => told.push('leaving'),
    opened: () => told.push('opened'),
    say: () => told.push('said'),
    unsay: () => told.push('unsaid'),
    notice: (isShown, canCancel) =>
      told.push(isShown ? `notice, ${canCancel ? '' : 'not '}to be cancelled` : 'no notice'),
  });
});
afterEach(() => void vi.useRealTimers());

test('a net to which the history goes back is seen as it was left', async () => {
  const camera: CameraPlace = { position: [0, -5, 2], target: [0, 0, 0], aspect: 1.5 };
  const goTo = async (index: number) => {
    const going = opener.goTo(index);
    asked.at(-1)!.answer();
    await going;
    const { view } = state.opening!.document;
    return [recipeNow(), view.camera, view.behind];
  };
  await open('dome');
  state.change({ view: { ...state.opening!.document.view, camera } });
  await open('vault');
  state.change({ view: { ...state.opening!.document.view, behind: true } });
  await open('tube');
  expect(await goTo(1)).toEqual(['vault', null, true]);
  expect(await goTo(0)).toEqual(['dome', camera, undefined]);
  expect(await goTo(2)).toEqual(['tube', null, undefined]);
});

test('what is chosen of the view while a net opens holds for it; the rest is as its scene has it', async () => {
  await open('dome');
  const { view } = state.opening!.document;
  const camera: CameraPlace = { position: [0, -5, 2], target: [0, 0, 0], aspect: 1.5 };
  const scene = sceneOf('vault');
  const opening = opener.openScene({ ...scene, view: { ...scene.view, showFaces: !view.showFaces, rods: 2 } });
  state.change({ view: { ...view, field: 'angle', rods: 3, camera, behind: true } });
  asked.at(-1)!.answer();
  await opening;
  const expected = { ...scene.view, showFaces: !view.showFaces, field: 'angle', rods: 3 };
  expect(state.opening!.document.view).toEqual(expected);
});

test('of two nets that open at once the second does not take over the view that the first came with', async () => {
  await open('dome');
  const before = state.opening!.document.view;
  const scene = sceneOf('vault');
  const openings = [
    opener.openScene({ ...scene, view: { ...scene.view, colourMap: 'log', rods: 2 } }),
    opener.openScene({ ...sceneOf('tube'), view: { ...scene.view, rods: 1 } }),
  ];
  state.change({ view: { ...before, field: 'angle' } });
  asked.at(-2)!.answer();
  await openings[0];
  expect(state.opening!.document.view).toEqual({ ...scene.view, colourMap: 'log', rods: 2, field: 'angle' });
  state.change({ view: { ...state.opening!.document.view, behind: true, showFaces: !before.showFaces } });
  asked.at(-1)!.answer();
  await openings[1];
  const chosen = { field: 'angle', showFaces: !before.showFaces };
  expect(state.opening!.document.view).toEqual({ ...scene.view, rods: 1, ...chosen });
});

/** Another net, or the history, in which it is opened again. */
async function arriveBy(going: Promise<void>): Promise<'y' | 'z'> {
  asked.at(-1)!.answer();
  await going;
  return state.opening!.document.view.upAxis ?? 'z';
}

test('a net to which the history goes back lies as it lay, whatever axis is up in the one that is left', async () => {
  await open('dome');
  expect(await arriveBy(opener.openNet({ recipe: 'from a file' }, 'y'))).toBe('y');
  expect(await arriveBy(opener.goTo(0))).toBe('z');
  state.change({ view: { ...state.opening!.document.view, upAxis: 'y' } });
  expect(await arriveBy(opener.openNet({ recipe: 'vault' }))).toBe('z');
  expect(await arriveBy(opener.goTo(0))).toBe('y');
});

test('a project tells how the nets of its history lie; where one of before does not, they lie as the present one', async () => {
  await open('dome');
  await arriveBy(opener.openNet({ recipe: 'from a file' }, 'y'));
  await arriveBy(opener.openNet({ recipe: 'vault' }));
  await arriveBy(opener.goTo(1));
  const { view } = state.opening!.document;
  const entries = opener.entries(state.snapshot()!);
  expect(entries.map(({ upAxis }) => upAxis)).toEqual(['z', undefined, 'z']);
  const axesOf = async (stored: Entry[]) => {
    // As they come from a file, the nets are others.
    const project: Project = { entries: structuredClone(stored), present: 1, view };
    const axes = [await arriveBy(opener.openProject(project))];
    for (const index of [0, 2, 1]) axes.push(await arriveBy(opener.goTo(index)));
    return axes.join('');
  };
  expect(await axesOf(entries)).toBe('yzzy');
  expect(await axesOf(entries.map(({ name, state: each }) => ({ name, state: each })))).toBe('yyyy');
});

test('while undo opens another net the history stays where it is, and a project has each net in its place', async () => {
  for (const recipe of ['dome', 'vault']) await open(recipe);
  const going = opener.goTo(0);
  const { present } = state.history;
  const recipes = opener.entries(state.snapshot()!).map((entry) => (entry.state.net as { recipe: string }).recipe);
  expect([present, recipes]).toEqual([1, ['dome', 'vault']]);
  asked.at(-1)!.answer();
  await going;
  expect([recipeNow(), state.history.present]).toEqual(['dome', 0]);
});

test('a net that had settled is left as one that has, though the solver is at work on the next by then', async () => {
  for (const settled of [true, false]) {
    await open('dome');
    state.change({ settled });
    const opening = opener.openScene(sceneOf('vault'));
    isChanging = true;
    asked.at(-1)!.answer();
    await opening;
    isChanging = false;
    expect(state.history.stateAt(state.history.present - 1)!.settled).toBe(settled);
  }
});

test('a net has the method of the one before, but for the usual ones: large nets have another', async () => {
  const method = () => state.opening!.document.method;
  const openNext = async (recipe: string) => {
    const opening = opener.openNet({ recipe });
    asked.at(-1)!.answer();
    await opening;
    return method();
  };
  expect(await openNext('dome:vertices=2000')).toBe('equilibrium');
  expect(await openNext('vault:vertices=100000')).toBe('projection');
  expect(await openNext('vault:vertices=4000')).toBe('equilibrium');
  await open('dome');
  state.opening!.document.method = 'li2022';
  expect(await openNext('vault:vertices=100000')).toBe('li2022');
});

test('a net is large where the core has another method, too', () => {
  const core = readFileSync(new URL('core/solve/method.h', ROOT), 'utf8');
  const most = Number(/k_most_vertices_at_rest = ([\d']+);/.exec(core)![1]!.replaceAll("'", ''));
  expect(usualMethod({ recipe: `dome:vertices=${most}` })).toBe('equilibrium');
  expect(usualMethod({ recipe: `dome:vertices=${most + 1}` })).toBe('projection');
});

test('undo while a net is being opened takes back this net, and again the change before', async () => {
  for (const recipe of ['dome', 'vault']) await open(recipe);
  const answer = async () => {
    asked.at(-1)!.answer();
    await vi.runAllTimersAsync();
  };
  void opener.openScene(sceneOf('tube'));
  const undone = [opener.goBy(-1), opener.goBy(-1)];
  await answer();
  expect([asked.at(-1)!.recipe, recipeNow()]).toEqual(['vault', 'tube']);
  await answer();
  await answer();
  await Promise.all(undone);
  expect([recipeNow(), state.history.present]).toEqual(['dome', 0]);
});

test('undo while a net is being opened does nothing if that fails', async () => {
  for (const recipe of ['dome', 'vault']) await open(recipe);
  const opening = opener.openScene(sceneOf('tube'));
  void opener.goBy(-1);
  asked.at(-1)!.refuse();
  await expect(opening).rejects.toThrow('refused');
  await vi.runAllTimersAsync();
  expect([recipeNow(), state.history.present]).toEqual(['vault', 1]);
});

test('a net that is asked for while undo waits for another one is what is open in the end', async () => {
  for (const recipe of ['dome', 'vault']) await open(recipe);
  const answer = async () => {
    asked.at(-1)!.answer();
    await vi.runAllTimersAsync();
  };
  // The first step is on its way to the dome, the second waits for that.
  for (const _ of [1, 2]) void opener.goBy(-1);
  await vi.runAllTimersAsync();
  void opener.openScene(sceneOf('link'));
  asked.at(-2)!.answer();
  await answer();
  expect([recipeNow(), asked.length]).toEqual(['link', 4]);
  void opener.openScene(sceneOf('tube'));
  void opener.goBy(-1);
  const now = state.snapshot()!;
  const { view } = state.opening!.document;
  void opener.openProject({
    entries: [{ name: ['newNet'], state: { ...now, net: { recipe: 'project' } } }],
    present: 0,
    view,
  });
  asked.at(-2)!.answer();
  await answer();
  expect([recipeNow(), asked.length]).toEqual(['project', 6]);
});

test('the first net begins the history, another is an entry to go back from', async () => {
  await open('dome');
  expect(state.history.canUndo).toBe(false);
  await open('vault');
  expect([recipeNow(), state.history.present]).toEqual(['vault', 1]);
  const back = opener.goTo(0);
  asked.at(-1)!.answer();
  await back;
  expect([recipeNow(), state.history.present]).toEqual(['dome', 0]);
});

test('a net that cannot be opened leaves the present one as it was', async () => {
  await open('dome');
  told.length = 0;
  const opening = opener.openScene(sceneOf('cube'));
  asked.at(-1)!.refuse();
  await expect(opening).rejects.toThrow('refused');
  expect([recipeNow(), state.history.names.length, opener.isOpening]).toEqual(['dome', 1, false]);
  expect(told).toEqual(['no notice']);
});

test('an entry of the history that cannot be opened leaves the present one as it was', async () => {
  await open('dome');
  await open('vault');
  const back = opener.goTo(0);
  asked.at(-1)!.refuse();
  await expect(back).rejects.toThrow('refused');
  expect([recipeNow(), state.history.present]).toEqual(['vault', 1]);
  expect(restored).toBe(0);
});

test('what a net goes back to while another is being opened does not reach that one, and the solver of this one if it stays', async () => {
  await open('dome');
  const before = state.snapshot()!;
  const goBackWhileOpening = async (recipe: string, answer: (asked: Asked) => void) => {
    state.change({ handles: [] });
    const opening = opener.openScene(sceneOf(recipe)).catch(() => {});
    await opener.restore(before);
    expect([state.handles, restored]).toEqual([before.handles, 0]);
    answer(asked.at(-1)!);
    await opening;
    await vi.runAllTimersAsync();
  };
  isReturning = true;
  await goBackWhileOpening('cube', (each) => each.refuse());
  expect(restored).toBe(0);
  isReturning = false;
  await goBackWhileOpening('cube', (each) => each.refuse());
  expect(restored).toBe(1);
  restored = 0;
  await goBackWhileOpening('vault', (each) => each.answer(2));
  expect([recipeNow(), state.handles.length, restored]).toEqual(['vault', 2, 0]);
});

test('a net that takes long is announced, and given up only for one that is open', async () => {
  const first = opener.openScene(sceneOf('dome'));
  vi.advanceTimersByTime(1000);
  expect(told).toEqual(['notice, not to be cancelled']);
  opener.cancel();
  asked[0]!.answer();
  await first;
  told.length = 0;
  const second = opener.openScene(sceneOf('vault'));
  vi.advanceTimersByTime(1000);
  expect(told).toEqual(['notice, to be cancelled']);
  opener.cancel();
  await expect(second).rejects.toThrow('refused');
  expect(recipeNow()).toBe('dome');
});

test('while a net is on its way the history goes nowhere', async () => {
  await open('dome');
  await open('vault');
  const third = opener.openScene(sceneOf('cube'));
  await opener.goTo(0);
  expect(asked.map(({ recipe }) => recipe)).toEqual(['dome', 'vault', 'cube']);
  asked.at(-1)!.answer();
  await third;
  expect(recipeNow()).toBe('cube');
});

test('a net opened as it comes keeps method and view, and the user hears if it has nothing to drag', async () => {
  await open('dome');
  state.change({ method: 'li2022', view: { ...state.opening!.document.view, field: 'angle' } });
  const opening = opener.openNet({ recipe: 'cube' });
  asked.at(-1)!.answer(0);
  await opening;
  expect(state.opening!.document).toMatchObject({ method: 'li2022', view: { field: 'angle', camera: null } });
  expect(told.at(-1)).toBe('said');
});

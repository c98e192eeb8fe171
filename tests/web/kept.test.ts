/** What the browser keeps: of which net, under which name, and when it is written again; with its storage in a table here. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import { type Project, readProject } from '../../web/src/document/project';
import { UndoHistory } from '../../web/src/document/undo';
import { Autosave } from '../../web/src/projects/autosave';
import { read } from '../../web/src/projects/kept';
import { documentAt } from './nets';

type Store = (mode: string, doing: (objects: object) => unknown) => unknown;

/** What is stored, and the ids of what was written. */
const { table, written } = vi.hoisted(() => ({ table: new Map<string, unknown>(), written: [] as string[] }));

vi.mock('idb-keyval', () => ({
  createStore: (): Store => async (_, doing) => {
    const put = (value: unknown, key: string) => {
      table.set(key, value);
      written.push(key);
    };
    return doing({ put, delete: (key: string) => table.delete(key), transaction: { commit: () => {} } });
  },
  promisifyRequest: async () => {},
  get: async (key: string) => table.get(key),
  getMany: async (keys: string[]) => keys.map((key) => table.get(key)),
  update: async (key: string, change: (value: unknown) => unknown) => table.set(key, change(table.get(key))),
  delMany: async (keys: string[]) => keys.forEach((key) => table.delete(key)),
}));

/** The names of locks that tabs hold. */
let held: string[];
/** The tab is hidden, or seen again. */
let switchTab: () => void;
let history: UndoHistory;
let camera: number;
let change: () => void;
/** Nothing is under way. */
let isQuiet: boolean;
let autosave: Autosave;

const snapshot = () => documentAt(new Float64Array(3));

/** The view is made anew whenever it is asked for, as the app does. */
const project = (): Project => ({
  entries: history.entries(snapshot()),
  present: history.present,
  view: { ...snapshot().view, camera: { position: [camera, 0, 0], target: [0, 0, 0] } },
});

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout'] });
  table.clear();
  written.length = 0;
  held = [];
  camera = 1;
  isQuiet = true;
  vi.stubGlobal('navigator', {
    locks: { request: async () => {}, query: async () => ({ held: held.map((name) => ({ name })) }) },
  });
  const session = new Map<string, string>();
  vi.stubGlobal('sessionStorage', {
    getItem: (key: string) => session.get(key) ?? null,
    setItem: (key: string, value: string) => session.set(key, value),
  });
  vi.stubGlobal('location', { hash: '' });
  vi.stubGlobal('addEventListener', () => {});
  vi.stubGlobal('document', { addEventListener: (_: string, listener: () => void) => (switchTab = listener) });
  history = new UndoHistory();
  history.begin([{ name: ['newNet'], state: snapshot() }], 0);
  const app = {
    on: (_: string, listener: () => void) => (change = listener),
    history,
    project,
    opening: null,
    get isQuiet() {
      return isQuiet;
    },
  };
  autosave = new Autosave(app as unknown as App, () => expect.fail('it was refused'), true);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Some time later, when all has been written. */
async function later(): Promise<void> {
  await new Promise(setImmediate);
  await autosave.save();
}

async function record(name: ['move' | 'open', string], bytes = 0): Promise<void> {
  history.record(documentAt(new Float64Array(bytes / 8)), name);
  change();
  await later();
}

test('another net does not take the place of a project with a name, also where the history is full', async () => {
  autosave.begin('hall', true);
  await later();
  table.set('names', { hall: 'Hall' });
  for (let i = 0; i < 3; ++i) await record(['move', '7'], 60e6);
  expect([autosave.id, history.forgotten]).toEqual(['hall', 2]);
  await record(['open', 'dome'], 60e6);
  expect(history.forgotten).toBe(3);
  expect(autosave.id).not.toBe('hall');
});

const turnTo = async (place: number) => {
  camera = place;
  switchTab();
  await later();
};
/** Where the camera stands in what is opened again. */
const kept = async () => {
  const { project } = (await read('hall'))!;
  return readProject(project).view.camera?.position[0];
};

test('a tab that is only looked at writes nothing anew; one that is turned writes its view alone', async () => {
  autosave.begin('hall', true);
  await later();
  for (let i = 0; i < 3; ++i) {
    switchTab();
    await later();
  }
  expect(written).toEqual(['hall']);
  await turnTo(2);
  await turnTo(3);
  expect(written).toEqual(['hall', 'view hall', 'view hall']);
  expect(await kept()).toBe(3);

  camera = 4;
  await record(['move', '7']);
  expect(written.at(-1)).toBe('hall');
  expect([...table.keys()]).not.toContain('view hall');
  expect(await kept()).toBe(4);
});

test('a project that goes on after a reload is turned, too; one that is not kept yet waits for a change', async () => {
  autosave.begin('hall', true);
  await later();
  autosave.begin('hall', false);
  await later();
  await turnTo(2);
  expect(written).toEqual(['hall', 'view hall']);

  autosave.begin('copy', false);
  await later();
  await turnTo(3);
  expect(written).toEqual(['hall', 'view hall']);
  await record(['move', '7']);
  await turnTo(4);
  expect(written).toEqual(['hall', 'view hall', 'copy', 'view copy']);
  expect(await kept()).toBe(2);
});

test('of those without a name the oldest goes, with its picture, unless a tab has it open', async () => {
  const ids = ['six', 'five', 'four', 'three', 'two', 'one'];
  table.set('index', ids);
  for (const id of ids) table.set(id, {}).set(`look ${id}`, {});
  held = ['chebnet.one'];
  autosave.begin('seven', true);
  await later();
  autosave.begin('eight', true);
  await later();
  expect(table.get('index')).toEqual(['eight', 'seven', 'six', 'five', 'four', 'three', 'one']);
  expect([...table.keys()].filter((key) => key.endsWith('two'))).toEqual([]);
  expect([...table.keys()].filter((key) => key.endsWith('one'))).toEqual(['one', 'look one']);
});

test('what is changed again and again before it comes to rest is stored all the same, after some time', async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'Date'] });
  isQuiet = false;
  autosave.begin('hall', true);
  const frames = async (seconds: number) => {
    for (let frame = 0; frame < 10 * seconds; ++frame) {
      change();
      vi.advanceTimersByTime(100);
    }
    await new Promise(setImmediate);
  };
  await frames(15);
  expect(written).toEqual([]);
  await frames(10);
  expect(written).toEqual(['hall']);
  await frames(20);
  expect(written).toEqual(['hall', 'hall']);
});

/** What the browser keeps: of which net, under which name, and when it is written again; with its storage in a table here. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import type { Project } from '../../web/src/document/project';
import { UndoHistory } from '../../web/src/document/undo';
import { Autosave } from '../../web/src/projects/autosave';
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
    return doing({ put, transaction: { commit: () => {} } });
  },
  promisifyRequest: async () => {},
  get: async (key: string) => table.get(key),
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
  vi.stubGlobal('navigator', {
    locks: { request: async () => {}, query: async () => ({ held: held.map((name) => ({ name })) }) },
  });
  vi.stubGlobal('sessionStorage', { setItem: () => {} });
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
    isQuiet: true,
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

test('a tab that is only looked at writes nothing anew; one that is turned does', async () => {
  autosave.begin('hall', true);
  await later();
  for (let i = 0; i < 3; ++i) {
    switchTab();
    await later();
  }
  expect(written).toEqual(['hall']);
  camera = 2;
  switchTab();
  await later();
  expect(written).toEqual(['hall', 'hall']);
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

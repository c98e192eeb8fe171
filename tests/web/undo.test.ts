/** Undo and redo: whole gestures, exact states. */
import { expect, test } from 'vitest';
import { UndoHistory } from '../../web/src/document/undo';
import type { Entry, Snapshot } from '../../web/src/document/undo';
import { load } from '../wasm/load';
import { documentAt } from './nets';
import { openPage } from './page_without_pictures';

const NET = { recipe: 'vault' };

function state(x: number, positions = Float64Array.of(x, x, x)): Snapshot {
  const target: [number, number, number] = [x, x, x];
  return { ...documentAt(positions), net: NET, handles: [{ vertex: 0, target, anchor: false }] };
}

test('goes back and forth through the very same states', () => {
  const history = new UndoHistory();
  const states = [state(0), state(1), state(2)];
  history.record(states[0]!, 'move');
  history.record(states[1]!, 'move');
  expect(history.undo(states[2]!)).toBe(states[1]);
  expect(history.undo(states[1]!)).toBe(states[0]);
  expect(history.undo(states[0]!)).toBeNull();
  expect(history.redo(states[0]!)).toBe(states[1]);
  expect(history.redo(states[1]!)).toBe(states[2]);
  expect(history.redo(states[2]!)).toBeNull();
});

test('a gesture is one entry, whatever happens in it', () => {
  const history = new UndoHistory();
  const before = state(0);
  history.beginGesture(before);
  history.record(state(1), 'move');
  history.record(state(2), 'move');
  history.endGesture('drag');
  expect(history.undo(state(3))).toBe(before);
  expect(history.canUndo).toBe(false);
});

test('a gesture that moves nothing has the name of what else was changed meanwhile, unless that was refused', () => {
  const history = new UndoHistory();
  const before = state(0);
  history.beginGesture(before);
  history.record(state(1), 'method');
  expect(history.gestureHasChanges).toBe(true);
  history.endGesture(null);
  expect(history.names).toEqual(['', 'method']);
  const refused = state(2);
  history.beginGesture(state(1));
  history.record(refused, 'option');
  history.takeBack(refused);
  expect(history.gestureHasChanges).toBe(false);
  history.endGesture(null);
  expect(history.names).toEqual(['', 'method']);
  expect(history.undo(state(2))).toBe(before);
});

test('a gesture cannot be undone while it goes on', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move');
  history.beginGesture(state(1));
  expect(history.canUndo).toBe(false);
  expect(history.undo(state(2))).toBeNull();
  expect(history.redo(state(2))).toBeNull();
  history.endGesture('drag');
  expect(history.undo(state(3))?.positions?.[0]).toBe(1);
  expect(history.undo(state(1))?.positions?.[0]).toBe(0);
});

test('a gesture that changes nothing, or is cancelled, leaves no entry and keeps what could be redone', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move');
  history.undo(state(1));
  history.beginGesture(state(0));
  history.endGesture(null);
  const before = state(0);
  history.beginGesture(before);
  expect(history.cancelGesture()).toBe(before);
  expect(history.canUndo).toBe(false);
  expect(history.redo(state(0))?.positions?.[0]).toBe(1);
});

test('a new change forgets what could be redone', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move');
  history.undo(state(1));
  history.record(state(0), 'move');
  expect(history.canRedo).toBe(false);
  expect(history.redo(state(2))).toBeNull();
});

test('a change that failed is taken back with what it had put an end to; not where another came after it', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move');
  history.record(state(1), 'option');
  history.undo(state(2));
  const before = state(1);
  history.record(before, 'handles');
  expect(history.canRedo).toBe(false);
  history.takeBack(before);
  history.takeBack(before);
  expect(history).toMatchObject({ names: ['', 'move', 'option'], present: 1 });
  expect(history.redo(state(1))?.positions?.[0]).toBe(2);
  expect(history.undo(state(2))?.positions?.[0]).toBe(1);
  history.record(before, 'handles');
  history.record(state(3), 'reset');
  history.takeBack(before);
  expect(history.names).toEqual(['', 'move', 'handles', 'reset']);
});

test('changes of the same key join, until another comes between', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move', 'move 7');
  history.record(state(1), 'move', 'move 7');
  history.record(state(2), 'move');
  history.record(state(3), 'move', 'move 7');
  history.endGesture(null); // none was under way
  history.record(state(4), 'move', 'move 7');
  expect(history.undo(state(5))?.positions?.[0]).toBe(3);
  history.redo(state(3));
  history.record(state(5), 'move', 'move 7');
  expect([state(6), state(5), state(3), state(2)].map((now) => history.undo(now)?.positions?.[0])).toEqual([
    5, 3, 2, 0,
  ]);
});

test('a change that joined one before and then failed leaves that one its name, unless another came after it', () => {
  const history = new UndoHistory();
  history.record(state(0), 'limit 20', 'limit');
  const refused = state(1);
  history.record(refused, 'limit 500', 'limit');
  expect(history.takeBack(refused)).toBe(false);
  expect(history.names).toEqual(['', 'limit 20']);
  history.record(refused, 'limit 500', 'limit');
  history.record(state(2), 'limit 30', 'limit');
  history.takeBack(refused);
  expect(history.names).toEqual(['', 'limit 30']);
  const both = [state(2), state(3)];
  history.record(both[0]!, 'limit 500', 'limit');
  history.record(both[1]!, 'limit 600', 'limit');
  for (const each of both) history.takeBack(each);
  expect(history.names).toEqual(['', 'limit 30']);
  const left = state(3);
  history.record(left, 'limit 500', 'limit');
  history.undo(state(4));
  history.takeBack(left);
  expect(history.names).toEqual(['', 'limit 500']);
});

test('forgets the oldest states of large nets, never the last', () => {
  const history = new UndoHistory();
  for (let i = 0; i < 8; ++i) history.record(state(i, new Float64Array(2e6)), 'move');
  let undone = 0;
  while (history.undo(state(99))) ++undone;
  expect(undone).toBe(6);
  history.record(state(0, new Float64Array(30e6)), 'move');
  expect(history.canUndo).toBe(true);
});

test('thousands of handles take room, too; those that states share take it once', () => {
  const handles = Array.from({ length: 5000 }, (_, vertex) => ({ vertex, target: [0, 0, 0], anchor: false }));
  const forgottenOf = (handlesNow: () => object[]) => {
    const history = new UndoHistory();
    for (let i = 0; i < 200; ++i) history.record({ ...state(i), handles: handlesNow() } as Snapshot, 'move');
    return history.forgotten;
  };
  expect(forgottenOf(() => handles)).toBe(0);
  expect(forgottenOf(() => [...handles])).toBeGreaterThan(0);
});

test('has a name for each state, the first and those undone too', () => {
  const history = new UndoHistory();
  history.begin([{ name: 'open', state: state(0) }], 0);
  history.record(state(0), 'move 7', '7');
  history.record(state(1), 'move 7 again', '7');
  history.beginGesture(state(2));
  history.endGesture('drag');
  expect(history).toMatchObject({ names: ['open', 'move 7 again', 'drag'], present: 2, canRedo: false });
  history.undo(state(3));
  expect(history).toMatchObject({ names: ['open', 'move 7 again', 'drag'], present: 1, canUndo: true, canRedo: true });
  history.record(state(2), 'reset');
  expect(history).toMatchObject({ names: ['open', 'move 7 again', 'reset'], present: 2 });
});

test('goes to any entry at once, and what was left is as it was', () => {
  const history = new UndoHistory();
  const states = [0, 1, 2, 3, 4].map((x) => state(x));
  for (const each of states.slice(0, 4)) history.record(each, 'move');
  expect(history.goTo(1, states[4]!)).toBe(states[1]);
  expect(history.goTo(4, states[1]!)).toBe(states[4]);
  expect(history.goTo(0, states[4]!)).toBe(states[0]);
  expect([0, 5, -1].map((index) => history.goTo(index, states[0]!))).toEqual([null, null, null]);
  expect(history.entries(states[0]!).map((entry) => entry.state)).toEqual(states);
});

test('goes on where another left off', () => {
  const entries: Entry[] = [0, 1, 2].map((x) => ({ name: `to ${x}`, state: state(x) }));
  const history = new UndoHistory();
  history.begin(entries, 1);
  expect(history.undo(state(1))).toBe(entries[0]!.state);
  expect(history.goTo(2, state(0))).toBe(entries[2]!.state);
});

test('a long history stays quick', () => {
  const history = new UndoHistory();
  const shared = new Float64Array(3e5);
  for (let i = 0; i < 3000; ++i) history.record(state(i, shared), `move ${i}`);
  expect(history.names).toHaveLength(3001);
  expect(history.goTo(0, state(3000, shared))?.handles[0]?.target[0]).toBe(0);
});

test('a behaviour that is undone before the solver has taken it is not solved for afterwards', async () => {
  const { app, events, asked, solve } = await openPage(await load());
  await app.openNet({ recipe: 'dome:vertices=100' });
  await solve();
  const { method, initialisation } = app.opening!.document;
  events.setBehaviour({ method, initialisation, options: { length_scale: 1.1 } });
  events.undo();
  await solve();
  expect(asked.filter((type) => type !== 'seen').slice(-3)).toEqual(['options', 'solve', 'restore']);
  expect(app.opening!.document.options).toEqual({});
});

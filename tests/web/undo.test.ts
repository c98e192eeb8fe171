/** Undo and redo: whole gestures, exact states. */
import { expect, test } from 'vitest';
import { UndoHistory } from '../../web/src/document/undo';
import type { Snapshot } from '../../web/src/document/undo';

function state(x: number, positions = Float64Array.of(x, x, x)): Snapshot {
  const target: [number, number, number] = [x, x, x];
  return { net: { recipe: 'vault' }, handles: [{ vertex: 0, target, anchor: false }], positions, settled: true };
}

test('goes back and forth through the very same states', () => {
  const history = new UndoHistory();
  const states = [state(0), state(1), state(2)];
  history.record(states[0]!);
  history.record(states[1]!);
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
  history.record(state(1));
  history.record(state(2));
  history.endGesture(true);
  expect(history.undo(state(3))).toBe(before);
  expect(history.canUndo).toBe(false);
});

test('a gesture cannot be undone while it goes on', () => {
  const history = new UndoHistory();
  history.record(state(0));
  history.beginGesture(state(1));
  expect(history.canUndo).toBe(false);
  expect(history.undo(state(2))).toBeNull();
  expect(history.redo(state(2))).toBeNull();
  history.endGesture(true);
  expect(history.undo(state(3))?.positions[0]).toBe(1);
  expect(history.undo(state(1))?.positions[0]).toBe(0);
});

test('a gesture that changes nothing, or is cancelled, leaves no entry and keeps what could be redone', () => {
  const history = new UndoHistory();
  history.record(state(0));
  history.undo(state(1));
  history.beginGesture(state(0));
  history.endGesture(false);
  const before = state(0);
  history.beginGesture(before);
  expect(history.cancelGesture()).toBe(before);
  expect(history.canUndo).toBe(false);
  expect(history.redo(state(0))?.positions[0]).toBe(1);
});

test('a new change forgets what could be redone', () => {
  const history = new UndoHistory();
  history.record(state(0));
  history.undo(state(1));
  history.record(state(0));
  expect(history.canRedo).toBe(false);
  expect(history.redo(state(2))).toBeNull();
});

test('changes of the same key join, until another comes between', () => {
  const history = new UndoHistory();
  history.record(state(0), 'move 7');
  history.record(state(1), 'move 7');
  history.record(state(2));
  history.record(state(3), 'move 7');
  history.record(state(4), 'move 7');
  expect(history.undo(state(5))?.positions[0]).toBe(3);
  history.redo(state(3));
  history.record(state(5), 'move 7');
  expect([state(6), state(5), state(3), state(2)].map((now) => history.undo(now)?.positions[0])).toEqual([5, 3, 2, 0]);
});

test('forgets the oldest states of large nets, never the last', () => {
  const history = new UndoHistory();
  for (let i = 0; i < 8; ++i) history.record(state(i, new Float64Array(2e6)));
  let undone = 0;
  while (history.undo(state(99))) ++undone;
  expect(undone).toBe(6);
  history.record(state(0, new Float64Array(30e6)));
  expect(history.canUndo).toBe(true);
});

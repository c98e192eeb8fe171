/** The way back to the last good shape. */
import { expect, test } from 'vitest';
import { UndoHistory } from '../../web/src/document/undo';
import { GoodPlaces } from '../../web/src/overlay/good_places';
import { documentAt } from './nets';

/** A history of changes of a net, each noted as good or wrong. */
function historyOf(
  shapes: readonly ('good' | 'wrong')[],
  vertices: number,
): { history: UndoHistory; places: GoodPlaces } {
  const [history, places] = [new UndoHistory(), new GoodPlaces()];
  for (const shape of shapes) {
    const { view: _, ...state } = documentAt(new Float64Array(3 * vertices));
    history.record(state, ['reset']);
    places.note(history, shape === 'good');
  }
  return { history, places };
}

test('leads past the wrong ones, and nowhere where there is no other', () => {
  const { history, places } = historyOf(['good', 'wrong', 'wrong', 'wrong'], 1);
  expect([history.present, places.lastBefore(history)]).toEqual([4, 1]);
  const { names, inGesture } = history;
  places.note({ names, inGesture, present: 1, forgotten: 0 }, false);
  places.note({ names, inGesture, present: 0, forgotten: 0 }, false);
  expect(places.lastBefore(history)).toBeUndefined();
  places.clear();
  expect(places.lastBefore(history)).toBe(3);
});

test('what is done in place of a wrong one that was undone is not wrong before it was seen', () => {
  const { history, places } = historyOf(['good', 'wrong'], 1);
  const { view: _, ...state } = documentAt(new Float64Array(3));
  history.undo(state);
  history.record(state, ['reset']);
  // Before the net has come to rest.
  history.record(state, ['reset']);
  expect([history.present, places.lastBefore(history)]).toEqual([3, 2]);
});

test('what a hand still holds does not spoil the place from where it was taken', () => {
  const { history, places } = historyOf(['good', 'good'], 1);
  const { view: _, ...state } = documentAt(new Float64Array(3));
  history.beginGesture(state);
  places.note(history, false);
  history.endGesture(['reset']);
  places.note(history, false);
  expect([history.present, places.lastBefore(history)]).toEqual([3, 2]);
});

test('is the same when the history has forgotten what lies far back', () => {
  const { history, places } = historyOf(['good', 'good', 'good', 'good', 'good', 'good', 'wrong', 'wrong'], 7e5);
  expect(history.forgotten).toBeGreaterThan(0);
  expect(places.lastBefore(history)).toBe(history.present - 2);
});

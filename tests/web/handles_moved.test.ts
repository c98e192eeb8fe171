/** Which handle the view follows. */
import { expect, test } from 'vitest';
import type { HandleData } from '../../web/src/document/document';
import { movedBetween } from '../../web/src/handles/moved';

const handle = (x: number, z: number, rest: Partial<HandleData> = {}): HandleData => ({
  vertex: 7,
  target: [x, 0, z],
  anchor: false,
  ...rest,
});
const movedTo = (x: number, z: number, rest: Partial<HandleData> = {}) =>
  movedBetween([handle(0, 0, rest)], [handle(x, z, rest)]);

test('one that stands elsewhere has been moved, but not one that is new, locked or hidden', () => {
  expect(movedTo(1, 0)).toBe(7);
  expect(movedTo(0, 0)).toBeUndefined();
  expect(movedBetween([], [handle(1, 0)])).toBeUndefined();
  expect(movedTo(1, 0, { anchor: true })).toBeUndefined();
  expect(movedTo(1, 0, { hidden: true })).toBeUndefined();
});

test('one that slides goes with the net where it slides, and has been moved across that', () => {
  expect(movedTo(1, 0, { slides: 'xy' })).toBeUndefined();
  expect(movedTo(1, 1, { slides: 'xy' })).toBe(7);
});

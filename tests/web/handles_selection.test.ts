import { expect, test } from 'vitest';
import type { HandleData } from '../../web/src/document/document';
import { all, chosen, toggled, united, unlocked, within } from '../../web/src/handles/selection';

const handle = (vertex: number, rest: Partial<HandleData> = {}): HandleData => ({
  vertex,
  target: [0, 0, 0],
  anchor: false,
  ...rest,
});
const handles = [handle(3), handle(5, { anchor: true }), handle(8), handle(9, { hidden: true })];

test('a vertex goes in, and out again', () => {
  expect(toggled([3], 8)).toEqual([3, 8]);
  expect(toggled([3, 8], 3)).toEqual([8]);
});

test('more are added once each', () => {
  expect(united([8, 3], [3, 5])).toEqual([8, 3, 5]);
});

test('what is no handle any more drops out', () => {
  expect(within([3, 4, 8], handles)).toEqual([3, 8]);
});

test('those that may move come with the leading one first', () => {
  expect(unlocked([8, 5, 3], handles).map(({ vertex }) => vertex)).toEqual([3, 8]);
});

test('those selected come in the order of selection', () => {
  expect(chosen([8, 4, 3], handles).map(({ vertex }) => vertex)).toEqual([8, 3]);
});

test('hidden ones are not taken by "all"', () => {
  expect(all(handles)).toEqual([3, 5, 8]);
});

/** Ways through vertices, and where a net is to be changed. */
import { expect, test } from 'vitest';
import { placeOf } from '../../web/src/change/place';
import { wayThrough } from '../../web/src/handles/way';

/** Vertices i + 6 j of a grid, at these places. */
const [ACROSS, UP] = [6, 4];
const pairs: number[] = [];
for (let j = 0; j < UP; ++j)
  for (let i = 0; i < ACROSS; ++i) {
    if (i + 1 < ACROSS) pairs.push(i + ACROSS * j, i + 1 + ACROSS * j);
    if (j + 1 < UP) pairs.push(i + ACROSS * j, i + ACROSS * (j + 1));
  }
const none = { lineStart: Int32Array.of(0), lineVertices: new Int32Array() };
const grid = {
  edges: Int32Array.from(pairs),
  restPositions: Float64Array.from({ length: 3 * ACROSS * UP }, (_, k) =>
    k % 3 === 2 ? 0 : k % 3 === 1 ? Math.floor(Math.floor(k / 3) / ACROSS) : Math.floor(k / 3) % ACROSS,
  ),
  ...none,
  loopStart: none.lineStart,
  loopVertices: none.lineVertices,
};

test('the way through vertices is a shortest one, and as near to the straight line as edges allow', () => {
  expect(wayThrough(grid, [0, 4])).toEqual([0, 1, 2, 3, 4]);
  const steps = wayThrough(grid, [0, 21]);
  expect(steps).toHaveLength(7);
  const farthest = Math.max(...steps.map((v) => Math.abs((v % ACROSS) - Math.floor(v / ACROSS)) / Math.SQRT2));
  expect(farthest).toBeLessThan(0.8);
  expect(wayThrough(grid, [0, 2, 14])).toEqual([0, 1, 2, 8, 14]);
  expect(wayThrough(grid, [7])).toEqual([7]);
});

test('a vertex that no edge leads to is left out', () => {
  const apart = { ...grid, restPositions: Float64Array.of(...grid.restPositions, 9, 9, 9) };
  expect(wayThrough(apart, [0, ACROSS * UP, 2])).toEqual([0, 1, 2]);
});

test('its edges are those of the place, in no other number than it has steps', () => {
  const { edges } = placeOf(grid, [0, 21], 'through');
  expect(new Set(edges).size).toBe(6);
  const ends = (edges ?? []).flatMap((e) => [grid.edges[2 * e]!, grid.edges[2 * e + 1]!]);
  expect(new Set(ends)).toEqual(new Set(wayThrough(grid, [0, 21])));
});

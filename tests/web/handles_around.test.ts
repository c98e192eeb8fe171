/** What is around a vertex, along the net. */
import { expect, test } from 'vitest';
import { verticesAround } from '../../web/src/handles/around';
import { partAround } from '../../web/src/handles/part';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import { load } from '../wasm/load';
import { grid } from './nets';

const core = await load();
const [COLUMNS, ROWS] = [21, 15];
const flat = grid(COLUMNS, ROWS);
const net = describeNet(core.openMesh({ ...flat, positions: flat.restPositions }));
const MIDDLE = 7 * COLUMNS + 10;

/** Squared, from the middle. */
const away = (vertex: number) => ((vertex % COLUMNS) - 10) ** 2 + (Math.floor(vertex / COLUMNS) - 7) ** 2;
const ascending = (vertices: readonly number[]) => [...vertices].sort((a, b) => a - b);
const all = Array.from({ length: COLUMNS * ROWS }, (_, vertex) => vertex);

test.each([1, 2, 3])('within %d edges of a vertex of a flat net are those of the disc', (radius) => {
  expect(ascending(verticesAround(net, [MIDDLE], radius))).toEqual(
    all.filter((vertex) => away(vertex) <= radius ** 2 + 1e-9),
  );
});

test('farther away it lies within the disc, and has all of one 8 % smaller', () => {
  const found = new Set(verticesAround(net, [MIDDLE], 6));
  expect([...found].filter((vertex) => away(vertex) > 36)).toEqual([]);
  expect(all.filter((vertex) => away(vertex) <= (0.92 * 6) ** 2 && !found.has(vertex))).toEqual([]);
});

test('the origins come first; around several it is what is around any of them', () => {
  const [a, b] = [MIDDLE, MIDDLE + 5];
  const found = verticesAround(net, [a, b], 2);
  expect(found.slice(0, 2)).toEqual([a, b]);
  const both = new Set([...verticesAround(net, [a], 2), ...verticesAround(net, [b], 2)]);
  expect(ascending(found)).toEqual(ascending([...both]));
});

test('it goes along the net: what is near in space alone is not in it', () => {
  // Two squares with a slit between, joined at neither side.
  const faces = Int32Array.from([0, 1, 2, 3, 4, 5, 6, 7]);
  const square = (x: number) => [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0];
  const apart = describeNet(
    core.openMesh({
      positions: Float64Array.from([...square(0), ...square(1.01)]),
      faceStart: Int32Array.from([0, 4, 8]),
      faceVertices: faces,
    }),
  );
  expect(ascending(verticesAround(apart, [1], 10))).toEqual([0, 1, 2, 3]);
});

test('the part around several vertices is of whole faces, and reaches as far as the radius', () => {
  const { hidden, triangles } = partAround(net, [MIDDLE, MIDDLE + 1], 2);
  const shown = all.filter((vertex) => hidden[vertex] === 0);
  const faces = new Set(triangles);
  expect(ascending([...faces])).toEqual(shown);
  const column = (vertex: number) => (vertex % COLUMNS) - 10;
  const row = (vertex: number) => Math.floor(vertex / COLUMNS) - 7;
  expect([Math.min(...shown.map(column)), Math.max(...shown.map(column))]).toEqual([-2, 3]);
  expect([Math.min(...shown.map(row)), Math.max(...shown.map(row))]).toEqual([-2, 2]);
  // No half of a square: the other triangle of each diagonal is there, too.
  expect(triangles.length % 6).toBe(0);
});

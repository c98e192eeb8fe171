/** Boundary loops and net lines, on nets where they can be told by eye. */
import { describe, expect, test } from 'vitest';
import { Lines } from '../../web/src/handles/lines';
import { load } from '../wasm/load';
import { grid } from './nets';

const ascending = (vertices: readonly number[]) => [...vertices].sort((a, b) => a - b);

describe('on a grid of 4 by 3 vertices', () => {
  const lines = new Lines(grid(4, 3));

  test('the boundary loop goes once round, from neighbour to neighbour', () => {
    const loop = lines.boundary(4);
    expect(loop[0]).toBe(4);
    expect(ascending(loop)).toEqual([0, 1, 2, 3, 4, 7, 8, 9, 10, 11]);
    for (const [k, vertex] of loop.entries()) {
      const step = Math.abs(vertex - loop[(k + 1) % loop.length]!);
      expect([1, 4]).toContain(step);
    }
    expect(lines.boundary(5)).toEqual([]);
  });

  test('row and column cross at an inner vertex', () => {
    const found = lines.through(5).map(ascending);
    expect(found).toHaveLength(2);
    expect(found).toContainEqual([4, 5, 6, 7]);
    expect(found).toContainEqual([1, 5, 9]);
  });

  test('a line runs from end to end in order', () => {
    const row = lines.through(5).find((line) => line.length === 4)!;
    expect([row, [...row].reverse()]).toContainEqual([4, 5, 6, 7]);
  });

  test('the boundary is a line too, and ends at corners', () => {
    expect(lines.through(1).map(ascending)).toContainEqual([0, 1, 2, 3]);
    expect(lines.through(0).map(ascending)).toHaveLength(2);
  });
});

describe('on nets of the gallery', async () => {
  const core = await load();

  test('every boundary vertex lies on one loop, as many loops as the core counts', () => {
    for (const recipe of ['dome:vertices=300', 'tube:vertices=300', 'torus:vertices=300']) {
      const net = core.openRecipe(recipe);
      const lines = new Lines(net);
      const loops = new Set<string>();
      for (let vertex = 0; vertex < net.info.vertices; ++vertex) {
        const loop = lines.boundary(vertex);
        if (loop.length > 0) loops.add(ascending(loop).join());
      }
      expect(loops.size, recipe).toBe(net.info.boundaryLoops);
      net.dispose();
    }
  });

  test('lines of a torus are closed and go through no vertex twice', () => {
    const net = core.openRecipe('torus:vertices=300');
    const lines = new Lines(net);
    for (const line of lines.through(0)) {
      expect(line.length).toBeGreaterThan(3);
      expect(new Set(line).size).toBe(line.length);
      expect(line).toContain(0);
    }
    expect(lines.through(0)).toHaveLength(2);
    net.dispose();
  });

  test.each(core.shapes().map(({ name }) => name))('all lines of a %s together hold every edge once', (name) => {
    const net = core.openRecipe(name);
    const steps = new Lines(net).all().flatMap((line) => line.slice(1).map((b, k) => ascending([line[k]!, b]).join()));
    const edges = Array.from({ length: net.info.edges }, (_, e) => `${net.edges[2 * e]},${net.edges[2 * e + 1]}`);
    expect(steps.sort()).toEqual(edges.sort());
    net.dispose();
  });

  test('a closed line ends where it begins', () => {
    const net = core.openRecipe('torus:vertices=300');
    expect(new Lines(net).all().every((line) => line[0] === line.at(-1))).toBe(true);
    net.dispose();
  });

  test('lines end at a singular vertex, one for each of its edges', () => {
    const net = core.openRecipe('jack:vertices=600');
    const valence = new Map<number, number>();
    for (const vertex of net.edges) valence.set(vertex, (valence.get(vertex) ?? 0) + 1);
    const lines = new Lines(net);
    const singular = [...valence.keys()].find((vertex) => valence.get(vertex) === 3 && lines.boundary(vertex).length === 0)!;
    const found = lines.through(singular);
    expect(found).toHaveLength(3);
    for (const line of found) expect(line).toContain(singular);
    net.dispose();
  });
});

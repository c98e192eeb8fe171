/** Lines drawn over a net: where on it they run, the ways along its edges nearest to them, and what lies on their sides. */
import { OrthographicCamera } from 'three';
import { describe, expect, test } from 'vitest';
import { type DrawnLine, extended, waysAlong } from '../../web/src/change/drawn_line';
import { edgesAlong } from '../../web/src/change/place';
import { sidesOf, stayingWithout } from '../../web/src/change/sides';
import type { DrawnPoint } from '../../web/src/handles/way';
import { projectionOf } from '../../web/src/view/picking';
import { Space } from '../../web/src/view/space';
import { Stroke } from '../../web/src/view/stroke';
import { fanTriangles } from '../../web/src/worker/triangles';
import { grid } from './nets';

/** Vertex x + 9 y stands at x, y. */
const ACROSS = 9;
const net = grid(ACROSS, 7);
const at = (x: number, y: number): number => x + ACROSS * y;

type Point = readonly [number, number];

/** Points close to each other on the lines between these. */
function drawn(...corners: Point[]): DrawnPoint[] {
  const along = corners.slice(1).flatMap(([x, y], k) => {
    const [fromX, fromY] = corners[k]!;
    return Array.from(
      { length: 21 },
      (_, i): Point => [fromX + ((x - fromX) * i) / 20, fromY + ((y - fromY) * i) / 20],
    );
  });
  return along.map(([x, y]) => ({ at: [x, y, 0], vertex: at(Math.round(x), Math.round(y)) }));
}

const ways = (...line: DrawnLine): number[][] => waysAlong(net, net.restPositions, line, 1);
const cut = (...line: DrawnLine): number[] => edgesAlong(net, ...ways(...line));

describe('the way along edges', () => {
  test('goes straight where the line trembles by less than an edge', () => {
    const line = drawn([0, 3.4], [2, 2.7], [4, 3.3], [6, 2.8], [8, 3.2]);
    expect(ways(line)).toEqual([Array.from({ length: ACROSS }, (_, x) => at(x, 3))]);
  });

  test('turns where the line turns, and goes nothing there and back', () => {
    const [way] = ways(drawn([1, 0], [1, 5], [7, 5], [7, 1]));
    const xs = [1, 2, 3, 4, 5, 6, 7];
    const wanted = [0, 1, 2, 3, 4].map((y) => at(1, y));
    expect(way).toEqual([...wanted, ...xs.map((x) => at(x, 5)), ...[4, 3, 2, 1].map((y) => at(7, y))]);
  });

  test('keeps within an edge of a line that runs across the net', () => {
    const [way] = ways(drawn([0, 0.2], [8, 5.7]));
    expect([way!.at(0), way!.at(-1)]).toEqual([at(0, 0), at(8, 6)]);
    const far = way!.map((v) => Math.abs(5.5 * (v % ACROSS) - 8 * (Math.floor(v / ACROSS) - 0.2)) / Math.hypot(5.5, 8));
    expect(Math.max(...far)).toBeLessThan(1);
  });

  test('leads back to where it began if the line does, nearly', () => {
    const [way] = ways(drawn([2, 1], [6, 1], [6, 5], [2, 5], [2.2, 1.9]));
    expect(way).toHaveLength(17);
    expect(way!.at(-1)).toBe(way![0]);
    expect(new Set(way).size).toBe(16);
  });

  test('is none for less than an edge', () => {
    expect(ways(drawn([2, 1], [2.2, 1.1]))).toEqual([]);
    expect(ways()).toEqual([]);
  });
});

test('a stroke goes on from the end of a line, and begins another elsewhere', () => {
  const [first, next, other] = [drawn([0, 3], [4, 3]), drawn([4.2, 3.4], [8, 3]), drawn([0, 5], [8, 5])];
  expect(extended([first], [next], 1)).toEqual([[...first, ...next]]);
  expect(extended([first], [other], 1)).toEqual([other]);
  expect(extended([], [other], 1)).toEqual([other]);
});

describe('the sides of a line', () => {
  test('are those of a line from border to border, the larger first', () => {
    expect(sidesOf(net, cut(drawn([0, 2], [8, 2]))).map(({ length }) => length)).toEqual([32, 16]);
    const alike = sidesOf(net, cut(drawn([4, 0], [4, 6])));
    expect(alike.map(({ length }) => length)).toEqual([24, 24]);
    expect(alike[0]).toContain(0);
  });

  test('are inside and outside of one that is closed', () => {
    const [outside, inside] = sidesOf(net, cut(drawn([2, 2], [5, 2], [5, 4], [2, 4], [2, 2])));
    expect([outside!.length, inside!.length]).toEqual([42, 6]);
    const stays = stayingWithout(net, outside!);
    expect(stays.filter(Boolean)).toHaveLength(12);
    expect(stays[at(2, 2)]).toBe(1);
    expect(stays[at(1, 2)]).toBe(0);
  });

  test('are one where it ends within the net', () => {
    expect(sidesOf(net, cut(drawn([0, 3], [5, 3])))).toHaveLength(1);
  });
});

describe('a stroke over the picture', () => {
  /** Seen from above, 100 pixels an edge, with the vertex 0 at 100, 700. */
  const camera = new OrthographicCamera(-5, 5, 4, -4, 0.1, 100);
  camera.position.set(4, 3, 10);
  camera.lookAt(4, 3, 0);
  const projection = projectionOf(camera, 1000, 800);
  const space = Object.assign(new Space(net.restPositions), { centre: [0, 0, 0], scale: 1 });
  const points = Float32Array.from({ length: 4 * ACROSS * 7 }, (_, i) =>
    i % 4 === 3 ? 0 : net.restPositions[3 * Math.floor(i / 4) + (i % 4)]!,
  );
  const triangles = fanTriangles(net.faceStart, net.faceVertices);
  const none = { x: 0, y: 0, z: 0, w: 0 };
  const place = ([x, y]: Point) => ({ x: 100 + 100 * x, y: 700 - 100 * y });
  const stroke = (sheet: object, from: Point, ...to: Point[]): DrawnLine => {
    const data = { points, vertexCount: ACROSS * 7, space };
    const line = new Stroke({ data, triangles, projection, section: none, ...sheet }, place(from));
    for (const each of to) line.extend(place(each));
    return line.pieces;
  };

  test('begins and ends on the border that it crosses, however fast the hand is', () => {
    const [piece, ...others] = stroke({}, [-0.7, 2.6], [8.9, 3.4]);
    expect(others).toEqual([]);
    const [first, last] = [piece!.at(0)!, piece!.at(-1)!];
    expect(first.at[0]).toBeCloseTo(0, 2);
    expect(last.at[0]).toBeCloseTo(8, 2);
    expect([first.vertex, last.vertex]).toEqual([at(0, 3), at(8, 3)]);
  });

  test('comes in pieces where it leaves the net, and in none beside it', () => {
    const pieces = stroke({}, [1, 5], [1, 8], [3, 8], [3, 4]);
    expect(pieces.map((piece) => [piece.at(0)!.vertex, piece.at(-1)!.vertex])).toEqual([
      [at(1, 5), at(1, 6)],
      [at(3, 6), at(3, 4)],
    ]);
    expect(stroke({}, [-0.5, -0.5], [8, -0.5])).toEqual([]);
  });

  test('is on what is in front, and not on what is hidden or beyond the section', () => {
    const layers = Float32Array.of(...points, ...points.map((x, i) => (i % 4 === 2 ? 1 : x)));
    const both = { points: layers, vertexCount: 2 * ACROSS * 7, space };
    const sheet = { data: both, triangles: Uint32Array.of(...triangles, ...triangles.map((v) => v + ACROSS * 7)) };
    const vertexOn = (more: object) => stroke({ ...sheet, ...more }, [2.1, 2.1])[0]?.[0]?.vertex;
    expect(vertexOn({})).toBe(at(2, 2) + ACROSS * 7);
    expect(vertexOn({ section: { x: 0, y: 0, z: 1, w: 0.5 } })).toBe(at(2, 2));
    const hidden = layers.map((x, i) => (i % 4 === 3 ? 1 : x));
    expect(vertexOn({ data: { ...both, points: hidden } })).toBeUndefined();
  });
});

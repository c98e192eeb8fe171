/** Mirror images on a grid of 5 by 3 unit squares' vertices: columns 0 … 4, so x = 2 is the plane through the centre. */
import { describe, expect, test } from 'vitest';
import type { HandleData, Vec3 } from '../../web/src/document/document';
import { PointGrid } from '../../web/src/handles/point_grid';
import { Mirror, offsetOf } from '../../web/src/handles/symmetry';
import { grid } from './nets';
import { printedSeed, random } from './random';

const net = grid(5, 3);
const mirror = new Mirror({ axis: 'x', through: 'centre' }, net.restPositions, 1);
const handle = (vertex: number, anchor = false): HandleData => ({ vertex, target: [0, 0, 0], anchor });

test('the plane lies in the middle of the net, or at the origin', () => {
  expect(offsetOf({ axis: 'x', through: 'centre' }, net.restPositions)).toBe(2);
  expect(offsetOf({ axis: 'y', through: 'centre' }, net.restPositions)).toBe(1);
  expect(offsetOf({ axis: 'x', through: 'origin' }, net.restPositions)).toBe(0);
});

describe('partners', () => {
  test('are mirror images of each other, a vertex on the plane its own', () => {
    expect(mirror.partner(0)).toBe(4);
    expect(mirror.partner(4)).toBe(0);
    expect(mirror.partner(6)).toBe(8);
    expect(mirror.partner(7)).toBe(7);
    expect(mirror.both([0, 7])).toEqual([0, 7, 4]);
  });

  test('may lie half an edge beside the image, not more', () => {
    const shifted = (by: number) => net.restPositions.map((x, i) => (i === 12 ? x + by : x));
    const at = (by: number) =>
      new Mirror(
        { axis: 'x', through: 'origin' },
        shifted(by).map((x, i) => (i % 3 === 0 ? x - 2 : x)),
        1,
      );
    expect(at(0.4).partner(0)).toBe(4);
    expect(at(0.6).partner(0)).toBeNull();
  });

  test('are missing where the net has no other side', () => {
    expect(new Mirror({ axis: 'x', through: 'origin' }, net.restPositions, 1).partner(1)).toBeNull();
  });
});

test('the partner of a vertex is found among those near its mirror image alone, of however many', () => {
  const side = 80;
  let reads = 0;
  const counted = new Proxy(grid(side, side).restPositions, {
    get(positions, key) {
      reads += 1;
      const value: unknown = Reflect.get(positions, key);
      return typeof value === 'function' ? value.bind(positions) : value;
    },
  });
  const across = new Mirror({ axis: 'x', through: 'centre' }, counted, 1);
  const vertices = Array.from({ length: side ** 2 }, (_, vertex) => vertex);
  reads = 0;
  const partners = vertices.map((vertex) => across.partner(vertex));
  expect(reads).toBeLessThan(100 * side ** 2);
  expect(partners).toEqual(vertices.map((vertex) => vertex + side - 1 - 2 * (vertex % side)));
});

test.each([0, 1e9, 1e16])('the nearest of points is found wherever they are: %s from the origin', (far) => {
  const next = random(printedSeed('points'));
  const points = Float64Array.from({ length: 600 }, () => far + 5 * next());
  const near = new PointGrid(points, 0.5);
  for (let round = 0; round < 200; ++round) {
    const place: Vec3 = [far + 6 * next() - 0.5, far + 6 * next() - 0.5, far + 6 * next() - 0.5];
    const distances = Array.from({ length: 200 }, (_, i) =>
      Math.hypot(...place.map((x, axis) => x - points[3 * i + axis]!)),
    );
    const least = Math.min(...distances);
    expect(near.nearest(place)).toBe(least <= 0.5 ? distances.lastIndexOf(least) : null);
  }
});

describe('targets', () => {
  const moved = (targets: [number, Vec3][], handles: HandleData[]) =>
    mirror.mirrored(
      targets.map(([vertex, target]) => ({ vertex, target })),
      handles,
    );

  test('are mirrored for the partner, if it is a handle and not locked', () => {
    expect(moved([[0, [-1, 5, 2]]], [handle(0), handle(4)])).toEqual([
      { vertex: 0, target: [-1, 5, 2] },
      { vertex: 4, target: [5, 5, 2] },
    ]);
    expect(moved([[0, [-1, 5, 2]]], [handle(0), handle(4, true)])).toHaveLength(1);
    expect(moved([[0, [-1, 5, 2]]], [handle(0)])).toHaveLength(1);
  });

  test('of what rests on the plane stay on it', () => {
    expect(moved([[7, [2.7, 1, 3]]], [handle(7)])).toEqual([{ vertex: 7, target: [2, 1, 3] }]);
  });

  test('of two partners moved together follow the side of the first', () => {
    const both = [handle(0), handle(4), handle(5), handle(9)];
    const up: [number, Vec3][] = [
      [4, [5, 0, 0]],
      [0, [1, 0, 0]],
      [5, [1, 1, 0]],
      [9, [5, 1, 0]],
    ];
    expect(moved(up, both)).toEqual([
      { vertex: 4, target: [5, 0, 0] },
      { vertex: 0, target: [-1, 0, 0] },
      { vertex: 9, target: [5, 1, 0] },
      { vertex: 5, target: [-1, 1, 0] },
    ]);
  });

  test('of a partner that rests beside the image stay beside it by as much', () => {
    const rest = net.restPositions.map((x, i) => (i === 13 ? x + 0.25 : x));
    const beside = new Mirror({ axis: 'x', through: 'centre' }, rest, 1);
    const targets = beside.mirrored([{ vertex: 0, target: [0, 0, 1] }], [handle(0), handle(4)]);
    expect(targets[1]).toEqual({ vertex: 4, target: [4, 0.25, 1] });
  });
});

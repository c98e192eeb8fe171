import { expect, test } from 'vitest';
import type { Vec3 } from '../../web/src/document/document';
import { centreOf, transformed } from '../../web/src/handles/transform';

const corners: Vec3[] = [
  [1, 1, 5],
  [3, 1, 5],
  [3, 3, 5],
  [1, 3, 5],
];
const close = (points: Vec3[], expected: Vec3[]) =>
  points.forEach((point, i) => point.forEach((x, axis) => expect(x).toBeCloseTo(expected[i]![axis]!, 12)));

test('the centre is the mean', () => {
  expect(centreOf(corners)).toEqual([2, 2, 5]);
});

test('a move takes all along', () => {
  close(transformed(corners, { kind: 'move', by: [1, -2, 0.5] }), [
    [2, -1, 5.5],
    [4, -1, 5.5],
    [4, 1, 5.5],
    [2, 1, 5.5],
  ]);
});

test('a quarter turn about z goes anticlockwise about the centre', () => {
  close(transformed(corners, { kind: 'rotate', axis: 'z', degrees: 90 }), [
    [3, 1, 5],
    [3, 3, 5],
    [1, 3, 5],
    [1, 1, 5],
  ]);
});

test.each(['x', 'y', 'z'] as const)('four quarter turns about %s come back, and a turn keeps lengths', (axis) => {
  const turn = (points: Vec3[]) => transformed(points, { kind: 'rotate', axis, degrees: 90 });
  close(turn(turn(turn(turn(corners)))), corners);
  const [a, b] = transformed(corners, { kind: 'rotate', axis, degrees: 37 });
  expect(Math.hypot(...a!.map((x, i) => x - b![i]!))).toBeCloseTo(2, 12);
});

test('positive turns are right-handed: y to z about x, z to x about y', () => {
  const ends = (a: Vec3): Vec3[] => [a, a.map((x) => -x) as Vec3];
  close(transformed(ends([0, 1, 0]), { kind: 'rotate', axis: 'x', degrees: 90 }), ends([0, 0, 1]));
  close(transformed(ends([0, 0, 1]), { kind: 'rotate', axis: 'y', degrees: 90 }), ends([1, 0, 0]));
});

test('scaling leaves the centre and multiplies distances', () => {
  close(transformed(corners, { kind: 'scale', factor: 2 }), [
    [0, 0, 5],
    [4, 0, 5],
    [4, 4, 5],
    [0, 4, 5],
  ]);
});

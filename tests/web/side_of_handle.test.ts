/** From where a net is seen first, so that its free handle is not behind it. */
import { expect, test } from 'vitest';
import { sideOf } from '../../web/src/dialogs/side_of_handle';
import type { HandleSeed } from '../../web/src/document/document';

/** Two upright sheets of one quad each, the first in front of the second. */
const walls = {
  positions: Float64Array.from([-1, 1].flatMap((y) => [-1, y, -1, 1, y, -1, 1, y, 1, -1, y, 1])),
  faceStart: Int32Array.of(0, 4, 8),
  faceVertices: Int32Array.of(0, 1, 2, 3, 4, 5, 6, 7),
};
const handles = (free: number): HandleSeed[] => [
  { vertex: free, target: null, anchor: false },
  { vertex: 1, target: null, anchor: true },
];

test('of two walls the one with the free handle is in front', () => {
  expect(sideOf(walls, handles(0), 'z')).toEqual({ camera: null, behind: false });
  expect(sideOf(walls, handles(4), 'z')).toEqual({ camera: null, behind: true });
});

test('one that neither side shows is looked at from another, at the middle of the net', () => {
  // A hall whose front and back walls stand before a pole in its middle.
  const pole = [0, 0, -1, 0.01, 0, -1, 0.01, 0, -0.9, 0, 0, -0.9];
  const hall = {
    positions: Float64Array.from([...walls.positions.map((x, i) => (i % 3 === 2 ? 2 * x + 1 : x)), ...pole]),
    faceStart: Int32Array.of(0, 4, 8, 12),
    faceVertices: Int32Array.of(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),
  };
  const { camera } = sideOf(hall, handles(8), 'z');
  const { position, target } = camera!;
  expect(target).toEqual([0, 0, 1]);
  expect(Math.abs(position[0])).toBeGreaterThan(Math.abs(position[1]));
});

test('without a free handle it is seen as any other net', () => {
  expect(sideOf(walls, [{ vertex: 1, target: null, anchor: true }], 'z')).toEqual({ camera: null });
});

import type { Vec3 } from './document';

/** The place of a vertex, of positions with 3 numbers each; the origin if there is no such vertex. */
export function pointOf(positions: Float64Array, vertex: number): Vec3 {
  const [x = 0, y = 0, z = 0] = positions.subarray(3 * vertex, 3 * vertex + 3);
  return [x, y, z];
}

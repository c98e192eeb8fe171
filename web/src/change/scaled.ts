/** Points in another size. */

/** The mean of points, 3 numbers each. */
export function centreOf(positions: Float64Array): number[] {
  const centre = [0, 0, 0];
  positions.forEach((x, i) => (centre[i % 3]! += (3 * x) / positions.length));
  return centre;
}

/** Points, 3 numbers each, so many times as far from a centre. */
export function scaled(positions: Float64Array, factor: number, centre: readonly number[]): Float64Array {
  return positions.map((x, i) => centre[i % 3]! + factor * (x - centre[i % 3]!));
}

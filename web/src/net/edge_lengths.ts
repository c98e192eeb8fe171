/** Edge lengths at given positions, and their deviation. */

/** @param edges 2 vertices an edge. */
export function edgeLengths(positions: Float64Array, edges: Int32Array): Float64Array {
  return Float64Array.from({ length: edges.length / 2 }, (_, e) => edgeLength(positions, edges, e));
}

export function edgeLength(positions: Float64Array, edges: Int32Array, e: number): number {
  const [a, b] = [3 * (edges[2 * e] ?? NaN), 3 * (edges[2 * e + 1] ?? NaN)];
  const along = (axis: number): number => (positions[a + axis] ?? NaN) - (positions[b + axis] ?? NaN);
  return Math.hypot(along(0), along(1), along(2));
}

/** A net with smaller deviations has its lengths, however its solve ended: ε₃ of Li et al. 2022. */
export const KEPT_DEVIATION = 1e-6;

/** dL = r + 1/r - 2 of an edge with r = length / rest length, without cancellation; see core/net/measures.h. */
export function deviation(ratio: number): number {
  return (ratio - 1) * ((ratio - 1) / ratio);
}

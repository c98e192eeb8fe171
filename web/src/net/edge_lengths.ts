/** Edge lengths at given positions, and their deviation. */

/** @param edges 2 vertices an edge. */
export function edgeLengths(positions: Float64Array, edges: Int32Array): Float64Array {
  return Float64Array.from({ length: edges.length / 2 }, (_, e) => {
    const [a, b] = [3 * (edges[2 * e] ?? NaN), 3 * (edges[2 * e + 1] ?? NaN)];
    const along = (axis: number): number => (positions[a + axis] ?? NaN) - (positions[b + axis] ?? NaN);
    return Math.hypot(along(0), along(1), along(2));
  });
}

/** dL = r + 1/r - 2 of an edge with r = length / rest length, without cancellation; see core/net/measures.h. */
export function deviation(ratio: number): number {
  return (ratio - 1) * ((ratio - 1) / ratio);
}

export interface LengthSpread {
  smallest: number;
  mean: number;
  largest: number;
  /** Largest difference of a length from the mean, as a fraction of the mean. */
  largestDeviation: number;
}

export function spreadOf(lengths: Float64Array): LengthSpread {
  const mean = lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
  const smallest = lengths.reduce((least, length) => Math.min(least, length), Infinity);
  const largest = lengths.reduce((most, length) => Math.max(most, length), 0);
  return { smallest, mean, largest, largestDeviation: Math.max(mean - smallest, largest - mean) / mean };
}

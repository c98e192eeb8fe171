/** Edges longer than their rest length: those that Li et al. 2022 draw pink and count as ρ (figure 8). */

export interface Edges {
  /** 2 vertices an edge. */
  edges: Int32Array;
  restLengths: Float64Array;
}

/** Relative excess below which an edge counts as equal: it is rounding, dL would be 1e-16. */
const ROUNDING = 1e-8;

export interface Placed {
  /** 3 numbers a vertex. */
  positions: Float64Array;
  /** What rest lengths are multiplied by. */
  lengthScale: number;
}

export function isLonger({ edges, restLengths }: Edges, { positions, lengthScale }: Placed, edge: number): boolean {
  const [a, b] = [3 * edges[2 * edge]!, 3 * edges[2 * edge + 1]!];
  const [x, y, z] = [
    positions[a]! - positions[b]!,
    positions[a + 1]! - positions[b + 1]!,
    positions[a + 2]! - positions[b + 2]!,
  ];
  const bound = lengthScale * restLengths[edge]! * (1 + ROUNDING);
  return x * x + y * y + z * z > bound * bound;
}

/** The energy of an edge, and the edge that has most of it. */

interface Edges {
  /** 2 vertices an edge. */
  edges: Int32Array;
  restLengths: Float64Array;
}

interface Placed {
  /** 3 numbers a vertex. */
  positions: Float64Array;
  /** What rest lengths are multiplied by. */
  lengthScale: number;
  /** dL of each edge. */
  fields: { deviation: Float32Array };
}

/** r^p + r^-p, with r = length / rest length; 2 at its least. */
export function energy(r: number, p: number): number {
  return r ** p + r ** -p;
}

/** r of the edge with the largest deviation. */
export function worstRatio(
  { edges, restLengths }: Edges,
  { positions, lengthScale, fields: { deviation } }: Placed,
): number {
  const worst = deviation.reduce((worst, dL, e) => (dL > deviation[worst]! ? e : worst), 0);
  const [a, b] = [3 * edges[2 * worst]!, 3 * edges[2 * worst + 1]!];
  const along = (axis: number): number => positions[a + axis]! - positions[b + axis]!;
  return Math.hypot(along(0), along(1), along(2)) / (lengthScale * restLengths[worst]!);
}

/** The energy of an edge, and the edge that has most of it. */
import { edgeLength } from './edge_lengths';
import type { Edges, Placed } from './longer';

/** r^p + r^-p, with r = length / rest length; 2 at its least. */
export function energy(r: number, p: number): number {
  return r ** p + r ** -p;
}

/** r of the edge with the largest deviation. */
export function worstRatio(
  { edges, restLengths }: Edges,
  { positions, lengthScale, fields: { deviation } }: Placed & { fields: { deviation: Float32Array } },
): number {
  const worst = deviation.reduce((worst, dL, e) => (dL > deviation[worst]! ? e : worst), 0);
  return edgeLength(positions, edges, worst) / (lengthScale * restLengths[worst]!);
}

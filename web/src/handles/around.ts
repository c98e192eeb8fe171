/** Distances along the net. */
import type { OpenedNet } from '../worker/protocol';

/** Rounding must not decide whether a vertex is as far away as the radius. */
const ROUNDING = 1e-6;

/** How far a vertex is from the origin nearest to it, in the net's unit. */
export interface Away {
  distance: number;
  origin: number;
}

/** The vertices no farther than `radius` mean edge lengths from the nearest origin, at rest: origins first. */
export function verticesAround(net: OpenedNet, origins: readonly number[], radius: number): number[] {
  return [...distancesAround(net, origins, radius).keys()];
}

/**
 * Likewise, with how far they are. Ways go along edges
 * and straight across faces, so that what is around a vertex of a flat net of squares is an octagon, which comes within 8 % of a
 * disc; along edges alone it would be a square standing on a corner.
 */
export function distancesAround(net: OpenedNet, origins: readonly number[], radius: number): Map<number, Away> {
  const most = radius * net.info.meanLength * (1 + ROUNDING);
  const { faceStart, faceVertices, restPositions } = net;
  const faces = facesAtVertices(net);
  const found = new Map(origins.map((vertex): [number, Away] => [vertex, { distance: 0, origin: vertex }]));
  const waiting = [...origins];
  // Label correcting: a vertex waits again whenever a shorter way to it has been found. The loop sees what is added to it.
  for (const vertex of waiting)
    for (const face of faces.get(vertex) ?? [])
      for (let corner = faceStart[face]!; corner < faceStart[face + 1]!; corner++) {
        const next = faceVertices[corner]!;
        const { distance: before, origin } = found.get(vertex)!;
        const distance = before + apart(restPositions, vertex, next);
        if (distance > most || distance >= (found.get(next)?.distance ?? Infinity)) continue;
        found.set(next, { distance, origin });
        waiting.push(next);
      }
  return found;
}

const known = new WeakMap<OpenedNet, Map<number, number[]>>();

/** By vertex the faces it is a corner of. */
function facesAtVertices(net: OpenedNet): Map<number, number[]> {
  const before = known.get(net);
  if (before) return before;
  const faces = new Map<number, number[]>();
  const { faceStart, faceVertices } = net;
  for (let face = 0; face + 1 < faceStart.length; face++)
    for (const vertex of faceVertices.subarray(faceStart[face], faceStart[face + 1])) {
      const those = faces.get(vertex);
      if (those) those.push(face);
      else faces.set(vertex, [face]);
    }
  known.set(net, faces);
  return faces;
}

function apart(positions: Float64Array, a: number, b: number): number {
  return Math.hypot(
    positions[3 * a]! - positions[3 * b]!,
    positions[3 * a + 1]! - positions[3 * b + 1]!,
    positions[3 * a + 2]! - positions[3 * b + 2]!,
  );
}

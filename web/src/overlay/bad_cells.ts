/** The cells of a net that is not as it should be. */
import type { FrameData, OpenedNet } from '../worker/protocol';
import { deviation, edgeLength, KEPT_DEVIATION } from '../net/edge_lengths';
import { sharpQuads } from '../net/fold';

/** Edges are told apart from the worst one when their error is below this part of it. */
const PART_OF_WORST = 0.01;
/** In degrees: what is just at the limit keeps it. */
const ROUNDING = 0.1;

export interface BadCells {
  /** Faces with an edge that is off. */
  off: ReadonlySet<number>;
  /** Quads with a corner below the limit. */
  sharp: ReadonlySet<number>;
}

/** @param limit of corners, in degrees. */
export function badCells(net: OpenedNet, { positions, lengthScale }: FrameData, limit: number): BadCells {
  return {
    off: facesAt(net, edgesOff(net, positions, lengthScale)),
    sharp: sharpQuads(net, positions, limit - ROUNDING),
  };
}

function edgesOff({ edges, restLengths }: OpenedNet, positions: Float64Array, scale: number): Set<string> {
  const errors = restLengths.map((length, edge) => deviation(edgeLength(positions, edges, edge) / (length * scale)));
  const worst = errors.reduce((most, each) => Math.max(most, each), 0);
  const least = Math.max(KEPT_DEVIATION, PART_OF_WORST * worst);
  const off = new Set<string>();
  errors.forEach((error, edge) => {
    if (error > least) off.add(keyOf(edges[2 * edge]!, edges[2 * edge + 1]!));
  });
  return off;
}

function facesAt({ faceStart, faceVertices }: OpenedNet, edges: ReadonlySet<string>): Set<number> {
  const faces = new Set<number>();
  for (let face = 0; edges.size > 0 && face + 1 < faceStart.length; face++) {
    const corners = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    if (corners.some((vertex, i) => edges.has(keyOf(vertex, corners.at(i - 1)!)))) faces.add(face);
  }
  return faces;
}

function keyOf(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** How much a net is folded at its edges and curved at its vertices, from its faces. */
import type { Edges } from './longer';

export interface Faces extends Edges {
  /** Face f is `faceVertices[faceStart[f]] … faceVertices[faceStart[f + 1] - 1]`. */
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

const DEGREES = 180 / Math.PI;
/** In degrees: no smooth bend folds a net so at an edge. */
export const SHARP_FOLD = 60;

/** The angle between the two faces at each edge, degrees: 0 is flat, 180 folded back. Edges of one face have 0. */
export function writeFolds(folds: Float32Array, positions: Float64Array, net: Faces): void {
  const normals = faceNormals(positions, net);
  const pairs = facePairs(net);
  for (let edge = 0; edge < folds.length; edge++) {
    const b = pairs[2 * edge + 1]!;
    folds[edge] = b < 0 ? 0 : DEGREES * angleBetween(normals, 3 * pairs[2 * edge]!, normals, 3 * b);
  }
}

/** How many edges are folded more sharply than a net of smooth bends is. */
export function sharpFolds(net: Faces, positions: Float64Array): number {
  const folds = new Float32Array(net.edges.length / 2);
  writeFolds(folds, positions, net);
  return folds.reduce((sum, fold) => sum + Number(fold > SHARP_FOLD), 0);
}

/** At each inner vertex 360° less the angles of the faces there, by the number of vertices: the total curvature of a net that
 *  were everywhere so curved, in degrees, whatever the size of its edges. Above 0 as a dome, below 0 as a saddle. */
export function writeCurvatures(curvatures: Float32Array, positions: Float64Array, net: Faces): void {
  const { edges, faceStart, faceVertices } = net;
  const count = curvatures.length;
  const sides = new Float64Array(6);
  curvatures.fill(360 * count);
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const from = faceStart[face]!;
    const end = faceStart[face + 1]!;
    for (let at = from; at < end; at++) {
      const corner = faceVertices[at]!;
      const next = faceVertices[at + 1 < end ? at + 1 : from]!;
      const last = faceVertices[at > from ? at - 1 : end - 1]!;
      for (let k = 0; k < 3; k++) {
        sides[k] = positions[3 * next + k]! - positions[3 * corner + k]!;
        sides[3 + k] = positions[3 * last + k]! - positions[3 * corner + k]!;
      }
      curvatures[corner]! -= count * DEGREES * angleBetween(sides, 0, sides, 3);
    }
  }
  const pairs = facePairs(net);
  for (let edge = 0; 2 * edge < edges.length; edge++)
    if (pairs[2 * edge + 1]! < 0) curvatures[edges[2 * edge]!] = curvatures[edges[2 * edge + 1]!] = 0;
}

/** Of each face by Newell's sum, which needs no plane faces; not of unit length. */
function faceNormals(positions: Float64Array, { faceStart, faceVertices }: Faces): Float64Array {
  const normals = new Float64Array(3 * (faceStart.length - 1));
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const from = faceStart[face]!;
    const end = faceStart[face + 1]!;
    for (let at = from; at < end; at++) {
      const a = 3 * faceVertices[at]!;
      const b = 3 * faceVertices[at + 1 < end ? at + 1 : from]!;
      for (let k = 0; k < 3; k++) {
        const i = (k + 1) % 3;
        const j = (k + 2) % 3;
        normals[3 * face + k]! += (positions[a + i]! - positions[b + i]!) * (positions[a + j]! + positions[b + j]!);
      }
    }
  }
  return normals;
}

// Without arrays of three: it is called for every edge, or corner, of a net in the hand.
function angleBetween(u: Float64Array, i: number, v: Float64Array, j: number): number {
  const x = u[i + 1]! * v[j + 2]! - u[i + 2]! * v[j + 1]!;
  const y = u[i + 2]! * v[j]! - u[i]! * v[j + 2]!;
  const z = u[i]! * v[j + 1]! - u[i + 1]! * v[j]!;
  const along = u[i]! * v[j]! + u[i + 1]! * v[j + 1]! + u[i + 2]! * v[j + 2]!;
  return Math.atan2(Math.sqrt(x * x + y * y + z * z), along);
}

const known = new WeakMap<Int32Array, Int32Array>();

/** The two faces of each edge, −1 for one that is not there. */
export function facePairs({ edges, faceStart, faceVertices }: Faces): Int32Array {
  const before = known.get(faceVertices);
  if (before) return before;
  const pairs = new Int32Array(edges.length).fill(-1);
  const key = (a: number, b: number) => Math.min(a, b) * 2 ** 26 + Math.max(a, b);
  const edgeOf = new Map<number, number>();
  for (let edge = 0; 2 * edge < edges.length; edge++) edgeOf.set(key(edges[2 * edge]!, edges[2 * edge + 1]!), edge);
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const [from, end] = [faceStart[face]!, faceStart[face + 1]!];
    for (let at = from; at < end; at++) {
      const edge = edgeOf.get(key(faceVertices[at]!, faceVertices[at + 1 < end ? at + 1 : from]!))!;
      pairs[pairs[2 * edge]! < 0 ? 2 * edge : 2 * edge + 1] = face;
    }
  }
  known.set(faceVertices, pairs);
  return pairs;
}

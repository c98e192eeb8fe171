/** How much a net is folded at its edges, curved at its vertices and sheared in its corners, from its faces. */
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
    const [a, b] = [pairs[2 * edge]!, pairs[2 * edge + 1]!];
    folds[edge] = b < 0 ? 0 : DEGREES * angleBetween(normals, 3 * a, normals, 3 * b);
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
  const count = curvatures.length;
  curvatures.fill(360 * count);
  forEachCorner(net, positions, (angle, vertex) => (curvatures[vertex]! -= count * DEGREES * angle));
  const { edges } = net;
  const pairs = facePairs(net);
  for (let edge = 0; 2 * edge < edges.length; edge++)
    if (pairs[2 * edge + 1]! < 0) curvatures[edges[2 * edge]!] = curvatures[edges[2 * edge + 1]!] = 0;
}

/** The quads with a corner sharper than so many degrees. */
export function sharpQuads(net: Corners, positions: Float64Array, limit: number): Set<number> {
  const sharp = new Set<number>();
  forEachCorner(net, positions, (angle, _, face) => {
    const isQuad = net.faceStart[face + 1]! - net.faceStart[face]! === 4;
    if (isQuad && DEGREES * angle < limit) sharp.add(face);
  });
  return sharp;
}

type Corners = Pick<Faces, 'faceStart' | 'faceVertices'>;

/** @param take is given the angle at each corner, in radians. */
function forEachCorner(
  { faceStart, faceVertices }: Corners,
  positions: Float64Array,
  take: (angle: number, vertex: number, face: number) => void,
): void {
  const sides = new Float64Array(6);
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const [from, end] = [faceStart[face]!, faceStart[face + 1]!];
    for (let at = from; at < end; at++) {
      const corner = faceVertices[at]!;
      const [next, last] = [faceVertices[at + 1 < end ? at + 1 : from]!, faceVertices[at > from ? at - 1 : end - 1]!];
      for (let k = 0; k < 3; k++) {
        sides[k] = positions[3 * next + k]! - positions[3 * corner + k]!;
        sides[3 + k] = positions[3 * last + k]! - positions[3 * corner + k]!;
      }
      take(angleBetween(sides, 0, sides, 3), corner, face);
    }
  }
}

/** Of each face by Newell's sum, which needs no plane faces; not of unit length. */
function faceNormals(positions: Float64Array, { faceStart, faceVertices }: Faces): Float64Array {
  const normals = new Float64Array(3 * (faceStart.length - 1));
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const [from, end] = [faceStart[face]!, faceStart[face + 1]!];
    for (let at = from; at < end; at++) {
      const [a, b] = [3 * faceVertices[at]!, 3 * faceVertices[at + 1 < end ? at + 1 : from]!];
      for (let k = 0; k < 3; k++) {
        const [i, j] = [(k + 1) % 3, (k + 2) % 3];
        normals[3 * face + k]! += (positions[a + i]! - positions[b + i]!) * (positions[a + j]! + positions[b + j]!);
      }
    }
  }
  return normals;
}

function angleBetween(u: Float64Array, i: number, v: Float64Array, j: number): number {
  const [a, b, c, x, y, z] = [u[i]!, u[i + 1]!, u[i + 2]!, v[j]!, v[j + 1]!, v[j + 2]!];
  return Math.atan2(Math.hypot(b * z - c * y, c * x - a * z, a * y - b * x), a * x + b * y + c * z);
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

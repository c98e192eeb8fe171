/** At how many edges a net on a surface folds of itself: where the surface has an edge, a net that follows it has to. */
import type { Point, SurfacePlace } from '../../../wasm/chebnet';
import { type Faces, facePairs, writeFolds } from '../net/fold';
import { combined, cross, dot } from './seed';

/** Of the surface itself, which folds between two cells by so much less than the net does there: as in core/drape/tilt.h, degrees. */
const OF_ITSELF = 60;
/** Of an edge: how far around a point the plane of the surface is looked for. Its normals are those of its corners in between. */
const AROUND = 0.01;
const DEGREES = 180 / Math.PI;

type Nearest = (point: Point) => SurfacePlace;

export function ownFolds(net: Faces, positions: Float64Array, nearest: Nearest): number {
  const folds = new Float32Array(net.edges.length / 2);
  writeFolds(folds, positions, net);
  const pairs = facePairs(net);
  const known = new Map<number, Point>();
  const beneath = (face: number): Point => {
    const normal = known.get(face) ?? normalBeneath(net, positions, face, nearest);
    known.set(face, normal);
    return normal;
  };
  return folds.reduce((sum, fold, edge) => {
    if (fold <= OF_ITSELF) return sum;
    const ofSurface = DEGREES * angleBetween(beneath(pairs[2 * edge]!), beneath(pairs[2 * edge + 1]!));
    return sum + Number(fold - ofSurface > OF_ITSELF);
  }, 0);
}

/** Upright on the surface where it is nearest to the middle of a face; of any length. */
function normalBeneath(net: Faces, positions: Float64Array, face: number, nearest: Nearest): Point {
  const corners = [...net.faceVertices.subarray(net.faceStart[face], net.faceStart[face + 1])].map(
    (vertex): Point => [positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!],
  );
  const [first, second] = [corners[0]!, corners[1]!];
  const middle = corners.reduce((sum, corner) => combined(1, sum, 1 / corners.length, corner), [0, 0, 0] as Point);
  const { position, normal } = nearest(middle);
  const step = AROUND * Math.hypot(...combined(1, second, -1, first));
  const axis: Point = Math.abs(normal[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const along = cross(normal, axis);
  const across = cross(normal, along);
  // From one side to the other: at a border nothing lies beyond it.
  const between = (direction: Point): Point => {
    const [a, b] = [-step, step].map((by) => nearest(combined(1, position, by, direction)).position);
    return combined(1, b!, -1, a!);
  };
  const upright = cross(between(along), between(across));
  return dot(upright, normal) < 0 ? combined(-1, upright, 0, upright) : upright;
}

function angleBetween(a: Point, b: Point): number {
  return Math.atan2(Math.hypot(...cross(a, b)), dot(a, b));
}

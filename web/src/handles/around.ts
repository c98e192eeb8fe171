/** Distances along the net. */
import type { OpenedNet } from '../worker/protocol';
import { NearestFirst } from './nearest_first';

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
  const { start, faces, distances, nearest } = surroundingsIn(net);
  const reached: number[] = [];
  const waiting = new NearestFirst();
  const reach = (vertex: number, distance: number, origin: number): void => {
    if (distances[vertex] === Infinity) reached.push(vertex);
    distances[vertex] = distance;
    nearest[vertex] = origin;
    waiting.add(vertex, distance);
  };
  for (const vertex of origins) reach(vertex, 0, vertex);
  // By Dijkstra (1959). A vertex waits again whenever a shorter way to it has been found; the longer one leads nowhere.
  for (let next = waiting.take(); next !== undefined; next = waiting.take()) {
    const { item: vertex, distance: before } = next;
    if (before > distances[vertex]!) continue;
    for (const face of faces.subarray(start[vertex], start[vertex + 1]))
      for (let corner = faceStart[face]!; corner < faceStart[face + 1]!; corner++) {
        const other = faceVertices[corner]!;
        if (distances[other]! <= before) continue;
        const distance = before + apart(restPositions, vertex, other);
        if (distance <= most && distance < distances[other]!) reach(other, distance, nearest[vertex]!);
      }
  }
  const found = new Map<number, Away>();
  for (const vertex of reached) found.set(vertex, { distance: distances[vertex]!, origin: nearest[vertex]! });
  for (const vertex of reached) distances[vertex] = Infinity;
  return found;
}

/** What it takes to find what is around. Kept with the net, so that a small radius costs little in a large one. */
interface Surroundings {
  /** The faces that a vertex is a corner of are from its start up to that of the next. */
  start: Int32Array;
  faces: Int32Array;
  /** From the nearest origin: infinite before and after. */
  distances: Float64Array;
  nearest: Int32Array;
}

const known = new WeakMap<OpenedNet, Surroundings>();

function surroundingsIn(net: OpenedNet): Surroundings {
  const before = known.get(net);
  if (before) return before;
  const { vertices } = net.info;
  const distances = new Float64Array(vertices).fill(Infinity);
  const surroundings = { ...facesAtVertices(net), distances, nearest: new Int32Array(vertices) };
  known.set(net, surroundings);
  return surroundings;
}

function facesAtVertices({ info, faceStart, faceVertices }: OpenedNet): Pick<Surroundings, 'start' | 'faces'> {
  const start = new Int32Array(info.vertices + 1);
  for (const vertex of faceVertices) start[vertex + 1]! += 1;
  for (let vertex = 0; vertex < info.vertices; vertex++) start[vertex + 1]! += start[vertex]!;
  const faces = new Int32Array(faceVertices.length);
  const free = start.slice();
  for (let face = 0; face + 1 < faceStart.length; face++)
    for (const vertex of faceVertices.subarray(faceStart[face], faceStart[face + 1])) faces[free[vertex]!++] = face;
  return { start, faces };
}

function apart(positions: Float64Array, a: number, b: number): number {
  return Math.hypot(
    positions[3 * a]! - positions[3 * b]!,
    positions[3 * a + 1]! - positions[3 * b + 1]!,
    positions[3 * a + 2]! - positions[3 * b + 2]!,
  );
}

/** Ways along the edges of the net. */
import type { Vec3 } from '../document/document';
import { pointOf } from '../document/point_of';
import type { OpenedNet } from '../worker/protocol';
import type { Selection } from './selection';

type Edges = Pick<OpenedNet, 'edges' | 'restPositions'>;

/** A point drawn on the net, and the corner of its face that is nearest to it. */
export interface DrawnPoint {
  at: Vec3;
  vertex: number;
}

/** From the first vertex to the next, and so on, each time by as few edges as can be, and of these ways by the one that is
 *  nearest to the straight line. One that cannot be reached is left out. */
export function wayThrough(net: Edges, vertices: Selection): number[] {
  const neighbours = neighboursOf(net);
  const way = vertices.slice(0, 1);
  for (const next of vertices.slice(1)) way.push(...wayBetween(net.restPositions, neighbours, way.at(-1)!, next));
  return way;
}

/** Along the edges nearest to a line of drawn points: from its beginning to its end by as few edges as can be, or, where that
 *  strays from it, by way of the point that is left farthest aside, and so on (as Douglas and Peucker 1973 thin out a line).
 *  @param positions where the net stands. @param width how far it may stray. */
export function wayAlong(
  edges: Int32Array,
  positions: Float64Array,
  points: readonly DrawnPoint[],
  width: number,
): number[] {
  const neighbours = neighboursOf({ edges, restPositions: positions });
  const follow = (part: readonly DrawnPoint[]): number[] => {
    const [from, to] = [part[0]!.vertex, part.at(-1)!.vertex];
    const way = [from, ...wayBetween(positions, neighbours, from, to)];
    const aside = part.slice(1, -1).map(({ at }) => distanceFrom(positions, way, at));
    const most = Math.max(0, ...aside);
    if (most <= width) return way;
    const turn = 1 + aside.indexOf(most);
    return [...follow(part.slice(0, turn + 1)), ...follow(part.slice(turn))];
  };
  return withoutSpurs(follow(points));
}

function distanceFrom(positions: Float64Array, way: readonly number[], at: Vec3): number {
  const squares = way.map((vertex, k) =>
    squaredDistance(at, pointOf(positions, way[k - 1] ?? vertex), pointOf(positions, vertex)),
  );
  return Math.sqrt(Math.min(...squares));
}

/** Nothing is gone there and back. */
function withoutSpurs(way: readonly number[]): number[] {
  const kept: number[] = [];
  for (const vertex of way)
    if (kept.at(-2) === vertex) kept.pop();
    else if (kept.at(-1) !== vertex) kept.push(vertex);
  const isClosed = kept[0] === kept.at(-1);
  while (isClosed && kept.length > 3 && kept[1] === kept.at(-2)) kept.splice(0, kept.length, ...kept.slice(1, -1));
  return kept;
}

function neighboursOf({ edges, restPositions }: Edges): number[][] {
  const neighbours: number[][] = Array.from({ length: restPositions.length / 3 }, () => []);
  for (let i = 0; i < edges.length; i += 2) {
    neighbours[edges[i]!]!.push(edges[i + 1]!);
    neighbours[edges[i + 1]!]!.push(edges[i]!);
  }
  return neighbours;
}

/** Without the first of its vertices. */
function wayBetween(positions: Float64Array, neighbours: number[][], from: number, to: number): number[] {
  const [a, b] = [pointOf(positions, from), pointOf(positions, to)];
  // The sums of squared distances from the straight line, and where the best way comes from, by edges from the beginning.
  const reached = new Map([[from, { off: 0, before: from }]]);
  let front = [from];
  while (front.length > 0 && !reached.has(to)) {
    const found = new Map<number, { off: number; before: number }>();
    for (const before of front)
      for (const vertex of neighbours[before]!) {
        if (reached.has(vertex)) continue;
        const off = reached.get(before)!.off + squaredDistance(pointOf(positions, vertex), a, b);
        if (off < (found.get(vertex)?.off ?? Infinity)) found.set(vertex, { off, before });
      }
    found.forEach((step, vertex) => reached.set(vertex, step));
    front = [...found.keys()];
  }
  if (!reached.has(to)) return [];
  const way: number[] = [];
  for (let vertex = to; vertex !== from; vertex = reached.get(vertex)!.before) way.unshift(vertex);
  return way;
}

/** From the segment between a and b. */
function squaredDistance(x: Vec3, a: Vec3, b: Vec3): number {
  const along = b.map((value, k) => value - a[k]!);
  const offset = x.map((value, k) => value - a[k]!);
  const length = along.reduce((sum, value) => sum + value * value, 0);
  const part = along.reduce((sum, value, k) => sum + value * offset[k]!, 0) / (length || 1);
  const nearest = Math.min(1, Math.max(0, part));
  return offset.reduce((sum, value, k) => sum + (value - nearest * along[k]!) ** 2, 0);
}

/** Ways along the edges of the net. */
import type { OpenedNet } from '../worker/protocol';
import type { Selection } from './selection';

type Edges = Pick<OpenedNet, 'edges' | 'restPositions'>;

/** From the first vertex to the next, and so on, each time by as few edges as can be, and of these ways by the one that is
 *  nearest to the straight line. One that cannot be reached is left out. */
export function wayThrough(net: Edges, vertices: Selection): number[] {
  const neighbours = neighboursOf(net);
  const way = vertices.slice(0, 1);
  for (const next of vertices.slice(1)) way.push(...wayBetween(net.restPositions, neighbours, way.at(-1)!, next));
  return way;
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
  const point = (vertex: number): number[] => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  const [a, b] = [point(from), point(to)];
  // The sums of squared distances from the straight line, and where the best way comes from, by edges from the beginning.
  const reached = new Map([[from, { off: 0, before: from }]]);
  let front = [from];
  while (front.length > 0 && !reached.has(to)) {
    const found = new Map<number, { off: number; before: number }>();
    for (const before of front)
      for (const vertex of neighbours[before]!) {
        if (reached.has(vertex)) continue;
        const off = reached.get(before)!.off + squaredDistance(point(vertex), a, b);
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
function squaredDistance(x: number[], a: number[], b: number[]): number {
  const along = b.map((value, k) => value - a[k]!);
  const offset = x.map((value, k) => value - a[k]!);
  const length = along.reduce((sum, value) => sum + value * value, 0);
  const part = along.reduce((sum, value, k) => sum + value * offset[k]!, 0) / (length || 1);
  const nearest = Math.min(1, Math.max(0, part));
  return offset.reduce((sum, value, k) => sum + (value - nearest * along[k]!) ** 2, 0);
}

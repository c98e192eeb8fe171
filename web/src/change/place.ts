/** Where a net is to be changed, as the core wants to know it. */
import type { ChangePlace } from '../../../wasm/chebnet';
import type { LineName } from '../handles/commands';
import { listsOf } from '../handles/lines';
import type { Selection } from '../handles/selection';
import type { OpenedNet } from '../worker/protocol';

/** A line through the leading handle, a way through all that are chosen, or the edges between them. */
export type PlaceName = LineName | 'through' | 'between';

type Edges = Pick<OpenedNet, 'edges' | 'restPositions'>;
type Lines = Edges & Pick<OpenedNet, 'lineStart' | 'lineVertices' | 'loopStart' | 'loopVertices'>;

/** The vertices are those that are chosen. */
export function placeOf(net: Lines, chosen: Selection, name: PlaceName): ChangePlace {
  const leading = chosen.at(-1);
  if (leading === undefined) return {};
  return {
    vertices: chosen,
    edges:
      name === 'between'
        ? edgesBetween(net, chosen)
        : edgesAlong(net, name === 'through' ? wayThrough(net, chosen) : walkThrough(net, leading, name)),
  };
}

function edgesBetween({ edges }: Lines, chosen: Selection): number[] {
  const vertices = new Set(chosen);
  const found: number[] = [];
  for (let e = 0; 2 * e < edges.length; ++e)
    if (vertices.has(edges[2 * e]!) && vertices.has(edges[2 * e + 1]!)) found.push(e);
  return found;
}

/** From end to end; a closed one ends where it begins. */
function walkThrough(net: Lines, vertex: number, name: LineName): Int32Array {
  const [start, vertices] = name === 'boundary' ? [net.loopStart, net.loopVertices] : [net.lineStart, net.lineVertices];
  const through = listsOf({ start, vertices }).filter((list) => list.includes(vertex));
  const walk = through[name === 'boundary' ? 0 : name] ?? new Int32Array();
  return name === 'boundary' ? Int32Array.of(...walk, ...walk.subarray(0, 1)) : walk;
}

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

function edgesAlong({ edges }: Lines, walk: ArrayLike<number> & Iterable<number>): number[] {
  const ends = (a: number, b: number): string => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const walked = new Set(Array.from(walk, (vertex, k) => ends(walk[k - 1] ?? vertex, vertex)));
  const found: number[] = [];
  for (let e = 0; 2 * e < edges.length; ++e) if (walked.has(ends(edges[2 * e]!, edges[2 * e + 1]!))) found.push(e);
  return found;
}

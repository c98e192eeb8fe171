/** Where a net is to be changed, as the core wants to know it. */
import type { ChangePlace } from '../../../wasm/chebnet';
import type { LineName } from '../handles/commands';
import { listsOf } from '../handles/lines';
import type { Selection } from '../handles/selection';
import { wayThrough } from '../handles/way';
import type { OpenedNet } from '../worker/protocol';

/** A line through the leading handle, a way through all that are chosen, or the edges between them. */
export type PlaceName = LineName | 'through' | 'between';

/** By name, or drawn: ways along edges, each by its vertices. */
export type Place = PlaceName | readonly (readonly number[])[];

type Lines = Pick<OpenedNet, 'edges' | 'restPositions' | 'lineStart' | 'lineVertices' | 'loopStart' | 'loopVertices'>;

/** The vertices are those that are chosen. */
export function placeOf(net: Lines, chosen: Selection, name: Place): ChangePlace {
  if (typeof name === 'object') return { edges: edgesAlong(net, ...name) };
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

export function edgesAlong(
  { edges }: Pick<OpenedNet, 'edges'>,
  ...walks: readonly (ArrayLike<number> & Iterable<number>)[]
): number[] {
  const ends = (a: number, b: number): string => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const walked = new Set(walks.flatMap((walk) => Array.from(walk, (vertex, k) => ends(walk[k - 1] ?? vertex, vertex))));
  const found: number[] = [];
  for (let e = 0; 2 * e < edges.length; ++e) if (walked.has(ends(edges[2 * e]!, edges[2 * e + 1]!))) found.push(e);
  return found;
}

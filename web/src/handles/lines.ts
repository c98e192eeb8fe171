/** The lines of vertices that a net is made of, its boundary loops and its net lines, as the core lists them. */
import type { VertexLists } from '../../../wasm/chebnet';

export function listsOf({ start, vertices }: VertexLists): Int32Array[] {
  return Array.from(start.subarray(1), (end, k) => vertices.subarray(start[k], end));
}

/** Those through a vertex; what a closed or crossing line meets again is named once. */
export function listsThrough(vertex: number, lists: VertexLists): number[][] {
  const through = listsOf(lists).filter((list) => list.includes(vertex));
  return through.map((list) => [...new Set(list)]);
}

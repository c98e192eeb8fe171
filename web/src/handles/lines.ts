/** Boundary loops and net lines as the core lists them. */
import type { VertexLists } from '../../../wasm/chebnet';

export function listsOf({ start, vertices }: VertexLists): Int32Array[] {
  return Array.from(start.subarray(1), (end, k) => vertices.subarray(start[k], end));
}

/** The lines through a vertex, each with distinct vertices even if it is closed or crosses itself. */
export function listsThrough(vertex: number, lists: VertexLists): number[][] {
  const through = listsOf(lists).filter((list) => list.includes(vertex));
  return through.map((list) => [...new Set(list)]);
}

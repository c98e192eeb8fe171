/** Handles to begin with on a net from a seed: the seed to be dragged, the ends of its four arms to hold the net. */
import type { HandleSeed } from '../document/document';

/** @param places of each vertex the steps from the seed along both families. */
export function suggestedHandles(places: Int32Array): HandleSeed[] {
  const arms = [farthest(places, 0, 1), farthest(places, 0, -1), farthest(places, 1, 1), farthest(places, 1, -1)];
  const ends = [...new Set(arms.filter((vertex) => steps(places, vertex) > 0))];
  return [
    ...ends.map((vertex) => ({ vertex, target: null, anchor: true })),
    { vertex: vertexAt(places, 0, 0), target: null, anchor: false },
  ];
}

/** The last vertex of an arm without a gap before it. */
function farthest(places: Int32Array, family: 0 | 1, sign: 1 | -1): number {
  let last = vertexAt(places, 0, 0);
  for (let step = sign; ; step += sign) {
    const next = family === 0 ? vertexAt(places, step, 0) : vertexAt(places, 0, step);
    if (next < 0) return last;
    last = next;
  }
}

function steps(places: Int32Array, vertex: number): number {
  return Math.abs(places[2 * vertex]!) + Math.abs(places[2 * vertex + 1]!);
}

function vertexAt(places: Int32Array, i: number, j: number): number {
  for (let vertex = 0; vertex < places.length / 2; vertex++)
    if (places[2 * vertex] === i && places[2 * vertex + 1] === j) return vertex;
  return -1;
}

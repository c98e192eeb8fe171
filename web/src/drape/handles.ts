/** Handles to begin with on a net from a seed: the ends of its arms, the longest of which is to be dragged while the others
 *  hold the net. Not the seed: where the arms run straight it could not move at all. */
import type { HandleSeed } from '../document/document';

/** @param places of each vertex the steps from the seed along both families. */
export function suggestedHandles(places: Int32Array): HandleSeed[] {
  const arms = [endOfArm(places, 1, 0), endOfArm(places, 0, 1), endOfArm(places, -1, 0), endOfArm(places, 0, -1)];
  return arms
    .filter(({ steps }) => steps > 0)
    .sort((a, b) => a.steps - b.steps)
    .map(({ vertex }, i, { length }) => ({ vertex, target: null, anchor: i + 1 < length }));
}

/** The last vertex of an arm without a gap before it. */
function endOfArm(places: Int32Array, di: number, dj: number): { vertex: number; steps: number } {
  let vertex = vertexAt(places, 0, 0);
  for (let steps = 0; ; steps++) {
    const next = vertexAt(places, (steps + 1) * di, (steps + 1) * dj);
    if (next < 0) return { vertex, steps };
    vertex = next;
  }
}

function vertexAt(places: Int32Array, i: number, j: number): number {
  for (let vertex = 0; vertex < places.length / 2; vertex++)
    if (places[2 * vertex] === i && places[2 * vertex + 1] === j) return vertex;
  return -1;
}

/** A colour for each vertex, as the view shows the chosen field. */
import type { Field } from '../document/document';
import { lookupTable, positionOn } from '../view/colour_map';
import type { Scale } from '../view/colour_map';
import type { FrameData } from '../worker/protocol';

const DEGREES = 180 / Math.PI;

/** Red, green, blue of each vertex, 0…255. */
export function vertexColours(scale: Scale, field: Field, frame: FrameData, edges: Int32Array): Uint8Array {
  const values = field === 'angle' ? frame.cornerAngles.map((angle) => angle * DEGREES) : worstAtVertices(frame, edges);
  const table = lookupTable(scale);
  const colours = new Uint8Array(3 * values.length);
  values.forEach((value, vertex) => {
    const entry = 4 * Math.round((table.length / 4 - 1) * positionOn(scale, value));
    colours.set(table.subarray(entry, entry + 3), 3 * vertex);
  });
  return colours;
}

/** The largest deviation of the edges at each vertex. */
function worstAtVertices({ deviations, positions }: FrameData, edges: Int32Array): Float32Array {
  const worst = new Float32Array(positions.length / 3);
  edges.forEach((vertex, i) => {
    worst[vertex] = Math.max(worst[vertex]!, deviations[i >> 1]!);
  });
  return worst;
}

/** A colour for each vertex, as the view shows the chosen field. */
import type { Field } from '../document/document';
import { lookupTable, positionOn } from '../view/colour_map';
import type { Scale } from '../view/colour_map';
import { isLonger } from '../view/longer';
import type { FrameData, OpenedNet } from '../worker/protocol';

const DEGREES = 180 / Math.PI;

type Edges = Pick<OpenedNet, 'edges' | 'restLengths'>;

/** Red, green, blue of each vertex, 0…255. */
export function vertexColours(scale: Scale, field: Field, frame: FrameData, net: Edges): Uint8Array {
  const values = valuesOf(field, frame, net);
  const table = lookupTable(scale);
  const colours = new Uint8Array(3 * values.length);
  values.forEach((value, vertex) => {
    const entry = 4 * Math.round((table.length / 4 - 1) * positionOn(scale, value));
    colours.set(table.subarray(entry, entry + 3), 3 * vertex);
  });
  return colours;
}

function valuesOf(field: Field, frame: FrameData, net: Edges): Float32Array {
  if (field === 'angle') return frame.cornerAngles.map((angle) => angle * DEGREES);
  return field === 'longer' ? longerAtVertices(frame, net) : worstAtVertices(frame, net);
}

/** The part of the edges at each vertex that is longer than it is to be. */
function longerAtVertices({ positions }: FrameData, net: Edges): Float32Array {
  const [longer, all] = [new Float32Array(positions.length / 3), new Float32Array(positions.length / 3)];
  net.edges.forEach((vertex, i) => {
    all[vertex]! += 1;
    if (isLonger(net, positions, i >> 1)) longer[vertex]! += 1;
  });
  return longer.map((count, vertex) => count / Math.max(1, all[vertex]!));
}

/** The largest deviation of the edges at each vertex. */
function worstAtVertices({ deviations, positions }: FrameData, { edges }: Edges): Float32Array {
  const worst = new Float32Array(positions.length / 3);
  edges.forEach((vertex, i) => {
    worst[vertex] = Math.max(worst[vertex]!, deviations[i >> 1]!);
  });
  return worst;
}

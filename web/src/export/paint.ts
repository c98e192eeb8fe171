/** A colour for each vertex, as the view shows the chosen field. */
import { lookupTable, positionOn, type Scale } from '../fields/colour_map';
import { type ColourField, numbersOf, type Placed } from '../fields/fields';
import type { Faces } from '../net/fold';
import type { Edges } from '../net/longer';

/** Red, green, blue of each vertex, 0…255. */
export function vertexColours(scale: Scale, field: ColourField, placed: Placed, net: Faces): Uint8Array {
  const values = numbersAtVertices(field, placed, net);
  const table = lookupTable(scale);
  const colours = new Uint8Array(3 * values.length);
  values.forEach((value, vertex) => {
    const entry = 4 * Math.round((table.length / 4 - 1) * positionOn(scale, value));
    colours.set(table.subarray(entry, entry + 3), 3 * vertex);
  });
  return colours;
}

function numbersAtVertices(field: ColourField, placed: Placed, net: Faces): Float32Array {
  const numbers = numbersOf(field, placed, net);
  if (field.place === 'vertex') return numbers;
  const vertices = placed.positions.length / 3;
  return field.atVertex === 'mean'
    ? meanAtVertices(numbers, net, vertices)
    : farthestAtVertices(numbers, net, vertices);
}

function meanAtVertices(numbers: Float32Array, { edges }: Edges, vertices: number): Float32Array {
  const [sums, counts] = [new Float32Array(vertices), new Float32Array(vertices)];
  edges.forEach((vertex, i) => {
    sums[vertex]! += numbers[i >> 1]!;
    counts[vertex]! += 1;
  });
  return sums.map((sum, vertex) => sum / Math.max(1, counts[vertex]!));
}

function farthestAtVertices(numbers: Float32Array, { edges }: Edges, vertices: number): Float32Array {
  const farthest = new Float32Array(vertices);
  edges.forEach((vertex, i) => {
    if (Math.abs(numbers[i >> 1]!) > Math.abs(farthest[vertex]!)) farthest[vertex] = numbers[i >> 1]!;
  });
  return farthest;
}

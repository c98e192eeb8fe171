/**
 * Positions in few bytes, for links. What is kept is how far each vertex stands from rest, as integers of a small step;
 * each is predicted from vertices that came before, and the difference is written as a number of variable length. Since
 * the integers are of displacements, a rest shape that differs in its last digits only moves the result as little.
 *
 * Layout: the step as a 64-bit float, little end first; then for each axis the vertices, in the order of prediction.ts.
 */

import { deviation, edgeLengths } from '../net/edge_lengths';
import { damaged, NumberReader, LARGEST_INTEGER, writeFloat64, writeInteger } from './numbers';
import { type Connectivity, forEachPrediction } from './prediction';

/** The part of an opened net that packing looks at; both sides must have the same, numbered alike (numbering.ts). */
export interface PackingNet {
  restPositions: Float64Array;
  /** The length each edge is to keep. */
  restLengths: Float64Array;
  edges: Int32Array;
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

/** Largest step, in edge lengths: rounding moves no vertex by more than half of it along each axis. */
const STEP = 1e-4;
/** How often the step may be halved so that a converged net stays converged. */
const HALVINGS = 5;

/**
 * Packs `positions` so that every vertex comes back within 1e-4 of the shortest rest edge. If all edges have dL below
 * `threshold`, they still have it afterwards, unless that would take a step below STEP / 2^HALVINGS.
 */
export function packPositions(positions: Float64Array, net: PackingNet, threshold: number): Uint8Array {
  const step = chooseStep(positions, net, threshold);
  const steps = toSteps(positions, net, step);
  const bytes: number[] = [];
  writeFloat64(bytes, step);
  forEachPrediction(connectivityOf(net), (i, prediction) => {
    const value = steps[i] ?? 0;
    writeInteger(bytes, value - prediction);
    return value;
  });
  return Uint8Array.from(bytes);
}

/** The positions that `packPositions` packed for this net. Throws a Failure, "bad_link", if they are damaged
 *  or belong to another net. */
export function unpackPositions(packed: Uint8Array, net: PackingNet): Float64Array {
  const reader = new NumberReader(packed);
  const step = reader.float64();
  if (!(step > 0 && step < Infinity)) throw damaged();
  const positions = Float64Array.from(net.restPositions);
  forEachPrediction(connectivityOf(net), (i, prediction) => {
    const value = prediction + reader.integer();
    if (!(Math.abs(value) <= LARGEST_INTEGER)) throw damaged();
    const position = (positions[i] ?? 0) + value * step;
    if (!Number.isFinite(position)) throw damaged();
    positions[i] = position;
    return value;
  });
  reader.end();
  return positions;
}

/** Not by spreading, which would copy all arrays of an editor, and some more. */
function connectivityOf({ restPositions, edges, faceStart, faceVertices }: PackingNet): Connectivity {
  return { vertices: restPositions.length / 3, edges, faceStart, faceVertices };
}

// ------------------------------------------------------------------------------------------------------------ the step

function chooseStep(positions: Float64Array, net: PackingNet, threshold: number): number {
  const first = STEP * shortestEdge(net);
  if (!(largestDeviation(positions, net) < threshold)) return first;
  for (let halvings = 0; halvings <= HALVINGS; ++halvings) {
    const step = first / 2 ** halvings;
    const rounded = toSteps(positions, net, step).map((steps, i) => (net.restPositions[i] ?? 0) + steps * step);
    if (largestDeviation(rounded, net) < threshold) return step;
  }
  return first;
}

function toSteps(positions: Float64Array, { restPositions }: PackingNet, step: number): Float64Array {
  return positions.map((x, i) => Math.round((x - (restPositions[i] ?? 0)) / step));
}

function shortestEdge({ restPositions, edges }: PackingNet): number {
  return edgeLengths(restPositions, edges).reduce((shortest, length) => Math.min(shortest, length), Infinity);
}

function largestDeviation(positions: Float64Array, { edges, restLengths }: PackingNet): number {
  const ratios = edgeLengths(positions, edges).map((length, e) => length / (restLengths[e] ?? NaN));
  return ratios.reduce((largest, ratio) => Math.max(largest, deviation(ratio)), 0);
}

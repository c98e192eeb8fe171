/**
 * Positions in few bytes, for links. What is kept is how far each vertex stands from rest, as integers of a small step;
 * each is predicted from vertices that came before, and the difference is written as a number of variable length. Since
 * the integers are of displacements, a rest shape that differs in its last digits only moves the result as little.
 *
 * Layout: the step as a 64-bit float, little end first; then for each axis the vertices, in the order of `makeWalk`.
 */

import { deviation, edgeLengths } from '../net/edge_lengths';
import { Failure } from '../failure';

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
/** No displacement of a net is so many steps long; more is damage. */
const LARGEST = 2 ** 48;

/**
 * Packs `positions` so that every vertex comes back within 1e-4 of the shortest rest edge. If all edges have dL below
 * `threshold`, they still have it afterwards, unless that would take a step below STEP / 2^HALVINGS.
 */
export function packPositions(positions: Float64Array, net: PackingNet, threshold: number): Uint8Array {
  const step = chooseStep(positions, net, threshold);
  const steps = toSteps(positions, net, step);
  const start = new DataView(new ArrayBuffer(8));
  start.setFloat64(0, step, true);
  const bytes = [...new Uint8Array(start.buffer)];
  forEachPrediction(net, (i, prediction) => {
    const value = steps[i] ?? 0;
    writeInteger(bytes, value - prediction);
    return value;
  });
  return Uint8Array.from(bytes);
}

/** The positions that `packPositions` packed for this net. Throws a Failure, "bad_link", if they are damaged
 *  or belong to another net. */
export function unpackPositions(packed: Uint8Array, net: PackingNet): Float64Array {
  if (packed.length < 8) throw damaged();
  const step = new DataView(packed.buffer, packed.byteOffset).getFloat64(0, true);
  if (!(step > 0 && step < Infinity)) throw damaged();
  const reader = { bytes: packed, at: 8 };
  const positions = Float64Array.from(net.restPositions);
  forEachPrediction(net, (i, prediction) => {
    const value = prediction + readInteger(reader);
    if (!(Math.abs(value) <= LARGEST)) throw damaged();
    const position = (positions[i] ?? 0) + value * step;
    if (!Number.isFinite(position)) throw damaged();
    positions[i] = position;
    return value;
  });
  if (reader.at !== packed.length) throw damaged();
  return positions;
}

function damaged(): Failure {
  return new Failure('bad_link', 'The positions in this link are damaged or belong to another net.');
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

// ------------------------------------------------------------------------------------------------------- the prediction

/** Every vertex after some of its neighbours, and what of the net is known by then. */
interface Walk {
  order: number[];
  /** For each vertex, of the quads that it completes: the opposite corner and the two others, one quad after another. */
  corners: number[][];
  /** For each vertex, the neighbours known before it. */
  neighbours: number[][];
}

/**
 * Calls `code` for every coordinate with its prediction; `code` returns the true value. A vertex that completes a quad
 * is expected to complete a parallelogram, up to what the parallelograms beside it missed.
 */
function forEachPrediction(net: PackingNet, code: (i: number, prediction: number) => number): void {
  const { order, corners, neighbours } = makeWalk(net);
  for (let axis = 0; axis < 3; ++axis) {
    const value = new Float64Array(order.length);
    const missed = new Float64Array(order.length);
    for (const vertex of order) {
      const quads = corners[vertex] ?? [];
      const plain = quads.length > 0 ? completed(quads, value) : mean(neighbours[vertex] ?? [], value);
      const prediction = Math.round(plain + (quads.length > 0 ? besides(quads, missed) : 0));
      const actual = code(3 * vertex + axis, prediction);
      value[vertex] = actual;
      if (quads.length > 0) missed[vertex] = actual - plain;
    }
  }
}

function completed(corners: readonly number[], value: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < corners.length; k += 3) {
    sum += at(value, corners[k + 1]) + at(value, corners[k + 2]) - at(value, corners[k]);
  }
  return (3 * sum) / corners.length;
}

function besides(corners: readonly number[], missed: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < corners.length; k += 3) sum += at(missed, corners[k + 1]) + at(missed, corners[k + 2]);
  return (1.5 * sum) / corners.length;
}

function mean(vertices: readonly number[], value: Float64Array): number {
  const sum = vertices.reduce((total, vertex) => total + at(value, vertex), 0);
  return vertices.length > 0 ? sum / vertices.length : 0;
}

function at(values: Float64Array, index: number | undefined): number {
  return (index === undefined ? undefined : values[index]) ?? 0;
}

/** Breadth first along edges, component by component. */
function makeWalk(net: PackingNet): Walk {
  const count = net.restPositions.length / 3;
  const adjacent = neighboursOf(net, count);
  const rank = new Int32Array(count).fill(-1);
  const order: number[] = [];
  for (let seed = 0, next = 0; seed < count; ++seed) {
    if (rank[seed] === -1) rank[seed] = order.push(seed) - 1;
    for (; next < order.length; ++next) {
      for (const vertex of adjacent[order[next] ?? 0] ?? []) {
        if (rank[vertex] === -1) rank[vertex] = order.push(vertex) - 1;
      }
    }
  }
  const rankOf = (vertex: number): number => rank[vertex] ?? 0;
  const neighbours = adjacent.map((near, vertex) => near.filter((other) => rankOf(other) < rankOf(vertex)));
  return { order, corners: cornersOf(net, rankOf, count), neighbours };
}

function neighboursOf({ edges }: PackingNet, count: number): number[][] {
  const adjacent: number[][] = Array.from({ length: count }, () => []);
  for (let e = 0; e < edges.length; e += 2) {
    const a = edges[e] ?? 0;
    const b = edges[e + 1] ?? 0;
    adjacent[a]?.push(b);
    adjacent[b]?.push(a);
  }
  return adjacent;
}

function cornersOf(
  { faceStart, faceVertices }: PackingNet,
  rankOf: (vertex: number) => number,
  count: number,
): number[][] {
  const corners: number[][] = Array.from({ length: count }, () => []);
  for (let face = 0; face + 1 < faceStart.length; ++face) {
    const quad = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    if (quad.length !== 4) continue;
    const last = quad.reduce((latest, vertex, k) => (rankOf(vertex) > rankOf(quad[latest] ?? 0) ? k : latest), 0);
    const corner = (turn: number): number => quad[(last + turn) % 4] ?? 0;
    corners[corner(0)]?.push(corner(2), corner(1), corner(3));
  }
  return corners;
}

// --------------------------------------------------------------------------------------------------------- the integers

/** Small ones of either sign in one byte: 7 bits a byte, low bits first, the sign in the lowest. */
function writeInteger(bytes: number[], value: number): void {
  let rest = value < 0 ? -2 * value - 1 : 2 * value;
  for (; rest >= 128; rest = Math.floor(rest / 128)) bytes.push(128 + (rest % 128));
  bytes.push(rest);
}

function readInteger(reader: { bytes: Uint8Array; at: number }): number {
  let value = 0;
  for (let unit = 1; unit <= 2 * LARGEST; unit *= 128) {
    const byte = reader.bytes[reader.at++];
    if (byte === undefined) throw damaged();
    value += (byte % 128) * unit;
    if (byte < 128) return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }
  throw damaged();
}

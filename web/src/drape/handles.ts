/** Handles to begin with on each piece of a net from a seed: the corners of its border, or of a border without corners the ends
 *  of its arms. One is to be dragged while the others hold the piece. Not the seed: where the arms run straight it could not move
 *  at all. */
import type { HandleSeed } from '../document/document';
import { listsOf } from '../handles/lines';
import type { OpenedNet } from '../worker/protocol';
import type { DrapedNet } from './drape_protocol';

/** A border is looked at over so many edge lengths to both sides, so that steps of whole cells are no corners; or if that is less,
 *  over such a part of it. */
const WINDOW = 4;
const PART = 1 / 8;
/** A corner turns by more than this, in degrees. A circle turns by 45° there. */
const LEAST_TURN = 65;
/** A border with fewer corners has none that could hold the net, one with more has steps. */
const [FEWEST, MOST] = [3, 8];

export function suggestedHandles({ net, places }: Pick<DrapedNet, 'net' | 'places'>): HandleSeed[] {
  return piecesOf(net).flatMap((piece) => handlesOn(net, places.subarray(2 * piece[0], 2 * piece[1]), piece));
}

/** From which vertex on, and up to which: those of a piece follow each other. */
type Piece = [first: number, end: number];

function piecesOf({ edges, info: { vertices } }: OpenedNet): Piece[] {
  const farthest = Array.from({ length: vertices }, (_, vertex) => vertex);
  for (let i = 0; i < edges.length; i += 2) {
    const [low, high] = [Math.min(edges[i]!, edges[i + 1]!), Math.max(edges[i]!, edges[i + 1]!)];
    farthest[low] = Math.max(farthest[low]!, high);
  }
  const pieces: Piece[] = [];
  for (let vertex = 0, first = 0, last = 0; vertex < vertices; vertex++) {
    last = Math.max(last, farthest[vertex]!);
    if (vertex < last) continue;
    pieces.push([first, vertex + 1]);
    first = vertex + 1;
  }
  return pieces;
}

/** On the piece whose vertices these places are of. */
function handlesOn(net: OpenedNet, places: Int32Array, [first, end]: Piece): HandleSeed[] {
  const corners = cornersOf(net, first, end);
  const areHolding = corners.length >= FEWEST && corners.length <= MOST;
  const vertices = areHolding
    ? fromSeed(net, first + vertexAt(places, 0, 0), corners)
    : endsOfArms(places).map((vertex) => first + vertex);
  return vertices.map((vertex, i, { length }) => ({ vertex, target: null, anchor: i + 1 < length }));
}

/** Of the longest loop of the border, the sharpest first. */
function cornersOf(net: OpenedNet, first: number, end: number): number[] {
  const loops = listsOf({ start: net.loopStart, vertices: net.loopVertices }).filter(
    ([vertex = -1]) => first <= vertex && vertex < end,
  );
  const loop = [...loops.sort((a, b) => b.length - a.length)[0]!];
  const around = loop.reduce((sum, vertex, at) => sum + apart(net, vertex, loop.at(at - 1)!), 0);
  const reach = Math.min(WINDOW * net.info.meanLength, PART * around);
  const turns = loop.map((_, at) => turnAt(net, loop, at, reach));
  const found: number[] = [];
  for (const at of [...loop.keys()].sort((a, b) => turns[b]! - turns[a]!)) {
    if (turns[at]! < LEAST_TURN) break;
    if (found.every((vertex) => apart(net, vertex, loop[at]!) > reach)) found.push(loop[at]!);
  }
  return found;
}

/** By how many degrees a loop turns between what lies before a vertex, within reach, and what lies after it. */
function turnAt(net: OpenedNet, loop: readonly number[], at: number, reach: number): number {
  const here = loop[at]!;
  const [before, after] = [-1, 1].map((step) => within(net, loop, at, step, reach));
  const [a, b, c] = [apart(net, before!, here), apart(net, here, after!), apart(net, before!, after!)];
  // The law of cosines.
  const cosine = (c * c - a * a - b * b) / (2 * a * b);
  return (Math.acos(Math.max(-1, Math.min(cosine, 1))) * 180) / Math.PI;
}

/** The vertex to which one comes along a loop within reach. */
function within(net: OpenedNet, loop: readonly number[], at: number, step: number, reach: number): number {
  let [vertex, gone] = [loop[at]!, 0];
  for (let k = 1; k < loop.length; k++) {
    const next = loop.at((at + k * step) % loop.length)!;
    gone += apart(net, vertex, next);
    vertex = next;
    if (gone >= reach) break;
  }
  return vertex;
}

/** The farthest from the seed last. */
function fromSeed(net: OpenedNet, seed: number, vertices: readonly number[]): number[] {
  return [...vertices].sort((a, b) => apart(net, seed, a) - apart(net, seed, b));
}

/** The longest arm last. */
function endsOfArms(places: Int32Array): number[] {
  const arms = [endOfArm(places, 1, 0), endOfArm(places, 0, 1), endOfArm(places, -1, 0), endOfArm(places, 0, -1)];
  return arms
    .filter(({ steps }) => steps > 0)
    .sort((a, b) => a.steps - b.steps)
    .map(({ vertex }) => vertex);
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

function apart({ restPositions: at }: OpenedNet, a: number, b: number): number {
  return Math.hypot(at[3 * a]! - at[3 * b]!, at[3 * a + 1]! - at[3 * b + 1]!, at[3 * a + 2]! - at[3 * b + 2]!);
}

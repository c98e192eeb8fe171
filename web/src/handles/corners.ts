/** The corners of a border. */
import type { OpenedNet } from '../worker/protocol';

/** A border is looked at over so many edge lengths to both sides, so that steps of whole cells are no corners; or if that is less,
 *  over such a part of it. */
const WINDOW = 4;
const PART = 1 / 8;
/** A corner turns by more than this, in degrees. A circle turns by 45° there. */
const LEAST_TURN = 65;

/** The vertices of a boundary loop at its corners, the sharpest first. */
export function cornersOf(net: OpenedNet, loop: readonly number[]): number[] {
  const reach = reachOn(net, loop);
  const turns = loop.map((_, at) => turnAt(net, loop, at, reach));
  const found: number[] = [];
  for (const at of [...loop.keys()].sort((a, b) => turns[b]! - turns[a]!)) {
    if (turns[at]! < LEAST_TURN) break;
    if (found.every((vertex) => apart(net, vertex, loop[at]!) > reach)) found.push(loop[at]!);
  }
  return found;
}

/** Of a vertex on a boundary loop, those over which it is looked at, before it and after it. */
export function besideOn(net: OpenedNet, loop: readonly number[], vertex: number): number[] {
  return [-1, 1].map((step) => within(net, loop, loop.indexOf(vertex), step, reachOn(net, loop)));
}

function reachOn(net: OpenedNet, loop: readonly number[]): number {
  return Math.min(WINDOW * net.info.meanLength, PART * lengthOf(net, loop));
}

/** By how many degrees a loop turns between what lies before a vertex, within reach, and what lies after it. */
function turnAt(net: OpenedNet, loop: readonly number[], at: number, reach: number): number {
  const [before, after] = [-1, 1].map((step) => within(net, loop, at, step, reach));
  return turnBetween(net, before!, loop[at]!, after!);
}

/** By how many degrees the way from one vertex by way of another to a third turns. */
export function turnBetween(net: OpenedNet, before: number, here: number, after: number): number {
  const [a, b, c] = [apart(net, before, here), apart(net, here, after), apart(net, before, after)];
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

/** Of a boundary loop, once around. */
export function lengthOf(net: OpenedNet, loop: readonly number[]): number {
  return loop.reduce((sum, vertex, at) => sum + apart(net, vertex, loop.at(at - 1)!), 0);
}

/** In space, at rest. */
export function apart({ restPositions: at }: OpenedNet, a: number, b: number): number {
  return Math.hypot(at[3 * a]! - at[3 * b]!, at[3 * a + 1]! - at[3 * b + 1]!, at[3 * a + 2]! - at[3 * b + 2]!);
}

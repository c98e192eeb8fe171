/** Handles that follow those in hand, the less the farther they are along the net. Loaded when it is first wanted. */
import type { Handle } from '../../../wasm/chebnet';
import type { HandleData, Vec3 } from '../document/document';
import type { OpenedNet } from '../worker/protocol';
import { distancesAround } from './around';

/** A handle that follows the one in hand that is nearest to it. */
export interface Follower {
  vertex: number;
  /** Where it stood at the start. */
  from: Vec3;
  leader: number;
  /** Of the way that its leader goes. */
  share: number;
}

/** What of the way of a hand is gone at a part, from 0 to 1, of the radius of influence: all in the hand, nothing at the radius, and
 *  smooth at both, as "smooth" is in other programs. */
export function shareAt(part: number): number {
  const near = 1 - Math.min(Math.max(part, 0), 1);
  return near * near * (3 - 2 * near);
}

/** By vertex, its share within `radius` edge lengths of those in hand, along the net at rest. */
export function sharesAround(net: OpenedNet, inHand: readonly number[], radius: number): Float32Array {
  const shares = new Float32Array(net.info.vertices);
  const widest = radius * net.info.meanLength;
  for (const [vertex, { distance }] of distancesAround(net, inHand, radius))
    shares[vertex] = shareAt(distance / widest);
  return shares;
}

/** The handles that follow: neither in hand nor locked, and nearer than the radius. */
export function followersOf(
  net: OpenedNet,
  handles: readonly HandleData[],
  inHand: readonly number[],
  radius: number,
): Follower[] {
  const around = distancesAround(net, inHand, radius);
  const held = new Set(inHand);
  return handles.flatMap(({ vertex, target, anchor }) => {
    const away = around.get(vertex);
    if (away === undefined || anchor || held.has(vertex)) return [];
    const share = shareAt(away.distance / (radius * net.info.meanLength));
    return share > 0 ? [{ vertex, from: target, leader: away.origin, share }] : [];
  });
}

/** Where they go with those in hand, which were at `from` at the start. */
export function following(
  followers: readonly Follower[],
  hand: readonly Handle[],
  from: (vertex: number) => Vec3,
): Handle[] {
  const targets = new Map(hand.map(({ vertex, target }) => [vertex, target]));
  return followers.map(({ vertex, from: stood, leader, share }) => {
    const to = targets.get(leader);
    const start = from(leader);
    return { vertex, target: to ? (stood.map((x, i) => x + share * (to[i]! - start[i]!)) as Vec3) : stood };
  });
}

/** A line drawn on a net, in one stroke or in several that go on from each other. */
import { type DrawnPoint, wayAlong } from '../handles/way';
import type { OpenedNet } from '../worker/protocol';

/** Points on the net from end to end, in several pieces where the line leaves the net in between. */
export type DrawnLine = readonly (readonly DrawnPoint[])[];

/** Two ends are one if they are as near as so many edges, or as such a part of the line is long. */
const NEAR = { edges: 1.5, part: 0.05 };
/** A line that begins where it ends is closed if it is so many times as long as that is near. */
const LEAST_LOOP = 4;

/** With another stroke: it goes on if it begins where the line ends, and is a line of its own elsewhere. */
export function extended(line: DrawnLine, stroke: DrawnLine, edgeLength: number): DrawnLine {
  const [last, next] = [line.at(-1), stroke[0]];
  if (!last || !next || distance(last.at(-1)!, next[0]!) > reachOf(line, edgeLength)) return stroke;
  return [...line.slice(0, -1), [...last, ...next], ...stroke.slice(1)];
}

/** The ways along edges that are nearest to a line, each by its vertices; one that is closed ends where it begins.
 *  @param positions where the net stands. */
export function waysAlong(
  { edges }: Pick<OpenedNet, 'edges'>,
  positions: Float64Array,
  line: DrawnLine,
  edgeLength: number,
): number[][] {
  return closed(line, edgeLength)
    .map((piece) => wayAlong(edges, positions, piece, edgeLength))
    .filter((way) => way.length > 1);
}

/** Leads it back to its beginning, if it ends there. */
function closed(line: DrawnLine, edgeLength: number): DrawnLine {
  const [first, last] = [line[0]?.[0], line.at(-1)];
  const reach = reachOf(line, edgeLength);
  if (!first || !last || distance(first, last.at(-1)!) > reach || lengthOf(line) < LEAST_LOOP * reach) return line;
  return [...line.slice(0, -1), [...last, first]];
}

function reachOf(line: DrawnLine, edgeLength: number): number {
  return Math.max(NEAR.edges * edgeLength, NEAR.part * lengthOf(line));
}

function lengthOf(line: DrawnLine): number {
  const lengths = line.flatMap((piece) => piece.slice(1).map((point, k) => distance(piece[k]!, point)));
  return lengths.reduce((sum, length) => sum + length, 0);
}

function distance({ at: a }: DrawnPoint, { at: b }: DrawnPoint): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

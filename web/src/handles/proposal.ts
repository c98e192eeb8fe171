/** Handles to begin with on a net that has none: on each piece the outer corners of its border, or else where that reaches farthest
 *  out, such as the feet of a shell, or where it has neither, the vertices that lie farthest out, such as the limbs of a body. One is
 *  to be dragged while the others hold the piece. */
import type { HandleSeed } from '../document/document';
import type { OpenedNet } from '../worker/protocol';
import { type Away, distancesAround, verticesAround } from './around';
import { apart, besideOn, cornersOf, lengthOf, turnBetween } from './corners';
import { listsOf } from './lines';

/** A border with fewer corners has none that could hold the net, one with more has steps. */
const [FEWEST, MOST] = [3, 8];
/** How many lie farthest out: on a piece with a border, which four hold like a sheet, and on a closed one. */
const [WITH_BORDER, CLOSED] = [4, 6];
/** What is nearer to another handle than this part of the way from the middle to the farthest vertex is no limb of its own. */
const LEAST_APART = 0.4;
/** The largest pieces only: a file may have hundreds. */
const MOST_PIECES = 4;
/** A border reaches out where it comes back by more than this part of the way from the middle to the farthest vertex on either side. */
const LEAST_PROMINENCE = 0.1;
/** Where a border reaches out twice no farther apart along the net than so many edges, it does so once. */
const SAME_ALONG_NET = 4;
/** Two face each other across a seam or a slit that are within so many edges in space, or as near by this part of the way between
 *  them along the net. */
const [FACING, FACING_PART] = [2, 0.25];
/** A part of a border is left alone if it is farther in space from all handles than this part of the diagonal of its piece's box,
 *  and a way from any of them to another turns there by more than this, in degrees. Else two hold it between them, as the corners
 *  of a strip hold its middle, and the feet of an arch its top. */
const [ALONE_BEYOND, ALONE_TURN] = [0.4, 105];

/** The last one is free, on the largest piece. */
export function proposedHandles(net: OpenedNet): HandleSeed[] {
  const tips = tipsOfTeeth(net);
  const largest = piecesOf(net).slice(0, MOST_PIECES).reverse();
  const onPieces = largest
    .map((all) => all.filter((vertex) => !tips.has(vertex)))
    .map((piece) => ({ piece, vertices: verticesOn(net, piece) }));
  const all = onPieces.flatMap(({ vertices }) => vertices);
  return onPieces.flatMap(({ piece, vertices }) => (vertices.length > 0 ? lastFree(net, piece, vertices, all) : []));
}

/** The vertices of each, of the largest first. */
function piecesOf(net: OpenedNet): number[][] {
  const seen = new Set<number>();
  const pieces: number[][] = [];
  for (let vertex = 0; vertex < net.info.vertices; vertex++) {
    if (seen.has(vertex)) continue;
    const piece = [...distancesAround(net, [vertex], Infinity).keys()];
    for (const each of piece) seen.add(each);
    pieces.push(piece);
  }
  return pieces.sort((a, b) => b.length - a.length);
}

/** Of single cells that stick out of a border, which would leave the rest of the net behind: their two outer corners. A net line
 *  goes on at one foot of them at least, as it does not at the end of a strip of one cell. */
function tipsOfTeeth({ info, faceStart, faceVertices }: OpenedNet): Set<number> {
  const facesAt = new Int32Array(info.vertices);
  for (const vertex of faceVertices) facesAt[vertex]! += 1;
  const tips = new Set<number>();
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const corners = [...faceVertices.subarray(faceStart[face], faceStart[face + 1])];
    const [outer, feet] = [corners.filter((each) => facesAt[each] === 1), corners.filter((each) => facesAt[each]! > 1)];
    if (outer.length !== 2 || feet.length !== 2 || feet.every((foot) => facesAt[foot] === 2)) continue;
    for (const tip of outer) tips.add(tip);
  }
  return tips;
}

/** The farthest from the middle the last. */
function verticesOn(net: OpenedNet, piece: readonly number[]): number[] {
  const inPiece = new Set(piece);
  const loops = loopsOf(net, inPiece);
  const [loop, ...holes] = loops;
  const middle = middleOf(net, piece);
  // Around a hole in its middle all ways begin at its rim: from one side of it the other would be the farthest out.
  const away = awayFrom(net, holes.find((hole) => hole.includes(middle)) ?? [middle], inPiece);
  const corners = loop ? cornersOf(net, loop).filter((vertex) => pointsOut(net, loop, vertex, away)) : [];
  const peaks = loop ? onePerPlace(net, outwards(peaksOf(loop, away), away)) : [];
  const ofBorder = [corners, peaks].find(({ length }) => length >= FEWEST && length <= MOST);
  const vertices = ofBorder
    ? joinedOnBorder(net, ofBorder, loops.flat(), ALONE_BEYOND * sizeOf(net, piece))
    : farthestOut(net, away, inPiece, loop ? WITH_BORDER : CLOSED);
  return outwards(vertices, away);
}

/** How far from these the vertices of a piece are. */
function awayFrom(net: OpenedNet, origins: readonly number[], piece: ReadonlySet<number>): Map<number, Away> {
  return new Map([...distancesAround(net, origins, Infinity)].filter(([vertex]) => piece.has(vertex)));
}

/** The farthest the last. */
function outwards(vertices: readonly number[], away: ReadonlyMap<number, Away>): number[] {
  return [...vertices].sort((a, b) => away.get(a)!.distance - away.get(b)!.distance);
}

/** Of those close together along the net, the last. The two sides of a seam are far apart along it, however close in space. */
function onePerPlace(net: OpenedNet, vertices: readonly number[]): number[] {
  return vertices.filter((vertex, at) => {
    const around = new Set(verticesAround(net, [vertex], SAME_ALONG_NET));
    return !vertices.slice(at + 1).some((other) => around.has(other));
  });
}

/** With more of them where they leave a large part of the border alone, as on a ring that is held beside its seam only. */
function joinedOnBorder(
  net: OpenedNet,
  handles: readonly number[],
  border: readonly number[],
  beyond: number,
): number[] {
  const found = [...handles];
  while (found.length < MOST) {
    const alone = border.filter((vertex) => isAlone(net, vertex, found, beyond));
    if (alone.length === 0) break;
    const gap = (vertex: number): number => Math.min(...found.map((handle) => apart(net, vertex, handle)));
    found.push(alone.reduce((farthest, vertex) => (gap(vertex) > gap(farthest) ? vertex : farthest)));
  }
  return found;
}

function isAlone(net: OpenedNet, vertex: number, handles: readonly number[], beyond: number): boolean {
  if (handles.some((handle) => apart(net, vertex, handle) <= beyond)) return false;
  return handles.every((a, at) => handles.slice(at + 1).every((b) => turnBetween(net, a, vertex, b) > ALONE_TURN));
}

/** The last one that stands alone is free: of two on the sides of a seam or a slit, or of a cut between pieces, it would be dragged
 *  away from the other. Where none does, as on a body that is wrapped in one piece, whose limbs all meet, another one is.
 *  @param all of every piece. */
function lastFree(
  net: OpenedNet,
  piece: readonly number[],
  vertices: readonly number[],
  all: readonly number[],
): HandleSeed[] {
  const standsAlone = (vertex: number): boolean => {
    const along = distancesAround(net, [vertex], Infinity);
    return all.every((other) => other === vertex || !faceEachOther(net, vertex, other, along.get(other)?.distance));
  };
  const free = [...vertices].reverse().find(standsAlone) ?? farthestInSpace(net, piece, vertices);
  const seed = (vertex: number): HandleSeed => ({ vertex, target: null, anchor: vertex !== free });
  return [...vertices.filter((vertex) => vertex !== free), free].map(seed);
}

/** @param along from one to the other; undefined: they are on two pieces. */
function faceEachOther(net: OpenedNet, a: number, b: number, along = Infinity): boolean {
  const gap = apart(net, a, b);
  if (gap <= FACING * net.info.meanLength) return gap < along / 2;
  return along !== Infinity && gap < FACING_PART * along;
}

function farthestInSpace(net: OpenedNet, piece: readonly number[], from: readonly number[]): number {
  let [most, far] = [from.at(-1)!, 0];
  for (const vertex of piece) {
    const gap = Math.min(...from.map((each) => apart(net, vertex, each)));
    if (gap > far) [most, far] = [vertex, gap];
  }
  return most;
}

/** Whether a corner of a border is no notch in it, nor the inner end of a slit: farther from the middle than the border beside it, and
 *  as far as a limb would be. */
function pointsOut(net: OpenedNet, loop: readonly number[], vertex: number, away: ReadonlyMap<number, Away>): boolean {
  const [before = 0, after = 0] = besideOn(net, loop, vertex).map((each) => away.get(each)!.distance);
  const { distance } = away.get(vertex)!;
  return 2 * distance > before + after && distance > LEAST_APART * farthest(away)[1];
}

/** Where a border lies farther from the middle than all of it as far as it must come back before it goes farther still. */
function peaksOf(loop: readonly number[], away: ReadonlyMap<number, Away>): number[] {
  const distances = loop.map((vertex) => away.get(vertex)!.distance);
  const least = LEAST_PROMINENCE * farthest(away)[1];
  return loop.filter((_, at) => [-1, 1].every((step) => comesBack(distances, at, step) > least));
}

/** By how much a loop of distances falls from one of them on, this way round, before it is greater; an equal one counts as such on
 *  one of the two ways. */
function comesBack(distances: readonly number[], at: number, step: number): number {
  const here = distances[at]!;
  let lowest = here;
  for (let k = 1; k < distances.length; k++) {
    const next = distances.at((at + k * step) % distances.length)!;
    if (next > here || (next === here && step > 0)) break;
    lowest = Math.min(lowest, next);
  }
  return here - lowest;
}

/** The longest first. */
function loopsOf(net: OpenedNet, piece: ReadonlySet<number>): number[][] {
  return listsOf({ start: net.loopStart, vertices: net.loopVertices })
    .map((loop) => [...loop].filter((vertex) => piece.has(vertex)))
    .filter(({ length }) => length > 0)
    .sort((a, b) => lengthOf(net, b) - lengthOf(net, a));
}

/** The farthest from the middle, then each time the one farthest from those found. */
function farthestOut(
  net: OpenedNet,
  away: ReadonlyMap<number, Away>,
  piece: ReadonlySet<number>,
  most: number,
): number[] {
  let [vertex, distance] = farthest(away);
  const least = LEAST_APART * distance;
  const found: number[] = [];
  while (found.length < most && distance > least) {
    found.push(vertex);
    [vertex, distance] = farthest(awayFrom(net, found, piece));
  }
  return found;
}

function farthest(away: ReadonlyMap<number, Away>): [vertex: number, distance: number] {
  let most: [number, number] = [-1, 0];
  for (const [vertex, { distance }] of away) if (distance > most[1]) most = [vertex, distance];
  return most;
}

/** The vertex nearest to the centre of all. */
function middleOf({ restPositions: at }: OpenedNet, piece: readonly number[]): number {
  const centre = [0, 1, 2].map((axis) => piece.reduce((sum, vertex) => sum + at[3 * vertex + axis]!, 0) / piece.length);
  const off = (vertex: number): number => Math.hypot(...centre.map((x, axis) => at[3 * vertex + axis]! - x));
  return piece.reduce((nearest, vertex) => (off(vertex) < off(nearest) ? vertex : nearest));
}

/** The diagonal of the box around these. */
function sizeOf({ restPositions: at }: OpenedNet, piece: readonly number[]): number {
  const extent = (axis: number): number => {
    const [least, most] = piece.reduce(
      ([low, high], vertex) => [Math.min(low, at[3 * vertex + axis]!), Math.max(high, at[3 * vertex + axis]!)],
      [Infinity, -Infinity],
    );
    return most - least;
  };
  return Math.hypot(extent(0), extent(1), extent(2));
}

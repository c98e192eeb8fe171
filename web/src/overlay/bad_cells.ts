/** The cells of a net that is not as it should be. */
import type { FrameData, OpenedNet } from '../worker/protocol';
import { deviation, edgeLength, KEPT_DEVIATION } from '../net/edge_lengths';
import { type Faces, facePairs, SHARP_FOLD, writeFolds } from '../net/fold';
import { isSharpQuad, sharpQuads } from '../net/sharp_quads';

/** Edges are told apart from the worst one when their error is below this part of it. */
const PART_OF_WORST = 0.01;
/** In degrees: what is just at the limit keeps it. */
const ROUNDING = 0.1;

export interface BadCells {
  /** Faces with an edge that is off. */
  off: ReadonlySet<number>;
  /** Quads with a corner below the limit. */
  sharp: ReadonlySet<number>;
  /** Faces at an edge at which the net is crumpled. */
  folded: ReadonlySet<number>;
}

export const NONE_BAD: BadCells = { off: new Set(), sharp: new Set(), folded: new Set() };

/** @param limit of corners, in degrees. */
export function badCells(net: OpenedNet, { positions, lengthScale }: FrameData, limit: number): BadCells {
  return {
    ...NONE_BAD,
    off: facesAt(net, edgesOff(net, positions, lengthScale)),
    sharp: sharpQuads(net, positions, limit - ROUNDING),
  };
}

/** Where an edit has made corners sharper than a limit that the method does not heed. */
export function creasedCells(net: OpenedNet, { positions }: FrameData, limit: number): BadCells {
  const least = limit - ROUNDING;
  const now = [...sharpQuads(net, positions, least)];
  return { ...NONE_BAD, sharp: new Set(now.filter((face) => !isSharpQuad(net, net.restPositions, least, face))) };
}

/** Where an edit has folded the net as no smooth bend does. */
export function crumpledCells(net: OpenedNet, { positions }: FrameData): BadCells {
  return { ...NONE_BAD, folded: facesAt(net, newFolds(net, net.restPositions, positions)) };
}

/** The edges that fold so much more sharply now than before: nets that are rough as they come may fold sharply all over. */
export function newFolds(net: Faces, before: Float64Array, now: Float64Array): number[] {
  const folds = foldsOf(net, now);
  const sharp: number[] = [];
  folds.forEach((fold, edge) => {
    if (fold > SHARP_FOLD) sharp.push(edge);
  });
  if (sharp.length === 0) return [];
  const old = foldsOf(net, before);
  return sharp.filter((edge) => folds[edge]! > old[edge]! + SHARP_FOLD);
}

function foldsOf(net: Faces, positions: Float64Array): Float32Array {
  const folds = new Float32Array(net.edges.length / 2);
  writeFolds(folds, positions, net);
  return folds;
}

function edgesOff({ edges, restLengths }: OpenedNet, positions: Float64Array, scale: number): number[] {
  const errors = restLengths.map((length, edge) => deviation(edgeLength(positions, edges, edge) / (length * scale)));
  const worst = errors.reduce((most, each) => Math.max(most, each), 0);
  const least = Math.max(KEPT_DEVIATION, PART_OF_WORST * worst);
  const off: number[] = [];
  errors.forEach((error, edge) => {
    if (error > least) off.push(edge);
  });
  return off;
}

function facesAt(net: OpenedNet, edges: readonly number[]): Set<number> {
  if (edges.length === 0) return new Set();
  const pairs = facePairs(net);
  return new Set(edges.flatMap((edge) => [...pairs.subarray(2 * edge, 2 * edge + 2)]).filter((face) => face >= 0));
}

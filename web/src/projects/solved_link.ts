/** A link without positions, a tenth as long. At rest a net has one shape, but for buckling, so that solving for it again
 *  usually gives that shape, and making the drag again where it does not; whether it does is tried here, as whoever opens
 *  the link will. */
import type { App } from '../app/app';
import { RunSolver } from '../compare/run_solver';
import { METHOD_AT_REST } from '../document/defaults';
import { whereDragged } from '../app/state';
import type { ChebnetDocument, HandleData, Replay } from '../document/document';
import { longestMove } from '../document/longest_move';
import { decodeScene, encodeEdit } from '../document/share';
import type { WorkerLike } from '../worker/client';

/** How far a vertex may come out from where it stands, in edge lengths: farther than two ways to the same rest end apart,
 *  and less than is seen: a tenth of a pixel. */
const SAME = 5e-3;
/** Milliseconds that a visitor waits for all trials. */
const PATIENCE = 20_000;
/** By which drags nets that buckle may come to the same shape again: like those of a hand, and like a place that was typed. */
const REPLAYS: readonly Replay[] = [
  [10, 3],
  [10, 5],
  [1, 1],
];

/** The present scene without its positions. */
export interface SolvedLink {
  hash: string;
  /** How far a vertex comes out from where it stands, at most, in edge lengths. */
  aside: number;
  /** That is too little to be seen. */
  isSame: boolean;
}

/** The first that opens into the present shape, else that which comes nearest; null: it cannot be solved again, takes too long,
 *  or nobody waits for it any more. */
export async function solvedLink(app: App, spawn: () => WorkerLike, unwanted: AbortSignal): Promise<SolvedLink | null> {
  const present = app.toShare();
  if (present === null) return null;
  const { document, net } = present;
  if (!canBeSolvedAgain(document)) return null;
  const ended = new AbortController();
  const end = (): void => ended.abort();
  unwanted.addEventListener('abort', end);
  const timer = setTimeout(end, PATIENCE);
  const dragged = { ...document, handles: document.handles.map(asDragged) };
  let nearest: SolvedLink | null = null;
  for (const replay of waysTo(document.handles)) {
    const hash = encodeEdit(replay ? dragged : document, net, replay);
    const positions = await solved(hash, spawn, ended.signal);
    if (ended.signal.aborted) break;
    if (positions === null) continue;
    const aside = longestMove(document.positions!, positions) / net.info.meanLength;
    if (nearest === null || aside < nearest.aside) nearest = { hash, aside, isSame: aside <= SAME };
    if (nearest.isSame) break;
  }
  clearTimeout(timer);
  unwanted.removeEventListener('abort', end);
  return unwanted.aborted ? null : nearest;
}

/** The likeliest first; undefined: without a drag. A handle that was held back says that the net was taut, as it is when it buckles. */
function waysTo(handles: readonly HandleData[]): readonly (Replay | undefined)[] {
  const isHeldBack = handles.some((handle) => asDragged(handle).target !== handle.target);
  return isHeldBack ? [...REPLAYS, undefined] : [undefined, ...REPLAYS];
}

/** Handles that slide have other targets for another reason. */
function asDragged(handle: HandleData): HandleData {
  return handle.slides ? handle : { ...handle, target: whereDragged(handle.target) };
}

function canBeSolvedAgain(document: ChebnetDocument): document is ChebnetDocument & { net: { recipe: string } } {
  const { net, method, settled, positions } = document;
  return 'recipe' in net && method === METHOD_AT_REST && settled && positions !== null;
}

/** Where the vertices of a hash come to rest; null: that fails, or has `ended` before. */
async function solved(hash: string, spawn: () => WorkerLike, ended: AbortSignal): Promise<Float64Array | null> {
  const solver = new RunSolver(spawn);
  const end = (): void => solver.dispose();
  ended.addEventListener('abort', end);
  let positions: Float64Array | null = null;
  try {
    await solver.solve(decodeScene(hash), (frame) => (positions = frame.positions));
    return positions;
  } catch {
    return null;
  } finally {
    ended.removeEventListener('abort', end);
    end();
  }
}

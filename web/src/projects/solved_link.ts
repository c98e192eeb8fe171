/** A link without positions, a tenth as long. At rest a net has one shape, but for buckling, so that solving for it again
 *  usually gives that shape; whether it does is tried here, as whoever opens the link will. */
import type { App } from '../app/app';
import { RunSolver } from '../compare/run_solver';
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument } from '../document/document';
import { longestMove } from '../document/longest_move';
import { decodeScene, encodeEdit } from '../document/share';
import type { WorkerLike } from '../worker/client';

/** How far a vertex may come out from where it stands, in edge lengths: farther than two ways to the same rest end apart,
 *  and less than is seen: a tenth of a pixel. */
const SAME = 5e-3;
/** Milliseconds that a visitor waits for it. */
const PATIENCE = 8_000;

/** The hash of the present scene without its positions, if it opens into the present shape all the same; else null, as when
 *  nobody waits for it any more. */
export async function solvedHash(app: App, spawn: () => WorkerLike, unwanted: AbortSignal): Promise<string | null> {
  const present = app.toShare();
  if (present === null) return null;
  const { document, net } = present;
  if (!canBeSolvedAgain(document)) return null;
  const hash = encodeEdit(document, net);
  const positions = await solved(hash, spawn, unwanted);
  const isSame = positions !== null && longestMove(document.positions!, positions) <= SAME * net.info.meanLength;
  return isSame ? hash : null;
}

function canBeSolvedAgain(document: ChebnetDocument): document is ChebnetDocument & { net: { recipe: string } } {
  const { net, method, settled, positions } = document;
  return 'recipe' in net && method === METHOD_AT_REST && settled && positions !== null;
}

/** Where the vertices of a hash come to rest; null: it takes too long, fails, or is unwanted. */
async function solved(hash: string, spawn: () => WorkerLike, unwanted: AbortSignal): Promise<Float64Array | null> {
  const solver = new RunSolver(spawn);
  const end = (): void => solver.dispose();
  const timer = setTimeout(end, PATIENCE);
  unwanted.addEventListener('abort', end);
  let positions: Float64Array | null = null;
  try {
    await solver.solve(decodeScene(hash), (frame) => (positions = frame.positions));
    return positions;
  } catch {
    return null;
  } finally {
    clearTimeout(timer);
    unwanted.removeEventListener('abort', end);
    end();
  }
}

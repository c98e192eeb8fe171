/** See App.flip(). */
import { longestMove } from '../document/longest_move';
import type { Snapshot } from '../document/undo';
import { sharpFolds } from '../net/fold';
import type { Client } from '../worker/client';
import type { State } from './state';

/** The part of the app that it uses. */
interface FlipHost {
  /** Fails where the net cannot be changed. */
  before(): Snapshot;
  /** Refused, the change that has just been recorded is taken back. */
  restoreFrom(before: Snapshot, after: Snapshot): Promise<void>;
  restore(snapshot: Snapshot): Promise<void>;
  isQuiet(): boolean;
}

export async function flip(client: Client, state: State, host: FlipHost): Promise<number | null> {
  host.before();
  const positions = await client.flipped();
  const before = host.before();
  const { opening, history } = state;
  if (opening === null || history.inGesture) return null;
  const from = opening.frame.positions.slice();
  history.record(before, ['flip']);
  const { revision } = history;
  await host.restoreFrom(before, { ...before, positions, settled: false });
  await client.idle();
  const frame = state.opening?.frame;
  if (!frame || !host.isQuiet() || history.revision !== revision) return null;
  const rests = ['converged', 'exact'].includes(frame.status);
  if (rests && sharpFolds(opening.net, frame.positions) <= sharpFolds(opening.net, from))
    return longestMove(from, frame.positions) / opening.net.info.meanLength;
  if (history.takeBack(before)) await host.restore(before);
  return 0;
}

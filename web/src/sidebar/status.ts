/** What the page says of the state of the solver. */
import type { Status } from '../../../wasm/chebnet';
import { KEPT_DEVIATION } from '../net/edge_lengths';
import type { FrameData } from '../worker/protocol';

type StatusOfFrame = Pick<FrameData, 'status' | 'iterations' | 'maxDeviation' | 'holdsBack'>;
export type Standing = Status | 'held_back' | 'settling' | 'stopped' | 'unsolved';

/** What is to be said of the solver, and the colour of its light: of a frame, while it is solving or not. */
export function standing({ status, iterations, maxDeviation, holdsBack }: StatusOfFrame, solving: boolean): Standing {
  if (holdsBack && maxDeviation < KEPT_DEVIATION) return 'held_back';
  if (status !== 'running') return status;
  if (solving) return maxDeviation < KEPT_DEVIATION ? 'settling' : 'running';
  return iterations > 0 ? 'stopped' : 'unsolved';
}

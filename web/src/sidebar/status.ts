/** What the page says of the state of the solver. */
import type { Status } from '../../../wasm/chebnet';
import { KEPT_DEVIATION } from '../net/edge_lengths';
import type { FrameData } from '../worker/protocol';

type StatusOfFrame = Pick<FrameData, 'status' | 'iterations' | 'maxDeviation' | 'holdsBack' | 'handles' | 'positions'>;
/** Of a place's distance from the origin: what digits may be lost. */
const CLOSE = 1e-9;

export type Standing = Status | 'held_back' | 'settling' | 'stopped' | 'unsolved';

/** What is to be said of the solver, and the colour of its light: of a frame, while it is solving or not. */
export function standing(frame: StatusOfFrame, solving: boolean): Standing {
  const { status, iterations, maxDeviation, holdsBack } = frame;
  if (holdsBack && maxDeviation < KEPT_DEVIATION) return 'held_back';
  if (status !== 'running') return status;
  if (solving) return maxDeviation < KEPT_DEVIATION && !isOnItsWay(frame) ? 'settling' : 'running';
  return iterations > 0 ? 'stopped' : 'unsolved';
}

/** Whether the net is still being drawn to handles that hold it. */
function isOnItsWay({ handles, positions }: Pick<FrameData, 'handles' | 'positions'>): boolean {
  return handles.some(({ vertex, target, weight, slides }) => {
    const [x, y, z] = target;
    const [u = x, v = y, w = z] = positions.subarray(3 * vertex, 3 * vertex + 3);
    return !weight && !slides && Math.hypot(u - x, v - y, w - z) > CLOSE * Math.hypot(x, y, z);
  });
}

/** Texts for the status of the solver. */
import type { Status } from '../../../wasm/chebnet';
import { words } from '../language/language';

export function statusWords(status: Status, solving: boolean, iterations: number): string {
  if (status !== 'running' || solving) return words.status[status];
  return iterations > 0 ? words.status.stopped : words.status.unsolved;
}

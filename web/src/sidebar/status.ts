/** Texts for the status of the solver. */
import type { Status, TraceRow } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { count } from '../language/numbers';

export function statusWords(status: Status, solving: boolean, iterations: number): string {
  if (status !== 'running' || solving) return words.status[status];
  return iterations > 0 ? words.status.stopped : words.status.unsolved;
}

/** Which stage an iteration belongs to and what is done there. */
export function stageWords({ stage, p, freeVertices }: TraceRow): string {
  return words.step.stage(stage, p > 0 ? p : null, count(freeVertices));
}

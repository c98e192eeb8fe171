/** How far a net over a whole surface is. */
import type { RemeshPhase } from '../../../wasm/chebnet';

/** In their order, with about how long each takes beside the others. */
const PHASES: readonly (readonly [RemeshPhase, number])[] = [
  ['border', 4],
  ['triangles', 1],
  ['singular', 3],
  ['field', 1],
  ['grid', 1],
  ['fit', 8],
];
const ALL = PHASES.reduce((sum, [, weight]) => sum + weight, 0);

/** @param done of the phase, 0 … 1. Returns the part of the whole. */
export function partDone(phase: RemeshPhase, done: number): number {
  const place = PHASES.findIndex(([each]) => each === phase);
  const before = PHASES.slice(0, place).reduce((sum, [, weight]) => sum + weight, 0);
  return (before + done * PHASES[place]![1]) / ALL;
}

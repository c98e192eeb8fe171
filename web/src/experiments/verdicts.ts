/** Whether the paper's claims hold, as the native program has measured it on our nets; verdicts.json is what it writes. */
import type { experiments } from '../language/en/experiments';
import file from './verdicts.json';

type Verdict = keyof typeof experiments.verdicts;
export type Unit = keyof typeof experiments.units;

export interface Finding {
  verdict: Verdict;
  /** True in so many of the edits asked. */
  held: number;
  asked: number;
  /** Numbers of the first edit, by index of the variant or one for all; null where there is no such number. */
  values: { variant?: number; value: number | null; unit: Unit }[];
}

const VERDICTS = file as unknown as { [figure: string]: { claims: Finding[] } | undefined };

/** The verdict on a claim, by its index in the figure; undefined: it was not measured. */
export function findingOf(figure: string, claim: number): Finding | undefined {
  return VERDICTS[figure]?.claims[claim];
}

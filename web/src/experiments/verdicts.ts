/** Whether the paper's claims hold, as the native program has measured it on our nets; verdicts.json is what it writes. */
import type { experiments } from '../language/en/experiments';
import file from './verdicts.json';

export type Verdict = keyof typeof experiments.verdicts;
export type Unit = keyof typeof experiments.units;

export interface Finding {
  verdict: Verdict;
  /** True in so many of the edits asked. */
  held: number;
  asked: number;
  /** Of the first edit: by the place of a variant, unless it is of all; null where there is no such number. */
  values: { variant?: number; value: number | null; unit: Unit }[];
}

const VERDICTS = file as unknown as { [figure: string]: { claims: Finding[] } | undefined };

/** Of a figure's claim by its place; undefined: it was not measured. */
export function findingOf(figure: string, claim: number): Finding | undefined {
  return VERDICTS[figure]?.claims[claim];
}

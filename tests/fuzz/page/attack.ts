/** Properties tried for a given time rather than a given number of times. */
import fc from 'fast-check';
import { test } from 'vitest';
import { printedSeed } from '../../web/random';

const SECONDS = Number(process.env['CHEBNET_FUZZ_SECONDS'] ?? 10);

/** Something that is to hold of whatever comes up. */
export interface Attack {
  /** Returns how many inputs were tried. */
  run: (seed: number, milliseconds: number) => number;
}

/** @param holds throws if it does not hold. */
export function attack<T>(input: fc.Arbitrary<T>, holds: (value: T) => void): Attack {
  return {
    run: (seed, milliseconds) => {
      let executions = 0;
      const trial = fc.property(input, (value) => {
        executions += 1;
        holds(value);
      });
      fc.assert(trial, { seed, numRuns: 1e9, interruptAfterTimeLimit: milliseconds, markInterruptAsFailure: false });
      return executions;
    },
  };
}

/** Shares the seconds of CHEBNET_FUZZ_SECONDS between the attacks of a file; prints how often each was made. */
export function attacks(title: string, list: Record<string, Attack>): void {
  const share = (1000 * SECONDS) / Object.keys(list).length;
  // What fails is made smaller after the time is over.
  const timeout = share + 300_000;
  test.each(Object.entries(list))('%s', { timeout }, (name, { run }) => {
    console.log(`executions: ${run(printedSeed(`${title}, ${name}`), share)}`);
  });
}

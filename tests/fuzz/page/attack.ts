/** Properties tried for a given time rather than a given number of times, after what has been kept of times before. */
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import fc from 'fast-check';
import { test } from 'vitest';
import { printedSeed } from '../../web/random';

const SECONDS = Number(process.env['CHEBNET_FUZZ_SECONDS'] ?? 10);
const CORPUS = join(import.meta.dirname, 'corpus');
const FOUND = resolve(import.meta.dirname, '../../../build/fuzz');

/** Something that is to hold of whatever comes up. */
export interface Attack {
  /** Returns how many inputs were tried. The smallest that breaks it is kept as a file of the folder, if it is raw. */
  run: (seed: number, milliseconds: number, folder: string) => number;
}

/** What a target is given from outside: text, or bytes. */
export interface Target {
  /** Of `corpus`: what once broke something, or reaches what little else does, a file each. */
  folder: string;
  /** Throws if it does not take what such a file holds. */
  holds: (bytes: Uint8Array) => void;
}

/** @param holds throws if it does not hold. */
export function attack<T>(input: fc.Arbitrary<T>, holds: (value: T) => void): Attack {
  return {
    run: (seed, milliseconds, folder) => {
      let executions = 0;
      let broken: T | undefined;
      const trial = fc.property(input, (value) => {
        executions += 1;
        try {
          holds(value);
        } catch (error) {
          broken = value;
          throw error;
        }
      });
      try {
        fc.assert(trial, { seed, numRuns: 1e9, interruptAfterTimeLimit: milliseconds, markInterruptAsFailure: false });
      } catch (error) {
        if (typeof broken === 'string' || broken instanceof Uint8Array) keep(folder, broken);
        throw error;
      }
      return executions;
    },
  };
}

/** Beside what the other fuzzers find; into the corpus it is put by hand, with a name. */
function keep(folder: string, input: string | Uint8Array): void {
  const name = createHash('sha1').update(input).digest('hex');
  mkdirSync(join(FOUND, folder), { recursive: true });
  writeFileSync(join(FOUND, folder, `crash-${name}`), input);
}

/** By name. */
function keptFiles(folder: string): string[] {
  const place = join(CORPUS, folder);
  return existsSync(place) ? readdirSync(place) : [];
}

/** Gives the target what was kept, and shares the seconds of CHEBNET_FUZZ_SECONDS between the attacks of a file; prints how
 *  often each was made. */
export function attacks(title: string, { folder, holds }: Target, list: Record<string, Attack>): void {
  const kept = keptFiles(folder);
  test.each(kept)('%s', (name) => holds(new Uint8Array(readFileSync(join(CORPUS, folder, name)))));
  console.log(`executions: ${kept.length}`);

  const share = (1000 * SECONDS) / Object.keys(list).length;
  // What fails is made smaller after the time is over.
  const timeout = share + 300_000;
  test.each(Object.entries(list))('%s', { timeout }, (name, { run }) => {
    console.log(`executions: ${run(printedSeed(`${title}, ${name}`), share, folder)}`);
  });
}

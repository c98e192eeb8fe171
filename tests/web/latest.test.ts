/** What is wanted faster than it can be done. */
import { beforeEach, expect, test } from 'vitest';
import { latestOnly } from '../../web/src/app/latest';
import { Failure } from '../../web/src/failure';

let begun: string[];
let failed: unknown[];
let end: { well(): void; badly(code: string): void };
let want: (wanted: string) => Promise<void>;

const afterwards = () => new Promise((resolve) => setTimeout(resolve));

beforeEach(() => {
  [begun, failed] = [[], []];
  const doing = (wanted: string) => {
    begun.push(wanted);
    return new Promise<void>((resolve, reject) => {
      end = { well: resolve, badly: (code) => reject(new Failure(code, wanted)) };
    });
  };
  want = latestOnly(doing, (error) => failed.push(error));
});

test('of what is wanted while something is done only the last is done, and all hear of the end of that', async () => {
  const ended: string[] = [];
  for (const each of ['a', 'b', 'c']) void want(each).then(() => ended.push(each));
  expect(begun).toEqual(['a']);
  end.well();
  await afterwards();
  expect(begun).toEqual(['a', 'c']);
  expect(ended).toEqual([]);
  end.well();
  await afterwards();
  expect(ended).toEqual(['a', 'b', 'c']);
  void want('d');
  expect(begun).toEqual(['a', 'c', 'd']);
});

test('what is refused is reported, and the next is done; what is cancelled takes that along', async () => {
  void want('a');
  void want('b');
  end.badly('too_large');
  await afterwards();
  expect(failed).toHaveLength(1);
  expect(begun).toEqual(['a', 'b']);
  void want('c');
  end.badly('cancelled');
  await afterwards();
  expect(begun).toEqual(['a', 'b']);
});

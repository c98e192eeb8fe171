/** The paper's figures: the description, what the native program says of them, the page's list and the README name the same. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import description from '../../web/src/experiments/figures.json';
import recorded from '../../web/src/experiments/verdicts.json';
import { ROOT } from '../wasm/load';

interface Recorded {
  claims: { verdict: string; held: number; asked: number; values: unknown[] }[];
}

const read = (path: string) => readFileSync(new URL(path, ROOT), 'utf8');
const verdicts = recorded as unknown as Record<string, Recorded>;
const { figures } = description;
const place = (figure: number | null) => (figure === null ? 'Section 4' : `Figure ${figure}`);

/** Those that show the method at work, and what it is to spare; 1 shows what others have made. */
const OF_THE_PAPER = [2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21];

test('each figure of the paper is there once', () => {
  expect(figures.flatMap(({ figure }) => figure ?? [])).toEqual(OF_THE_PAPER);
});

test('the native program lists the same figures', () => {
  const program = fileURLToPath(new URL('build/native/chebnet_experiments', ROOT));
  const listed = execFileSync(program, ['--list'], { encoding: 'utf8' }).trim().split('\n');
  expect(listed).toEqual(figures.map(({ name, figure, title }) => `${name}  ${place(figure)}: ${title.en}`));
});

test('each claim has a verdict, and the table that the README links says the same', () => {
  const rows = read('tests/bench/FIGURES.md')
    .split('\n')
    .filter((line) => /^\| (Figure|Section)/.test(line));
  const expected = figures.flatMap(({ name, figure, claims }) =>
    claims.map(({ text }, i) => {
      const { verdict, held, asked } = verdicts[name]!.claims[i]!;
      return `| ${place(figure)} | ${text.en} | **${verdict}** | ${held} of ${asked} |`;
    }),
  );
  expect(rows.map((row) => `${row.split(' | ').slice(0, 4).join(' | ')} |`)).toEqual(expected);
  expect(Object.keys(verdicts)).toEqual(figures.map(({ name }) => name));
  expect(read('README.md')).toContain('](tests/bench/FIGURES.md)');
});

test('verdicts follow from how many edits bear a claim out', () => {
  for (const { claims } of Object.values(verdicts))
    for (const { verdict, held, asked } of claims)
      expect(verdict).toBe(held === asked ? 'holds' : held === 0 ? 'does not hold' : 'differs');
});

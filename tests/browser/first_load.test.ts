/** What a first visitor waits for: every byte that crosses the network until the first net can be dragged. */
import { readFileSync } from 'node:fs';
import { relative } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { distance, dragBy } from './geometry';
import { DIST, visits } from './page';

/** Page, styles, scripts, worker and module together, as a server sends them that compresses. */
const MOST_BYTES = 350_000;

const { arrive, served } = visits();

function compressed(file: string): number {
  return gzipSync(readFileSync(file), { level: 9 }).length;
}

/** A slow machine may have asked for what comes after the first net before the test asks what came. */
function beforeLateSections(files: readonly string[]): readonly string[] {
  const first = files.findIndex((file) => file.includes('late_sections'));
  return first < 0 ? files : files.slice(0, first);
}

test.each([
  ['en', 'zh'],
  ['zh-CN', 'en'],
])('in %s the first net is dragged after less than 350 kB, without the words of %s', async (locale, other) => {
  const before = served().length;
  const { script } = await arrive('', { locale });
  const files = beforeLateSections(served().slice(before));
  const { vertex } = (await script.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const from = await script.position(vertex);
  await dragBy(script, vertex, [-60, -40]);
  await script.settled();
  expect(distance(await script.position(vertex), from)).toBeGreaterThan(0);

  const sizes = files.map((file) => [relative(DIST, file), compressed(file)] as const).sort(([, a], [, b]) => b - a);
  const sum = sizes.reduce((all, [, size]) => all + size, 0);
  console.log([...sizes, ['all', sum]].map(([name, size]) => `${String(size).padStart(8)}  ${name}`).join('\n'));
  for (const kind of ['html', 'css', 'js', 'wasm'])
    expect(sizes.some(([name]) => name.endsWith(`.${kind}`))).toBe(true);
  expect(sum).toBeLessThan(MOST_BYTES);
  expect(sizes.filter(([name]) => name.startsWith(`assets/${other}-`))).toEqual([]);
});

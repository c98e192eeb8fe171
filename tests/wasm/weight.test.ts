/** What the modules weigh is written down as it is. */
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { ROOT } from './load';

const readme = readFileSync(new URL('wasm/README.md', ROOT), 'utf8');

test.each(['chebnet_editor', 'chebnet_core'])('%s weighs what wasm/README.md says, within a twentieth', (module) => {
  const row = new RegExp(`^\\| \`${module}\` \\|.*\\| (\\d+) \\| (\\d+) \\|$`, 'm').exec(readme);
  const [raw, compressed] = (row ?? []).slice(1).map(Number);
  const bytes = readFileSync(new URL(`build/wasm/${module}.wasm`, ROOT));
  const differs = (said: number | undefined, is: number) => Math.abs((said ?? 0) * 1000 - is) / is;
  expect(differs(raw, bytes.length)).toBeLessThan(0.05);
  expect(differs(compressed, gzipSync(bytes).length)).toBeLessThan(0.05);
});

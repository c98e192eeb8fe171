/** The script that wasm/README.md has for Node runs as it stands there. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { ROOT } from './load';

test('the script of wasm/README.md pulls a net', () => {
  const script = /```js\n(.*?)```/s.exec(readFileSync(new URL('wasm/README.md', ROOT), 'utf8'))?.[1];
  const said = execFileSync('node', ['--input-type=module', '-e', script ?? ''], {
    cwd: fileURLToPath(ROOT),
    encoding: 'utf8',
  });
  expect(said).toMatch(/^converged /);
});

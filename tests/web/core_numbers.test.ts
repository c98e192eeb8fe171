/** Numbers of the core that JavaScript repeats. */
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

const ROOT = new URL('../../', import.meta.url);

/** What the first group finds in a file. */
function found(path: string, pattern: RegExp): string {
  const match = pattern.exec(readFileSync(new URL(path, ROOT), 'utf8'));
  if (match?.[1] === undefined) throw new Error(`${path} has no ${pattern}`);
  return match[1];
}

test('the usual limit of corners is that of the core', () => {
  const degrees = Number(found('core/base/angle.h', /k_usual_limit_degrees = (\d+),/));
  expect(degrees).toBe(180 / Number(found('wasm/facade.js', /^const SHEAR_LIMIT = Math\.PI \/ (\d+);/m)));
  expect(degrees).toBe(Number(found('web/src/fields/fields.ts', /^const USUAL_CORNER_LIMIT = (\d+);/m)));
});

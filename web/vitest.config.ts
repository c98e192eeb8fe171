import { defineConfig } from 'vitest/config';

const tests = (folder: string, timeout: number) => ({
  extends: './vite.config.ts',
  // The tests lie outside this folder; their packages come from it all the same.
  resolve: {
    dedupe: ['fast-check', 'fflate', 'idb-keyval', 'playwright-core', 'puppeteer-core', 'rhino3dm', 'three', 'vite'],
  },
  test: {
    name: folder,
    dir: `../tests/${folder}`,
    include: ['**/*.test.ts'],
    environment: 'node',
    // What drives a browser keeps nothing between files, and takes seconds to import anew for each.
    isolate: folder !== 'browser' && folder !== 'engines',
    testTimeout: timeout,
    hookTimeout: timeout,
    // What is waited for comes late on a machine that others use too.
    expect: { poll: { timeout: timeout / 3 } },
  },
});

/** The same tests in another browser. */
function engine(name: 'chromium' | 'firefox' | 'webkit') {
  const project = tests('engines', 240_000);
  return { ...project, test: { ...project.test, name: `engines ${name}`, env: { CHEBNET_ENGINE: name } } };
}

/** Run by tests/fuzz/run. */
const fuzz = tests('fuzz', 20_000);

export default defineConfig({
  test: {
    projects: [
      tests('wasm', 120_000),
      tests('web', 20_000),
      tests('browser', 120_000),
      engine('chromium'),
      engine('firefox'),
      engine('webkit'),
      fuzz,
    ],
  },
});

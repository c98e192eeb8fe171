import { defineConfig } from 'vitest/config';

const tests = (folder: string, timeout: number) => ({
  extends: './vite.config.ts',
  // The tests lie outside this folder; their packages come from it all the same.
  resolve: { dedupe: ['fflate', 'playwright-core', 'rhino3dm', 'three', 'vite'] },
  test: {
    name: folder,
    dir: `../tests/${folder}`,
    include: ['**/*.test.ts'],
    environment: 'node',
    testTimeout: timeout,
    hookTimeout: timeout,
    // What is waited for comes late on a machine that others use too.
    expect: { poll: { timeout: timeout / 6 } },
  },
});

export default defineConfig({
  test: {
    projects: [tests('wasm', 120_000), tests('web', 20_000), tests('browser', 120_000)],
  },
});

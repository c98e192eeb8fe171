/** The page says whose work it contains: each library in its scripts and modules, with its licence. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Rolldown } from 'vite';
import { build } from 'vite';
import { beforeAll, expect, test } from 'vitest';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));

let files: Rolldown.RolldownOutput['output'];
let licences: string;
beforeAll(async () => {
  const root = `${ROOT}web`;
  const built = (await build({
    root,
    logLevel: 'error',
    build: { write: false, sourcemap: true },
  })) as Rolldown.RolldownOutput;
  files = built.output;
  const file = files.find(({ fileName }) => fileName === 'licences.txt');
  licences = file?.type === 'asset' ? String(file.source) : '';
});

/** Of one library, from the line with its name to the next. */
function licenceOf(name: string): string {
  const texts = licences.split(/^=+\n(?=.+\n=+\n)/m);
  return texts.find((text) => text.startsWith(name) && /^[\n ]/.test(text.slice(name.length))) ?? '';
}

/** The files that the built scripts, also those of workers, were made of. */
function sources(): string[] {
  const maps = files.flatMap((file) =>
    file.type === 'asset' && file.fileName.endsWith('.map') ? [String(file.source)] : [],
  );
  return maps.flatMap((map) => (JSON.parse(map) as { sources: string[] }).sources);
}

test('chebnet comes first, under the licence of the repository', () => {
  expect(licenceOf('chebnet')).toContain('Permission is hereby granted, free of charge');
  expect(licences.indexOf('\nchebnet\n')).toBeLessThan(licences.indexOf('\nthree '));
});

test('each package in a built script has its licence in the file', () => {
  const packages = new Set(
    sources().flatMap((path) => /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1] ?? []),
  );
  expect([...packages]).toEqual(expect.arrayContaining(['three', 'fflate', 'idb-keyval', 'rhino3dm']));
  for (const name of packages) expect(licenceOf(name), name).toMatch(/copyright/i);
});

test('so has what is in the page in another shape: colours, helpers of the build, libraries inside rhino3dm', () => {
  expect(licenceOf('d3-scale-chromatic')).toContain('Cynthia Brewer');
  expect(licenceOf('vite')).toContain('Vite contributors');
  for (const name of ['openNURBS', 'Draco', 'zlib', 'libuuid']) expect(licenceOf('rhino3dm')).toContain(`\n${name}\n`);
});

/** Where the compiler of the modules finds headers, and whose they are. */
const HEADERS: readonly (readonly [place: RegExp, library: string])[] = [
  [/\/eigen3\//, 'Eigen'],
  [/\/fast_float\//, 'fast_float'],
  [/\/include\/c\+\+\/v1\//, 'LLVM'],
  [/\/clang\/[\d.]+\/include\//, 'LLVM'],
  [/\/include\/emscripten\//, 'Emscripten'],
  [/\/sysroot\/include\//, 'musl'],
];

test('each library that the modules are compiled with has its licence in the file', () => {
  const log = execFileSync('ninja', ['-C', `${ROOT}build/wasm`, '-t', 'deps'], { encoding: 'utf8', maxBuffer: 1e8 });
  const paths = [...new Set(log.split('\n').filter((line) => line.startsWith('    ')))].map((line) => line.trim());
  const foreign = paths.filter(
    (path) => (path.startsWith('/') && !path.startsWith(ROOT)) || path.includes('fast_float'),
  );
  const libraries = new Set(foreign.map((path) => HEADERS.find(([place]) => place.test(path))?.[1] ?? path));
  expect([...libraries].sort()).toEqual(['Eigen', 'Emscripten', 'LLVM', 'fast_float', 'musl']);
  for (const name of libraries) expect(licenceOf(name), name).toMatch(/copyright/i);
});

test('whoever passes Eigen on says where its source is', () => {
  expect(licenceOf('Eigen')).toContain('Mozilla Public License');
  expect(licenceOf('Eigen')).toMatch(/source is unmodified .* https:\/\//);
});

test('the list of dependencies marks the packages that the page contains', () => {
  const marked = [...readFileSync(`${ROOT}DEPENDENCIES.md`, 'utf8').matchAll(/^\| (\S+) \| (\S+) \| \* /gm)].map(
    ([, name, version]) => `${name} ${version}`,
  );
  const contained = [...licences.matchAll(/^=+\n(\S+ [\d.]+) \(.*\)\n=+$/gm)].map(([, title]) => title);
  expect(marked.filter((each) => contained.includes(each)).sort()).toEqual(contained);
});

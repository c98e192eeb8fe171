/** Imports of the page and includes of the core go down: no circle of files, and no arrow from a room to one above it. What
 *  JavaScript has of the core, wasm/, stands below the page and above the core. What a file of the core needs, it includes, and what
 *  one of the page exports, another one uses. */
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { ROOT } from '../wasm/load';

/** Of each file those that it imports, by their paths. */
type Imports = Map<string, string[]>;

/** Rooms from the ground up; a file beside them is a room of its own. Those of the page are read from its floor plan. */
const PAGE = readFileSync(new URL('web/README.md', ROOT), 'utf8')
  .split('```')[1]!
  .trim()
  .split('\n')
  .map((line) => line.split(' ')[0]!);
const CORE = [
  'base',
  'net',
  'change',
  'energy',
  'linear',
  'surface',
  'io',
  'fabricate',
  'solve',
  'shapes',
  'edit',
  'drape',
  'remesh',
  'wasm',
  'cli',
];

describe.each([
  ['the page', PAGE, readImports()],
  ['the core', CORE, readIncludes()],
])('%s', (_, rooms, imports) => {
  test('has no room that is not listed', () => {
    const found = new Set([...imports.keys()].map(roomOf));
    expect([...found].filter((room) => !room.endsWith('.d.ts')).sort()).toEqual([...rooms].sort());
  });

  test('has no file that imports itself by way of others', () => {
    const done = new Set<string>();
    const visit = (file: string, path: string[]): void => {
      if (path.includes(file)) throw new Error(`a circle: ${[...path.slice(path.indexOf(file)), file].join(' -> ')}`);
      if (done.has(file)) return;
      for (const next of imports.get(file) ?? []) visit(next, [...path, file]);
      done.add(file);
    };
    for (const file of imports.keys()) visit(file, []);
    expect(done.size).toBe(imports.size);
  });

  test('imports go down', () => {
    const level = (file: string) => rooms.indexOf(roomOf(file));
    const all = [...imports].flatMap(([file, others]) => others.map((next) => ({ file, next })));
    expect(all.length).toBeGreaterThan(imports.size);
    expect(all.filter(({ file, next }) => level(next) > level(file))).toEqual([]);
  });
});

test('what a file of the page exports, another one uses', () => {
  const root = fileURLToPath(ROOT);
  const folders = ['web/src', 'web', 'tests/web', 'tests/browser', 'tests/engines', 'tests/wasm'];
  const sources = folders.flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: folder === 'web/src', encoding: 'utf8' })
      .filter((file) => file.endsWith('.ts'))
      .map((file) => ({ file: join(folder, file), text: readFileSync(join(root, folder, file), 'utf8') })),
  );
  const users = new Map<string, Set<string>>();
  for (const { file, text } of sources)
    for (const [name] of text.replace(/\/\*[\s\S]*?\*\//g, '').matchAll(/[\w$]+/g))
      users.set(name, (users.get(name) ?? new Set()).add(file));
  const exported = sources
    .filter(({ file }) => file.startsWith('web/src/'))
    .flatMap(({ file, text }) =>
      [...text.matchAll(/^export (?:async )?(?:interface|type|class|const|let|function\*?) ([\w$]+)/gm)].map(
        ([, name]) => ({ file, name: name! }),
      ),
    );
  expect(exported.length).toBeGreaterThan(500);
  expect(exported.filter(({ name }) => users.get(name)!.size === 1)).toEqual([]);
});

// Eigen is precompiled for the library, and with it half of the standard one.
test('what comes without Eigen includes all that it needs', { timeout: 240_000 }, () => {
  const root = fileURLToPath(ROOT);
  const includes = readIncludes();
  const comesWithEigen = (file: string): boolean =>
    /^#include <(Eigen|emscripten)\//m.test(readFileSync(join(root, file), 'utf8')) ||
    includes.get(file)!.some(comesWithEigen);
  const others = [...includes.keys()].filter((file) => roomOf(file) !== 'cli' && !comesWithEigen(file));
  expect(others).toContain('core/base/error.h');
  const compiler = process.env['CXX'] ?? 'c++';
  const { stderr, status } = spawnSync(compiler, ['-fsyntax-only', '-std=c++20', '-w', '-Icore', '-xc++', ...others], {
    cwd: root,
    encoding: 'utf8',
  });
  expect({ stderr, status }).toEqual({ stderr: '', status: 0 });
});

function roomOf(file: string): string {
  return file.replace(/^(core|web\/src)\//, '').split('/')[0]!;
}

/** Of each source of the page those that it imports: at once, by import(), or as a worker. */
function readImports(): Imports {
  const FORMS =
    /^(?:import|export)\s[^'"]*?'(\.[^']+)'|^import '(\.[^']+)'|import\('(\.[^']+)'\)|new URL\('(\.[^']+)'/gm;
  return readFiles(['web/src', 'wasm'], /\.m?[jt]s$/, (file, text) =>
    [...text.matchAll(FORMS)].map(([, ...found]) => {
      const path = join(dirname(file), found.find((each) => each !== undefined)!);
      return [path, `${path}.ts`, `${path}.d.ts`];
    }),
  );
}

/** Of each source of the core the headers that it includes: by their path in core, or from beside it. */
function readIncludes(): Imports {
  return readFiles(['core', 'wasm'], /\.(h|cpp)$/, (file, text) =>
    [...text.matchAll(/^#include "([^"]+)"/gm)].map(([, path]) => [join('core', path!), join(dirname(file), path!)]),
  );
}

/** @param find of a file the paths that each of its imports may have; the first that is there counts. */
function readFiles(folders: string[], names: RegExp, find: (file: string, text: string) => string[][]): Imports {
  const root = fileURLToPath(ROOT);
  const files = folders.flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((file) => names.test(file))
      .map((file) => join(folder, file)),
  );
  const known = new Set(files);
  const importsOf = (file: string) => {
    const text = readFileSync(join(root, file), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
    return find(file, text).flatMap((paths) => paths.filter((path) => known.has(path)).slice(0, 1));
  };
  return new Map(files.map((file) => [file, [...new Set(importsOf(file))]]));
}

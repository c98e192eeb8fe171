/** Imports of the page and includes of the core go down: no circle of files, and no arrow from a room to one above it; what
 *  a file of the core needs, it includes. */
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { ROOT } from '../wasm/load';

/** Of each file those that it imports, by their paths in the folder. */
type Imports = Map<string, string[]>;

/** Rooms from the ground up. A file beside them is a room of its own. */
const PAGE = [
  // What any of them may lean on.
  ...['failure.ts', 'net', 'language', 'fields', 'lazy.ts', 'elements', 'document'],
  // What is done with a net.
  ...[
    'worker',
    'files',
    'equalize',
    'handles',
    'change',
    'offline',
    'view',
    'drape',
    'export',
    'compare',
    'experiments',
  ],
  // The controls: their contract with the page, and where they stand.
  ...['panels.ts', 'overlay', 'dialogs', 'comparison', 'sidebar'],
  // The page.
  ...[
    'app',
    'keys.ts',
    'learn',
    'projects',
    'script_arguments.ts',
    'surface_script.ts',
    'scripting.ts',
    'embed',
    'main.ts',
  ],
];
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

// Eigen is precompiled for the library, and with it half of the standard one.
test('what comes without Eigen includes all that it needs', { timeout: 240_000 }, () => {
  const root = fileURLToPath(new URL('core', ROOT));
  const includes = readIncludes();
  const comesWithEigen = (file: string): boolean =>
    /^#include <Eigen\//m.test(readFileSync(join(root, file), 'utf8')) || includes.get(file)!.some(comesWithEigen);
  const others = [...includes.keys()].filter((file) => roomOf(file) !== 'cli' && !comesWithEigen(file));
  expect(others).toContain('base/error.h');
  const compiler = process.env['CXX'] ?? 'c++';
  const { stderr, status } = spawnSync(compiler, ['-fsyntax-only', '-std=c++20', '-w', '-I.', '-xc++', ...others], {
    cwd: root,
    encoding: 'utf8',
  });
  expect({ stderr, status }).toEqual({ stderr: '', status: 0 });
});

function roomOf(file: string): string {
  return file.split('/')[0]!;
}

/** Of each source of the page those that it imports when it is loaded; what it loads later, by import(), is another matter. */
function readImports(): Imports {
  return readFiles('web/src', /\.ts$/, (file, text) => {
    const found = [...text.matchAll(/^(?:import|export)\s[^'"]*?'(\.[^']+)'|^import '(\.[^']+)'/gm)];
    const paths = found.map(([, from, alone]) => relative('.', join(dirname(file), (from ?? alone)!)));
    return paths.map((path) => [`${path}.ts`, path]);
  });
}

/** Of each source of the core the headers that it includes: by their path in core, or from beside it. */
function readIncludes(): Imports {
  return readFiles('core', /\.(h|cpp)$/, (file, text) =>
    [...text.matchAll(/^#include "([^"]+)"/gm)].map(([, path]) => [path!, join(dirname(file), path!)]),
  );
}

/** @param find of a file the paths that each of its imports may have; the first that is there counts. */
function readFiles(folder: string, names: RegExp, find: (file: string, text: string) => string[][]): Imports {
  const root = fileURLToPath(new URL(folder, ROOT));
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter((file) => names.test(file));
  const known = new Set(files);
  const importsOf = (file: string) => {
    const text = readFileSync(join(root, file), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
    return find(file, text).flatMap((paths) => paths.filter((path) => known.has(path)).slice(0, 1));
  };
  return new Map(files.map((file) => [file, [...new Set(importsOf(file))]]));
}

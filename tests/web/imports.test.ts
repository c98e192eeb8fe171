/** Imports of the page go down: no circle of files, and no arrow from a room to one above it. */
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { ROOT } from '../wasm/load';

const SOURCES = fileURLToPath(new URL('web/src', ROOT));

/** From the ground up. A file beside the rooms is a room of its own. */
const ROOMS = [
  // What any of them may lean on.
  ...['failure.ts', 'net', 'language', 'fields', 'lazy.ts', 'elements', 'document'],
  // What is done with a net.
  ...['worker', 'files', 'equalize', 'handles', 'offline', 'view', 'export', 'compare', 'experiments'],
  // The controls: their contract with the page, and where they stand.
  ...['panels.ts', 'overlay', 'dialogs', 'comparison', 'sidebar'],
  // The page.
  ...['app', 'keys.ts', 'learn', 'projects', 'scripting.ts', 'embed', 'main.ts'],
];

const imports = readImports();

test('the page has no room that is not listed', () => {
  const rooms = new Set([...imports.keys()].map(roomOf));
  expect([...rooms].filter((room) => !ROOMS.includes(room) && !room.endsWith('.d.ts'))).toEqual([]);
});

test('no file imports itself by way of others', () => {
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
  const level = (file: string) => ROOMS.indexOf(roomOf(file));
  const up = [...imports].flatMap(([file, all]) =>
    all.filter((next) => level(next) > level(file)).map((next) => `${file} -> ${next}`),
  );
  expect(up).toEqual([]);
});

function roomOf(file: string): string {
  return file.split('/')[0]!;
}

/** Of each source the sources that it imports when it is loaded; what it loads later, by import(), is another matter. */
function readImports(): Map<string, string[]> {
  const files = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.ts'));
  const known = new Set(files);
  const of = (file: string) => {
    const text = readFileSync(join(SOURCES, file), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
    const found = [...text.matchAll(/^(?:import|export)\s[^'"]*?'(\.[^']+)'|^import '(\.[^']+)'/gm)];
    const paths = found.map(([, from, alone]) => relative('.', join(dirname(file), (from ?? alone)!)));
    return paths.flatMap((path) => [`${path}.ts`, path].filter((each) => known.has(each)).slice(0, 1));
  };
  return new Map(files.map((file) => [file, [...new Set(of(file))]]));
}

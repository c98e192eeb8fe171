/** CONTRIBUTING.md tells the truth: the files of its recipes are those in which their examples are named. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { ROOT } from '../wasm/load';

const root = fileURLToPath(ROOT);

/** How the example of a recipe is named in sources, as a whole word or in some form of it. */
const NAMED: Record<string, RegExp> = {
  'A method': /\b(k_)?gradient_descent\b/,
  'A shape': /\bk_saddle\b|^ {2}saddle: ['{]/m,
  'A file format': /\bk_off\b|"io\/off\.h"|^ {2}off: '/m,
  'A colour field': /\{"angle", |^ {2}angle: Float32Array;$|^ {2}angle: \{$|^ {4}angle: \{ choice/m,
  'A panel of the sidebar': /\bDragPanel\b|^ {4}drag: '(Dragging|拖动)'/m,
  'A force': /class GravityTerm|GravityTerm::GravityTerm/,
  'Another version of the link format': /\bsecond: Reader\b|\breadNumbering\b/,
};

const recipes = readRecipes();
const sources = ['core', 'wasm', 'web/src']
  .flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' }).map((file) => `${folder}/${file}`),
  )
  .filter((file) => /\.(cpp|h|ts|js|cmake)$|CMakeLists\.txt$/.test(file));

test('has a recipe for each of these', () => {
  expect([...recipes.keys()]).toEqual(expect.arrayContaining(Object.keys(NAMED)));
});

test.each(Object.entries(NAMED))('%s is in the files that its recipe lists, and in no others', (title, name) => {
  const found = sources.filter((file) => name.test(readFileSync(join(root, file), 'utf8')));
  expect(
    recipes
      .get(title)!
      .filter((file) => sources.includes(file))
      .sort(),
  ).toEqual(found.sort());
});

test('every file that a recipe lists is there', () => {
  for (const file of [...recipes.values()].flat()) expect(() => readFileSync(join(root, file))).not.toThrow();
});

/** Below each heading `### A method, such as …` the files that its numbered lines begin with. */
function readRecipes(): Map<string, string[]> {
  const [, ...sections] = readFileSync(join(root, 'CONTRIBUTING.md'), 'utf8').split(/^### /m);
  return new Map(
    sections.map((section) => {
      const files = [...section.matchAll(/^\d+\. `([^`]+)`/gm)].map(([, file]) => file!);
      return [section.slice(0, section.search(/,|\n/)), files];
    }),
  );
}

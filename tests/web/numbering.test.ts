/** How nets are numbered stays as it is for ever; and if it did not, nothing would be shown on wrong vertices. */
import { readFileSync } from 'node:fs';
import { beforeEach, describe, expect, test } from 'vitest';
import type { Editor, Editors } from '../../wasm/chebnet';
import { freshScene } from '../../web/src/document/defaults';
import { numberingOf } from '../../web/src/document/numbering';
import { parseProject } from '../../web/src/document/project';
import { objText } from '../../web/src/document/obj_text';
import { core as chinese } from '../../web/src/language/zh/core';
import { sceneOf } from '../../web/src/projects/link';
import { load, loadFirst, ROOT } from '../wasm/load';
import { goldens, isMaking, readData, writeData } from './golden_files';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

interface Pinned {
  vertices: number;
  numbering: number;
  /** Where the vertices rest, taken together: packed positions are how far they stand from there. */
  rest: number[];
}

const [first, core] = await Promise.all([loadFirst(), load()]);

/** Every shape as it comes, and with each parameter at both its ends. */
const RECIPES = core.shapes().flatMap(({ name, parameters }) => {
  const others = parameters.filter((parameter) => parameter.name !== 'vertices');
  const ends = others.flatMap((each) =>
    [each.smallest, each.largest].map((value) => `${name}:vertices=300,${each.name}=${value}`),
  );
  return [name, `${name}:vertices=150`, ...ends];
});
const FILES = [
  'obj/blender.obj',
  'obj/meshlab.obj',
  'obj/rhino.obj',
  'ply/blender.ply',
  'ply/meshlab.ply',
  'ply/scanner.ply',
  'off/geomview.off',
  'off/meshlab.off',
];

/** As the page opens a file: by way of the text that links and projects carry. */
function openFile(path: string): Editor {
  const mesh = core.readMesh(readFileSync(new URL(`tests/data/${path}`, ROOT)), path);
  return core.openObj(objText(core.repairMesh(mesh).mesh), path);
}

function pinned({ info, edges, faceStart, faceVertices, restPositions }: Editor): Pinned {
  const rest = [0, 0, 0];
  restPositions.forEach((x, i) => (rest[i % 3]! += ((1 + (i % 7)) * x) / info.vertices));
  return { vertices: info.vertices, numbering: numberingOf({ edges, faceStart, faceVertices }), rest };
}

describe('is what it was', () => {
  const file = 'numbering.json';
  const expected = readData(file) as Record<string, Pinned>;
  if (isMaking) {
    for (const recipe of RECIPES) expected[recipe] ??= pinned(core.openRecipe(recipe));
    for (const path of FILES) expected[path] ??= pinned(openFile(path));
    writeData(file, expected);
  }
  const check = (editor: Editor, { vertices, numbering, rest }: Pinned) => {
    const found = pinned(editor);
    expect(found).toMatchObject({ vertices, numbering });
    found.rest.forEach((x, axis) => expect(x).toBeCloseTo(rest[axis]!, 9));
    editor.dispose();
  };

  test.each(Object.entries(expected).filter(([name]) => !FILES.includes(name)))('%s', (recipe, each) =>
    check(core.openRecipe(recipe), each),
  );
  test.each(FILES)('%s', (path) => check(openFile(path), expected[path]!));

  test('of every shape', () => expect(RECIPES.filter((recipe) => expected[recipe] === undefined)).toEqual([]));

  test.each(first.shapes().map(({ name }) => name))('for %s also in the core that comes first', (name) => {
    const recipe = `${name}:vertices=150`;
    try {
      check(first.openRecipe(recipe), expected[recipe]!);
    } catch (error) {
      expect(error).toMatchObject({ code: 'left_out' });
    }
  });
});

test('tells edges and faces in another order or direction, and vertices by other numbers', () => {
  const net = core.openRecipe('steps:vertices=150');
  const { edges, faceStart, faceVertices } = net;
  const swapped = (numbers: Int32Array, i: number, j: number) => {
    const copy = numbers.slice();
    [copy[i], copy[j]] = [numbers[j]!, numbers[i]!];
    return copy;
  };
  const all = [{ edges, faceStart, faceVertices }];
  for (let e = 0; e < edges.length; ++e)
    all.push({ edges: swapped(edges, e, (e + 1) % edges.length), faceStart, faceVertices });
  for (let k = 0; k < faceVertices.length; ++k)
    all.push({ edges, faceStart, faceVertices: swapped(faceVertices, k, (k + 1) % faceVertices.length) });
  for (let v = 1; v < net.info.vertices; ++v) {
    const relabelled = (numbers: Int32Array) => numbers.map((each) => (each === v ? v - 1 : each === v - 1 ? v : each));
    all.push({ edges: relabelled(edges), faceStart, faceVertices: relabelled(faceVertices) });
  }
  // Some have changed places with their equals.
  const different = new Set(all.map((each) => JSON.stringify(Object.values(each).map((numbers) => [...numbers]))));
  expect(new Set(all.map(numberingOf)).size).toBe(different.size);
});

describe('when a core numbers the edges of domes the other way round,', () => {
  const other: Editors = {
    ...core,
    openRecipe: (recipe) => {
      const editor = core.openRecipe(recipe);
      return recipe.startsWith('dome') ? Object.assign(editor, { edges: editor.edges.slice().reverse() }) : editor;
    },
  };
  const golden = (kind: 'link' | 'chebnet.json', name: string) =>
    goldens(kind).find((each) => each.name === name)!.text;
  const REFUSAL = expect.objectContaining({
    code: 'other_numbering',
    message: expect.stringMatching(/numbered otherwise/),
  });

  let page: Page;
  beforeEach(async () => {
    page = await openPage(other);
    await page.app.openScene(freshScene({ recipe: 'vault:vertices=100' }));
    await page.solve();
  });

  test('a link to one is refused, and the net before stays', async () => {
    const before = page.app.opening;
    await expect(page.app.openScene(await sceneOf(golden('link', 'v2/shape-dome')))).rejects.toEqual(REFUSAL);
    expect(page.app.opening).toBe(before);
    await page.app.openScene(await sceneOf(golden('link', 'v2/shape-vault')));
    expect(page.app.opening!.net.info.vertices).toBe(117);
  });

  test('what a link of the first version packed comes out wrong: it cannot tell', async () => {
    const { positions, ...scene } = await sceneOf(golden('link', 'v1/shape-dome'));
    await page.app.openScene({ ...scene, positions, settled: true });
    expect(page.app.opening!.frame.maxDeviation).toBeGreaterThan(1e-3);
  });

  test('a project is refused once it comes to one', async () => {
    const project = parseProject(golden('chebnet.json', 'v2/lesson'));
    await page.app.openProject(project);
    const vault = page.app.opening;
    page.app.goTo(0);
    await page.solve();
    expect(page.said).toContainEqual(expect.stringMatching(/numbered otherwise/));
    expect(page.app.opening!.net).toBe(vault!.net);
    expect(page.app.history.present).toBe(project.present);
    await expect(page.app.openProject({ ...project, present: 0 })).rejects.toEqual(REFUSAL);
  });

  test('it is said in Chinese too', () => {
    expect(chinese.failure('other_numbering', 'numbered otherwise')).toMatch(/编号/);
  });
});

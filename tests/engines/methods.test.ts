/** Handles, methods, plots and comparisons, in each engine. */
import { beforeEach, expect, test, vi } from 'vitest';
import { largestError } from '../browser/geometry';
import { load } from '../wasm/load';
import type { Visitor } from './visitor';
import { PATIENCE, visitors } from './visitor';

const SHAPE = 'vault:vertices=300';

const chebnet = await load();
const reference = chebnet.openRecipe(SHAPE);
const { restPositions, suggestedHandles } = reference;
const { meanLength } = reference.info;
const dragged = suggestedHandles.at(-1)!;
const placeOf = (vertex: number) =>
  Array.from(restPositions.subarray(3 * vertex, 3 * vertex + 3)) as [number, number, number];
const [x, y, z] = placeOf(dragged);
const TARGET: [number, number, number] = [x - 0.5, y + 0.3, z - 0.3];

const { share } = visitors();
let visitor: Visitor;
beforeEach(async () => {
  visitor = await share();
});

/** Colours of a canvas of the page, counted. */
const coloursOf = (selector: string) =>
  visitor.run((each) => {
    const canvas = document.querySelector<HTMLCanvasElement>(each);
    const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    return new Set(new Uint32Array(Uint8ClampedArray.from(data).buffer)).size;
  }, selector);

test('a solve is plotted', async () => {
  await visitor.openNet({ recipe: SHAPE });
  await visitor.clickOn('For research');
  await visitor.drag(dragged, [-40, -30]);
  await vi.waitUntil(async () => (await coloursOf('.plot canvas')) > 10, PATIENCE);
});

test('a click adds a handle, Delete removes it', async () => {
  await visitor.openNet({ recipe: SHAPE });
  const free = reference.edges.find((vertex) => !suggestedHandles.includes(vertex))!;
  const place = await visitor.placeInSight(free);
  const handles = () => visitor.handles();
  await visitor.click(place.x, place.y);
  await expect.poll(handles).toEqual([...suggestedHandles, free]);
  await visitor.settled();
  await visitor.press('Delete');
  await expect.poll(handles).toEqual([...suggestedHandles]);
});

/** Where the net comes to stand in Node. */
function solvedInNode(method: string): { status: string; positions: Float64Array } {
  const editor = chebnet.openRecipe(SHAPE);
  editor.setMethod(method);
  editor.setHandles(
    Array.from(suggestedHandles, (vertex) => ({ vertex, target: vertex === dragged ? TARGET : placeOf(vertex) })),
  );
  const { status } = editor.solve();
  return { status, positions: editor.positions() };
}

test('every method comes to the same end as in Node', async () => {
  await visitor.openNet({ recipe: SHAPE });
  for (const { name } of chebnet.methods()) {
    const expected = solvedInNode(name);
    await visitor.run(
      async (method, vertex, target) => {
        await window.chebnet.open({ recipe: 'vault:vertices=300' });
        await window.chebnet.setOptions({ method });
        await window.chebnet.move(vertex, target);
        await window.chebnet.settled();
      },
      name,
      dragged,
      TARGET,
    );
    expect(await visitor.stats(), name).toMatchObject({ method: name, status: expected.status });
    // It ends with a Newton step shorter than 1e-3 edge lengths, which leaves about the square of that.
    const tolerance = name === 'equilibrium' ? 1e-5 : 1e-9;
    expect(largestError(await visitor.positions(), expected.positions), name).toBeLessThan(tolerance * meanLength);
  }
});

test('methods are compared on the same edit, with curves and a table', async () => {
  await visitor.openNet({ recipe: SHAPE });
  await visitor.run((vertex, target) => window.chebnet.move(vertex, target), dragged, TARGET);
  await visitor.settled();
  await visitor.clickOn('For research');
  await visitor.clickOn('Compare methods');
  await visitor.clickOn('Compare');
  const text = await visitor.read('4 runs', '.comparison');
  expect(text.match(/Converged/g)?.length).toBeGreaterThanOrEqual(3);
  await vi.waitUntil(async () => (await coloursOf('.comparison canvas')) > 10, PATIENCE);
  await visitor.picture('comparison');
});

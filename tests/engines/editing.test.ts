/** A visitor edits a net, in each engine: by real pointer and key events. */
import { beforeEach, expect, test } from 'vitest';
import { distance, largestDeviation, largestError } from '../browser/geometry';
import { load } from '../wasm/load';
import type { Visitor } from './visitor';
import { visitors } from './visitor';

const SHAPE = 'vault:vertices=600';

const chebnet = await load();
const reference = chebnet.openRecipe(SHAPE);
const { edges, restPositions, suggestedHandles } = reference;
const { meanLength } = reference.info;
const dragged = suggestedHandles.at(-1)!;
const placeIn = (positions: Float64Array) => positions.subarray(3 * dragged, 3 * dragged + 3);

const { share } = visitors();
let visitor: Visitor;
beforeEach(async () => {
  visitor = await share();
});

test('the first net can be dragged', async () => {
  const [before, vertex] = [await visitor.positions(), (await visitor.handles()).at(-1)!];
  await visitor.picture('first');
  await visitor.drag(vertex, [-60, -40]);
  const after = await visitor.positions();
  expect(
    distance(after.subarray(3 * vertex, 3 * vertex + 3), before.subarray(3 * vertex, 3 * vertex + 3)),
  ).toBeGreaterThan(0);
  expect(await visitor.stats()).toMatchObject({ status: 'converged', method: 'equilibrium' });
  await visitor.picture('dragged');
});

test('a drag keeps every length; Escape cancels it, undo takes it back, redo repeats it', async () => {
  await visitor.openNet({ recipe: SHAPE });
  expect(largestError(await visitor.positions(), restPositions)).toBeLessThan(1e-9);
  await visitor.drag(dragged, [-70, -50], () => visitor.press('Escape'));
  expect(distance(placeIn(await visitor.positions()), placeIn(restPositions))).toBeLessThan(1e-9);

  await visitor.drag(dragged, [-70, -50]);
  const after = await visitor.positions();
  expect(distance(placeIn(after), placeIn(restPositions))).toBeGreaterThan(meanLength);
  expect(largestDeviation(after, edges, meanLength)).toBeLessThan(1.001e-6);

  await visitor.press('Control+z');
  await expect.poll(async () => largestError(await visitor.positions(), restPositions)).toBeLessThan(1e-6 * meanLength);
  await visitor.press('Control+Shift+z');
  await expect.poll(async () => largestError(await visitor.positions(), after)).toBeLessThan(1e-6 * meanLength);
});

test('the wheel brings the net nearer, and moves no vertex', async () => {
  await visitor.openNet({ recipe: SHAPE });
  const apart = async () => {
    const [a, b] = await visitor.run(
      (vertices) => vertices.map((vertex) => window.chebnet.screenPosition(vertex)),
      [0, dragged],
    );
    return Math.hypot(a!.x - b!.x, a!.y - b!.y);
  };
  const before = await apart();
  await visitor.driver.movePointer(480, 400);
  await visitor.driver.turnWheel(-200);
  await expect.poll(apart).toBeGreaterThan(1.05 * before);
  expect(largestError(await visitor.positions(), restPositions)).toBeLessThan(1e-9);
});

test('a coordinate may be typed with a comma for the decimal point', async () => {
  await visitor.openNet({ recipe: SHAPE });
  await visitor.clickOn(`Handles (${suggestedHandles.length})`);
  const before = placeIn(await visitor.positions())[2]!;
  const wanted = (before - 0.25).toFixed(2);
  const chooseHeight = async () => {
    await visitor.clickOn(`Vertex ${dragged}`);
    return visitor.run(() => {
      const inputs = [...document.querySelectorAll<HTMLInputElement>('.handles .coordinates input')];
      const height = inputs.filter((input) => input.checkVisibility())[2];
      height?.focus();
      height?.select();
      return height !== undefined;
    });
  };
  await expect.poll(chooseHeight).toBe(true);
  for (const key of [...wanted.replace('.', ','), 'Enter']) await visitor.press(key);
  await expect.poll(async () => placeIn(await visitor.positions())[2]!).toBeCloseTo(Number(wanted), 9);
});

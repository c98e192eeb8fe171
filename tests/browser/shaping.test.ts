/** Soft handles, locality and reach under real hands. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { distance } from './geometry';
import { OUTPUT, type Script, type Visit, visits } from './page';

const site = visits();
let visit: Visit;
let script: Script;

beforeEach(async () => {
  visit = await site.share();
  ({ script } = visit);
  await script.open({ recipe: 'elephant:vertices=1200' });
  await script.settled();
});

const dragged = (): Promise<number> => visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);

const target = (vertex: number) =>
  visit.page.evaluate((v) => window.chebnet.handles().find((each) => each.vertex === v)!.target, vertex);

/** Takes the last handle and moves it by so many pixels; `held` while it is still in hand. */
async function drag(by: [number, number], held?: () => Promise<void>): Promise<void> {
  const { mouse } = visit.page;
  const vertex = await dragged();
  const { x, y } = await script.screenPosition(vertex);
  const before = await target(vertex);
  await mouse.move(x, y);
  await mouse.down();
  const first = 12 / Math.hypot(...by);
  await mouse.move(x + first * by[0], y + first * by[1], { steps: 3 });
  await expect.poll(() => target(vertex)).not.toEqual(before);
  await script.settled(); // the solver has answered, with the limits of the drag before that
  await mouse.move(x + by[0], y + by[1], { steps: 8 });
  await held?.();
  await mouse.up();
  await script.settled();
}

function movedVertices(before: Float64Array, after: Float64Array): number {
  let moved = 0;
  for (let i = 0; i < before.length; i += 3)
    moved += [0, 1, 2].some((axis) => before[i + axis] !== after[i + axis]) ? 1 : 0;
  return moved;
}

test('a drag stops where the net can follow no farther, unless it is told not to', async () => {
  await drag([0, -2000], async () => {
    await script.settled();
    await visit.page.screenshot({ path: join(OUTPUT, 'reach.png') });
  });
  expect((await script.stats()).status).not.toBe('unreachable');
  await visit.page.keyboard.press('Control+z');
  await script.settled();
  await visit.page.getByRole('button', { name: 'Show all' }).click(); // the view had followed the handle
  await script.settled();
  await visit.page.getByText('Dragging', { exact: true }).click();
  await visit.page.getByLabel('Keep within reach').uncheck();
  await drag([0, -2000]);
  expect((await script.stats()).status).toBe('unreachable');
});

/** So many edges from the hand, by keys. */
async function chooseLocality(): Promise<number> {
  await visit.page.getByText('Dragging', { exact: true }).click();
  const slider = visit.page.getByLabel('Locality');
  await slider.focus();
  await slider.press('End');
  for (let i = 0; i < 14; i++) await slider.press('ArrowLeft');
  return Number.parseInt((await slider.getAttribute('aria-valuetext'))!, 10);
}

const localityIs = (words: string) =>
  visit.page.waitForFunction((each) => document.querySelector('.locality output')?.textContent === each, words);

test('with a locality only what is near the hand moves; undo takes the choice back; a link carries it', async () => {
  const edges = await chooseLocality();
  expect(edges).toBeGreaterThan(3);
  await visit.page.screenshot({ path: join(OUTPUT, 'locality.png') });
  const link = await visit.page.evaluate(() => window.chebnet.link());

  const before = await script.positions();
  await drag([6, -12], async () => {
    await visit.page.screenshot({ path: join(OUTPUT, 'locality-drag.png') });
  });
  const moved = movedVertices(before, await script.positions());
  expect(moved).toBeGreaterThan(0);
  expect(moved).toBeLessThan(before.length / 3 / 2);

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(movedVertices(before, await script.positions())).toBe(0);
  await visit.page.keyboard.press('Control+z');
  await localityIs('everything');

  const other = await site.arrive(link);
  expect(await other.page.getByLabel('Locality').getAttribute('aria-valuetext')).toBe(`${edges} edges`);
});

test('where the part that may move is too small for a handle, one button lets the whole net move, and it gets there', async () => {
  // Towards the one other handle there is, which the whole net can do.
  const [held, vertex] = await visit.page.evaluate(async () => {
    const both = [window.chebnet.handles()[0]!, window.chebnet.handles().at(-1)!] as const;
    await window.chebnet.setHandles([...both]);
    return [both[0].vertex, both[1].vertex];
  });
  const edges = await chooseLocality();
  const [from, towards] = [await script.position(vertex), await script.position(held)];
  const way = 0.4;
  const there = from.map((each, axis) => each + way * (towards[axis]! - each)) as [number, number, number];
  await script.move(vertex, there);
  await script.settled();
  const widen = visit.page.getByRole('button', { name: 'Let the whole net move' });
  await widen.waitFor();
  expect((await script.stats()).status).not.toBe('converged');
  await widen.click();
  await localityIs('everything');
  await widen.waitFor({ state: 'hidden' });
  await script.settled();
  expect((await script.stats()).status).toBe('converged');
  expect(distance(await script.position(vertex), there)).toBeLessThan(1e-6);
  await visit.page.keyboard.press('Control+z');
  await widen.waitFor();
  await localityIs(`${edges} edges`);
});

test('a soft handle follows its target as far as its weight pulls, and every edge keeps its length', async () => {
  const vertex = await dragged();
  const [x, y, z] = await script.position(vertex);
  const off = async (weight: number): Promise<number> => {
    await visit.page.evaluate(
      ([each, target, w]) =>
        window.chebnet.setHandles(
          window.chebnet.handles().map((h) => (h.vertex === each ? { ...h, target, weight: w } : h)),
        ),
      [vertex, [x, y, z + 3] as [number, number, number], weight] as const,
    );
    await script.settled();
    expect((await script.stats()).maxDeviation).toBeLessThan(1e-6);
    return z + 3 - (await script.position(vertex))[2];
  };
  const light = await off(0.02);
  expect(await off(50)).toBeLessThan(0.5 * light);
});

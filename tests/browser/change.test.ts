/** The net itself is changed: finer, coarser, cut, shorter and longer, each exact and undone in a step. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { load } from '../wasm/load';
import { OUTPUT, type Script, type Visit, visits } from './page';

const SHAPE = 'vault:vertices=300';
const net = (await load()).openRecipe(SHAPE);

const { share } = visits();
let visit: Visit;
let script: Script;

beforeEach(async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
  await visit.page.locator('summary', { hasText: /^Change the net$/ }).click();
});

const section = () => visit.page.locator('details', { hasText: /^Change the net/ });
const press = (name: string) => section().getByRole('button', { name, exact: true }).click();
const vertices = async () => (await script.stats()).vertices;

const undo = () => visit.page.keyboard.press('Control+z');
const width = async () => {
  const positions = await script.positions();
  const x = positions.filter((_, i) => i % 3 === 0);
  return Math.max(...x) - Math.min(...x);
};

/** The vertices in the middle of the borders to the left and to the right. */
async function middlesOfSides(): Promise<[number, number]> {
  const positions = await script.positions();
  const numbers = Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  const towards = (sign: number) => (v: number) => sign * positions[3 * v]! - 0.2 * Math.abs(positions[3 * v + 1]!);
  const first = (value: (v: number) => number) => numbers.reduce((a, b) => (value(b) > value(a) ? b : a));
  return [first(towards(-1)), first(towards(1))];
}

/** Clicks on a handle. */
async function choose(vertex: number): Promise<void> {
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.mouse.click(x, y);
  await section().getByText('At the chosen handle:').waitFor();
}

async function becomes(count: (before: number) => number, name: string): Promise<void> {
  const wanted = count(await vertices());
  await press(name);
  await expect.poll(vertices).toBe(wanted);
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
}

test('finer, another length, and back', async () => {
  const first = await vertices();
  const handles = (await visit.page.evaluate(() => window.chebnet.handles())).map(({ vertex }) => vertex);
  const edgeLength = async () => Number(await section().getByLabel('Edge length').inputValue());
  const length = net.info.meanLength;
  await expect.poll(edgeLength).toBeCloseTo(length, 4);
  await press('Refine');
  await visit.page.getByText(/^The net has [\d,]+ vertices now\.$/).waitFor();
  await script.settled();
  expect(await vertices()).toBeGreaterThan(3.5 * first);
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
  expect((await visit.page.evaluate(() => window.chebnet.handles())).map(({ vertex }) => vertex)).toEqual(handles);
  await expect.poll(edgeLength).toBeCloseTo(length / 2, 4);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-refined.png') });

  const fine = await vertices();
  await becomes(() => first, 'Coarsen');
  await section().getByLabel('Edge length').fill('2');
  await press('Apply');
  await expect.poll(width).toBeGreaterThan(20);

  await undo();
  await expect.poll(width).toBeLessThan(20);
  await undo();
  await expect.poll(vertices).toBe(fine);
  await undo();
  await expect.poll(vertices).toBe(first);
});

test('a line is cut, one side goes, a row comes, and a reason is given where it cannot be', async () => {
  const { vertex } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  expect(await section().getByRole('button', { name: 'Cut' }).isEnabled()).toBe(false);
  await choose(vertex);
  await section().getByRole('button', { name: 'Cut' }).hover();
  await visit.page.screenshot({ path: join(OUTPUT, 'change-line.png') });
  await press('Add a row');
  await visit.page.getByText(/where rows are added: choose a vertex there/).waitFor();

  const whole = await vertices();
  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
  await expect.poll(vertices).toBeGreaterThan(whole);
  const line = (await vertices()) - whole;
  await press('Join borders');
  await expect.poll(vertices).toBe(whole);

  await choose(vertex);
  await press('Keep the smaller side');
  await visit.page.getByText(/handles are gone: their vertices are no more/).waitFor();
  await expect.poll(vertices).toBeLessThan(whole);
  await script.settled();
  const half = await vertices();
  const kept = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);
  await choose(kept);
  await section().getByLabel('Line').selectOption('Net line 2');
  await visit.page.screenshot({ path: join(OUTPUT, 'change-half.png') });
  expect(half).toBeGreaterThan(line);
});

test('a row is put in and taken out, and the way through two handles is cut', async () => {
  const { vertex } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const before = await vertices();
  await choose(vertex);
  await press('Put a row in');
  await expect.poll(vertices).toBeGreaterThan(before);
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-inserted.png') });
  const [kept] = (await visit.page.evaluate(() => window.chebnet.handles())).slice(-1);
  await choose(kept!.vertex);
  await press('Take the line out');
  await expect.poll(vertices).toBe(before);

  await script.settled();
  const ends = await middlesOfSides();
  await script.setHandles([ends[0], vertex, ends[1]].map((each) => ({ vertex: each })));
  await script.settled();
  await choose(ends[0]);
  await visit.page.keyboard.down('Shift');
  for (const next of [vertex, ends[1]]) {
    const { x, y } = await script.screenPosition(next);
    await visit.page.mouse.click(x, y);
  }
  await visit.page.keyboard.up('Shift');
  await section().getByText('At the 3 chosen handles').waitFor();
  await section().getByLabel('Line').selectOption('Way through the handles');
  await section().getByRole('button', { name: 'Cut' }).hover();
  await expect.poll(() => visit.page.locator('path.preview').getAttribute('d')).toMatch(/(?:h0M.*){8}/);
  await visit.page.screenshot({ path: join(OUTPUT, 'change-way.png') });
  await press('Cut');
  await visit.page.getByText(/It has 2 pieces\./).waitFor();
});

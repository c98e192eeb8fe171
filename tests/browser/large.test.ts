/** Nets of up to 100,000 vertices: slower than others, but the page lives. */
import { beforeEach, expect, test } from 'vitest';
import { en } from '../../web/src/language/en';
import { load } from '../wasm/load';
import { distance, dragBy, fan } from './geometry';
import type { Script, Visit } from './page';
import { visits, openForResearch } from './page';
import { dropWaves, makeWaves } from './waves';

const RECIPE = 'vault:vertices=100000';
/** Takes seconds to be made. */
const SLOW_RECIPE = 'jack:vertices=100000';
/** A small picture: a software renderer takes long enough. */
const viewport = { width: 800, height: 500 };

const core = await load();
const { vertices, meanLength, dragged } = whatIs(RECIPE);

const { arrive } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await arrive('', { viewport });
  ({ script } = visit);
});

test('opens and is drawn', async () => {
  await script.open({ recipe: RECIPE });
  await drawn();
  await script.settled();
  expect(await script.stats()).toMatchObject({ vertices, status: 'converged' });
});

test('three thousand handles come', async () => {
  const count = 3000;
  await script.open({ recipe: 'vault:vertices=20000' });
  await script.settled();
  await script.setHandles(Array.from({ length: count }, (_, vertex) => ({ vertex })));
  await script.settled();
  expect(await script.stats()).toMatchObject({ handles: count, status: 'converged' });
});

test('twenty thousand triangles around one vertex open, and are solved', async () => {
  const count = 20_000;
  await script.open({ obj: fan(count) });
  await script.settled();
  await script.setHandles([{ vertex: 1 }, { vertex: count / 2 }, { vertex: 0, target: [0, 0, 0.01] }]);
  await script.settled();
  expect(await script.stats()).toMatchObject({ vertices: count + 1, handles: 3 });
  expect((await script.positions()).every(Number.isFinite)).toBe(true);
});

test('a net too large to be at rest while it is edited is said to be creased, with the way out', async () => {
  const { page } = visit;
  await script.open({ recipe: 'sheet:vertices=13000' });
  await script.settled();
  // Opposite corners.
  const last = (await script.stats()).vertices - 1;
  await script.setHandles([{ vertex: 0 }, { vertex: last }]);
  await script.settled();
  const notice = page.locator('.stuck-notice');
  expect(await notice.textContent()).toBe('');
  const [[x, y, z], [a, b, c]] = [await placeOf(0), await placeOf(last)];
  // Along the diagonal, until cells are rhombi of some 25 degrees.
  await script.move(last, [x + 1.38 * (a - x), y + 1.38 * (b - y), z + 1.38 * (c - z)]);
  await script.settled();
  await notice.getByText(/Cells with corners sharper than 30°: [1-9]/).waitFor();
  await notice.getByRole('button', { name: 'Bring it to rest' }).click();
  await expect.poll(async () => (await script.stats()).method).toBe('equilibrium');
  await notice.getByText('keeps only its lengths').waitFor({ state: 'detached' });
});

test('of many handles a hundred are listed until more are asked for, and any that is selected', async () => {
  const { page } = visit;
  await page.evaluate(() => window.chebnet.setHandles(Array.from({ length: 350 }, (_, vertex) => ({ vertex }))));
  await script.settled();
  await page.getByText('Handles (350)').click();
  const rows = page.locator('.handles li');
  expect(await rows.count()).toBe(100);
  await page.getByRole('spinbutton', { name: 'Vertex number' }).fill('300');
  await page.keyboard.press('Enter');
  expect(await rows.count()).toBe(101);
  await page.getByRole('button', { name: 'Vertex 300', exact: true, expanded: true }).waitFor();
  await page.getByRole('button', { name: 'Show 100 of 249 more' }).focus();
  await page.keyboard.press('Enter');
  expect(await rows.count()).toBe(201);
  expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Vertex 100');
});

test('on its way it can be given up for the net of before; a drag moves it, Escape takes that back', async () => {
  const { page } = visit;
  const [there, { vertices: few }] = [await script.positions(), await script.stats()];
  const cancel = page.getByRole('button', { name: 'Cancel', exact: true });
  for (const giveUp of [() => cancel.click(), () => page.keyboard.press('Escape')]) {
    const opening = script.open({ recipe: SLOW_RECIPE }).catch(String);
    await page.getByText('Opening the net').waitFor();
    await giveUp();
    expect(await opening).toMatch(/given up/);
    await script.settled();
    expect(await script.stats()).toMatchObject({ vertices: few, status: 'converged' });
    expect(await script.positions()).toEqual(there);
  }
  await script.open({ recipe: RECIPE });
  await script.settled();
  const before = await placeOf(dragged);
  const moved = async () => distance(await placeOf(dragged), before);
  await dragBy(script, dragged, [-40, -30], {
    steps: 3, // each is waited for until it is drawn
    atEnd: async () => {
      await expect.poll(moved, { timeout: 30_000 }).toBeGreaterThan(meanLength);
      await page.keyboard.press('Escape');
    },
  });
  await script.settled();
  expect(await moved()).toBeLessThan(1e-9);
  expect((await script.stats()).status).toBe('converged');
}, 300_000); // each picture takes a software renderer a second or more

test('a solve that would take minutes shows how it goes and can be cancelled, also beside its status and by Escape', async () => {
  const { page } = visit;
  const recipe = 'vault:vertices=20000';
  const { dragged: vertex, meanLength: length } = whatIs(recipe);
  await script.open({ recipe });
  await script.settled();
  await openForResearch(page, 'Solver');
  await solveWithoutEnd();
  const [x, y, z] = await placeOf(vertex);
  const stop = page.locator('.status').getByRole('button', { name: 'Stop', exact: true });
  const ways = [
    () => page.getByRole('button', { name: 'Cancel', exact: true }).click(),
    () => stop.click(),
    async () => {
      await stop.waitFor();
      await page.keyboard.press('Escape');
    },
  ];
  for (const [i, end] of ways.entries()) {
    expect(await stop.isVisible()).toBe(false);
    await script.move(vertex, [x, y, z - (20 + i) * length]);
    await expect.poll(async () => (await script.stats()).iterations, { timeout: 30_000 }).toBeGreaterThan(1);
    await page.getByText('Solving', { exact: true }).waitFor();
    await end();
    await script.settled();
    expect((await script.stats()).status).toBe('running');
    await page.locator('.status-words', { hasText: 'Paused' }).waitFor();
  }
});

test('beside Stop all that the status can say is read', async () => {
  const { page } = visit;
  const recipe = 'vault:vertices=4000';
  const { dragged: vertex, meanLength: length } = whatIs(recipe);
  await script.open({ recipe });
  await script.settled();
  const row = page.locator('.status');
  const heights = new Map<number, number>();
  for (const width of [768, 1366]) {
    await page.setViewportSize({ width, height: 500 });
    heights.set(width, await row.evaluate((element) => element.getBoundingClientRect().height));
  }
  await solveWithoutEnd();
  const [x, y, z] = await placeOf(vertex);
  await script.move(vertex, [x, y, z - 10 * length]);
  await row.getByRole('button', { name: 'Stop', exact: true }).waitFor();
  for (const [width, height] of heights) {
    await page.setViewportSize({ width, height: 500 });
    const found = await row.evaluate(looksOfAll, Object.values(en.status));
    for (const { text, ...look } of found) expect(look, text).toEqual({ isCut: false, height });
  }
});

/** Runs in the page: how it looks with each text in turn. All in one call, for what solves draws between calls. */
function looksOfAll(row: Element, texts: string[]): { text: string; isCut: boolean; height: number }[] {
  const words = row.querySelector('.status-words')!;
  return texts.map((text) => {
    words.textContent = text;
    const isCut = words.scrollHeight > words.clientHeight;
    return { text, isCut, height: row.getBoundingClientRect().height };
  });
}

test('Stop waits until the hand lets go', async () => {
  const { page } = visit;
  const recipe = 'vault:vertices=4000';
  await script.open({ recipe });
  await script.settled();
  await solveWithoutEnd();
  const stop = page.locator('.status').getByRole('button', { name: 'Stop', exact: true });
  let seen = 0;
  await dragBy(script, whatIs(recipe).dragged, [30, -40], {
    during: async () => {
      await page.waitForTimeout(250);
      if (await stop.isVisible()) seen += 1;
    },
  });
  expect(seen).toBe(0);
  await stop.click();
});

test('a shape that becomes too large to be at rest while it is dragged says so beside the slider', async () => {
  const { page } = visit;
  await script.open({ recipe: 'vault:vertices=12000' });
  const said = page.getByText('With more than 12,000 vertices the net keeps its lengths alone');
  const slider = page.getByRole('slider', { name: 'Vertices' });
  await slider.focus();
  expect(await said.count()).toBe(0);
  await page.keyboard.press('ArrowRight');
  await said.waitFor();
  await slider.focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
  await expect.poll(() => said.count()).toBe(0);
});

test('a million triangles are read in steps that are shown, can be given up, and open as what they are', async () => {
  const { page } = visit;
  const before = await script.stats();
  await page.evaluate(makeWaves);
  const file = page.getByRole('dialog', { name: /^waves\.stl$/ });
  await page.evaluate(dropWaves);
  await file.getByText('Reading the mesh').waitFor();
  await file.getByRole('button', { name: 'Cancel', exact: true }).click();
  await file.waitFor({ state: 'detached' });
  await script.settled();
  expect(await script.stats()).toMatchObject({ vertices: before.vertices, status: 'converged' });

  const draper = page.getByRole('dialog', { name: /^A net on a surface$/ });
  await page.evaluate(dropWaves);
  await file.getByText('1,002,528').waitFor({ timeout: 60_000 });
  expect(await page.evaluate(() => window.steps)).toEqual([
    'Loading the file',
    'Reading the mesh',
    'Looking for defects',
    'Measuring the edges',
  ]);
  await file.getByText(/^One uncut piece will cover it/).waitFor();
  await file.getByRole('button', { name: 'Make a net on it…' }).click();
  await draper.locator('.results .facts:not(.stale)', { hasText: 'Largest dL' }).waitFor({ timeout: 60_000 });
  await draper.getByRole('button', { name: 'Open this net' }).click();
  await page.getByRole('group', { name: 'Surface: waves.stl' }).waitFor();
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
}, 300_000); // a quarter of that on an idle machine

/** With a method that is slow, and never content. */
function solveWithoutEnd(): Promise<void> {
  return visit.page.evaluate(() =>
    window.chebnet.setOptions({
      method: 'gradient_descent',
      max_iterations: 1e6,
      energy_tolerance: 0,
      gradient_tolerance: 0,
    }),
  );
}

function whatIs(recipe: string): { vertices: number; meanLength: number; dragged: number } {
  const editor = core.openRecipe(recipe);
  const { vertices, meanLength } = editor.info;
  const dragged = editor.suggestedHandles.at(-1)!;
  editor.dispose();
  return { vertices, meanLength, dragged };
}

/** A picture with the net on it has been drawn: in the frame after it came, at the latest. Frames per second do not tell: a
 *  software renderer takes longer than one. */
async function drawn() {
  await visit.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

async function placeOf(vertex: number): Promise<[number, number, number]> {
  const place = (v: number) => Array.from(window.chebnet.positions().subarray(3 * v, 3 * v + 3));
  const [x = NaN, y = NaN, z = NaN] = await visit.page.evaluate(place, vertex);
  return [x, y, z];
}

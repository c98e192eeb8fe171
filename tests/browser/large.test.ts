/** Nets of up to 100,000 vertices: slower than others, but the page lives. */
import { beforeEach, expect, test } from 'vitest';
import { load } from '../wasm/load';
import { distance, dragBy, fan } from './geometry';
import type { Script, Visit } from './page';
import { visits, openForResearch } from './page';
import { mainThreadTasks, yardstick } from './tasks';

const RECIPE = 'vault:vertices=100000';
/** Takes seconds to be made. */
const SLOW_RECIPE = 'jack:vertices=100000';
/** A small picture: a software renderer takes long enough. */
const viewport = { width: 800, height: 500 };
/** In pieces of fixed work. */
const LONGEST_TASK = 1.5;
/** Of a surface with ten times as many triangles, in numbers for the graphics card. */
const LONGEST_OF_MILLION = 3;
/** Other work on the machine can only lengthen a task: one attempt within the limit shows that the page keeps to it. */
const ATTEMPTS = 3;

/** Squares along a side of the sheet that is dropped: 1,002,528 triangles. */
const WAVES = 708;

declare global {
  interface Window {
    waves: File;
    /** What reading said it was doing, in order. */
    steps: string[];
  }
}

const core = await load();
const { vertices, meanLength, dragged } = whatIs(RECIPE);

const { arrive, browser } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await arrive('', { viewport });
  ({ script } = visit);
});

test('opens and is drawn, and no task of the page lasts long', async () => {
  await drawn();
  await expectShortTasks(LONGEST_TASK, async () => {
    await script.open({ recipe: RECIPE });
    await drawn();
    await script.settled();
  });
  expect(await script.stats()).toMatchObject({ vertices, status: 'converged' });
});

test('three thousand handles come without a long task', async () => {
  const count = 3000;
  await expectShortTasks(LONGEST_TASK, async () => {
    await script.open({ recipe: 'vault:vertices=20000' });
    await script.settled();
    await script.setHandles(Array.from({ length: count }, (_, vertex) => ({ vertex })));
    await script.settled();
  });
  expect(await script.stats()).toMatchObject({ handles: count, status: 'converged' });
});

test('twenty thousand triangles around one vertex open, and are solved', async () => {
  const count = 20_000;
  await expectShortTasks(LONGEST_TASK, async () => {
    await script.open({ obj: fan(count) });
    await script.settled();
  });
  await script.setHandles([{ vertex: 1 }, { vertex: count / 2 }, { vertex: 0, target: [0, 0, 0.01] }]);
  await script.settled();
  expect(await script.stats()).toMatchObject({ vertices: count + 1, handles: 3 });
  expect((await script.positions()).every(Number.isFinite)).toBe(true);
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
    atEnd: async () => {
      await expect.poll(moved, { timeout: 30_000 }).toBeGreaterThan(meanLength);
      await page.keyboard.press('Escape');
    },
  });
  await script.settled();
  expect(await moved()).toBeLessThan(1e-9);
  expect((await script.stats()).status).toBe('converged');
}, 300_000); // each picture takes a software renderer a second or more

test('a solve that would take minutes shows how it goes and can be cancelled', async () => {
  const { page } = visit;
  const recipe = 'vault:vertices=20000';
  const { dragged: vertex, meanLength: length } = whatIs(recipe);
  await script.open({ recipe });
  await script.settled();
  await openForResearch(page, 'Solver');
  await page.evaluate(() =>
    window.chebnet.setOptions({
      method: 'gradient_descent',
      max_iterations: 1e6,
      energy_tolerance: 0,
      gradient_tolerance: 0,
    }),
  );
  const [x, y, z] = await placeOf(vertex);
  await script.move(vertex, [x, y, z - 20 * length]);
  await expect.poll(async () => (await script.stats()).iterations, { timeout: 30_000 }).toBeGreaterThan(1);
  await page.getByText('Solving', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Cancel', exact: true }).click();
  await script.settled();
  expect((await script.stats()).status).toBe('running');
  await page.locator('.status-words', { hasText: 'Paused' }).waitFor();
});

test('a million triangles are read in steps that are shown, can be given up, and open as what they are', async () => {
  const { page } = visit;
  const before = await script.stats();
  await page.evaluate(makeWaves, WAVES);
  const file = page.getByRole('dialog', { name: /^waves\.stl$/ });
  await page.evaluate(dropWaves);
  await file.getByText('Reading the mesh').waitFor();
  await file.getByRole('button', { name: 'Cancel', exact: true }).click();
  await file.waitFor({ state: 'detached' });
  await script.settled();
  expect(await script.stats()).toMatchObject({ vertices: before.vertices, status: 'converged' });

  const draper = page.getByRole('dialog', { name: /^A net on a surface$/ });
  await expectShortTasks(LONGEST_OF_MILLION, async () => {
    await page.evaluate(dropWaves);
    await file.getByText('1,002,528').waitFor({ timeout: 60_000 });
    expect(await page.evaluate(() => window.steps)).toEqual([
      'Loading the file',
      'Reading the mesh',
      'Looking for defects',
      'Measuring the edges',
    ]);
    await file.getByText(/^More curvature than one net can take/).waitFor();
    await file.getByRole('button', { name: 'Make a net on it…' }).click();
    await draper.locator('.results .facts:not(.stale)', { hasText: 'Largest dL' }).waitFor({ timeout: 60_000 });
    await draper.getByRole('button', { name: 'Open this net' }).click();
    await page.getByRole('group', { name: 'Surface: waves.stl' }).waitFor();
    await script.settled();
  });
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-9);
}, 300_000); // a quarter of that, if nothing has to be tried again

/** No task of the page lasts longer than `most` pieces of fixed work. */
async function expectShortTasks(most: number, doing: () => Promise<void>) {
  const ratios: number[] = [];
  while (ratios.length < ATTEMPTS && !ratios.some((ratio) => ratio < most)) {
    const { own } = await mainThreadTasks(browser(), doing);
    const [task, work] = [Math.max(...own), yardstick()];
    console.log(`longest task: ${task.toFixed(1)} ms; the fixed work: ${work.toFixed(1)} ms`);
    ratios.push(task / work);
  }
  expect(Math.min(...ratios)).toBeLessThan(most);
}

/** Runs in the page, where 50 MB need not be sent. Binary STL: each triangle has corners of its own, which are found to be one. */
function makeWaves(side: number) {
  const bytes = new DataView(new ArrayBuffer(84 + 100 * side * side));
  bytes.setUint32(80, 2 * side * side, true);
  let at = 84;
  const add = (...corners: [number, number][]) => {
    corners.forEach(([i, j], k) =>
      [i, j, 50 * Math.sin(i / 50) * Math.cos(j / 67)].forEach((x, axis) =>
        bytes.setFloat32(at + 12 * (k + 1) + 4 * axis, x, true),
      ),
    );
    at += 50;
  };
  for (let i = 0; i < side; i++)
    for (let j = 0; j < side; j++) {
      add([i, j], [i + 1, j], [i + 1, j + 1]);
      add([i, j], [i + 1, j + 1], [i, j + 1]);
    }
  window.waves = new File([bytes], 'waves.stl');
}

/** Likewise. */
function dropWaves() {
  window.steps = [];
  new MutationObserver(() => {
    const step = document.querySelector('label[for=file-progress]')?.textContent;
    if (step && step !== window.steps.at(-1)) window.steps.push(step);
  }).observe(document.body, { subtree: true, childList: true, characterData: true });
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(window.waves);
  document
    .getElementById('view')!
    .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
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

/** The page never holds up the visitor for more than 50 ms, on a net of 15,000 vertices. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { load } from '../wasm/load';
import { dragBy } from './geometry';
import { OUTPUT, Script, launch, newPage, serve } from './page';

let browser: Browser;
let site: Awaited<ReturnType<typeof serve>>;

beforeAll(async () => {
  [browser, site] = await Promise.all([launch(), serve()]);
});
afterAll(async () => {
  await browser.close();
  site.close();
});

type Watched = { longTasks: number[] };

function watchLongTasks() {
  const durations: number[] = [];
  (window as unknown as Watched).longTasks = durations;
  new PerformanceObserver((list) => durations.push(...list.getEntries().map(({ duration }) => duration))).observe({
    type: 'longtask',
  });
}

/** Here the software renderer draws on the same two cores. What is asked is the page's own work, so nothing is drawn;
 *  everything up to the draw calls, uploads included, stays. */
function drawNothing() {
  for (const call of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const) {
    WebGL2RenderingContext.prototype[call] = () => undefined;
  }
}

/** Opens a net, drags it about and says how long the main thread was held up. */
async function dragAbout(page: Page, recipe: string) {
  const script = new Script(page);
  const editor = (await load()).openRecipe(recipe);
  const dragged = editor.suggestedHandles.at(-1)!;
  editor.dispose();
  await page.goto(site.address);
  await script.waitForNet();
  await script.open({ recipe });
  await script.settled();
  await page.waitForTimeout(1000);
  await page.evaluate(() => void ((window as unknown as Watched).longTasks.length = 0));
  const drawnPerSecond: number[] = [];
  const solverMs: number[] = [];
  const during = async () => {
    const { framesPerSecond, milliseconds } = await script.stats();
    drawnPerSecond.push(framesPerSecond);
    solverMs.push(milliseconds);
  };
  for (const move of [[-40, -30], [40, 30], [-30, 20], [30, -20]] as [number, number][]) {
    await dragBy(script, dragged, move, { during });
  }
  await script.settled();
  await page.waitForTimeout(300);
  const longTasks = await page.evaluate(() => (window as unknown as Watched).longTasks);
  const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
  return { recipe, longTasks, framesPerSecond: median(drawnPerSecond), solverMs: median(solverMs) };
}

test.each(['vault:vertices=4000', 'vault:vertices=15000'])('%s', async (recipe) => {
  const figures = [];
  for (const drawing of [true, false]) {
    const { page, complaints, close } = await newPage(browser);
    await page.addInitScript(watchLongTasks);
    if (!drawing) await page.addInitScript(drawNothing);
    figures.push({ drawing, ...(await dragAbout(page, recipe)) });
    expect(complaints).toEqual([]);
    await close();
  }
  console.log(figures);
  writeFileSync(join(OUTPUT, `figures-${recipe.replace(/\W+/g, '-')}.json`), JSON.stringify(figures, null, 2));
  expect(Math.max(0, ...figures.filter(({ drawing }) => !drawing).flatMap(({ longTasks }) => longTasks))).toBe(0);
});

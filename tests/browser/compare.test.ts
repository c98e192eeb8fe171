/** Comparing methods on the present edit: by real clicks, with the curves, the table, the files and Cancel. */
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Download, Locator } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import { load } from '../wasm/load';
import { dragBy, largestError } from './geometry';
import type { Script, Visit } from './page';
import { OUTPUT, allSections, drawn, openForResearch, room, visits } from './page';
import { pixels } from './pixels';

const SHAPE = 'vault:vertices=1000';
const METHODS = ['li2022', 'projection', 'composite_majorization', 'local_global'];

const chebnet = await load();
const reference = chebnet.openRecipe(SHAPE);
const dragged = reference.suggestedHandles.at(-1)!;

const { arrive, share } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await share({ deviceScaleFactor: 1 }); // curves are looked for by their colours, pixel by pixel
  ({ script } = visit);
});

test('four methods run on the same edit, with curves, a table and files', async () => {
  await edit(SHAPE);
  const own = await script.positions();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');

  const rows = await table();
  expect(rows).toHaveLength(4);
  for (const { iterations, milliseconds, angle, handleError } of rows) {
    expect(Number(iterations)).toBeGreaterThan(0);
    expect(milliseconds).toMatch(/^\d+(\.\d)?$/);
    expect(angle).toMatch(/^\d+\.\d°$/);
    expect(handleError).toBe('0');
  }
  expect(rows.slice(0, 3).map(({ status }) => status)).toEqual(Array(3).fill('Converged'));
  expect(await drawnCurves()).toEqual([4, 4]);
  await visit.page.screenshot({ path: join(OUTPUT, 'compare-desktop.png') });

  const lines = (await saved('Table CSV')).trim().split('\n');
  expect(lines.map((line) => line.split(',')[1])).toEqual(['method', ...METHODS]);
  const traces = (await saved('Traces CSV'))
    .trim()
    .split('\n')
    .map((line) => line.split(','));
  expect(traces[0]?.slice(0, 4)).toEqual(['run', 'iteration', 'milliseconds', 'max_deviation']);
  const starts = traces.filter(([, iteration]) => iteration === '0');
  const names = ['Li et al. 2022', 'Projection', 'Composite majorization', 'Local–global'].map((name) =>
    Buffer.from(name).toString('latin1'),
  );
  expect(starts.map(([run]) => run)).toEqual(names);
  expect(new Set(starts.map(([, , , deviation]) => deviation)).size).toBe(1);
  expect(traces.filter(([run]) => run === 'Li et al. 2022')).toHaveLength(1 + Number(rows[0]?.iterations));
  expect((await saved('Plots PNG')).slice(1, 4)).toBe('PNG');

  expect(largestError(await script.positions(), own)).toBe(0);
});

test('where there is nothing to solve, that is said in place of empty plots, with the way on', async () => {
  const { page } = visit;
  await script.open({ recipe: SHAPE });
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toMatch(/nothing to solve: move a handle first/);
  await page.screenshot({ path: join(OUTPUT, 'compare-idle.png') });
  for (const part of ['.plots', '.table', '.actions'])
    expect(await page.locator(`.comparison ${part}`).isVisible()).toBe(false);
  // On a phone, too, it is closed where it is named, and the sentence has the width.
  const { width, height } = page.viewportSize()!;
  await page.setViewportSize({ width: 360, height: 740 });
  const [name, close, sentence] = await Promise.all(
    ['h2', 'button:last-child', 'p'].map(
      async (part) => (await page.locator(`.comparison header > ${part}`).boundingBox())!,
    ),
  );
  expect(close!.y).toBeLessThan(name!.y + name!.height);
  expect(sentence!.width).toBeGreaterThan(300);
  await page.setViewportSize({ width, height });

  await dragBy(script, dragged, [-40, 30]);
  await script.settled();
  await page.getByRole('button', { name: 'Compare again' }).click();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  expect(await drawnCurves()).toEqual([4, 4]);
});

test('no two of all methods are drawn alike', async () => {
  await edit('dome:vertices=100');
  await openForResearch(visit.page, 'Compare methods');
  for (const box of await visit.page.locator('fieldset.methods input').all()) await box.check();
  await visit.page.getByRole('button', { name: 'Compare', exact: true }).click();
  const swatches = visit.page.locator('.comparison .swatch');
  await expect.poll(() => swatches.count()).toBe(chebnet.methods().length);
  const looks = await swatches.evaluateAll((all) =>
    all.map((swatch) => [getComputedStyle(swatch).color, getComputedStyle(swatch).borderTopStyle].join(' ')),
  );
  expect(new Set(looks).size).toBe(looks.length);
});

test('a row shows its net until the user goes back or goes on', async () => {
  await edit(SHAPE);
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  const notice = visit.page.getByText('Showing the result of Local–global');
  const row = visit.page.getByRole('button', { name: 'Local–global', exact: true });

  await row.click();
  await notice.waitFor();
  expect(await row.getAttribute('aria-pressed')).toBe('true');
  await visit.page.screenshot({ path: join(OUTPUT, 'compare-result.png') });
  await visit.page.getByRole('button', { name: 'Back to your net' }).click();
  await notice.waitFor({ state: 'detached' });

  await row.press('Enter');
  await notice.waitFor();
  await dragBy(script, dragged, [20, 10]);
  await notice.waitFor({ state: 'detached' });
  expect(await row.getAttribute('aria-pressed')).toBe('false');
});

test('runs of a comparison that takes the place of another are not there to be clicked before they have run', async () => {
  await edit('vault:vertices=200');
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  expect(await visit.page.evaluate(countEarly)).toBe(0);
});

/** Runs in the page: compares, and counts the frames in which a run with nothing to tell can be clicked. */
async function countEarly(): Promise<number> {
  const begin = [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Compare')!;
  const before = document.querySelector('.comparison tbody');
  begin.click();
  let early = 0;
  for (const end = performance.now() + 500; performance.now() < end; ) {
    await new Promise(requestAnimationFrame);
    const rows = [...document.querySelectorAll('.comparison tbody tr')];
    if (rows.some((row) => !row.querySelector('button')!.disabled && row.querySelector('td')!.textContent === ''))
      ++early;
  }
  return document.querySelector('.comparison tbody') === before ? NaN : early;
}

test('two nets stand side by side, seen from the same place', async () => {
  await edit(SHAPE);
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  const { page } = visit;
  await page.getByRole('button', { name: 'Local–global beside the other net' }).click();
  await page.getByText('From left to right: your net | Local–global').waitFor();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, 'compare-beside.png') });

  const before = await script.screenPosition(dragged);
  const box = (await page.locator('#beside-1 canvas').boundingBox())!;
  await page.mouse.move(box.x + 30, box.y + box.height - 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 130, box.y + box.height - 50, { steps: 5 });
  await page.mouse.up();
  const turned = async () => {
    const after = await script.screenPosition(dragged);
    return Math.hypot(after.x - before.x, after.y - before.y);
  };
  await expect.poll(turned).toBeGreaterThan(5);

  await page.getByRole('button', { name: 'Back to your net' }).click();
  expect(await page.locator('#beside canvas').count()).toBe(0);
});

test('methods that know no soft handles say so in their rows', async () => {
  await edit(SHAPE);
  const handles = await visit.page.evaluate(() => window.chebnet.handles());
  await script.setHandles(handles.map((handle) => (handle.vertex === dragged ? { ...handle, weight: 1 } : handle)));
  await script.settled();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  const refused = expect.stringContaining(`handle ${dragged} is soft`);
  expect((await table()).map(({ status }) => status)).toEqual([refused, 'Converged', refused, refused]);
  expect(await drawnCurves()).toEqual([1, 1]);
  await visit.page.screenshot({ path: join(OUTPUT, 'compare-soft.png') });
});

test('above a comparison, what is said of the net stands beside it', async () => {
  const { page } = visit;
  await page.setViewportSize({ width: 1280, height: 800 });
  await script.open({ recipe: SHAPE });
  await compare();
  await page.locator('.comparison').waitFor();
  const { target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(dragged, [target[0], target[1], target[2] + 9]);
  const notice = (await page.locator('.stuck-notice .message').boundingBox())!;
  await page.screenshot({ path: join(OUTPUT, 'compare-stuck.png') });
  const right = await page.evaluate(() => {
    const { stats, screenPosition } = window.chebnet;
    return Math.max(...Array.from({ length: stats().vertices }, (_, vertex) => screenPosition(vertex).x));
  });
  expect(notice.x).toBeGreaterThan(right);
  const comparison = (await page.locator('.comparison').boundingBox())!;
  expect(notice.y + notice.height).toBeLessThan(comparison.y);
});

test('editing goes on meanwhile, and Cancel works at once', async () => {
  await edit('vault:vertices=8000');
  await compare('Gradient descent');
  await expect.poll(async () => (await table()).map(({ status }) => status), { timeout: 20_000 }).toContain('Running…');

  const { vertex, target } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(vertex, [target[0], target[1], target[2] + 0.1]);
  await script.settled();
  expect((await script.stats()).status).toBe('converged');

  await visit.page.getByRole('button', { name: 'Cancel', exact: true }).last().click();
  await expect.poll(said, { interval: 20 }).toMatch(/Cancelled/);
  const after = await table();
  expect(after.at(-1)?.status).toBe('Cancelled');
  // There is nothing more to cancel.
  await visit.page.locator('.comparison .actions button', { hasText: /^Cancel$/ }).waitFor({ state: 'hidden' });
  await visit.page.waitForTimeout(500);
  expect(await table()).toEqual(after);
});

test.each([
  [360, 740],
  [390, 844],
])('a phone of %i by %i has room for it, and for the net above it', async (width, height) => {
  const { page } = visit;
  await page.setViewportSize({ width, height });
  await edit(SHAPE);
  await page.getByRole('button', { name: 'Controls' }).click();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `compare-phone-${width}.png`) });
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
  const [left, right, top] = await page.evaluate(() => {
    const { stats, screenPosition } = window.chebnet;
    const places = Array.from({ length: stats().vertices }, (_, vertex) => screenPosition(vertex));
    const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
    return [Math.min(...xs), Math.max(...xs), Math.min(...ys)] as const;
  });
  expect(right - left).toBeGreaterThan(width / 2);
  const tools = (await page.locator('.toolbar:not(.selection-bar)').boundingBox())!;
  expect(top).toBeGreaterThan(tools.y + tools.height);
  expect(await page.locator('.legend').isVisible()).toBe(false);
});

test('on a tablet the net above a comparison stands beside the legend, as large as there is room', async () => {
  const { page, script } = visit;
  await page.setViewportSize({ width: 1024, height: 768 });
  await edit('vault:vertices=200');
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  await drawn(page);
  const { x, width, height } = (await page.locator('.legend').boundingBox())!;
  const { vertices } = await script.stats();
  const places = await Promise.all(Array.from({ length: vertices }, (_, v) => script.screenPosition(v)));
  const across = places.map((place) => place.x);
  expect(Math.min(...across)).toBeGreaterThan(x + width);
  expect(Math.max(...across) - Math.min(...across)).toBeGreaterThan(2 * height);
});

/** How dark it is at the right edge of what can be scrolled there, 0 … 1, at this part of its height. */
async function shadeOf(part: Locator, at: number): Promise<number> {
  await drawn(visit.page);
  const { x, y, width, height } = (await part.boundingBox())!;
  const clip = { x: x + width - 6, y: y + at * height, width: 1, height: 1 };
  const colours = await pixels(visit.page, await visit.page.screenshot({ clip }));
  return colours.evaluate(([red]) => 1 - red! / 255);
}

test.each([
  [360, 740],
  [768, 1024],
  [1024, 768],
])('at %i by %i what goes on aside shows that it does, as long as there is more', async (width, height) => {
  const { page } = visit;
  await page.setViewportSize({ width, height });
  await edit('vault:vertices=200');
  const fold = page.getByRole('button', { name: 'Controls', exact: true });
  if (await fold.isVisible()) await fold.click();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  const results = page.locator('.comparison .table');
  // Between its lines; above its words.
  const parts = [[results, 0.48] as const, [page.locator('.toolbar:not(.selection-bar)'), 0.15] as const];
  for (const [part, at] of width < 720 ? parts : parts.slice(0, 1)) {
    await part.evaluate((each) => each.scrollIntoView({ block: 'center' }));
    expect(await shadeOf(part, at)).toBeGreaterThan(0.1);
    const name = part.locator('tbody th').first();
    const stood = (await name.count()) > 0 && (await name.boundingBox());
    const box = (await part.boundingBox())!;
    await page.mouse.move(box.x + 30, box.y + at * box.height + 20);
    await page.mouse.wheel(2000, 0);
    // A line that is pointed at is a little darker.
    await expect.poll(() => shadeOf(part, at)).toBeLessThan(0.06);
    if (stood) expect((await name.boundingBox())!.x).toBeCloseTo(stood.x, 0);
  }
});

test.each([768, 1024])('in a window of %i pixels it is closed where it is named', async (width) => {
  const { page } = visit;
  await page.setViewportSize({ width, height: 768 });
  await edit('vault:vertices=200');
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  const place = async (part: string) => (await page.locator(`.comparison header ${part}`).last().boundingBox())!;
  const [name, close, results] = [
    await place('h2'),
    await place('button'),
    (await page.locator('.comparison').boundingBox())!,
  ];
  expect(close.y).toBeLessThan(name.y + name.height);
  expect(results.x + results.width - close.x - close.width).toBeLessThan(40);
});

test.each([
  [683, 384],
  [700, 500],
])('in a low window of %i by %i neither tools nor legend run over it', async (width, height) => {
  await visit.page.setViewportSize({ width, height });
  await edit(SHAPE);
  await visit.page.getByRole('button', { name: 'Controls' }).click();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  await visit.page.screenshot({ path: join(OUTPUT, `compare-low-${width}.png`) });
  const { y: top } = (await visit.page.locator('.comparison').boundingBox())!;
  for (const part of ['.toolbar:not(.selection-bar)', '.legend']) {
    const box = await visit.page.locator(part).first().boundingBox();
    if (box) expect(box.y + box.height, part).toBeLessThanOrEqual(top);
  }
});

test.each([
  [390, 844],
  [683, 384],
  [740, 360],
  [844, 390],
  [1280, 500],
])('at %i by %i the net is seen beside it and open controls', async (width, height) => {
  const { page } = visit;
  await page.setViewportSize({ width, height });
  await edit(SHAPE);
  const fold = page.getByRole('button', { name: 'Controls', exact: true });
  if (await fold.isVisible()) await fold.click();
  await compare();
  await expect.poll(said, { timeout: 60_000 }).toBe('4 runs');
  if (await fold.isVisible()) await fold.click();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `compare-beside-controls-${width}.png`) });
  expect((await page.locator('#view').boundingBox())!.height).toBeGreaterThan(80);
  expect(await room(page)).toBeGreaterThan(0);
  const tall = await page.evaluate(() => {
    const { vertices } = window.chebnet.stats();
    const heights = Array.from({ length: vertices }, (_, vertex) => window.chebnet.screenPosition(vertex).y);
    return Math.max(...heights) - Math.min(...heights);
  });
  expect(tall).toBeGreaterThan(40);
});

test('what plots is loaded when a plot is seen; if it cannot be, that is said in its place, and the net goes on', async () => {
  ({ script } = await arrive());
  const { page } = script;
  await allSections(page);
  await script.open({ recipe: SHAPE });
  const contentType = 'text/javascript';
  let asked = 0;
  await page.route(/uplot-[^/]*\.js$/, (route) => {
    ++asked;
    return route.fulfill({ contentType, body: 'throw new Error("cut off")' });
  });
  await dragBy(script, dragged, [20, 10]);
  expect(asked).toBe(0);
  await openForResearch(page, 'Step');
  await page.locator('.plot').getByText('This part of the page could not be loaded').waitFor();
  await dragBy(script, dragged, [-10, -10]);
  await script.settled();
  expect((await script.stats()).status).toBe('converged');
});

test('a browser that calls its language C, which is the name of none, has its plot', async () => {
  ({ script } = await arrive());
  const { page } = script;
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'language', { value: 'C' });
    Object.defineProperty(navigator, 'languages', { value: ['C'] });
  });
  await page.reload();
  await script.waitForNet();
  expect(await page.evaluate(() => navigator.language)).toBe('C');
  await allSections(page);
  await script.open({ recipe: SHAPE });
  await openForResearch(page, 'Step');
  await dragBy(script, dragged, [20, 10]);
  await page.locator('.plot canvas').waitFor();
});

/** Opens a shape and pulls its last handle. */
async function edit(recipe: string) {
  await script.open({ recipe });
  const { vertex, target } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(vertex, [target[0] - 1, target[1] + 0.5, target[2] - 0.5]);
  await script.settled();
}

/** With the usual methods and others. */
async function compare(...more: string[]) {
  const { page } = visit;
  await openForResearch(page, 'Compare methods');
  for (const name of more) await page.getByRole('checkbox', { name, exact: true }).check();
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
}

function said(): Promise<string> {
  return visit.page.locator('.comparison [role=status]').innerText();
}

function table() {
  return visit.page.locator('.comparison tbody tr').evaluateAll((rows) =>
    rows.map(({ children }) => {
      const [, iterations, milliseconds, , , angle, , handleError, status] = [...children].map(
        ({ textContent }) => textContent,
      );
      return { iterations, milliseconds, angle, handleError, status };
    }),
  );
}

/** How many of the methods' colours are found in each plot. */
function drawnCurves(): Promise<number[]> {
  return visit.page.locator('.comparison').evaluate((element) => {
    const wanted = [...element.querySelectorAll('.swatch')].map((swatch) =>
      getComputedStyle(swatch).color.match(/\d+/g)!.map(Number),
    );
    return [...element.querySelectorAll('canvas')].map((canvas) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      const isDrawn = (colour: number[]) => {
        for (let i = 0; i < data.length; i += 4) {
          if (data[i + 3] === 255 && colour.every((value, k) => Math.abs(value - data[i + k]!) < 8)) return true;
        }
        return false;
      };
      return wanted.filter(isDrawn).length;
    });
  });
}

/** The file behind a button, as text. */
async function saved(button: string): Promise<string> {
  const download: Promise<Download> = visit.page.waitForEvent('download');
  await visit.page.getByRole('button', { name: button }).click();
  return readFile(await (await download).path(), 'latin1');
}

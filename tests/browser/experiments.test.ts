/** The paper's figures on the page: by link, as a list, with the note on what is claimed, and all variants run at once. */
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { Visit } from './page';
import { OUTPUT, drawn, openForResearch, visits } from './page';

/** A picture that is drawn fast, again and again. */
const SMALL = { width: 800, height: 320 };
const PHONE = { viewport: { width: 390, height: 844 } };

const { arrive, share } = visits();

/** The page with a figure, by a link that comes while something else is open. */
async function visitFigure(experiment: string, viewport?: { width: number; height: number }): Promise<Visit> {
  const visit = await share();
  const { page } = visit;
  if (viewport) await page.setViewportSize(viewport);
  await page.evaluate((name) => {
    const hash = `#experiment=${name}`;
    if (location.hash === hash) dispatchEvent(new HashChangeEvent('hashchange'));
    else location.hash = hash;
  }, experiment);
  await noteOf(page).waitFor();
  await visit.script.settled();
  return visit;
}

const noteOf = (page: Page) => page.getByRole('region', { name: 'Experiment' });

test('a link opens a figure, unsolved, with what the paper claims, and steps show where they lead', async () => {
  const { page, script } = await arrive('#experiment=long-edges');
  const note = noteOf(page);
  await note.getByText('Figure 8: Composite majorization without a smooth start').waitFor();
  expect(await note.getByRole('listitem').allInnerTexts()).toContainEqual(
    expect.stringMatching(
      /^It takes more iterations\.\nDoes not hold: it was so in none of the 3 edits\.\s+In the first edit\s+Li et al\. 2022\s+\d+ iterations\s+Composite majorization\s+\d+ iterations/,
    ),
  );
  expect(await note.innerText()).toMatch(/Computer Graphics Forum 41\(2\), 2022/);
  expect(await script.stats()).toMatchObject({ method: 'composite_majorization', iterations: 0 });

  await openForResearch(page, 'Step');
  const arrows = page.getByLabel('Direction as arrows');
  await arrows.check();
  await note.getByRole('button', { name: 'One step' }).click();
  await expect.poll(async () => (await script.stats()).iterations).toBe(1);
  await script.settled();
  await expect
    .poll(() => page.locator('[role=status]').allInnerTexts())
    .toContainEqual(expect.stringMatching(/Large exponent, exponent p = /));
  await expect.poll(() => page.locator('.sidebar').innerText()).toMatch(/Move, edges\s+\d/);
  await page.screenshot({ path: join(OUTPUT, 'experiment-desktop.png') });
  const net = { x: 400, y: 150, width: 400, height: 550 };
  const withArrows = await page.screenshot({ clip: net });
  await arrows.uncheck();
  await expect.poll(async () => (await page.screenshot({ clip: net })).equals(withArrows)).toBe(false);

  await note.getByRole('link', { name: 'Li et al. 2022' }).click();
  await expect.poll(async () => (await script.stats()).method).toBe('li2022');
  await note.getByRole('button', { name: 'Solve' }).click();
  await expect.poll(async () => (await script.stats()).status, { timeout: 20_000 }).toBe('converged');

  const solved = await script.positions();
  await page.keyboard.press('Control+z');
  await script.settled();
  expect(await script.positions()).not.toEqual(solved);
  await page.keyboard.press('Control+y');
  await script.settled();
  expect(await script.positions()).toEqual(solved);
});

test('the list of figures is links, and a link to the one that is open begins it again', async () => {
  const { page, script } = await share();
  await openForResearch(page, 'Experiments');
  const link = page.getByRole('link', { name: 'General meshes' });
  for (const _ of ['first', 'again']) {
    await link.click();
    await expect.poll(async () => script.stats()).toMatchObject({ method: 'li2022', iterations: 0 });
    await page.getByText(/: General meshes\. Undo brings back/).waitFor();
    await page.locator('.status-words', { hasText: 'Ready to be solved' }).waitFor();
    await page.getByRole('button', { name: 'One step' }).first().click();
    await expect.poll(async () => (await script.stats()).iterations).toBe(1);
  }
  expect(await link.getAttribute('aria-current')).toBe('true');
});

test('links lead to other edits with the same variant, and to other variants with the same edit', async () => {
  const { page } = await visitFigure('starts&variant=1');
  const note = noteOf(page);
  await note.getByText('Figure 18').waitFor();
  const [edits, variants] = ['Edits', 'Variants'].map((name) => note.getByRole('navigation', { name }));
  const current = () =>
    Promise.all([edits!, variants!].map((links) => links.locator('[aria-current=true]').innerText()));
  const [first, other] = await edits!.getByRole('link').allInnerTexts();
  expect(await current()).toEqual([first, '5 × ARAP']);
  await edits!.getByRole('link', { name: other! }).click();
  await expect.poll(current).toEqual([other, '5 × ARAP']);
  await variants!.getByRole('link', { name: '5 × local–global' }).click();
  await expect.poll(current).toEqual([other, '5 × local–global']);
});

test.each([
  [1280, 800],
  [1366, 768],
])('at %i by %i what is said of a net that is stuck leaves the buttons of the note free', async (width, height) => {
  const { page, script } = await visitFigure('long-edges', { width, height });
  const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(vertex, [target[0], target[1], target[2] + 20]);
  await page.locator('.stuck-notice .message').waitFor();
  await script.settled();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `experiment-stuck-${width}.png`) });
  const { buttons, covered } = await noteOf(page)
    .locator('.buttons button:visible')
    .evaluateAll((all) => {
      // No message takes the pointer: what is below it can be pressed, but not seen.
      const over = document.querySelector('.messages')!.getBoundingClientRect();
      const isCovered = (each: Element) => {
        const { left, right, top, bottom } = each.getBoundingClientRect();
        return left < over.right && over.left < right && top < over.bottom && over.top < bottom;
      };
      return { buttons: all.length, covered: all.filter(isCovered).map(({ textContent }) => textContent) };
    });
  expect(buttons).toBeGreaterThan(1);
  expect(covered).toEqual([]);
});

test.each([
  [900, 700],
  [1024, 768],
  [820, 1180],
])('at %i by %i what is said of the net covers neither the note nor a handle', async (width, height) => {
  const { page, script } = await visitFigure('one-edit', { width, height });
  await noteOf(page).getByRole('button', { name: 'Solve' }).click();
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  await script.settled();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `experiment-crumpled-${width}.png`) });
  const box = (await page.locator('.messages').boundingBox())!;
  const note = (await noteOf(page).boundingBox())!;
  expect(box.y).toBeGreaterThanOrEqual(note.y + note.height);
  const handles = await page.evaluate(() =>
    window.chebnet.handles().map((h) => window.chebnet.screenPosition(h.vertex)),
  );
  const covered = handles.filter(
    ({ x, y }) => box.x - 12 < x && x < box.x + box.width + 12 && box.y - 12 < y && y < box.y + box.height + 12,
  );
  expect(covered).toEqual([]);
});

test('on a phone on its side neither message nor tools lie over the note, also where a handle is selected', async () => {
  const { page, script } = await arrive('#experiment=one-edit', {
    viewport: { width: 740, height: 360 },
    hasTouch: true,
  });
  const note = noteOf(page);
  await note.getByRole('button', { name: 'Solve' }).tap();
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  await script.settled();
  // What to do is a line below the tools, not a column beside them.
  const toDo = page.locator('.title > p').first();
  const tools = (await page.locator('.toolbar:not(.selection-bar)').boundingBox())!;
  await page.screenshot({ path: join(OUTPUT, 'experiment-side.png') });
  const isClear = async () => {
    await drawn(page);
    const [box, over] = [(await note.boundingBox())!, (await message.boundingBox())!];
    expect(over.y).toBeGreaterThanOrEqual(box.y + box.height);
    expect(over.width).toBeGreaterThan(280);
    expect(box.y).toBeGreaterThanOrEqual(tools.y + tools.height);
  };
  await isClear();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar:not([hidden])').waitFor({ state: 'attached' });
  await page.screenshot({ path: join(OUTPUT, 'experiment-side-selected.png') });
  await isClear();
  await message.getByRole('button', { name: 'Dismiss' }).tap();
  await expect.poll(async () => (await toDo.boundingBox())?.height ?? 0).toBeGreaterThan(0);
  expect((await toDo.boundingBox())!.height).toBeLessThan(45);
});

test('a phone shows net and note without scrolling sideways', async () => {
  const { page } = await arrive('#experiment=competitors', PHONE);
  await noteOf(page).getByText('Figure 17').waitFor();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, 'experiment-phone.png') });
  expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);
  await noteOf(page).getByText('Figure 17').click();
  await noteOf(page).getByText('A larger p does not help D_p.').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'experiment-phone-open.png') });
});

test.each([
  ['one-edit', 0],
  ['long-edges', 400],
])(
  'on a tablet upright the net of %s is large below the note, of which at most %i pixels are to be scrolled to',
  async (experiment, most) => {
    const { page } = await visitFigure(experiment, { width: 768, height: 1024 });
    await drawn(page);
    await page.screenshot({ path: join(OUTPUT, `experiment-tablet-${experiment}.png`) });
    const note = (await noteOf(page).boundingBox())!;
    const cut = await noteOf(page)
      .locator('details')
      .evaluate((text) => text.scrollHeight - text.clientHeight);
    expect(cut).toBeLessThanOrEqual(most);
    const [top, bottom] = await page.evaluate(() => {
      const { stats, screenPosition } = window.chebnet;
      const heights = Array.from({ length: stats().vertices }, (_, vertex) => screenPosition(vertex).y);
      return [Math.min(...heights), Math.max(...heights)] as const;
    });
    expect(top).toBeGreaterThan(note.y + note.height);
    expect(bottom - top).toBeGreaterThan(300);
  },
);

test.each([
  [820, 1180, 'one-edit'],
  [820, 1180, 'energy-of-an-edge'],
  [1024, 768, 'one-edit'],
  [1280, 800, 'one-edit'],
])('on a screen of %i by %i the note on %s stays clear above a comparison', async (width, height, experiment) => {
  const { page } = await visitFigure(experiment, { width, height });
  const note = noteOf(page);
  await note.getByRole('button', { name: 'One step' }).waitFor();
  await openForResearch(page, 'Compare methods');
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await page.locator('.comparison .table').waitFor();
  await drawn(page);
  // Nothing lies over its heading, or over what can be done.
  const covered = await note.locator('summary, .buttons button').evaluateAll((all) =>
    all
      .filter((each) => each.checkVisibility())
      .flatMap((each) => {
        const { left, right, top, bottom } = each.getBoundingClientRect();
        const corners = [left + 3, right - 3].flatMap((x) => [top + 3, bottom - 3].map((y) => [x, y] as const));
        const isSeen = corners.every(([x, y]) => each.contains(document.elementFromPoint(x, y)));
        return isSeen ? [] : [each.textContent];
      }),
  );
  expect(covered).toEqual([]);
  const [box, legend] = [(await note.boundingBox())!, (await page.locator('.legend').boundingBox())!];
  expect(box.y + box.height).toBeLessThanOrEqual(legend.y);
});

test('an unknown experiment shows the first net and says so', async () => {
  const { page, script } = await arrive('#experiment=nonsense');
  await expect.poll(() => page.getByRole('alert').innerText()).toMatch(/experiment/);
  expect((await script.stats()).vertices).toBeGreaterThan(1000);
});

// ------------------------------------------------------------------------------------------------------ what is claimed

test('figure 4: three nets with every edge at its length, apart from each other', async () => {
  const { page } = await visitFigure('shear');
  const rows = await runAll(page);
  expect(rows.map(({ status }) => status)).toEqual(['Converged', 'Converged', 'Converged']);
  const [, ...distances] = rows.map(({ distance }) => distance);
  for (const distance of distances) expect(distance).toBeGreaterThan(0.05);

  await page.getByRole('button', { name: 'Side by side' }).click();
  await expect.poll(() => page.locator('#view canvas, #beside canvas').count()).toBe(3);
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, 'experiment-abreast.png') });
  await page.getByRole('button', { name: 'Back to your net' }).click();
  await expect.poll(() => page.locator('#beside canvas').count()).toBe(0);
});

test('figure 8: composite majorization makes more edges longer than L on its way, and the legend says how many', async () => {
  const peaks: number[] = [];
  for (const variant of ['Composite majorization', 'Li et al. 2022']) {
    const { page } = await visitFigure('long-edges', SMALL);
    await noteOf(page).getByRole('link', { name: variant }).click();
    await noteOf(page).locator('[aria-current=true]', { hasText: variant }).waitFor();
    const shares = await stepToEnd(page);
    peaks.push(Math.max(...shares));
    await expect
      .poll(() => page.locator('.legend .words').innerText())
      .toBe(`Net: ${(100 * shares.at(-1)!).toFixed(1)} % longer than L`);
  }
  expect(peaks[0]).toBeGreaterThan(peaks[1]!);
});

test('figure 16: nets of other sizes are run, but not shown in place of the one that is open', async () => {
  const { page } = await visitFigure('resolutions');
  const rows = await runAll(page);
  expect(rows.map(({ status }) => status)).toEqual(['Converged', 'Converged', 'Converged']);
  const buttons = page.locator('.comparison tbody th button');
  expect(await buttons.evaluateAll((all) => all.map((each) => (each as HTMLButtonElement).disabled))).toEqual([
    false,
    true,
    true,
  ]);
});

test('figure 17: ARAP ends above the threshold, local–global after more iterations, and D_p is not helped by a larger p', async () => {
  const { page } = await visitFigure('competitors');
  const [paper, ...competitors] = await runAll(page);
  expect(paper!.status).toBe('Converged');
  const others = competitors.filter(({ name }) => name !== 'Composite majorization');
  expect(others.map(({ name }) => name)).toEqual(['ARAP', 'Local–global', 'D_p, p = 4', 'D_p, p = 8']);
  const [arap, localGlobal, dp4, dp8] = others;
  expect(arap!.status).not.toBe('Converged');
  expect(localGlobal!.iterations).toBeGreaterThan(paper!.iterations);
  expect(dp8!.iterations).toBeGreaterThan(dp4!.iterations);
  // What the paper claims is beside the numbers to be read.
  const claim = await noteOf(page).getByRole('list').first().boundingBox();
  const note = await noteOf(page).boundingBox();
  expect(note!.height).toBeGreaterThan(150);
  expect(claim!.y).toBeLessThan(note!.y + note!.height / 2);
});

test('figure 3: new nets are made of three bodies, beside edits, and can be stopped', {
  timeout: 300_000,
}, async () => {
  const { page } = await visitFigure('new-net');
  const trial = noteOf(page).getByRole('region', { name: 'An edit and a new net' });
  const begin = trial.getByRole('button', { name: 'Make new nets' });
  const bodies = trial.locator('tbody');
  await begin.click();
  await trial.getByText('Rabbit 3,492: making a new net').waitFor({ timeout: 60_000 });
  await expect
    .poll(() => trial.locator('progress').evaluate((bar: HTMLProgressElement) => bar.value))
    .toBeGreaterThan(0.1);
  await trial.getByRole('button', { name: 'Stop' }).click();
  expect(await trial.locator('progress').isVisible()).toBe(false);

  await begin.click();
  await trial.getByText(/^A new net took /).waitFor({ timeout: 120_000 });
  expect(await bodies.count()).toBeGreaterThan(0);
  await begin.waitFor({ timeout: 240_000 });
  await page.screenshot({ path: join(OUTPUT, 'experiment-new-net.png') });
  const rows = await bodies.evaluateAll((all) =>
    all.map((body) =>
      [...body.querySelectorAll('tr')].map(({ children }) => [...children].map((cell) => cell.textContent ?? '')),
    ),
  );
  expect(rows.map(([head]) => head?.[0])).toEqual(['Rabbit 3,492', 'Teddy 3,474', 'Horse 1,452']);
  for (const [, paper, ours, made] of rows) {
    const seconds = ([, time = '']: string[] = []) => parseFloat(time) / (time.endsWith('ms') ? 1000 : 1);
    expect(seconds(made)).toBeGreaterThan(seconds(paper));
    expect(seconds(made)).toBeGreaterThan(5 * seconds(ours));
    expect(paper![2]).toBe(ours![2]);
    expect(Number(made![2])).toBeGreaterThanOrEqual(8);
    expect(Number(made![3])).toBeLessThan(Number(ours![3]));
  }
  expect(await trial.getByRole('status').innerText()).toMatch(/A new net took \d[\d,.]* to \d[\d,.]* times as long/);

  // What was found out is still there after another figure.
  await page.evaluate(() => (location.hash = '#experiment=shear'));
  await noteOf(page).getByText('Figure 4').waitFor();
  await page.evaluate(() => (location.hash = '#experiment=new-net'));
  await noteOf(page).getByText('Figure 3').waitFor();
  expect(await bodies.count()).toBe(3);
});

/** By a few steps at a time; the part of the edges longer than L after each few. */
function stepToEnd(page: Page): Promise<number[]> {
  return page.evaluate(async () => {
    const { chebnet } = window;
    const edges = chebnet.edges();
    const lengths = () => {
      const at = chebnet.positions();
      const along = (edge: number, axis: number) =>
        at[3 * edges[2 * edge]! + axis]! - at[3 * edges[2 * edge + 1]! + axis]!;
      return Array.from({ length: edges.length / 2 }, (_, edge) =>
        Math.hypot(along(edge, 0), along(edge, 1), along(edge, 2)),
      );
    };
    // All have it at rest; now some have been stretched by handles that were moved.
    const length = lengths().sort((a, b) => a - b)[edges.length >> 2]!;
    const step = [...document.querySelectorAll<HTMLButtonElement>('.experiment button')].find(
      ({ textContent }) => textContent === 'One step',
    )!;
    const shares: number[] = [];
    do {
      for (let i = 0; i < 4; ++i) step.click();
      await chebnet.settled();
      shares.push(lengths().filter((each) => each > (1 + 1e-8) * length).length / (edges.length / 2));
    } while (chebnet.stats().status === 'running' && shares.length < 15);
    return shares;
  });
}

/** Presses the button, and reads the table when all is done. */
async function runAll(page: Page) {
  await noteOf(page).getByRole('button', { name: 'Run all' }).click();
  await page.locator('.comparison [role=status]', { hasText: /^\d+ runs$/ }).waitFor({ timeout: 90_000 });
  const cells = await page
    .locator('.comparison tbody tr')
    .evaluateAll((rows) => rows.map(({ children }) => [...children].map((cell) => cell.textContent ?? '')));
  return cells.map(([name = '', iterations = '', , , , , distance = '', , status]) => {
    return { name, iterations: Number(iterations.replace(',', '')), distance: Number(distance), status };
  });
}

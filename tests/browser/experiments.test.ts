/** A link to an experiment: the net, what to look for, and one step of the solve with its direction. */
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { OUTPUT, visits } from './page';

const PHONE = { viewport: { width: 390, height: 844 } };

const { arrive } = visits();

test('a link opens an experiment, unsolved, and steps show where they lead', async () => {
  const { page, script } = await arrive('#experiment=long-edges');
  const note = page.getByRole('region', { name: 'Experiment' });
  expect(await note.innerText()).toMatch(/Figure 8: Longer on the way/);
  expect(await note.innerText()).toMatch(/composite majorization/i);
  expect(await script.stats()).toMatchObject({ vertices: 1505, method: 'composite_majorization', iterations: 0 });

  await page.locator('summary', { hasText: /^Step$/ }).click();
  const arrows = page.getByLabel('Direction as arrows');
  await arrows.check();
  await note.getByRole('button', { name: 'One step' }).click();
  await expect.poll(async () => (await script.stats()).iterations).toBe(1);
  await script.settled();
  await expect.poll(() => page.locator('[role=status]').allInnerTexts()).toContainEqual(expect.stringMatching(/Stage 1/));
  await expect.poll(() => page.locator('.sidebar').innerText()).toMatch(/Move, edges\s+\d/);
  await page.screenshot({ path: join(OUTPUT, 'experiment-desktop.png') });
  const net = { x: 500, y: 150, width: 300, height: 550 };
  const withArrows = await page.screenshot({ clip: net });
  await arrows.uncheck();
  await expect.poll(async () => (await page.screenshot({ clip: net })).equals(withArrows)).toBe(false);

  await note.getByRole('link', { name: 'The paper’s method' }).click();
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

test('the list of experiments is links, and a link to the one that is open begins it again', async () => {
  const { page, script } = await arrive();
  await page.locator('summary', { hasText: /^Experiments$/ }).click();
  const link = page.getByRole('link', { name: 'General meshes' });
  for (const _ of ['first', 'again']) {
    await link.click();
    await expect.poll(async () => script.stats()).toMatchObject({ vertices: 1369, iterations: 0 });
    await script.move(684, [0.14, -0.03, 3]);
    await script.settled();
    expect((await script.stats()).iterations).toBeGreaterThan(0);
  }
});

test('a phone shows net and note without scrolling sideways', async () => {
  const { page } = await arrive('#experiment=singular-vertices', PHONE);
  await expect.poll(() => page.getByRole('region', { name: 'Experiment' }).isVisible()).toBe(true);
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(OUTPUT, 'experiment-phone.png') });
  expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);
});

test('an unknown experiment shows the first net and says so', async () => {
  const { page, script } = await arrive('#experiment=nonsense');
  await expect.poll(() => page.getByRole('alert').innerText()).toMatch(/experiment/);
  expect((await script.stats()).vertices).toBeGreaterThan(1000);
});

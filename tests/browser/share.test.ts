/** Links: what one visitor copies, another one sees. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { load } from '../wasm/load';
import { hashWithZeros } from '../web/hash_with_zeros';
import { distance, dragBy } from './geometry';
import type { Visit } from './page';
import { visits } from './page';

const { address, arrive } = visits();

test('a copied link shows the same scene', async () => {
  const recipe = 'vault:vertices=1000';
  const reference = (await load()).openRecipe(recipe);
  const dragged = reference.suggestedHandles.at(-1)!;
  const { meanLength, vertices } = reference.info;

  const sender = await arrive();
  await sender.script.open({ recipe });
  await dragBy(sender.script, dragged, [-60, -40]);
  await sender.script.settled();
  await sender.page
    .getByRole('button', { name: /copy link|share/i })
    .first()
    .click();
  await sender.page.waitForTimeout(500);
  const link = await sender.page.evaluate(() => navigator.clipboard.readText());
  console.log(`link of ${link.length} characters`);
  expect(link.startsWith(`${address()}#`)).toBe(true);
  expect(link.length).toBeLessThan(8000);

  const receiver = await arrive(link);
  await receiver.script.settled();
  const [sent, received] = [await sender.script.positions(), await receiver.script.positions()];
  expect(received).toHaveLength(3 * vertices);
  const errors = Array.from({ length: vertices }, (_, v) =>
    distance(sent.subarray(3 * v, 3 * v + 3), received.subarray(3 * v, 3 * v + 3)),
  );
  expect(Math.max(...errors)).toBeLessThan(1e-4 * meanLength);
  expect((await receiver.script.stats()).handles).toBe((await sender.script.stats()).handles);
  const [here, there] = [await sender.script.screenPosition(dragged), await receiver.script.screenPosition(dragged)];
  expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(3);
});

test('ends of colours set by hand come with the link, each field with its own; a click leads back to those of the map', async () => {
  const { page, script } = await arrive();
  await script.settled();
  const legendOf = (at: Page) => at.getByRole('region', { name: 'Legend' });
  const ticks = (at = page) => legendOf(at).locator('.ticks span').allInnerTexts();
  const picture = () => page.locator('#view').screenshot();
  const own = await ticks();
  const before = await picture();
  await legendOf(page).getByText('Ends of the colours').click();
  const [low, high] = [page.getByLabel('Lower end'), page.getByLabel('Upper end')];
  expect([await low.inputValue(), await high.inputValue()]).toEqual(['1e-6', '2e-6']);

  await low.fill('3e-6');
  await low.press('Enter');
  expect(await low.evaluate((input: HTMLInputElement) => input.validationMessage)).toMatch(/lower one first/);
  expect(await ticks()).toEqual(own);
  await low.fill('1e-30');
  await high.fill('1e-25');
  await high.press('Enter');
  expect(await low.evaluate((input: HTMLInputElement) => input.validity.valid)).toBe(true);
  expect(await ticks()).toEqual(['dL 1e-30', 'dL 1e-25']);
  await expect.poll(picture).not.toEqual(before);

  await page.evaluate(() => window.chebnet.settled());
  const receiver = await arrive(await page.evaluate(() => window.chebnet.link()));
  expect(await ticks(receiver.page)).toEqual(['dL 1e-30', 'dL 1e-25']);

  await page.getByText('Appearance', { exact: true }).click();
  await page.getByLabel('Colour by').selectOption('angle');
  expect(await ticks()).toEqual(['45°', '90°', '135°']);
  await page.getByLabel('Colour by').selectOption('deviation');
  expect(await ticks()).toEqual(['dL 1e-30', 'dL 1e-25']);
  await page.getByRole('button', { name: 'Automatic' }).click();
  expect(await ticks()).toEqual(own);
  expect(await low.inputValue()).toBe('1e-6');
});

const BROKEN = [
  ['of another site', '#nonsense'],
  ['of a future version', '#v=999&d=AAAA'],
  ['cut inside a character', '#%E0%A4%A'],
  ['of noise', `#${'A'.repeat(5000)}`],
  ['of a gigabyte', hashWithZeros({}, 1e9)],
] as const;

test('a broken link shows the first net and says so', async () => {
  const first = async ({ script }: Visit) => {
    const { vertices, handles } = await script.stats();
    return { vertices, handles };
  };
  const usual = await first(await arrive());
  for (const [what, hash] of BROKEN) {
    const visit = await arrive(hash);
    const said = () => visit.page.locator('[role=alert], [role=status]').allInnerTexts();
    await expect.poll(said, { message: what }).toContainEqual(expect.stringMatching(/link/i));
    expect(await first(visit), what).toEqual(usual);
  }
});

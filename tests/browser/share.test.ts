/** Links: what one visitor copies, another one sees. */
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { load } from '../wasm/load';
import { hashWithZeros } from '../web/hash_with_zeros';
import { distance, dragBy } from './geometry';
import type { Visit } from './page';
import { drawn, OUTPUT, room, visits } from './page';

const { address, arrive, share } = visits();

/** Opens "Share", waits until the link is copied, and returns it. */
async function copied({ page }: Visit): Promise<string> {
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  await page.getByRole('dialog', { name: 'Share' }).getByText('The link is copied.').waitFor();
  return page.evaluate(() => navigator.clipboard.readText());
}

/** Largest distance between the places of a vertex. */
function farthest(a: Float64Array, b: Float64Array): number {
  expect(a).toHaveLength(b.length);
  const places = Array.from({ length: a.length / 3 }, (_, v) => 3 * v);
  return Math.max(...places.map((at) => distance(a.subarray(at, at + 3), b.subarray(at, at + 3))));
}

test('a copied link is short, and shows the same scene; at choice it has all positions', async () => {
  const recipe = 'vault:vertices=1000';
  const reference = (await load()).openRecipe(recipe);
  const dragged = reference.suggestedHandles.at(-1)!;
  const { meanLength } = reference.info;
  const sender = await share();
  await sender.script.open({ recipe });
  await dragBy(sender.script, dragged, [-60, -40]);
  await sender.script.settled();
  const sent = await sender.script.positions();
  const short = await copied(sender);
  await sender.page.screenshot({ path: join(OUTPUT, 'share-short.png') });
  await sender.page.getByRole('radio', { name: /^These positions/ }).click();
  await expect.poll(() => sender.page.evaluate(() => navigator.clipboard.readText())).not.toBe(short);
  const exact = await sender.page.evaluate(() => navigator.clipboard.readText());
  console.log(`links of ${short.length} and ${exact.length} characters`);
  expect(short.length).toBeLessThan(500);
  expect(exact.length).toBeLessThan(8000);

  for (const link of [short, exact]) {
    expect(link.startsWith(`${address()}#`)).toBe(true);
    const receiver = await arrive(link);
    await receiver.script.settled();
    expect(farthest(await receiver.script.positions(), sent)).toBeLessThan(1e-4 * meanLength);
    expect((await receiver.script.stats()).handles).toBe((await sender.script.stats()).handles);
    const [here, there] = [await sender.script.screenPosition(dragged), await receiver.script.screenPosition(dragged)];
    expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(3);
  }
});

/** Opens a shape of the gallery, and drags its last handle over the screen. */
async function dragShape({ page, script }: Visit, shape: string, [dx, dy]: [number, number]): Promise<void> {
  await page.locator(`.gallery [data-shape=${shape}]`).click();
  await expect.poll(() => page.locator(`.gallery [data-shape=${shape}]`).getAttribute('aria-pressed')).toBe('true');
  await script.settled();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await dragBy(script, vertex, [dx, dy]);
  await script.settled();
}

test('nobody has to wait for the trial whether a link does without positions', async () => {
  const sender = await share();
  const { page } = sender;
  await dragShape(sender, 'shirt', [60, -40]);
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Share' });
  await dialog.getByText('Solving for the shape again').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'share-waits.png') });
  await dialog.getByRole('button', { name: 'Do not wait' }).click();
  await dialog.getByText('The link is copied.').waitFor();
  expect(await dialog.getByRole('button', { name: 'Do not wait' }).count()).toBe(0);
  expect((await page.evaluate(() => navigator.clipboard.readText())).length).toBeGreaterThan(1000);
});

test.each([
  ['sheet', 30, 20],
  ['saddle', -50, -40],
  // Pulled taut beyond its reach: it has several shapes at rest, and its drag is made again.
  ['scroll', 180, 0],
] as const)(
  'a link of a %s after one drag is short: it comes to rest again, if not to the last digit',
  async (shape, dx, dy) => {
    const sender = await share();
    const { script } = sender;
    await dragShape(sender, shape, [dx, dy]);
    const sent = await script.positions();
    const link = await copied(sender);
    expect(link.length).toBeLessThan(500);
    const receiver = await arrive(link);
    await receiver.script.settled();
    const edge = distance(sent.subarray(0, 3), sent.subarray(3, 6));
    expect(farthest(await receiver.script.positions(), sent)).toBeLessThan(1e-2 * edge);
  },
);

test('where the clipboard is closed the link goes into the address bar, but only when it is to be copied', async () => {
  const { page, script } = await arrive();
  await script.open({ recipe: 'vault:vertices=300' });
  await script.settled();
  await page.evaluate(() => (navigator.clipboard.writeText = () => Promise.reject(new Error('No.'))));
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Share' });
  await dialog.getByText('The link is made').waitFor();
  expect(new URL(page.url()).hash).toBe('');
  await dialog.getByRole('button', { name: 'Copy link' }).click();
  await dialog.getByText('the link is in the address bar').waitFor();
  expect(new URL(page.url()).hash).toMatch(/^#v/);
});

test('a link that can neither be copied nor be put into the address bar says why', async () => {
  const { page, script } = await arrive();
  await script.settled();
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error('closed'));
    history.replaceState = () => {
      throw new Error('too often');
    };
  });
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Share' });
  await dialog.getByText('The link is made').waitFor();
  await dialog.getByRole('button', { name: 'Copy link' }).click();
  await dialog.getByRole('status').getByText('too often').waitFor();
});

test('a link shows a net that was dragged from where its sender saw it, though nobody turned the camera', async () => {
  const sender = await share();
  await sender.script.settled();
  const { vertex } = (await sender.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const untouched = await copied(sender);
  await sender.page.keyboard.press('Escape');
  await dragBy(sender.script, vertex, [150, 60]);
  await sender.script.settled();
  const seen = await sender.script.screenPosition(vertex);
  const dragged = await sender.page.evaluate(() => window.chebnet.link());
  const receiver = await arrive(dragged);
  await receiver.script.settled();
  const { x, y } = await receiver.script.screenPosition(vertex);
  expect(Math.hypot(x - seen.x, y - seen.y)).toBeLessThan(3);
  // A phone shows all of it, and one that is framed as it is, of which the link has no camera, as large as it can.
  for (const [link, least] of [
    [dragged, 0],
    [untouched, 15],
  ] as const) {
    const phone = await arrive(link, { viewport: { width: 390, height: 844 } });
    await phone.script.settled();
    expect(await room(phone.page)).toBeGreaterThan(least);
  }
});

test('a net of thousands of cells made on a surface has a link, which opens as the net with all its handles', async () => {
  const sender = await share();
  await sender.page.evaluate(() => window.chebnet.remesh({ own: 'pebble' }, { cells: 3000 }));
  await sender.script.settled();
  expect((await sender.script.stats()).vertices).toBeGreaterThan(2500);
  const { vertex, target } = (await sender.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await sender.script.move(vertex, [target[0], target[1], target[2] + 0.05]);
  await sender.script.settled();
  const link = await copied(sender);
  console.log(`a link of ${link.length} characters`);
  const receiver = await arrive(link);
  await receiver.script.settled();
  const [sent, got] = [await sender.script.stats(), await receiver.script.stats()];
  for (const name of ['vertices', 'edges', 'handles', 'status'] as const) expect(got[name]).toBe(sent[name]);
  expect(got.maxDeviation).toBeLessThan(1e-6);
  const [sentPlaces, places] = [await sender.script.positions(), await receiver.script.positions()];
  const edge = distance(places.subarray(0, 3), places.subarray(3, 6));
  expect(farthest(places, sentPlaces)).toBeLessThan(1e-4 * edge);
});

test('what a wide screen showed is within a narrow one, which keeps what is zoomed in there', async () => {
  const sender = await share();
  await sender.page.mouse.move(80, 560);
  await sender.page.mouse.down();
  await sender.page.mouse.move(200, 580, { steps: 3 });
  await sender.page.mouse.up();
  const receiver = await arrive(await copied(sender), { viewport: { width: 390, height: 844 } });
  const places = () =>
    receiver.page.evaluate(() =>
      Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v)),
    );
  const across = (await places()).map(({ x }) => x);
  expect(Math.min(...across)).toBeGreaterThan(0);
  expect(Math.max(...across)).toBeLessThan(390);

  await receiver.page.locator('#view canvas').focus();
  for (let i = 0; i < 8; i++) await receiver.page.keyboard.press('+');
  await drawn(receiver.page);
  expect((await places()).some(({ x }) => x < 0 || x > 390)).toBe(true);
  const zoomed = (await places())[0]!;
  const link = await receiver.page.evaluate(() => window.chebnet.link());
  const again = await arrive(link, { viewport: { width: 390, height: 844 } });
  const { x, y } = await again.script.screenPosition(0);
  expect(Math.hypot(x - zoomed.x, y - zoomed.y)).toBeLessThan(1);
});

test('where solving again would give another shape, the link has the positions', async () => {
  const sender = await share();
  await sender.script.open({ recipe: 'dome:vertices=300' });
  await sender.page.evaluate(() => window.chebnet.setOptions({ method: 'projection' }));
  const { vertex, target } = (await sender.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await sender.script.move(vertex, [target[0], target[1], target[2] + 1]);
  await sender.script.settled();
  const receiver = await arrive(await copied(sender));
  expect(await sender.page.getByRole('radio').count()).toBe(0);
  expect(farthest(await receiver.script.positions(), await sender.script.positions())).toBeLessThan(1e-4);
});

test('ends of colours set by hand come with the link, each field with its own; a click leads back to those of the map', async () => {
  const { page, script } = await share();
  await script.settled();
  const legendOf = (at: Page) => at.getByRole('region', { name: 'Legend' });
  const ticks = (at = page) => legendOf(at).locator('.ticks span').allInnerTexts();
  const picture = () => page.locator('#view').screenshot();
  const own = await ticks();
  const before = await picture();
  await legendOf(page).getByText('Ends of the colours').click();
  const [low, high] = [page.getByLabel('Lower end'), page.getByLabel('Upper end')];
  expect([await low.inputValue(), await high.inputValue()]).toEqual(['1e-6', '2e-6']);
  const unit = legendOf(page).locator('.unit');
  expect(await unit.innerText()).toBe('dL of 0.1\u00a0% and 0.14\u00a0%');

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
  await high.fill('0,5');
  await high.press('Enter');
  expect(await ticks()).toEqual(['dL 1e-30', 'dL 0.5']);
  await high.fill('1e-25');
  await high.press('Enter');

  await page.evaluate(() => window.chebnet.settled());
  const receiver = await arrive(await page.evaluate(() => window.chebnet.link()));
  expect(await ticks(receiver.page)).toEqual(['dL 1e-30', 'dL 1e-25']);

  await page.getByText('Appearance', { exact: true }).click();
  await page.getByLabel('Colour by').selectOption('angle');
  expect(await ticks()).toEqual(['45°', '90°', '135°']);
  expect(await unit.innerText()).toBe('In degrees');
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

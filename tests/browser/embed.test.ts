/** The editor inside of another page: it does not get in the way, wakes at a click, and takes calls. */
import { join } from 'node:path';
import type { Frame, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import { distance } from './geometry';
import { OUTPUT, visits } from './page';

const site = visits();
let page: Page;
let frame: Frame;
beforeEach(async () => {
  ({ page } = await site.open('lesson.html'));
  await page.getByText('The largest dL of its').waitFor();
  frame = page.frame({ url: /\?embed/ })!;
});

const settled = () => frame.evaluate(() => window.chebnet.settled());
const shield = () => frame.getByRole('button', { name: 'Press to drag the net' });
const scrolled = () => page.evaluate(() => scrollY);
const crown = () => frame.evaluate(() => window.chebnet.handles().at(-1)!);

/** Where the handle to drag is seen in the window. */
async function placeOfCrown() {
  const { vertex } = await crown();
  const { x, y } = await frame.evaluate((v) => window.chebnet.screenPosition(v), vertex);
  const box = (await page.locator('iframe').boundingBox())!;
  return { x: box.x + x, y: box.y + y };
}

test('the page scrolls past it, a click wakes it, a drag moves the net, Escape and a click elsewhere let go', async () => {
  await page.setViewportSize({ width: 1000, height: 700 });
  const before = await placeOfCrown();
  await page.mouse.move(before.x, before.y + 60);
  await page.mouse.wheel(0, 80);
  await expect.poll(scrolled).toBe(80);
  const after = await placeOfCrown();
  expect(Math.hypot(after.x - before.x, after.y + 80 - before.y)).toBeLessThan(1e-6);

  await shield().click();
  await shield().waitFor({ state: 'hidden' });
  const still = await scrolled();
  await page.mouse.wheel(0, 80);
  const { target } = await crown();
  const { x, y } = await placeOfCrown();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 30, { steps: 5 });
  await page.mouse.up();
  await settled();
  expect(await scrolled()).toBe(still);
  expect(distance((await crown()).target, target)).toBeGreaterThan(0.1);
  await page.screenshot({ path: join(OUTPUT, 'lesson.png') });

  await page.keyboard.press('Escape');
  await shield().waitFor();
  await shield().click();
  await shield().waitFor({ state: 'hidden' });
  await page.getByRole('heading').first().click();
  await shield().waitFor();
});

test('buttons of the page move its handle and hear what comes of it', async () => {
  await settled();
  const { target } = await crown();
  await page.getByRole('button', { name: 'Push the crown down' }).click();
  await expect.poll(async () => (await crown()).target[2]).toBeCloseTo(target[2] - 0.4, 9);
  await expect.poll(() => page.getByRole('status').innerText()).toMatch(/is (\d\.\de-\d+|below 1e-12), after [1-9]/);
});

test('the way out leads to the editor with the same scene', async () => {
  await page.getByRole('button', { name: 'Push the crown down' }).click();
  await settled();
  const [editor] = await Promise.all([
    page.waitForEvent('popup'),
    frame.getByRole('link', { name: 'Open in chebnet' }).click(),
  ]);
  await editor.waitForFunction(() => window.chebnet?.stats().vertices > 0);
  expect(new URL(editor.url()).search).toBe('');
  const there = await editor.evaluate(() => window.chebnet.handles().at(-1)!);
  expect(distance(there.target, (await crown()).target)).toBeLessThan(1e-6);
});

test('what is said of a broken link leaves free what says to press', async () => {
  const visit = await site.open('?embed=1#n=broken', { viewport: { width: 500, height: 380 } });
  const boxOf = async (part: string) => (await visit.page.locator(part).boundingBox())!;
  await visit.page.getByText('This link is not one of chebnet.').waitFor();
  const [message, press] = [await boxOf('.message'), await boxOf('.shield span')];
  await visit.page.screenshot({ path: join(OUTPUT, 'embed-broken-link.png') });
  expect(press.y + press.height).toBeLessThan(message.y);
  expect(press.y).toBeGreaterThan(0);
});

test('on a phone it has room, and no panels', async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.screenshot({ path: join(OUTPUT, 'lesson-phone.png') });
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  expect(await frame.getByRole('complementary').count()).toBe(0);
});

/** Feet that slide on the ground while the crown of a flat sheet is raised, with a mouse. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { distance, dragBy } from './geometry';
import type { Script, Visit } from './page';
import { OUTPUT, visits } from './page';

const SHEET = 'sheet:vertices=121';
/** Of 11 by 11 vertices. */
const [CROWN, FOOT, OTHER_FOOT] = [60, 55, 65];

const { share } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHEET });
  await visit.page.evaluate((crown) => window.chebnet.setHandles([{ vertex: crown, anchor: false }]), CROWN);
  await script.settled();
});

const bar = () => visit.page.getByRole('group', { name: 'Selected handles' });
const button = (name: string) => bar().getByRole('button', { name, exact: true });
const handles = () => visit.page.evaluate(() => window.chebnet.handles());
const width = async () => distance(await script.position(FOOT), await script.position(OTHER_FOOT));

async function click(vertex: number) {
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.mouse.click(x, y);
  await script.settled();
}

test('the border of a sheet is let slide, comes inwards on the ground as the crown is raised, and goes back', async () => {
  await click(FOOT);
  await button('Boundary loop').click();
  await script.settled();
  await button('Slide on the ground').click();
  await expect.poll(async () => (await handles()).filter(({ slides }) => slides === 'xy').length).toBe(40);
  expect(await button('Slide on the ground').getAttribute('aria-pressed')).toBe('true');
  const before = await width();

  await dragBy(script, CROWN, [0, -60]);
  await script.settled();
  await visit.page.screenshot({ path: join(OUTPUT, 'sliding-sheet.png') });
  const raised = await script.position(CROWN);
  expect(raised[2]).toBeGreaterThan(0.5);
  const inwards = await width();
  expect(inwards).toBeLessThan(before - 0.02);
  const feet = (await handles()).filter(({ slides }) => slides);
  for (const { vertex, target } of feet) {
    expect((await script.position(vertex))[2]).toBe(0);
    expect(await script.position(vertex)).toEqual(target);
  }
  expect((await visit.page.evaluate(() => window.chebnet.stats())).maxDeviation).toBeLessThan(1e-6);

  // A link has it, to the last digit of the feet.
  const link = await visit.page.evaluate(() => window.chebnet.link());
  expect(link).toContain('#v4=');

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  await expect.poll(width).toBe(before);
  await visit.page.keyboard.press('Control+z');
  await expect.poll(async () => (await handles()).some(({ slides }) => slides)).toBe(false);
  expect(await visit.page.evaluate(() => window.chebnet.link())).toContain('#v2=');
});

test('one handle slides along what the list says, and a hand moves it only across that', async () => {
  await visit.page.evaluate(
    ([crown, foot]) =>
      window.chebnet.setHandles([
        { vertex: crown!, anchor: true },
        { vertex: foot!, anchor: false },
      ]),
    [CROWN, FOOT],
  );
  await visit.page.locator('summary', { hasText: /^Handles \(/ }).click();
  await visit.page
    .locator('.handles li .name')
    .filter({ hasText: `Vertex ${FOOT}` })
    .click();
  await visit.page
    .locator('.handles li label:visible')
    .filter({ hasText: /^Slides/ })
    .locator('select')
    .selectOption({ label: 'On the ground' });
  await expect.poll(async () => (await handles())[1]!.slides).toBe('xy');
  const [x, y] = await script.position(FOOT);
  const coordinates = visit.page.locator('.handles .coordinates:visible input');
  expect(await coordinates.nth(0).isDisabled()).toBe(true);
  expect(await coordinates.nth(2).isDisabled()).toBe(false);

  await dragBy(script, FOOT, [-40, -40]);
  await script.settled();
  await visit.page.screenshot({ path: join(OUTPUT, 'sliding-foot.png') });
  const after = await script.position(FOOT);
  expect(after[2]).toBeGreaterThan(0.3);
  // It is where the net takes it, not where the hand was.
  expect(Math.hypot(after[0] - x, after[1] - y)).toBeLessThan(0.5);

  await visit.page.evaluate(() => window.chebnet.setOptions({ method: 'li2022' }));
  await visit.page.locator('.handles li p:visible', { hasText: /^This method holds handles/ }).waitFor();
});

test('the view of a detail stays while feet slide that are out of sight', async () => {
  const border = Array.from({ length: 121 }, (_, v) => v).filter((v) =>
    [v % 11, Math.floor(v / 11)].some((k) => k % 10 === 0),
  );
  await visit.page.evaluate(
    ([crown, ...feet]) =>
      window.chebnet.setHandles([
        ...feet.map((vertex) => ({ vertex, anchor: false, slides: 'xy' as const })),
        { vertex: crown!, anchor: false },
      ]),
    [CROWN, ...border],
  );
  await script.settled();
  const { x, y } = await script.screenPosition(CROWN);
  await visit.page.mouse.move(x, y);
  for (let turn = 0; turn < 3; turn++) await visit.page.mouse.wheel(0, -300);
  const view = (await visit.page.locator('#view').boundingBox())!;
  const edge = async () => {
    const [a, b] = [await script.screenPosition(CROWN), await script.screenPosition(CROWN + 1)];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  await expect.poll(edge).toBeGreaterThan(view.width / 10);
  await visit.page.waitForTimeout(400); // the camera coasts
  const before = await script.screenPosition(CROWN);
  const atFirst = await width();
  await script.move(CROWN, [0, 0, 0.3 * distance(await script.position(CROWN), await script.position(CROWN + 1))]);
  await script.settled();
  expect(await width()).toBeLessThan(atFirst);
  await visit.page.waitForTimeout(400); // for as long as the camera would glide
  const after = await script.screenPosition(CROWN);
  expect(Math.abs(after.x - before.x)).toBeLessThan(5);
  expect(Math.abs(after.y - before.y)).toBeLessThan(80);
});

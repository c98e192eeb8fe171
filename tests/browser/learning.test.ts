/** Learning: the sheet of keys, the lessons that act on the net, the hints of a first visit. */
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { distance, dragBy, largestError } from './geometry';
import type { Visit } from './page';
import { OUTPUT, allSections, visits } from './page';

const { arrive, share } = visits();

test('a key and a button show all keys, and the keys do what the sheet says', async () => {
  const { page, script } = await share();
  const sheet = page.getByRole('dialog', { name: 'Keys' });
  await page.keyboard.press('?');
  await sheet.waitFor();
  const text = await sheet.innerText();
  for (const line of [
    /Undo\s+Ctrl \+ Z/,
    /Redo\s+Ctrl \+ Shift \+ Z or Ctrl \+ Y/,
    /Take hold of the patch .*\s+P\n/,
    /Show only what is around the selection.*\s+I\n/,
    /Drag without snapping\s+Ctrl \+ drag/,
    /Rename a handle or a group\s+F2/,
    /See the whole net\s+Home/,
    /Set the pen down, or lift it\s+Space or Enter/,
  ]) {
    expect(text).toMatch(line);
  }
  await page.screenshot({ path: join(OUTPUT, 'keys.png') });
  await page.keyboard.press('Control+a');
  await page.keyboard.press('?');
  await sheet.waitFor({ state: 'detached' });
  expect(await page.getByTitle('5 handles selected').isVisible()).toBe(false);
  await page.keyboard.press('Control+a');
  await page.getByTitle('5 handles selected').waitFor();
  await page.getByRole('button', { name: 'Keys' }).click();
  await sheet.waitFor();
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  expect((await script.stats()).handles).toBe(5);
});

test('keys of a single sign can be switched off, and stay so; those with Ctrl and those of the picture go on', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  const sheet = page.getByRole('dialog', { name: 'Keys' });
  const single = sheet.getByRole('switch').or(sheet.getByRole('checkbox'));
  const show = async () => {
    await page.getByRole('button', { name: 'Keys' }).click();
    await sheet.waitFor();
  };
  const select = () => page.getByRole('button', { name: 'Select', exact: true });
  const isSelecting = () => select().getAttribute('aria-pressed');
  await page.keyboard.press('l');
  expect(await isSelecting()).toBe('true');
  await page.keyboard.press('l');

  await show();
  expect(await single.isChecked()).toBe(true);
  await single.click();
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  for (const _ of [1, 2]) {
    await page.keyboard.press('l');
    await page.keyboard.press('?');
    expect(await isSelecting()).toBe('false');
    expect(await sheet.count()).toBe(0);
    await page.keyboard.press('Control+a');
    await page.getByTitle('5 handles selected').waitFor();
    await page.keyboard.press('Escape');
    await page.reload();
    await script.waitForNet();
  }

  await page.locator('canvas').first().focus();
  const before = await script.screenPosition(0);
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => script.screenPosition(0)).not.toEqual(before);

  await show();
  expect(await single.isChecked()).toBe(false);
  await single.click();
  await page.keyboard.press('Escape');
  await page.keyboard.press('l');
  expect(await isSelecting()).toBe('true');
});

const showMe = ({ page }: Visit, what: RegExp) => page.getByRole('button', { name: what }).click();

test('each paragraph is shown by the net', async () => {
  const visit = await share();
  const { page, script } = visit;
  const before = await script.positions();
  await page.getByText('Learn', { exact: true }).click();
  const now = page.getByText(/^Now: p\s=\s/);
  expect(await now.innerText()).toMatch(/p\s=\s2;.* r\s=\s1\.0000$/);
  await page.screenshot({ path: join(OUTPUT, 'learn.png') });

  // A handle goes a little way and comes back.
  await showMe(visit, /gives way/);
  await expect.poll(async () => largestError(await script.positions(), before)).toBeGreaterThan(0.1);
  await expect.poll(async () => largestError(await script.positions(), before), { timeout: 5000 }).toBe(0);
  expect(await page.getByRole('button', { name: 'Undo', exact: true }).isDisabled()).toBe(true);

  await showMe(visit, /power of ten/);
  expect(await page.getByLabel('Colours').inputValue()).toBe('log');

  // The worst edge climbs a wall, then stage by stage comes down.
  await showMe(visit, /climbing/);
  await expect
    .poll(async () => Number(/r\s=\s(.*)$/.exec(await now.innerText())![1]))
    .toSatisfy((r: number) => Math.abs(r - 1) > 0.02);
  expect(await page.getByLabel('Colours').inputValue()).toBe('paper');
  // A step that waits is no failure.
  const status = page.locator('.status');
  await status.getByText(/^Paused/).waitFor();
  expect(await status.locator('.light').evaluate((light) => getComputedStyle(light).backgroundColor)).toBe(
    'rgb(139, 149, 165)',
  );
  await page
    .locator('.lesson')
    .getByText(/^Paused\. .*goes on to the next/)
    .first()
    .waitFor();
  await page.screenshot({ path: join(OUTPUT, 'learn-energy.png') });
  const stage = page.locator('.lesson [aria-current=step]');
  expect(await stage.textContent()).toContain('p=2');
  await showMe(visit, /one stage/);
  await stage.filter({ hasText: 'p=50' }).waitFor();
  await page.screenshot({ path: join(OUTPUT, 'learn-stages.png') });
  const done = page.getByText(/^All stages are done/);
  await showMe(visit, /one stage/);
  await stage
    .getByText(/^Only the vertices/)
    .or(done)
    .waitFor();
  if (!(await done.isVisible())) await showMe(visit, /one stage/);
  await done.waitFor();
  const isAsBefore = async () => {
    await script.settled();
    expect(largestError(await script.positions(), before)).toBe(0);
    expect(await script.stats()).toMatchObject({ method: 'equilibrium' });
    expect(await page.getByRole('button', { name: 'Undo', exact: true }).isDisabled()).toBe(true);
  };
  await isAsBefore();

  // In the middle of a lesson, any other input brings the net back.
  await showMe(visit, /climbing/);
  await expect.poll(async () => largestError(await script.positions(), before)).toBeGreaterThan(0.1);
  await page.locator('.status-words').click();
  await isAsBefore();
  await expect.poll(() => page.getByText(/goes on to the next/).count()).toBe(0);

  // Colours stay while the net is looked at, and go with the lesson.
  await showMe(visit, /power of ten/);
  await page.mouse.click(60, 600);
  expect(await page.getByLabel('Colours').inputValue()).toBe('log');
  await page.locator('.status-words').click();
  expect(await page.getByLabel('Colours').inputValue()).toBe('paper');
});

test('formulas of the lessons are formulas', async () => {
  const { page } = await share();
  await page.getByText('Learn', { exact: true }).click();
  await page.locator('.lesson math').first().waitFor();
  const formulas = await page.locator('.lesson math').allTextContents();
  expect(formulas).toContain('dL=r+1r−2');
  expect(formulas).toContain('rp+r−p');
  // Fractions and exponents stand higher than what they are beside.
  const [base, exponent] = await page
    .locator('.lesson msup > *')
    .evaluateAll((parts) => parts.slice(0, 2).map((each) => each.getBoundingClientRect().top));
  expect(exponent).toBeLessThan(base!);
  expect(await page.locator('.lesson p').filter({ hasText: /[{}^]/ }).count()).toBe(0);
});

test.each(['en', 'zh-CN'])('what p and r are now stays in one line each, however narrow it is (%s)', async (locale) => {
  const { page } = await arrive('', { locale });
  await allSections(page);
  await page.locator('summary', { hasText: /^(Learn|学习)$/ }).click();
  const now = page.locator('.energy + .quiet');
  await expect.poll(() => now.innerText()).toMatch(/r\s=\s1\.0000$/);
  const broken = await now.evaluate((element) => {
    const text = element.firstChild!;
    const lines = (from: number, to: number): number => {
      const range = document.createRange();
      range.setStart(text, from);
      range.setEnd(text, to);
      return new Set(Array.from(range.getClientRects(), ({ top }) => Math.round(top))).size;
    };
    const equations = [...text.nodeValue!.matchAll(/[pr]\s=\s[\d.]+/g)];
    const widths = Array.from({ length: 160 }, (_, i) => 120 + i);
    return widths.filter((width) => {
      element.style.width = `${width}px`;
      return equations.some(({ index, 0: { length } }) => lines(index, index + length) > 1);
    });
  });
  expect(broken).toEqual([]);
});

test('a lesson that moves a handle leaves the hint to drag it', async () => {
  const { page, script } = await arrive('', {}, { hints: true });
  const hint = page.locator('.hint');
  await hint.getByText('Drag the orange sphere').waitFor();
  await page.locator('summary', { hasText: /^Learn$/ }).click();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const before = await script.position(vertex);
  await page.locator('.lesson button').first().click();
  await expect.poll(async () => distance(await script.position(vertex), before)).toBeGreaterThan(0.1);
  await script.settled();
  await expect.poll(async () => distance(await script.position(vertex), before)).toBe(0);
  await hint.getByText('Drag the orange sphere').waitFor();
});

test('a first visit is given three hints, one after another, each until it is done or dismissed, and never again', async () => {
  const visit = await arrive('', {}, { hints: true });
  const { page, script } = visit;
  const hint = page.locator('.hint');
  await hint.getByText('Drag the orange sphere').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'hint-drag.png') });

  await dragBy(script, (await page.evaluate(() => window.chebnet.handles().at(-1)!)).vertex, [0, 40]);
  await hint.getByText('Press the net').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'hint-add.png') });
  await page.reload();
  await script.waitForNet();
  await hint.getByText('Press the net').waitFor();
  await hint.getByRole('button', { name: 'Got it' }).focus();
  await page.keyboard.press('Enter');
  await hint.getByText('a link to what you see').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'hint-share.png') });
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ colorScheme: 'dark' });
  await expect
    .poll(async () => {
      const narrow = (await hint.boundingBox())!;
      return narrow.x >= 0 && narrow.x + narrow.width <= 390;
    })
    .toBe(true);
  await page.screenshot({ path: join(OUTPUT, 'hint-share-phone.png') });
  await page.getByRole('group', { name: 'Actions' }).getByRole('button', { name: 'Share' }).click();
  await hint.waitFor({ state: 'hidden' });
  await page.locator('.qr svg').waitFor();
  await page.reload();
  await script.waitForNet();
  await script.settled();
  expect(await hint.count()).toBe(0);
});

test.each([
  ['a desk', 1280, 800],
  ['a phone', 390, 844],
  ['a small phone', 360, 740],
  ['a phone on its side', 844, 390],
  ['a small phone on its side', 667, 375],
  ['a desk at 200 %', 683, 384],
  ['a tablet', 820, 1180],
])('on %s no hint lies over the net', async (_, width, height) => {
  const { page, script } = await arrive('', { viewport: { width, height } }, { hints: true });
  const hint = page.locator('.hint');
  await hint.waitFor();
  const under = async () => {
    const { x, y, width: w, height: h } = (await hint.boundingBox())!;
    return page.evaluate(
      ([left, top, right, bottom]) =>
        [...Array(window.chebnet.stats().vertices).keys()].filter((vertex) => {
          const place = window.chebnet.screenPosition(vertex);
          return left < place.x && place.x < right && top < place.y && place.y < bottom;
        }),
      [x, y, x + w, y + h] as const,
    );
  };
  for (const recipe of ['dome', 'sheet', 'vault', 'tube']) {
    await script.open({ recipe });
    await script.settled();
    expect(await under(), recipe).toEqual([]);
  }
});

test('the note on an experiment stands where it stands for who knows the page, and does not move when hints come', async () => {
  const placeOfNote = async (hints: boolean) => {
    const { page, script } = await arrive('#experiment=long-edges', {}, { hints });
    await script.settled();
    if (hints) await page.locator('.hint:not([hidden])').waitFor({ state: 'attached' });
    return page.locator('.experiment').boundingBox();
  };
  expect(await placeOfNote(true)).toEqual(await placeOfNote(false));
});

test('an embedded page gives no hints', async () => {
  const { page, script } = await arrive('?embed', {}, { hints: true });
  await script.settled();
  expect(await page.locator('.hint').count()).toBe(0);
});

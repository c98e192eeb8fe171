/** A phone, upright and on its side, and a desk at 200 %: all there is can be reached, is large enough and is not covered. */
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import { en } from '../../web/src/language/en';
import { zh } from '../../web/src/language/zh';
import { dragBy } from './geometry';
import { allSections, drawn, OUTPUT, unfoldAll, visits } from './page';
import type { Visit } from './page';

const { arrive, share } = visits();

const SIZES = [
  ['a phone', { width: 360, height: 740 }, true],
  ['a small phone', { width: 375, height: 553 }, true],
  ['a phone on its side', { width: 740, height: 360 }, true],
  ['a desk at 200 %', { width: 640, height: 400 }, false],
] as const;

/** In pixels: WCAG 2.2, success criterion 2.5.8. */
const LEAST = 24;

/** What is wrong with the controls inside, each scrolled into view as a finger would. */
async function faults(page: Page, inside: string): Promise<string[]> {
  await drawn(page);
  const { count, found } = await page.evaluate(
    async ([selector, least]) => {
      const roots = [...document.querySelectorAll(selector)];
      const all = roots.flatMap((root) => [
        ...root.querySelectorAll<HTMLElement>('button, select, input, summary, a[href], textarea'),
      ]);
      const wrong: string[] = [];
      let seen = 0;
      for (const control of all) {
        if (!control.checkVisibility({ visibilityProperty: true }) || control.closest('[inert]')) continue;
        if (control.matches('p a, li a, dd a')) continue; // Within a sentence.
        seen += 1;
        control.scrollIntoView({ block: 'center', inline: 'nearest' });
        const box = control.getBoundingClientRect();
        // A label belongs to what it names.
        const target = control.closest('label') ?? control;
        const { width, height } = target.getBoundingClientRect();
        const name = `${control.tagName} ${control.ariaLabel ?? (control.textContent || control.closest('label')?.textContent || control.title)}`;
        const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
        if (Math.min(width, height) < least) wrong.push(`${name}: ${width} × ${height}`);
        if (box.left < -1 || box.right > innerWidth + 1 || y < 0 || y > innerHeight)
          wrong.push(`${name}: out of sight, ${Math.round(box.left)} to ${Math.round(box.right)}, at ${Math.round(y)}`);
        else if (!target.contains(document.elementFromPoint(x, y)) && !(control as HTMLButtonElement).disabled)
          wrong.push(`${name}: covered by ${document.elementFromPoint(x, y)?.outerHTML.slice(0, 80)}`);
      }
      return { count: seen, found: wrong };
    },
    [inside, LEAST] as const,
  );
  expect(count).toBeGreaterThan(0);
  return found;
}

/** Which of these parts lie on each other, if they are seen. */
async function overlaps(page: Page, parts: readonly string[]): Promise<string[]> {
  const seen = await Promise.all(
    parts.map(async (part) => ({ part, box: await page.locator(part).first().boundingBox() })),
  );
  return seen.flatMap(({ part, box }, i) =>
    seen.slice(i + 1).flatMap(({ part: other, box: beside }) => {
      const apart =
        box === null ||
        beside === null ||
        box.x + box.width <= beside.x ||
        beside.x + beside.width <= box.x ||
        box.y + box.height <= beside.y ||
        beside.y + beside.height <= box.y;
      return apart ? [] : [`${part} and ${other}`];
    }),
  );
}

describe.each(SIZES)('%s', (name, viewport, isMobile) => {
  const visit = () => share({ viewport, ...(isMobile && { hasTouch: true, isMobile }) });
  const picture = (page: Page, of: string) =>
    page.screenshot({ path: join(OUTPUT, `${name.replace(/\W+/g, '-')}-${of}.png`) });
  const button = (page: Page, label: string) => page.getByRole('button', { name: label, exact: true });

  test('tools have words, and stand beside title, legend and each other', async () => {
    const { page } = await visit();
    await page.locator('.sections > *').nth(6).waitFor({ state: 'attached' });
    await picture(page, 'first');
    expect(await faults(page, '.toolbar')).toEqual([]);
    const words = await page
      .locator('.toolbar:not(.selection-bar) button span')
      .evaluateAll((all) =>
        all.map((each) => each.checkVisibility() && each.scrollWidth <= each.parentElement!.clientWidth),
      );
    expect(words.length).toBe(8);
    expect(words.every(Boolean)).toBe(true);
    expect(await overlaps(page, ['.title h1', '.toolbar:not(.selection-bar)', '.legend', '.status'])).toEqual([]);
  });

  test('the net is large enough to be taken hold of, also beside open controls', async () => {
    const { page, script } = await visit();
    await script.settled();
    const fold = button(page, 'Controls');
    for (const [unfold, least] of [
      [false, 120],
      [true, 60],
    ] as const) {
      if (unfold && (await fold.isVisible())) await fold.click();
      await drawn(page);
      const height = await page.evaluate(() => {
        const all = Array.from(
          { length: window.chebnet.stats().vertices },
          (_, v) => window.chebnet.screenPosition(v).y,
        );
        return Math.max(...all) - Math.min(...all);
      });
      expect(height).toBeGreaterThan(least);
    }
  });

  test('the legend is whole, and away from the net', async () => {
    const { page, script } = await visit();
    await script.settled();
    await drawn(page);
    const legend = (await page.locator('.legend').boundingBox())!;
    const tools = (await page.locator('.toolbar:not(.selection-bar)').boundingBox())!;
    expect(legend.x).toBeGreaterThanOrEqual(0);
    expect(legend.y + legend.height).toBeLessThanOrEqual(viewport.height);
    const cut = await page.locator('.legend :is(h2, .ticks span, .words)').evaluateAll(
      (all) =>
        all.filter((each) => {
          const box = each.getBoundingClientRect();
          return each.scrollWidth > each.clientWidth + 1 || box.left < 0 || box.right > innerWidth || box.height < 12;
        }).length,
    );
    expect(cut).toBe(0);
    const places = await page.evaluate(() =>
      Array.from({ length: window.chebnet.stats().vertices }, (_, vertex) => window.chebnet.screenPosition(vertex)),
    );
    for (const { x, y, width, height } of [legend, tools]) {
      const under = places.filter((at) => at.x > x && at.x < x + width && at.y > y && at.y < y + height);
      expect(under).toEqual([]);
    }
  });

  test('what is selected is not covered by what can be done with it', async () => {
    const { page, script } = await visit();
    await script.settled();
    await drawn(page);
    const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
    const { x, y } = await script.screenPosition(vertex);
    await (isMobile ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
    await page.getByRole('group', { name: 'Selected handles' }).waitFor();
    await drawn(page);
    await picture(page, 'selected');
    expect(await faults(page, '.selection-bar')).toEqual([]);
    // The field of the radius stands in a row with buttons, at their height.
    const middle = async (each: Locator) => {
      const { y, height } = (await each.boundingBox())!;
      return y + height / 2;
    };
    const bar = page.locator('.selection-bar');
    const field = await middle(bar.getByRole('spinbutton'));
    const buttons = await Promise.all((await bar.locator('button:visible').all()).map(middle));
    expect(Math.min(...buttons.map((at) => Math.abs(at - field)))).toBeLessThan(3);
    const covered = await page.evaluate(
      () =>
        Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v)).filter(
          (at) => document.elementFromPoint(at.x, at.y)?.closest('.selection-bar') != null,
        ).length,
    );
    expect(covered).toBe(0);
  });

  test('the controls, with every section unfolded', async () => {
    const { page } = await visit();
    const fold = button(page, 'Controls');
    if (await fold.isVisible()) await fold.click();
    await unfoldAll(page);
    await page.locator('.lesson').first().waitFor({ state: 'attached' });
    await picture(page, 'controls');
    expect(await faults(page, '.sidebar')).toEqual([]);
  });

  test('an iPhone need not magnify the page to have something written', async () => {
    const { page } = await visit();
    await unfoldAll(page);
    const sizes = await page
      .locator('select, input:not([type=checkbox], [type=range], [type=radio])')
      .evaluateAll((all) => all.map((each) => Number.parseFloat(getComputedStyle(each).fontSize)));
    expect(sizes.length).toBeGreaterThan(10);
    if (isMobile) expect(Math.min(...sizes)).toBeGreaterThanOrEqual(16);
  });

  test('a change is undone beside open controls', async () => {
    const { page, script } = await visit();
    await script.settled();
    const fold = button(page, 'Controls');
    if (await fold.isVisible()) await fold.click();
    await page.evaluate(() => window.chebnet.setOptions({ method: 'projection' }));
    await picture(page, 'undo');
    expect(await faults(page, '.toolbar')).toEqual([]);
    await button(page, 'Undo').click();
    await button(page, 'Redo').click();
    expect(await button(page, 'Redo').isDisabled()).toBe(true);
    expect(await button(page, 'Undo').isDisabled()).toBe(false);
  });

  test('what the net does not reach is told beside it, and can be put away', async () => {
    const { page, script } = await visit();
    await script.settled();
    const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
    const lift = (height: number) => script.move(vertex, [target[0], target[1], target[2] + height]);
    await lift(20);
    const notice = page.locator('.stuck-notice');
    await notice.getByText(/out of reach/).waitFor();
    await picture(page, 'stuck');
    expect(await faults(page, '.stuck-notice')).toEqual([]);
    const fold = button(page, 'Controls');
    for (const unfold of [false, true]) {
      if (unfold && (await fold.isVisible())) await fold.click();
      await drawn(page);
      await picture(page, `stuck-${unfold}`);
      const covered = await page.evaluate(() => {
        const isUnder = ({ x, y }: { x: number; y: number }) =>
          document.elementsFromPoint(x, y).some((each) => each.closest('.stuck-notice'));
        const all = Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v));
        return all.filter(isUnder).length / all.length;
      });
      expect(covered).toBeLessThan(0.2);
      expect(await faults(page, '.stuck-notice')).toEqual([]);
      expect(await overlaps(page, ['.stuck-notice .plain', '.stuck-notice .buttons'])).toEqual([]);
    }
    await notice.getByRole('button', { name: 'Dismiss' }).click();
    await expect.poll(() => notice.innerText()).toBe('');
    await lift(22);
    await notice.getByText(/out of reach/).waitFor();
    await button(page, 'Undo').click();
    await expect.poll(() => notice.innerText()).toBe('');
  });

  test('where a hand was held back, the way out and the handle are free beside open controls', async () => {
    const { page, script } = await visit();
    await script.open({ recipe: 'dome:vertices=500,reach=55' });
    await script.settled();
    await drawn(page);
    const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
    const { x, y } = await script.screenPosition(vertex);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 150, y - 130, { steps: 10 });
    await page.mouse.up();
    await script.settled();
    await button(page, 'Let edges grow').waitFor();
    const fold = button(page, 'Controls');
    if (await fold.isVisible()) await fold.click();
    await drawn(page);
    await picture(page, 'held-back');
    expect(await button(page, 'Let edges grow').isVisible()).toBe(true);
    expect(await faults(page, '.stuck-notice')).toEqual([]);
    const place = await script.screenPosition(vertex);
    const [left, top, right, bottom] = await page.locator('.stuck-notice .message').evaluate((message) => {
      const box = message.getBoundingClientRect();
      return [box.left, box.top, box.right, box.bottom] as const;
    });
    const isCovered = place.x > left && place.x < right && place.y > top && place.y < bottom;
    expect(isCovered).toBe(false);
    const view = (await page.locator('#view').boundingBox())!;
    expect(bottom).toBeLessThanOrEqual(view.y + view.height);
  });

  test('the picture stays where it is, whatever the solver says', async () => {
    const { page } = await visit();
    expect(await placesOf(page, '#view')).toEqual([expect.stringContaining(', all of it')]);
  });

  test('menus and dialogs', async () => {
    const { page } = await visit();
    for (const [label, menu] of [
      ['File', '#project-menu'],
      ['Export', '#export-menu'],
    ] as const) {
      await button(page, label).click();
      await picture(page, label);
      expect(await faults(page, menu), label).toEqual([]);
      expect(await page.locator(`${menu} .line span`).first().isVisible()).toBe(true);
      await page.keyboard.press('Escape');
    }
    await button(page, 'Share').click();
    await page.getByRole('dialog').getByRole('button', { name: 'Copy link' }).waitFor();
    await picture(page, 'share');
    expect(await faults(page, 'dialog[open]')).toEqual([]);
    await page.keyboard.press('Escape');
  });

  test('"On a surface…"', async () => {
    const { page } = await visit();
    const fold = button(page, 'Controls');
    if (await fold.isVisible()) await fold.click();
    await button(page, 'On a surface…').click();
    await page.locator('dialog.drape .primary:not([disabled])').waitFor();
    await picture(page, 'surface');
    expect(await faults(page, 'dialog[open]')).toEqual([]);
    await page.locator('dialog label', { hasText: /^Net/ }).getByRole('combobox').selectOption('whole');
    await picture(page, 'whole-surface');
    expect(await faults(page, 'dialog[open]')).toEqual([]);
  });
});

test('on its side a phone has nothing below its camera', async () => {
  const { page } = await arrive('', { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true });
  await allSections(page);
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setSafeAreaInsetsOverride', { insets: { left: 47, right: 47, bottom: 21 } });
  const sides = async (selector: string) => {
    const { x, width } = (await page.locator(selector).first().boundingBox())!;
    return [x, x + width] as const;
  };
  await expect.poll(async () => (await sides('.title h1'))[0]).toBeGreaterThanOrEqual(47);
  expect((await sides('.sidebar'))[1]).toBeLessThanOrEqual(844 - 47);
  await page.getByRole('button', { name: 'On a surface…' }).click();
  await page.locator('dialog.drape .primary:not([disabled])').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'below-the-camera.png') });
  const [left, right] = await sides('dialog.drape');
  expect([left >= 47, right <= 844 - 47]).toEqual([true, true]);
});

test.each([
  [740, 360],
  [640, 400],
])(
  'at %i by %i what is said of a net that is stuck covers neither the handle nor what can be done with it',
  async (width, height) => {
    const { page, script } = await share({ viewport: { width, height }, hasTouch: true, isMobile: true });
    const vertex = await pullTooFar({ page, script }, 150, -130);
    await page.screenshot({ path: join(OUTPUT, `stuck-selected-${width}.png`) });
    expect(await page.locator('.selection-bar').isVisible()).toBe(true);
    for (const part of ['.stuck-notice', '.selection-bar']) expect(await faults(page, part)).toEqual([]);
    expect(await overlaps(page, ['.stuck-notice', '.selection-bar'])).toEqual([]);
    const at = await script.screenPosition(vertex);
    for (const part of ['.stuck-notice', '.selection-bar']) {
      const box = (await page.locator(part).boundingBox())!;
      const isCovered = at.x > box.x && at.x < box.x + box.width && at.y > box.y && at.y < box.y + box.height;
      expect(isCovered, part).toBe(false);
    }
  },
);

test('what is said of a net that is stuck makes way for a handle that is touched after it', async () => {
  const { page, script } = await share({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await script.open({ recipe: 'dome:vertices=500,reach=55' });
  await script.settled();
  await drawn(page);
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y - 150, { steps: 10 });
  await page.mouse.up();
  await script.settled();
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  const at = await script.screenPosition(vertex);
  await page.touchscreen.tap(at.x, at.y);
  await page.locator('.selection-bar').waitFor();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, 'stuck-touched.png') });
  const box = (await message.boundingBox())!;
  const radius = 12;
  expect(at.y - radius > box.y + box.height || at.y + radius < box.y).toBe(true);
  expect(await overlaps(page, ['.stuck-notice', '.selection-bar'])).toEqual([]);
});

test.each([
  [390, 844],
  [360, 740],
])(
  'at %i by %i what is said of a net that is stuck leaves the arrows of what is selected free',
  async (width, height) => {
    const { page, script } = await share({ viewport: { width, height }, hasTouch: true, isMobile: true });
    for (const [across, down] of [
      [80, -150],
      [0, -250],
    ] as const) {
      const vertex = await pullTooFar({ page, script }, across, down);
      await page.screenshot({ path: join(OUTPUT, `stuck-arrows-${width}-${across}.png`) });
      const at = await script.screenPosition(vertex);
      const box = (await page.locator('.stuck-notice .message').boundingBox())!;
      const arrow = 0.14 * (await page.locator('#view').boundingBox())!.height;
      expect(at.y - arrow > box.y + box.height || at.y + 12 < box.y, `${across}, ${down}`).toBe(true);
    }
  },
);

test.each([
  [1024, 768, 'en'],
  [1024, 768, 'zh-CN'],
  [768, 1024, 'en'],
])('on a tablet of %i by %i the arrow at what is selected is clear of hint and tools (%s)', async (...size) => {
  const [width, height, locale] = size;
  const options = { viewport: { width, height }, hasTouch: true, isMobile: true, locale };
  const { page, script } = await arrive('', options, { hints: true });
  await allSections(page);
  const hint = page.locator('.hint');
  await hint.waitFor();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar').waitFor();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `arrow-${width}-${locale}.png`) });
  const arrow = { left: x - 12, right: x + 12, top: y - 0.15 * height };
  for (const each of [
    hint.locator('span').first(),
    hint.getByRole('button'),
    page.locator('.toolbar:not(.selection-bar)'),
  ]) {
    const box = (await each.boundingBox())!;
    const isClear = box.x + box.width < arrow.left || box.x > arrow.right || box.y + box.height < arrow.top;
    expect(isClear, await each.innerText()).toBe(true);
  }
});

test.each([
  [800, 600, false],
  [800, 600, true],
  [960, 700, false],
])('at %i by %i the tools of a selection cover no part of the net, and none is cut (touch: %s)', async (...size) => {
  const [width, height, isMobile] = size;
  const { page, script } = await arrive('', {
    viewport: { width, height },
    ...(isMobile && { hasTouch: true, isMobile }),
  });
  await allSections(page);
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await (isMobile ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
  await page.locator('.selection-bar').waitFor();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `selected-${width}-${isMobile}.png`) });
  expect(await faults(page, '.selection-bar')).toEqual([]);
  const bar = (await page.locator('.selection-bar').boundingBox())!;
  const lowest = await page.evaluate(() =>
    Math.max(...window.chebnet.handles().map((each) => window.chebnet.screenPosition(each.vertex).y)),
  );
  expect(lowest + 9).toBeLessThan(bar.y);
  expect(bar.y + bar.height).toBeLessThan(height);
});

test.each([
  [360, 740],
  [844, 390],
])('at %i by %i the line below the title makes room for the arrow at what is selected', async (width, height) => {
  const { page, script } = await share({ viewport: { width, height }, hasTouch: true, isMobile: true });
  const line = page.locator('.title p').first();
  const isSeen = () => line.evaluate((each) => getComputedStyle(each).visibility === 'visible');
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  expect(await isSeen()).toBe(true);
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar').waitFor();
  await expect.poll(isSeen).toBe(false);
  await page.locator('#view canvas').focus();
  await page.keyboard.press('Escape');
  await expect.poll(isSeen).toBe(true);
});

test.each([
  [360, 740, 'en'],
  [360, 740, 'zh-CN'],
  [844, 390, 'en'],
])('at %i by %i more than one way out is seen beside what is selected (%s)', async (width, height, locale) => {
  const { page, script } = await arrive('', { viewport: { width, height }, hasTouch: true, isMobile: true, locale });
  const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar').waitFor();
  await script.move(vertex, [target[0], target[1], target[2] + 20]);
  await page.locator('.stuck-notice .message').waitFor();
  await drawn(page);
  const [end, ...begins] = await page.locator('.stuck-notice .buttons').evaluate((ways) => {
    const seen = [...ways.children].filter((each) => each.checkVisibility());
    return [ways.getBoundingClientRect().right, ...seen.map((each) => each.getBoundingClientRect().left)];
  });
  expect(begins.length).toBe(3);
  // A good part of it, before it fades.
  expect(begins[1]! + 40).toBeLessThan(end!);
});

test.each([
  [360, 740],
  [375, 553],
  [740, 360],
])(
  'at %i by %i no message lies over a part of the net or over what can be done with a handle',
  async (width, height) => {
    const { page, script } = await share({ viewport: { width, height }, hasTouch: true, isMobile: true });
    const isClear = async () => {
      await drawn(page);
      const net = await page.evaluate(() =>
        Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v)),
      );
      const box = (await page.locator('.message').first().boundingBox())!;
      const isIn = ({ x, y }: { x: number; y: number }) =>
        x > box.x && x < box.x + box.width && y > box.y && y < box.y + box.height;
      expect(net.filter(isIn)).toEqual([]);
      expect(await overlaps(page, ['.message', '.selection-bar', '.toolbar:not(.selection-bar)'])).toEqual([]);
    };
    for (const recipe of ['dome', 'vase']) {
      await script.open({ recipe });
      await script.settled();
      const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
      const { x, y } = await script.screenPosition(vertex);
      await page.touchscreen.tap(x, y);
      await page.getByRole('button', { name: 'Lock', exact: true }).tap();
      await page.locator('#view canvas').focus();
      await page.keyboard.press('ArrowUp');
      await page.getByText('Locked handles stay.').waitFor();
      await page.screenshot({ path: join(OUTPUT, `message-selected-${width}-${recipe}.png`) });
      await isClear();
    }
    await pullTooFar({ page, script }, 60, -60);
    await page.screenshot({ path: join(OUTPUT, `stuck-selected-${width}-${height}.png`) });
    await isClear();
    for (const part of ['.stuck-notice', '.selection-bar']) expect(await faults(page, part)).toEqual([]);
  },
);

test.each([
  [true, 'en'],
  [true, 'zh-CN'],
  [false, 'en'],
])('the menu of files names keys only where there are some (touch: %s, %s)', async (isMobile, locale) => {
  const options = isMobile ? { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile } : {};
  const { page } = await arrive('', { ...options, locale });
  await allSections(page);
  await page.locator('[popovertarget="project-menu"]').click();
  const text = await page.locator('#project-menu').innerText();
  expect(text.includes('Ctrl')).toBe(!isMobile);
  expect(text).not.toMatch(/[(（]\s*[)）]/);
  await page.screenshot({ path: join(OUTPUT, `menu-keys-${isMobile}-${locale}.png`) });
});

test('at 400 % tools and legend stay above the line of the solver, and its buttons can be pressed', async () => {
  const { page, script } = await share({ viewport: { width: 320, height: 256 } });
  await script.settled();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, 'at-400.png') });
  expect(await overlaps(page, ['.title h1', '.toolbar:not(.selection-bar)', '.legend', '.status'])).toEqual([]);
  expect(await faults(page, '.toolbar')).toEqual([]);
  expect(await faults(page, '.status')).toEqual([]);
  await page.getByRole('button', { name: 'Controls', exact: true }).click();
  await page.locator('.sections.open').waitFor();
});

test.each([
  [640, 400],
  [640, 360],
])('at %i by %i the legend leaves the line of the solver free beside open controls', async (width, height) => {
  const { page } = await share({ viewport: { width, height } });
  await page.getByRole('button', { name: 'Controls', exact: true }).click();
  await drawn(page);
  await page.screenshot({ path: join(OUTPUT, `legend-beside-controls-${height}.png`) });
  expect(await overlaps(page, ['.legend', '.status', '.toolbar:not(.selection-bar)'])).toEqual([]);
});

/** Lower than wide, from a small phone on its side to a low window. */
const LOW = [
  { width: 740, height: 360 },
  { width: 844, height: 390 },
  { width: 1024, height: 500 },
] as const;

describe.each(LOW)('on a screen of $width × $height', (viewport) => {
  const open = async (label: string) => {
    const { page } = await share();
    await page.getByRole('button', { name: 'Share', exact: true }).waitFor();
    await page.setViewportSize(viewport);
    const [fold, button] = ['Controls', label].map((name) => page.getByRole('button', { name, exact: true }));
    if (!(await button!.isVisible())) await fold!.click();
    await button!.click();
    return page;
  };
  /** Where it is; null: a part of it cannot be seen, for something lies over it or it is beside its dialog's scrolled part. */
  const seenWhole = (page: Page, of: string) =>
    page.locator(of).evaluate((element) => {
      const { left, right, top, bottom, width, height } = element.getBoundingClientRect();
      const corners = [left + 12, right - 12].flatMap((x) => [top + 12, bottom - 12].map((y) => [x, y] as const));
      const isSeen = corners.every(([x, y]) => element.contains(document.elementFromPoint(x, y)));
      return isSeen ? { width, height } : null;
    });

  test('the picture of a net being laid takes most of the height, and stays in sight', async () => {
    const page = await open('On a surface…');
    await page.locator('dialog.drape .primary:not([disabled])').waitFor();
    expect((await seenWhole(page, '.drape .picture'))!.height).toBeGreaterThan(200);
    await page.getByRole('button', { name: 'Draw a cut' }).scrollIntoViewIfNeeded();
    expect((await seenWhole(page, '.drape .picture'))!.height).toBeGreaterThan(200);
    const texts = page.locator('.drape :is(figcaption, .proposals, .side, .results)');
    const ends = await texts.evaluateAll((all) =>
      all
        .map((each) => each.getBoundingClientRect())
        .sort((a, b) => a.top - b.top)
        .map(({ top, bottom }) => [top, bottom] as const),
    );
    for (const [i, [top]] of ends.entries()) if (i > 0) expect(top).toBeGreaterThanOrEqual(ends[i - 1]![1]);
  });

  test('the code of a link is seen whole, and nothing lies over it', async () => {
    const page = await open('Share');
    await page.getByRole('dialog').getByText('The link is copied.').waitFor();
    const code = page.getByRole('img', { name: 'QR code' });
    await code.scrollIntoViewIfNeeded();
    const { width, height } = (await seenWhole(page, '.qr svg'))!;
    expect(width).toBe(height);
    expect(width).toBeGreaterThanOrEqual(200);
    const below = (await page.getByRole('heading', { name: 'To embed in a page' }).boundingBox())!;
    const { y } = (await code.boundingBox())!;
    expect(below.y).toBeGreaterThanOrEqual(y + height);
    await page.getByRole('button', { name: 'Copy code' }).click();
    await page.getByRole('dialog').getByText('The code is copied.').waitFor();
  });
});

test.each([
  [820, 1180, 'en'],
  [1024, 768, 'en'],
  [768, 1024, 'zh-CN'],
])(
  'on a tablet of %i by %i the tools of a selection have words, and leave legend and handles free (%s)',
  async (...size) => {
    const [width, height, locale] = size;
    const { page, script } = await arrive('', { viewport: { width, height }, hasTouch: true, isMobile: true, locale });
    await page.locator('.group').waitFor({ state: 'attached' });
    const handles = await page.evaluate(() => window.chebnet.handles());
    const places = await Promise.all(handles.map(({ vertex }) => script.screenPosition(vertex)));
    const { x, y } = places.at(-1)!;
    await page.touchscreen.tap(x, y);
    const tools = page.locator('.selection-bar');
    await tools.waitFor();
    expect(await faults(page, '.selection-bar')).toEqual([]);
    const words = await tools
      .locator('button:visible')
      .evaluateAll((all) => all.map((each) => (each as HTMLElement).innerText));
    expect(words.filter((text) => text.trim() === '')).toEqual([]);
    expect(await overlaps(page, ['.selection-bar', '.legend .bar', '.status'])).toEqual([]);
    const box = (await tools.boundingBox())!;
    expect(box.x).toBeGreaterThan(0);
    const radius = 9;
    for (const place of places)
      expect(place.y + radius < box.y || place.x + radius < box.x || place.x - radius > box.x + box.width).toBe(true);
  },
);

test('on a phone the dialogs of a link and of projects are as wide as the room, and their buttons have one line', async () => {
  const { page } = await arrive('', { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const sideways = () =>
    page.locator('dialog[open] .body').evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
  await page.getByRole('button', { name: 'Share' }).click();
  await page.locator('.qr svg').waitFor();
  expect(await sideways()).toBe(0);
  await page.keyboard.press('Escape');

  await page.getByRole('button', { name: 'File', exact: true }).click();
  await page.locator('#project-menu').getByText('My projects…').click();
  const lines = await page.getByRole('button', { name: 'Keep it' }).evaluate((keep) => {
    const words = document.createRange();
    words.selectNodeContents(keep);
    return words.getClientRects().length;
  });
  expect(lines).toBe(1);
  expect(await sideways()).toBe(0);
});

test('on a phone a message takes the place of the legend, and leaves the handles free', async () => {
  const { page, script } = await arrive('#v2=AAAA', {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
  });
  await allSections(page);
  const said = page.locator('.message');
  await said.waitFor();
  const { y } = (await said.boundingBox())!;
  const handles = await page.evaluate(() => window.chebnet.handles());
  for (const { vertex } of handles) expect((await script.screenPosition(vertex)).y + 12).toBeLessThan(y);
  expect(await overlaps(page, ['.message', '.toolbar:not(.selection-bar)', '.status'])).toEqual([]);
  expect(await page.locator('.legend').isVisible()).toBe(false);
  await said.getByRole('button').click();
  await page.locator('.legend').waitFor();
});

test.each([
  [820, 1180],
  [1024, 768],
  [1280, 800],
])('on a screen of %i by %i a message stands above the legend and the tools of a selection', async (width, height) => {
  const { page, script } = await share({ viewport: { width, height }, hasTouch: true, isMobile: true });
  await script.settled();
  const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar').waitFor();
  await script.move(vertex, [target[0], target[1], target[2] + 20]);
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  const above = async (other: string): Promise<void> => {
    const [box, beside] = [(await message.boundingBox())!, (await page.locator(other).boundingBox())!];
    expect(box.y + box.height, other).toBeLessThanOrEqual(beside.y);
  };
  await above('.selection-bar');
  await page.keyboard.press('Escape');
  await page.locator('.selection-bar').waitFor({ state: 'hidden' });
  await above('.legend');
});

test.each(['en', 'zh-CN'])(
  'the legend keeps a number and its unit in one line, however narrow it is (%s)',
  async (locale) => {
    const { page, script } = await arrive('', { locale });
    await script.settled();
    // Beyond its reach, where edges are off their length.
    const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
    await script.move(vertex, [target[0] + 99, target[1], target[2]]);
    const words = page.locator('.legend .words');
    await expect.poll(() => words.innerText()).toMatch(/\d\s%$/);
    expect(await words.isVisible()).toBe(true);
    const broken = await words.evaluate((element) => {
      const text = element.firstChild!;
      const end = text.nodeValue!.length;
      const lineOf = (at: number): number => {
        const range = document.createRange();
        range.setStart(text, at);
        range.setEnd(text, at + 1);
        return range.getBoundingClientRect().top;
      };
      const widths = Array.from({ length: 130 }, (_, i) => 70 + i);
      return widths.filter((width) => {
        element.style.width = `${width}px`;
        return lineOf(end - 1) !== lineOf(end - 3);
      });
    });
    expect(broken).toEqual([]);
  },
);

test.each([
  [768, 1024],
  [820, 1180],
  [960, 700],
  [1024, 768],
  [1280, 800],
  [1366, 768],
  [1440, 900],
  [1441, 900],
])('at %i by %i the line below the title is one, and clear of the tools', async (width, height) => {
  for (const [hints, selector] of [
    [true, '.hint'],
    [false, '> p'],
  ] as const) {
    const { page } = await arrive('', { viewport: { width, height }, hasTouch: true }, { hints });
    const line = page.locator(`.title ${selector}:visible`).first();
    await line.waitFor();
    const [said, tools] = [(await line.boundingBox())!, (await page.locator('.toolbar').first().boundingBox())!];
    expect(said.height).toBeLessThan(40);
    if (width > 1440) expect(said.x + said.width).toBeLessThanOrEqual(tools.x);
    else expect(said.y).toBeGreaterThanOrEqual(tools.y + tools.height);
  }
});

test('on a tablet each hint has its button beside it', async () => {
  const { page } = await arrive('', { viewport: { width: 1024, height: 768 }, hasTouch: true }, { hints: true });
  const hint = page.locator('.hint');
  for (const words of ['Drag the orange sphere', 'Press the net', 'a link to what you see']) {
    await hint.getByText(words).waitFor();
    expect((await hint.boundingBox())!.height).toBeLessThan(40);
    await hint.getByRole('button', { name: 'Got it' }).tap();
  }
});

test.each([
  [900, 700],
  [1024, 768],
  [1280, 800],
])('at %i by %i what is said of a net above it cuts no line below the title', async (width, height) => {
  const { page, script } = await arrive('', { viewport: { width, height } }, { hints: true });
  await page.locator('.hint:visible').waitFor();
  await script.open({ recipe: 'rabbit:vertices=972' });
  await script.settled();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await dragBy(script, vertex, [-90, -170]);
  await script.settled();
  await page.locator('.stuck-notice[data-place^=top] .message').waitFor();
  await drawn(page);
  const { x, y, height: high } = (await page.locator('.stuck-notice .message').boundingBox())!;
  const lines = await page.locator('.title .hint > :visible').all();
  for (const line of lines) {
    const box = (await line.boundingBox())!;
    expect(box.x + box.width <= x || box.y + box.height <= y || box.y >= y + high).toBe(true);
  }
  // It comes back.
  await page.locator('.stuck-notice .message > .plain').click();
  await page.locator('.hint:visible').waitFor();
});

/** Of a large net, as long as they become, in the order of the section Convergence. */
const LONG = [
  ...['100,000', '199,370', '3,000', '0.00012 %', '< 1e-16', '12,345'],
  ...['99.9 ms', '120', '1.2e-16', '1.2e-16 L', '1.2e-16 L', 'Opening corners'],
];

test.each(['en', 'zh-CN'])(
  'numbers of the solve are seen whole, however narrow their panel is (%s)',
  async (locale) => {
    const { page } = await arrive('', {
      viewport: { width: 820, height: 1180 },
      hasTouch: true,
      isMobile: true,
      locale,
    });
    const numbers = page.locator('.numbers').first();
    await page.locator('.group > summary').click();
    await numbers.waitFor();
    for (const width of [820, 768, 1024, 1280]) {
      await page.setViewportSize({ width, height: 1024 });
      await drawn(page);
      const outside = await numbers.evaluate((list, long) => {
        const values = [...list.querySelectorAll('dd')];
        const { left, right } = list.getBoundingClientRect();
        const isOutside = (value: HTMLElement) =>
          value.getBoundingClientRect().left < left || value.getBoundingClientRect().right > right + 1;
        const cut = () => values.filter(isOutside).map((value) => value.parentElement!.textContent);
        const now = cut();
        const texts = values.map((value) => value.textContent);
        const put = (all: readonly (string | null)[]) =>
          values.forEach((value, i) => (value.textContent = all[i] ?? ''));
        put(long);
        const then = cut();
        put(texts);
        return [...now, ...then];
      }, LONG);
      expect(outside, `${width} px`).toEqual([]);
    }
  },
);

/** Where a part of the page is while the solver says one thing and another, each place once, and how much is seen of what it says. */
/** Selects the crown of a dome and drags it so many pixels, beyond what the net reaches. */
async function pullTooFar(
  { page, script }: Pick<Visit, 'page' | 'script'>,
  across: number,
  down: number,
): Promise<number> {
  await script.open({ recipe: 'dome:vertices=500,reach=55' });
  await script.settled();
  await drawn(page);
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.touchscreen.tap(x, y);
  await page.locator('.selection-bar').waitFor();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + across, y + down, { steps: 10 });
  await page.mouse.up();
  await script.settled();
  await page.locator('.stuck-notice .message').waitFor();
  await drawn(page);
  return vertex;
}

function placesOf(page: Page, part: string): Promise<string[]> {
  return page.evaluate(
    ({ part, all }) => {
      const line = document.querySelector<HTMLElement>('.status-words')!;
      const said = line.textContent;
      const found = all.map((words) => {
        line.textContent = words;
        const { top, height } = document.querySelector(part)!.getBoundingClientRect();
        const isWhole = line.scrollHeight <= line.clientHeight;
        return `${height} px at ${top} px, ${isWhole ? 'all' : 'a part'} of it is seen`;
      });
      line.textContent = said;
      return [...new Set(found)];
    },
    { part, all: [en, zh].flatMap(({ status }) => Object.values(status)) },
  );
}

/** Lists within a part of the page that do not show one of their choices whole. */
function cutLists(page: Page, part: string): Promise<string[]> {
  return page.locator(`${part} select:visible`).evaluateAll((lists) => {
    const pen = document.createElement('canvas').getContext('2d')!;
    const ARROW = 20;
    return (lists as HTMLSelectElement[]).flatMap((list) => {
      const { font, paddingLeft, paddingRight } = getComputedStyle(list);
      pen.font = font;
      const room = list.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - ARROW;
      const shown = [...list.options].filter((option) => !option.hidden).map(({ text }) => text);
      return shown.filter((text) => pen.measureText(text).width > room);
    });
  });
}

test.each([
  [360, 740],
  [820, 1180],
  [1280, 800],
])(
  'on a screen of %i by %i lists of choices are read whole, beside the net and on a surface',
  async (width, height) => {
    const { page } = await arrive('', { viewport: { width, height }, hasTouch: true, isMobile: true });
    await allSections(page);
    const fold = page.getByRole('button', { name: 'Controls', exact: true });
    if (await fold.isVisible()) await fold.click();
    expect(await cutLists(page, '.sections')).toEqual([]);
    await page.getByRole('button', { name: 'On a surface…' }).click();
    for (const net of ['piece', 'whole']) {
      await page.locator('dialog label', { hasText: /^Net/ }).getByRole('combobox').selectOption(net);
      expect(await cutLists(page, 'dialog'), net).toEqual([]);
    }
  },
);

test.each([
  [390, 844, 'en'],
  [390, 844, 'zh-CN'],
  [740, 360, 'en'],
])('at %i by %i what a list of the menu of exports says is read whole (%s)', async (width, height, locale) => {
  const { page } = await arrive('', { viewport: { width, height }, hasTouch: true, isMobile: true, locale });
  await allSections(page);
  await page.getByRole('button', { name: /^(Export|导出)$/ }).tap();
  await page.locator('#export-menu:popover-open').waitFor();
  expect(await cutLists(page, '#export-menu')).toEqual([]);
});

test('below the last control of a section is room, whatever is hidden after it', async () => {
  const { page } = await share();
  const choice = page.getByRole('combobox', { name: 'The net' });
  for (const behaviour of ['lengths', 'shape']) {
    await choice.selectOption(behaviour);
    const below = await choice.evaluate((list) => {
      const section = list.closest('details')!;
      const controls = [...section.children].filter((each) => each.checkVisibility());
      const end = Math.max(...controls.map((each) => each.getBoundingClientRect().bottom));
      return section.getBoundingClientRect().bottom - end;
    });
    expect(below, behaviour).toBeGreaterThanOrEqual(20);
  }
});

test('the controls stay where they are, whatever the solver says', async () => {
  const { page } = await arrive('', { hasTouch: true, isMobile: true });
  for (const width of [740, 820, 1024, 1121, 1280]) {
    await page.setViewportSize({ width, height: 800 });
    await drawn(page);
    expect(await placesOf(page, '.sections'), `${width} px`).toEqual([expect.stringContaining(', all of it')]);
  }
});

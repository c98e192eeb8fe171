/** axe finds nothing to complain of, whatever is open, on light and dark, on a desktop and a phone. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import type { AxeResults } from 'axe-core';
import type { Frame, Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import { drawn, OUTPUT, unfoldAll, visits } from './page';

const AXE = readFileSync(
  createRequire(new URL('../../web/package.json', import.meta.url)).resolve('axe-core/axe.min.js'),
  'utf8',
);
const site = visits();

/** What axe complains of in light and dark, with the elements. Evaluated, for the page's policy keeps out added scripts.
 *  @param part what is looked at, as a selector. */
async function faults(page: Page, view: Page | Frame = page, part = 'html'): Promise<string[]> {
  await view.evaluate(AXE);
  const run = (rules: string[] | null) =>
    view.evaluate(
      async ([within, only]) => {
        const { axe } = window as unknown as { axe: { run(within: string, options: object): Promise<AxeResults> } };
        const { violations } = await axe.run(within, only === null ? {} : { runOnly: only });
        return violations.flatMap(({ id, nodes }) =>
          nodes.map(({ target, any }) => `${id}: ${target.join(' ')}: ${any[0]?.message ?? ''}`),
        );
      },
      [part, rules] as const,
    );
  const light = await run(null);
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  const dark = await run(['color-contrast']);
  await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' });
  return [...light, ...dark.map((fault) => `dark: ${fault}`)];
}

/** Two faces with the same corners, a vertex of no face, edges of different lengths. */
const BROKEN = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\nf 4 3 2 1\n';

describe.each([
  { name: 'desktop', viewport: { width: 1280, height: 800 } },
  { name: 'phone', viewport: { width: 390, height: 844 } },
])('$name', ({ name, viewport }) => {
  const options = { viewport, colorScheme: 'light', reducedMotion: 'reduce' } as const;
  const picture = (what: string) => ({ path: join(OUTPUT, `axe-${name}-${what}.png`) });

  test('the editor', async () => {
    const { page, script } = await site.arrive('', options, { hints: true });
    await script.settled();
    await page.getByText('Drag the orange sphere, and').waitFor();
    const found: Record<string, string[]> = { first: await faults(page) };
    for (let hint = 0; hint < 3; ++hint) await page.getByRole('button', { name: 'Got it' }).click();

    const dialog = page.getByRole('dialog');
    await page.keyboard.press('?');
    await dialog.waitFor();
    found.keys = await faults(page, page, 'dialog');
    await page.screenshot(picture('keys'));
    await dialog.getByRole('button', { name: 'Close' }).click();
    await page.getByRole('button', { name: 'Share', exact: true }).click();
    await dialog.locator('svg').waitFor();
    found.share = await faults(page, page, 'dialog');
    await page.screenshot(picture('share'));
    await dialog.getByRole('button', { name: 'Close' }).click();

    await page.getByRole('button', { name: 'Export', exact: true }).click();
    found.menu = await faults(page);
    await page.screenshot(picture('menu'));
    await page.keyboard.press('Escape');

    if (name === 'phone') await page.getByRole('button', { name: 'Controls' }).click();
    await unfoldAll(page);
    await page.keyboard.press('l');
    await page.keyboard.press('Control+a');
    found.sections = await faults(page);
    await page.screenshot(picture('sections'));
    await page.keyboard.press('Escape');

    await page.getByRole('button', { name: 'Equalise…', exact: true }).click();
    await dialog.locator('canvas').waitFor();
    found.equalise = await faults(page, page, 'dialog');
    await page.screenshot(picture('equalise'));
    await dialog.getByRole('button', { name: 'Cancel' }).click();

    await page.getByRole('button', { name: 'On a surface…', exact: true }).click();
    await dialog.getByText('Largest dL').waitFor();
    found.surface = await faults(page, page, 'dialog');
    await page.screenshot(picture('surface'));
    await dialog.getByRole('button', { name: 'Cancel' }).click();

    await page.getByRole('button', { name: 'Compare', exact: true }).click();
    await page.locator('.comparison .uplot').nth(1).waitFor();
    found.comparison = await faults(page);
    await page.screenshot(picture('comparison'));
    await page.getByRole('button', { name: 'Close the comparison' }).click();

    await page.evaluate((obj) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([obj], 'broken.obj'));
      document
        .getElementById('view')!
        .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }, BROKEN);
    await dialog.getByText('Mean length').waitFor();
    found.file = await faults(page, page, 'dialog');
    await page.screenshot(picture('file'));

    expect(found).toEqual({
      first: [],
      keys: [],
      share: [],
      menu: [],
      sections: [],
      equalise: [],
      surface: [],
      comparison: [],
      file: [],
    });
  });

  test('a figure of the paper, and its nets side by side', async () => {
    const { page } = await site.arrive('#experiment=shear', options);
    const note = page.getByRole('region', { name: 'Experiment' });
    await note.getByText('Figure 4').waitFor();
    await note.evaluate((each) => (each.querySelector('details')!.open = true));
    const found: Record<string, string[]> = { note: await faults(page) };
    await page.screenshot(picture('figure'));
    await note.getByRole('button', { name: 'Run all' }).click();
    await page.getByText('3 runs').waitFor();
    await page.getByRole('button', { name: 'Side by side' }).click();
    await page.locator('#beside canvas').first().waitFor();
    found.abreast = await faults(page);
    await page.screenshot(picture('abreast'));
    expect(found).toEqual({ note: [], abreast: [] });
  });

  test('a lesson with the editor in it', async () => {
    const { page } = await site.open('lesson.html', options);
    await page.getByText('The largest dL of its').waitFor();
    const frame = page.frame({ url: /\?embed/ })!;
    const [lesson, asleep] = [await faults(page), await faults(page, frame)];
    await frame.getByRole('button', { name: 'Press to drag the net' }).click();
    expect({ lesson, asleep, awake: await faults(page, frame) }).toEqual({ lesson: [], asleep: [], awake: [] });
  });
});

/** Whatever in a part of the page can have the focus, and the ring around it is cut off by what scrolls there. */
function cutRings(page: Page, part: string): Promise<string[]> {
  return page.evaluate((within) => {
    const cut: string[] = [];
    for (const each of document.querySelectorAll<HTMLElement>(
      `${within} :is(button, input, select, summary, a, [tabindex])`,
    )) {
      each.focus();
      if (document.activeElement !== each) continue;
      const { outlineOffset, outlineWidth } = getComputedStyle(each);
      const reach = parseFloat(outlineOffset) + parseFloat(outlineWidth);
      const ring = each.getBoundingClientRect();
      const isCut = (around: Element) => {
        if (getComputedStyle(around).overflowY === 'visible') return false;
        const { left, right, top, bottom } = around.getBoundingClientRect();
        const gaps = [ring.left - left, right - ring.right, ring.top - top, bottom - ring.bottom];
        return Math.min(...gaps) < reach - 0.5;
      };
      for (let around = each.parentElement; around !== null; around = around.parentElement)
        if (isCut(around)) cut.push(`${each.ariaLabel ?? each.textContent}, by ${around.className || around.tagName}`);
    }
    return cut;
  }, part);
}

test('the ring around what has the focus is seen whole', async () => {
  const { page, script } = await site.arrive();
  await script.settled();
  await unfoldAll(page);
  await page.keyboard.press('Tab');
  await drawn(page);
  expect(await cutRings(page, '.sidebar')).toEqual([]);
  for (const label of ['Share', 'Keys', 'Equalise…']) {
    await page.getByRole('button', { name: label, exact: true }).press('Enter');
    await page.getByRole('dialog').waitFor();
    expect(await cutRings(page, 'dialog'), label).toEqual([]);
    await page.keyboard.press('Escape');
  }
});

test('a dialog has the focus where one goes on, from its beginning, and gives it back', async () => {
  const { page, script } = await site.arrive();
  await script.open({ recipe: 'vault:vertices=300' });
  await script.settled();
  const focused = () => page.locator(':focus').innerText();
  for (const [label, first] of [
    ['Share', /^(Do not wait|Copy link)$/],
    ['Equalise…', /^Equalise$/],
  ] as const) {
    await page.getByRole('button', { name: label, exact: true }).press('Enter');
    await page.getByRole('dialog').waitFor();
    await expect.poll(focused).toMatch(first);
    await page.keyboard.press('Escape');
    await expect.poll(focused).toBe(label);
  }
});

test('forced colours leave legend, sliders, status and the chosen shape to be seen', async () => {
  const { page, script } = await site.arrive('', { forcedColors: 'active' });
  await script.settled();
  const styleOf = (selector: string, name: string) =>
    page
      .locator(selector)
      .first()
      .evaluate((each, property) => getComputedStyle(each).getPropertyValue(property), name);
  expect(await styleOf('.legend .bar', 'background-image')).toMatch(/gradient/);
  expect(await styleOf('input[type=range]', 'border-top-width')).toBe('1px');
  expect(await styleOf('.light', 'background-color')).not.toBe(await styleOf('.status', 'background-color'));
  expect(await styleOf('.gallery [aria-pressed=true]', 'outline-width')).toBe('3px');
  await page.screenshot({ path: join(OUTPUT, 'forced-colours.png') });
});

interface Heard {
  role: string;
  name: string;
}

/** What a screen reader is given: the accessibility tree as Chromium has it. */
async function listenTo(page: Page) {
  const session = await page.context().newCDPSession(page);
  const said = ({ role, name }: { role?: { value?: unknown }; name?: { value?: unknown } }): Heard => ({
    role: String(role?.value ?? ''),
    name: String(name?.value ?? ''),
  });
  return {
    /** Where the focus is; null: on nothing. */
    focus: async (): Promise<Heard | null> => {
      const { result } = await session.send('Runtime.evaluate', { expression: 'document.activeElement' });
      if (result.className === 'HTMLBodyElement') return null;
      const object = result.objectId === undefined ? {} : { objectId: result.objectId };
      const { nodes } = await session.send('Accessibility.getPartialAXTree', { ...object, fetchRelatives: false });
      return said(nodes[0]!);
    },
    texts: async (): Promise<string[]> => {
      const { nodes } = await session.send('Accessibility.getFullAXTree');
      const heard = nodes.filter(({ ignored }) => !ignored).map(said);
      return heard.flatMap(({ role, name }) => (role === 'StaticText' ? [name] : []));
    },
  };
}

test('a screen reader is led through the basic edit and told what came of it', async () => {
  const { page, script } = await site.arrive();
  await script.settled();
  await page.getByText('History', { exact: true }).waitFor();
  const { focus, texts: heard } = await listenTo(page);
  const focusOn = async (role: string, name: RegExp) => {
    for (let i = 0; i < 80; ++i) {
      await page.keyboard.press('Tab');
      const reached = await focus();
      expect(reached?.name, `the name of a ${reached?.role}`).not.toBe('');
      if (reached?.role === role && name.test(reached.name)) return;
    }
    throw new Error(`Tab does not lead to a ${role} ${name}`);
  };

  await focusOn('button', /^Vault$/);
  await page.keyboard.press('Enter');
  await expect.poll(heard).toContainEqual(expect.stringMatching(/^Open vault\. Every edge keeps its length/));
  await focusOn('DisclosureTriangle', /^Handles/);
  await page.keyboard.press('Enter');
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await focusOn('button', new RegExp(`^Vertex ${vertex}$`));
  await page.keyboard.press('Enter');
  await expect.poll(heard).toContainEqual(expect.stringMatching(new RegExp(`^Selected: handle ${vertex}\\.`)));

  const before = await script.position(vertex);
  await focusOn('application', /^The net\. Arrow keys .* move the selected handles/);
  await page.keyboard.press('ArrowUp');
  await expect
    .poll(heard)
    .toContainEqual(expect.stringMatching(new RegExp(`^Move handle ${vertex}\\. Every edge keeps its length`)));
  expect(await script.position(vertex)).not.toEqual(before);
  await page.keyboard.press('Control+z');
  await expect.poll(heard).toContainEqual(expect.stringMatching(new RegExp(`^Undone: Move handle ${vertex}\\.`)));
  await script.settled();
  expect(await script.position(vertex)).toEqual(before);
});

test('what came of a key is told once the solver has answered, however late', async () => {
  const { page, script } = await site.arrive();
  await script.settled();
  await page.getByText('History', { exact: true }).waitFor();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.mouse.click(x, y);
  await page.locator('.narrator', { hasText: 'Selected' }).waitFor();
  const heard = await page.evaluateHandle((moving) => {
    const place = () =>
      window.chebnet
        .positions()
        .slice(3 * moving, 3 * moving + 3)
        .join();
    const before = place();
    const all: { text: string; isMoved: boolean }[] = [];
    const narrator = document.querySelector('.narrator')!;
    new MutationObserver(() => all.push({ text: narrator.textContent!, isMoved: place() !== before })).observe(
      narrator,
      {
        childList: true,
      },
    );
    const post = Worker.prototype.postMessage as (this: Worker, message: unknown) => void;
    Worker.prototype.postMessage = function (message: unknown) {
      setTimeout(() => post.call(this, message), 1000);
    };
    return all;
  }, vertex);
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => heard.jsonValue()).toHaveLength(1);
  const [{ text, isMoved } = { text: '', isMoved: false }] = await heard.jsonValue();
  expect(text).toMatch(new RegExp(`^Move handle ${vertex}\\. Every edge keeps its length`));
  expect(isMoved).toBe(true);
});

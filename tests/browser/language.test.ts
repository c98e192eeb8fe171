/** The page in Chinese: every text, at every width, and the way from one language to the other. */
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { dropFile, OUTPUT, unfoldAll, visits } from './page';

const { arrive, open } = visits();
const CHINESE = { locale: 'zh-CN' };

/** Names, keys, units and formulas, the other language by its own name, and in parentheses what the core says. */
const NAMES =
  /chebnet|English|ARAP|L-BFGS|Hessian|Li|li2022|WebGL|JavaScript|Esc|Ctrl|Shift|Home|F2|Delete|OBJ|PLY|OFF|STL|GLB|3DM|SVG|CSV|PNG|Rhino|Blender|dL|D\^p|[rp]\^-?p|\|r - 1\||mm|ms|MB|1\.obj|（[ -~]+）/g;

/** What the page says in Latin letters beyond names: texts, and what a pointer or a screen reader learns besides. */
async function foreignWords(page: Page): Promise<string[]> {
  const texts = await page.evaluate(() => {
    const said: string[] = [document.title];
    const visible = (element: Element): boolean =>
      element.checkVisibility() && element.closest('cite, kbd, textarea') === null;
    for (const element of document.querySelectorAll('body *')) {
      if (!visible(element)) continue;
      for (const name of ['aria-label', 'title', 'placeholder', 'aria-valuetext', 'alt'])
        said.push(element.getAttribute(name) ?? '');
      for (const node of element.childNodes) if (node.nodeType === Node.TEXT_NODE) said.push(node.nodeValue ?? '');
    }
    return said;
  });
  const latin = (text: string) => /[A-Za-z]{2,}/.test(text.replace(NAMES, ''));
  return [...new Set(texts.filter(latin))];
}

async function overflow(page: Page, selector: string): Promise<number> {
  return page.locator(selector).evaluate((each) => each.scrollWidth - each.clientWidth);
}

test('a Chinese visitor reads Chinese: in the picture, in every panel, on a file and on its fault', async () => {
  const { page, script } = await arrive('', CHINESE);
  await script.settled();
  expect(await page.locator('html').getAttribute('lang')).toBe('zh-CN');
  await page.locator('.status-words', { hasText: '每条边的长度都保持不变' }).waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-desktop.png') });
  await unfoldAll(page);
  await page.keyboard.press('Control+a');
  await page.getByRole('heading', { name: '已选中 5 个手柄' }).waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-selection.png') });
  await page.getByRole('button', { name: '导出', exact: true }).click();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-save.png') });
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: '分享' }).click();
  await page.getByRole('img', { name: '链接的二维码' }).waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.keyboard.press('Escape');

  await dropFile(page, '1.obj', 'v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 9 9 9\nf 1 2 3 4\nf 1 2 3 4\n');
  const dialog = page.getByRole('dialog');
  await dialog.getByText('此网格有缺陷').waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-file.png') });
  await dialog.getByRole('radio', { name: /均匀化/ }).check();
  await dialog.getByRole('button', { name: '修复并均匀化…' }).click();
  const equalise = page.getByRole('dialog', { name: '均匀化边长：1.obj' });
  await equalise.getByRole('button', { name: '开始均匀化' }).click();
  await equalise.getByText('每条边的长度都是').waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-equalise.png') });
  await equalise.getByRole('button', { name: '取消' }).click();
  await dialog.getByRole('button', { name: '取消' }).click();
  await dropFile(page, '2.obj', 'v 0 0\n');
  await page
    .getByRole('alert')
    .getByText(/^无法读取（2\.obj:1.*）。$/)
    .waitFor();
});

/** Runs in the page, before anything else: what the section of shapes says at any time without a Chinese word. */
function collectForeign(): void {
  const foreign = new Set<string>();
  Object.assign(window, { foreign });
  const look = () => {
    for (const each of document.querySelectorAll<HTMLElement>('.gallery button, .parameters label, .parameters input'))
      for (const text of [each.textContent, each.title])
        if (/[A-Za-z]/.test(text) && !/\p{Script=Han}/u.test(text)) foreign.add(text);
  };
  new MutationObserver(look).observe(document, { subtree: true, childList: true, attributes: true });
}

test('shapes and their parameters are named in Chinese from the first picture on, and then explained', async () => {
  const { page } = await open('', CHINESE);
  await page.addInitScript(collectForeign);
  await page.reload();
  const titles = (controls: string) =>
    page.locator(controls).evaluateAll((all) => all.map((each) => (each as HTMLElement).title));
  const explained = (texts: string[]) => texts.length > 0 && texts.every((text) => /\p{Script=Han}.*。$/u.test(text));
  await page.getByRole('button', { name: '拱顶' }).waitFor();
  // Sliders come with the net, after the gallery's tables; explanations with the sections after both.
  await expect.poll(() => page.locator('.parameters label > span').allInnerTexts()).toEqual(['顶点数', '延伸角']);
  await expect.poll(() => titles('.gallery button[aria-pressed]')).toSatisfy(explained);
  await expect.poll(() => titles('.parameters input')).toSatisfy(explained);
  await page.getByRole('button', { name: '大象' }).click();
  await page.getByRole('slider', { name: '鼻长' }).waitFor();
  await expect.poll(() => titles('.parameters input')).toSatisfy(explained);
  expect(await page.evaluate(() => [...(window as unknown as { foreign: Set<string> }).foreign])).toEqual([]);
});

test('in an experiment, its steps and its comparison too, and on a phone nothing runs over the edge', async () => {
  const { page, script } = await arrive('#experiment=long-edges', CHINESE);
  await script.settled();
  await page.getByRole('button', { name: '单步迭代' }).first().click();
  await unfoldAll(page);
  await page.getByRole('button', { name: '开始比较' }).click();
  const results = page.getByRole('region', { name: '比较结果' });
  await results.getByText('2 次求解').waitFor();
  await results.getByRole('button', { name: 'Li 等 2022', exact: true }).click();
  await page.getByText('正在显示').waitFor();
  expect(await foreignWords(page)).toEqual([]);
  await page.screenshot({ path: join(OUTPUT, 'chinese-comparison.png') });

  await page.setViewportSize({ width: 390, height: 844 });
  expect(await overflow(page, 'html')).toBeLessThanOrEqual(0);
  await page.getByRole('button', { name: '关闭比较' }).click();
  await page.screenshot({ path: join(OUTPUT, 'chinese-phone.png') });
  await page.getByRole('button', { name: '控制面板' }).click();
  expect(await overflow(page, 'html')).toBeLessThanOrEqual(0);
  expect(await overflow(page, '#sections')).toBeLessThanOrEqual(0);
  await page.screenshot({ path: join(OUTPUT, 'chinese-phone-controls.png') });
});

test('a lesson speaks the language of the editor in it', async () => {
  const { page } = await open('lesson.html', CHINESE);
  await page.getByText(/条边中最大的 dL 为/).waitFor();
  expect(await page.locator('html').getAttribute('lang')).toBe('zh-CN');
  expect(await foreignWords(page)).toEqual([]);
  await page.frameLocator('iframe').getByRole('button', { name: /点击/ }).waitFor();
  await page.getByRole('button', { name: '把顶点压低' }).click();
  await page.getByText(/共迭代 [1-9]/).waitFor();
  await page.screenshot({ path: join(OUTPUT, 'chinese-lesson.png') });
});

test('the choice of a language is remembered, and the net stays, its history in that language', async () => {
  const { page, script } = await arrive('#experiment=exponent');
  expect(await page.locator('html').getAttribute('lang')).toBe('en-US');
  await script.open({ recipe: 'tube:vertices=300' });
  await script.settled();
  const { vertices } = await script.stats();
  // Or what is still on its way is broken off, which counts as a complaint.
  await page.waitForLoadState('networkidle');
  await page.getByRole('button', { name: '中文' }).click();
  await page.locator('html[lang=zh-CN]').waitFor();
  await script.waitForNet();
  expect(await page.title()).toContain('切比雪夫网');
  expect((await script.stats()).vertices).toBe(vertices);
  await page.getByText('历史记录', { exact: true }).click();
  await expect.poll(() => page.locator('.history button').allInnerTexts()).toEqual(['打开链接', '打开管']);
  await page.waitForLoadState('networkidle');
  await page.reload();
  await script.waitForNet();
  await page.waitForLoadState('networkidle');
  await page.getByRole('button', { name: 'English' }).click();
  await page.locator('html[lang=en-US]').waitFor();
  expect(await page.getByRole('button', { name: 'English' }).getAttribute('aria-pressed')).toBe('true');
});

/** Visits to the page, for tests. */
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { DIST, launch, newVisit, serve } from './site';
import type { Visit } from './site';

export { DIST, MOVING, Script } from './site';
export type { Visit } from './site';
export const README_PICTURE = fileURLToPath(new URL('../../web/screenshot.png', import.meta.url));
export const OUTPUT = fileURLToPath(new URL('../output', import.meta.url));
mkdirSync(OUTPUT, { recursive: true });

/** For one file of tests: a browser and the site while they run. After each test its visits end, and none may have
 *  complained. */
export function visits(root = () => DIST) {
  let browser: Browser;
  let site: Awaited<ReturnType<typeof serve>>;
  const going: Visit[] = [];

  beforeAll(async () => {
    [browser, site] = await Promise.all([launch(), serve(root)]);
  });
  afterEach(async () => {
    const ended = going.splice(0);
    await Promise.all(ended.map(({ page }) => page.context().close()));
    for (const { complaints } of ended) expect(complaints).toEqual([]);
  });
  afterAll(async () => {
    await browser.close();
    site.close();
  });

  /** Opens any page of the site. Hints are for the tests that want them. */
  async function open(link: string, options: BrowserContextOptions = {}, { hints = false } = {}): Promise<Visit> {
    const visit = await newVisit(browser, options);
    if (!hints) await visit.page.addInitScript(() => localStorage.setItem('chebnet.hints', 'drag add share'));
    going.push(visit);
    await visit.page.goto(new URL(link, site.address).href);
    return visit;
  }

  /** Opens the page, or a link into it, and waits for the net. */
  async function arrive(
    link = '',
    options: BrowserContextOptions = {},
    preferences: { hints?: boolean } = {},
  ): Promise<Visit> {
    const visit = await open(link, options, preferences);
    await visit.script.waitForNet();
    return visit;
  }

  /** The files that visitors have got so far. */
  const served = (): string[] => [...site.served];

  return { browser: () => browser, address: () => site.address, served, open, arrive };
}

/** Unfolds a section among those for research. */
export async function openForResearch(page: Page, section: string): Promise<void> {
  await page.locator('summary', { hasText: /^For research$/ }).click();
  await page.locator('summary', { hasText: section }).click();
}

/** Resolves when what was asked for has been drawn: one frame lays the page out, the next draws what follows from that. */
export function drawn(page: Page): Promise<unknown> {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Drops a file on the picture. */
export function dropFile(page: Page, name: string, content: Uint8Array | string): Promise<void> {
  const bytes = Buffer.from(content).toString('base64');
  return page.evaluate(
    ([fileName, base64]) => {
      const file = new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], fileName);
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(file);
      document
        .getElementById('view')
        ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, bytes] as const,
  );
}

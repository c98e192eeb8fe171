/** Visits to the page, for tests. */
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { asAtFirst, type First, putAway } from './put_away';
import { DIST, launch, newVisit, serve } from './site';
import type { Visit } from './site';

export { dropFile } from './drop_file';
export { DIST, MOVING, Script } from './site';
export type { Visit } from './site';
export const README_PICTURE = fileURLToPath(new URL('../../web/screenshot.png', import.meta.url));
export const NETS_PICTURE = fileURLToPath(new URL('../../web/nets.jpg', import.meta.url));
export const OUTPUT = fileURLToPath(new URL('../output', import.meta.url));
mkdirSync(OUTPUT, { recursive: true });

/** For one file of tests: a browser and the site while they run. After each test its visits end, and none may have
 *  complained; one that is to be shared stays, if the test passed. */
export function visits(root = () => DIST) {
  let browser: Browser;
  let site: Awaited<ReturnType<typeof serve>>;
  const going: Visit[] = [];
  /** The visit that tests share, by what it was asked for. */
  let shared: { visit: Visit; options: string; first: First } | null = null;

  beforeAll(async () => {
    [browser, site] = await Promise.all([launch(), serve(root)]);
  });
  afterEach(async ({ task }) => {
    const ended = going.splice(0);
    const complaints = ended.flatMap((visit) => visit.complaints);
    const stays = task.result?.state !== 'fail' && complaints.length === 0 ? shared?.visit : undefined;
    await Promise.all(ended.filter((visit) => visit !== stays).map(({ page }) => page.context().close()));
    if (stays === undefined) shared = null;
    expect(complaints).toEqual([]);
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

  /** The page as `arrive` shows it, without a link, for tests that need not be the first thing a visitor does: one visit for
   *  all, as long as what each has done can be put away. Loading takes longer than most of them. */
  async function share(options: BrowserContextOptions = {}): Promise<Visit> {
    const wanted = JSON.stringify(options);
    if (shared?.options === wanted) {
      if (await putAway(shared.visit.page, shared.first)) {
        going.push(shared.visit);
        return shared.visit;
      }
      // No fault, but seconds are lost: where every test says so, something is not closed any more.
      console.log('The page could not be brought back to how it was at first: it is loaded again.');
    }
    await shared?.visit.page.context().close();
    const visit = await arrive('', options);
    shared = { visit, options: wanted, first: await asAtFirst(visit.page) };
    return visit;
  }

  /** The files that visitors have got so far. */
  const served = (): string[] => [...site.served];

  return { browser: () => browser, address: () => site.address, served, open, arrive, share };
}

/** Unfolds a section among those for research. */
export async function openForResearch(page: Page, section: string): Promise<void> {
  await page.locator('summary', { hasText: /^For research$/ }).click();
  await page.locator('summary', { hasText: section }).click();
}

/** Resolves when the sections are there that come after the first picture. */
export async function allSections(page: Page): Promise<void> {
  await page.locator('.sections > details.group').waitFor({ state: 'attached' });
}

/** Unfolds every section of the page, once all are there. */
export async function unfoldAll(page: Page): Promise<void> {
  await allSections(page);
  await page.evaluate(() => document.querySelectorAll('details').forEach((each) => (each.open = true)));
}

/** Resolves when what was asked for has been drawn: one frame lays the page out, the next draws what follows from that. */
export function drawn(page: Page): Promise<unknown> {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Pixels between the net and the nearest side of the picture; negative: a part of it is outside. */
export function room(page: Page): Promise<number> {
  return page.evaluate(() => {
    const { left, right, top, bottom } = document.querySelector('#view canvas')!.getBoundingClientRect();
    const places = Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v));
    return Math.min(...places.flatMap(({ x, y }) => [x - left, right - x, y - top, bottom - y]));
  });
}

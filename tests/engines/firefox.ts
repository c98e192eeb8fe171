/** Firefox, by puppeteer-core and WebDriver BiDi. */
import { existsSync } from 'node:fs';
import puppeteer from 'puppeteer-core';
import type { ConsoleMessage, KeyInput, Page } from 'puppeteer-core';
import { STORAGE } from './driver';
import type { Driver, Engine } from './driver';
import { newFolder, startDisplay } from './temporary';

const PROGRAMS = ['/usr/bin/firefox-esr', '/usr/bin/firefox'];

/** What Firefox says about drawing in software. */
const EXPECTED = [/WebGL warning/, /GPU stall/];

/** What Firefox says of a file that its service worker was handing to a page that is left, cut off like any other, but on the
 *  console or as an error of the page. Of a page that stays it is a fault. */
const CUT_OFF = /A ServiceWorker intercepted the request and encountered an unexpected error/;
/** Milliseconds about the change of pages in which it may be said. */
const LEAVING = 2000;

/** What nobody waits for any longer: the page was left, or a worker ended. */
const GIVEN_UP = ['NS_BINDING_ABORTED', 'NS_BASE_STREAM_CLOSED', 'Parent browsing context was disposed'];

export async function startFirefox(): Promise<Engine> {
  const executablePath = [process.env['FIREFOX'] ?? '', ...PROGRAMS].find(existsSync);
  if (executablePath === undefined) throw new Error('no Firefox: install it or set FIREFOX to its path');
  const display = await startDisplay();
  const downloads = newFolder();
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath,
    headless: false,
    env: { ...process.env, DISPLAY: display.name },
    extraPrefsFirefox: {
      'webgl.force-enabled': true,
      // In kB, for all together; each site may take a fifth.
      'dom.quotaManager.temporaryStorage.fixedLimit': Math.ceil((5 * STORAGE) / 1024),
      'ui.prefersReducedMotion': 1,
      'browser.download.dir': downloads.path,
      'browser.download.folderList': 2,
      'browser.download.alwaysOpenPanel': false,
    },
  });

  async function newWindow(): Promise<Driver> {
    const context = await browser.createBrowserContext();
    const page = await context.newPage();
    await page.setViewport({ width: 1280, height: 800 });
    const complaints = complaintsOf(page);
    return {
      goto: async (url) => void (await page.goto(url)),
      reload: async () => void (await page.reload()),
      evaluate: (expression) => page.evaluate(expression),
      movePointer: (x, y) => page.mouse.move(x, y),
      pressButton: () => page.mouse.down(),
      releaseButton: () => page.mouse.up(),
      turnWheel: (deltaY) => page.mouse.wheel({ deltaY }),
      pressKey: (key) => page.keyboard.down(key as KeyInput),
      releaseKey: (key) => page.keyboard.up(key as KeyInput),
      resize: async (width, height) => {
        await page.setViewport({ width, height });
        // The answer can come before the page has that size, and what is clicked on by its place then is elsewhere.
        await page.waitForFunction(`innerWidth === ${width} && innerHeight === ${height}`);
      },
      screenshot: async () => Buffer.from(await page.screenshot()),
      downloads: downloads.path,
      complaints: async () => complaints(),
      close: () => context.close(),
    };
  }

  async function close(): Promise<void> {
    await browser.close();
    await display.stop();
    downloads.remove();
  }

  return { name: 'firefox', newWindow, close };
}

function complaintsOf(page: Page): () => string[] {
  const complaints: string[] = [];
  const cutOff: { text: string; time: number }[] = [];
  const changes: { from: number; to: number }[] = [];
  let left: number | null = null;
  page.on('request', (request) => {
    if (request.isNavigationRequest()) left = Date.now();
  });
  // The page that came has been read.
  page.on('framenavigated', () => {
    changes.push({ from: left ?? Date.now(), to: Date.now() });
    left = null;
  });
  const complain = (text: string): void => {
    if (CUT_OFF.test(text)) cutOff.push({ text, time: Date.now() });
    else complaints.push(text);
  };
  page.on('console', (message: ConsoleMessage) => {
    const serious = ['error', 'warn', 'assert'].includes(message.type());
    if (serious && !EXPECTED.some((each) => each.test(message.text()))) complain(message.text());
  });
  page.on('pageerror', (error) => complain(error instanceof Error ? String(error.stack ?? error) : String(error)));
  page.on('requestfailed', (request) => {
    const reason = request.failure()?.errorText ?? '';
    if (!GIVEN_UP.includes(reason)) complaints.push(`${request.url()}: ${reason}`);
  });
  const wasLeft = (time: number) => changes.some(({ from, to }) => time > from - LEAVING && time < to + LEAVING);
  return () => [...complaints, ...cutOff.filter(({ time }) => !wasLeft(time)).map(({ text }) => text)];
}

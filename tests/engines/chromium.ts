/** Chromium, by playwright-core. */
import { join } from 'node:path';
import { launch, newVisit } from '../browser/site';
import { STORAGE } from './driver';
import type { Driver, Engine } from './driver';
import { newFolder } from './temporary';

export async function startChromium(): Promise<Engine> {
  const browser = await launch();

  async function newWindow(): Promise<Driver> {
    const { page, complaints } = await newVisit(browser, { serviceWorkers: 'allow' });
    const downloads = newFolder();
    page.on(
      'download',
      (download) => void download.saveAs(join(downloads.path, download.suggestedFilename())).catch(() => {}),
    );
    const session = await page.context().newCDPSession(page);
    return {
      goto: async (url) => {
        // Before the page stores anything: what it may take is looked up twice a minute only. An empty page has no origin.
        const { origin } = new URL(url);
        if (origin !== 'null') await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: STORAGE });
        await page.goto(url);
      },
      reload: async () => void (await page.reload()),
      evaluate: (expression) => page.evaluate(expression),
      movePointer: (x, y) => page.mouse.move(x, y),
      pressButton: () => page.mouse.down(),
      releaseButton: () => page.mouse.up(),
      turnWheel: (dy) => page.mouse.wheel(0, dy),
      pressKey: (key) => page.keyboard.down(key),
      releaseKey: (key) => page.keyboard.up(key),
      resize: (width, height) => page.setViewportSize({ width, height }),
      screenshot: () => page.screenshot(),
      downloads: downloads.path,
      complaints: async () => complaints,
      close: async () => {
        await page.context().close();
        downloads.remove();
      },
    };
  }

  return { name: 'chromium', newWindow, close: () => browser.close() };
}

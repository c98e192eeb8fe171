/** Pages of others that embed the editor: what it says where it cannot start. */
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Answer, News } from '../../web/src/embed/protocol';
import { visits } from './page';

declare global {
  interface Window {
    heard: (Answer | News)[];
  }
}

const { address, open } = visits();

/** Another site. */
const elsewhere = createServer((_, response) => response.writeHead(200, { 'content-type': 'text/html' }).end());
beforeAll(() => new Promise<void>((done) => elsewhere.listen(0, '127.0.0.1', done)));
afterAll(() => {
  elsewhere.closeAllConnections();
  elsewhere.close();
});

const LISTEN = '<script>window.heard = []; addEventListener("message", ({ data }) => heard.push(data));</script>';
const editor = () => `<iframe sandbox="allow-scripts" width="600" height="400" src="${address()}?embed"></iframe>`;

test.each(['its own pages only', 'all'])(
  'without an origin it cannot start, also where the site gives its files to %s; it says so to visitor and host',
  async (whom) => {
    // What the visit would note of hints cannot be noted in a frame without an origin.
    const { page, complaints } = await open(
      `http://127.0.0.1:${(elsewhere.address() as AddressInfo).port}/`,
      {},
      { hints: true },
    );
    // Playwright gives what passes through its hands to all.
    if (whom === 'all')
      await page.route(`${address()}**`, async (route) => route.fulfill({ response: await route.fetch() }));
    await page.setContent(LISTEN + editor());
    const sentence = page.frameLocator('iframe').getByText('chebnet cannot start');
    // Nothing lies over it.
    await sentence.click({ trial: true });
    if (whom === 'all') await page.frameLocator('iframe').getByRole('link', { name: 'Open in chebnet' }).waitFor();
    expect(await page.evaluate(() => window.heard)).toEqual([
      {
        chebnet: 1,
        event: 'error',
        error: { code: 'no_origin', message: expect.stringContaining('allow-same-origin') },
      },
    ]);
    // The browser complains of each file that it does not load.
    await page.goto('about:blank');
    complaints.splice(0);
  },
);

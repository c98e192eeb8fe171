/** Pages of others that embed the editor: whom it listens to, and what it says where it cannot start. */
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Frame } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Answer, News } from '../../web/src/embed/protocol';
import type { Visit } from './page';
import { visits } from './page';

declare global {
  interface Window {
    heard: (Answer | News)[];
  }
}

const LISTEN = '<script>window.heard = []; addEventListener("message", ({ data }) => heard.push(data));</script>';
const { address, open } = visits();

/** Another site: its pages by their names, '' being the one that is visited. */
let pages: Record<string, string> = {};
const elsewhere = createServer(({ url = '/' }, response) => {
  response.writeHead(200, { 'content-type': 'text/html' }).end(LISTEN + pages[url.slice(1)]);
});
beforeAll(() => new Promise<void>((done) => elsewhere.listen(0, '127.0.0.1', done)));
afterAll(() => {
  elsewhere.closeAllConnections();
  elsewhere.close();
});

const placeOf = (name: string) => `http://127.0.0.1:${(elsewhere.address() as AddressInfo).port}/${name}`;
const editor = (attributes = '') => `<iframe ${attributes} src="${address()}?embed"></iframe>`;

function visitHost(html: string, others: Record<string, string> = {}): Promise<Visit> {
  pages = { '': html, ...others };
  // What the visit would note of hints cannot be noted in a frame without an origin.
  return open(placeOf(''), {}, { hints: true });
}

const heardBy = (frame: Frame) => frame.evaluate(() => window.heard);
const isReady = (frame: Frame) => expect.poll(() => heardBy(frame)).toContainEqual({ chebnet: 1, event: 'ready' });
const isAnswered = (frame: Frame, id: string) => expect.poll(() => heardBy(frame)).toContainEqual(expect.objectContaining({ id }));

/** Has the script in `from` ask the editor, which is `path` of its own window. */
function ask(from: Frame, path: 'frames[0]' | 'frames[0].frames[0]' | 'parent.frames[0]', id: string, call: string, ...args: unknown[]) {
  return from.evaluate(`${path}.postMessage(${JSON.stringify({ chebnet: 1, id, call, args })}, '*')`);
}

test('a page of another site gets answers, also when its frame has a sandbox with an origin', async () => {
  for (const sandbox of ['', 'sandbox="allow-scripts allow-same-origin"']) {
    const { page } = await visitHost(editor(sandbox));
    const host = page.mainFrame();
    await isReady(host);
    await ask(host, 'frames[0]', 'mine', 'settled');
    await ask(host, 'frames[0]', 'handles', 'handles');
    await isAnswered(host, 'mine');
    await isAnswered(host, 'handles');
  }
});

test('a frame beside it is not heard', async () => {
  const { page } = await visitHost(editor() + '<iframe src="beside"></iframe>', { beside: '' });
  const host = page.mainFrame();
  const beside = page.frame({ url: placeOf('beside') })!;
  await isReady(host);
  await ask(host, 'frames[0]', 'opened', 'open', { recipe: 'vault:vertices=200' });
  await isAnswered(host, 'opened');
  await ask(beside, 'parent.frames[0]', 'beside', 'setHandles', []);
  await ask(host, 'frames[0]', 'mine', 'handles');
  await isAnswered(host, 'mine');
  const answers = (await heardBy(host)).filter((each) => 'id' in each);
  expect(answers).toEqual([
    { chebnet: 1, id: 'opened', result: undefined },
    { chebnet: 1, id: 'mine', result: expect.arrayContaining([expect.objectContaining({ anchor: true })]) },
  ]);
  expect(await heardBy(beside)).toEqual([]);
});

test('a page that holds its host is not heard', async () => {
  const { page } = await visitHost('<iframe src="host"></iframe>', { host: editor() });
  const [above, host] = [page.mainFrame(), page.frame({ url: placeOf('host') })!];
  await isReady(host);
  await ask(above, 'frames[0].frames[0]', 'above', 'stats');
  await ask(host, 'frames[0]', 'mine', 'stats');
  await isAnswered(host, 'mine');
  expect(await heardBy(above)).toEqual([]);
  expect((await heardBy(host)).filter((each) => 'id' in each && each.id === 'above')).toEqual([]);
});

test.each(['its own pages only', 'all'])('without an origin it cannot start, also where the site gives its files to %s; it says so to visitor and host', async (whom) => {
  const { page, complaints } = await visitHost('');
  // Playwright gives what passes through its hands to all.
  if (whom === 'all') await page.route(`${address()}**`, async (route) => route.fulfill({ response: await route.fetch() }));
  await page.setContent(LISTEN + editor('sandbox="allow-scripts" width="600" height="400"'));
  const sentence = page.frameLocator('iframe').getByText('chebnet cannot start');
  // Nothing lies over it.
  await sentence.click({ trial: true });
  if (whom === 'all') await page.frameLocator('iframe').getByRole('link', { name: 'Open in chebnet' }).waitFor();
  expect(await heardBy(page.mainFrame())).toEqual([
    { chebnet: 1, event: 'error', error: { code: 'no_origin', message: expect.stringContaining('allow-same-origin') } },
  ]);
  // The browser complains of each file that it does not load.
  await page.goto('about:blank');
  complaints.splice(0);
});

/** The page without a network, and how it goes over to another version: whole or not at all. */
import { createHash } from 'node:crypto';
import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { distance, dragBy } from './geometry';
import type { Visit } from './page';
import { DIST, visits } from './page';

let served = DIST;
const folders: string[] = [];
const { arrive } = visits(() => served);

let visit: Visit;
beforeEach(async () => {
  served = DIST;
  visit = await arrive('', { serviceWorkers: 'allow' });
  await visit.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
});
afterEach(() => folders.splice(0).forEach((folder) => rmSync(folder, { recursive: true })));

const scriptOf = (page: Page) => page.evaluate(() => document.querySelector('script[src]')!.getAttribute('src'));
const sha256 = (data: Buffer) => createHash('sha256').update(data).digest('base64');

/** As a later build leaves it: the page's script has another name, and so has the version. */
function anotherVersion(): { folder: string; script: string } {
  const folder = mkdtempSync(join(tmpdir(), 'chebnet-dist-'));
  folders.push(folder);
  cpSync(DIST, folder, { recursive: true });
  const old = readdirSync(join(DIST, 'assets')).find((name) => /^index-.*\.js$/.test(name))!;
  const script = 'index-another.js';
  renameSync(join(folder, 'assets', old), join(folder, 'assets', script));
  const edit = (path: string, change: (text: string) => string) =>
    writeFileSync(join(folder, path), change(readFileSync(join(folder, path), 'utf8')));
  edit('index.html', (html) => html.replace(old, script));
  const [before, after] = [DIST, folder].map((each) => sha256(readFileSync(join(each, 'index.html'))));
  edit('service_worker.js', (text) => text.replace(old, script).replace(before!, after!).replace('"version":"', '"version":"another'));
  return { folder, script: `./assets/${script}` };
}

test('after one visit it opens without a network, and a net can be dragged', async () => {
  const { page, script } = visit;
  await page.context().setOffline(true);
  await page.reload();
  await script.waitForNet();
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const before = await script.position(vertex);
  await dragBy(script, vertex, [-60, -40]);
  await script.settled();
  expect(distance(await script.position(vertex), before)).toBeGreaterThan(0);
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-6);
});

test('whose work it contains can be read without a network', async () => {
  const { page } = visit;
  await page.context().setOffline(true);
  await page.getByText('Learn', { exact: true }).click();
  const opened = page.waitForEvent('popup');
  await page.getByRole('link', { name: /licence/ }).click();
  const text = (await opened).locator('body');
  await text.getByText('Jean-loup Gailly').waitFor();
  expect(await text.innerText()).toContain('© 2010');
});

test('a file that was spoilt where it is kept is fetched anew', async () => {
  const { page, script } = visit;
  const spoilt = await page.evaluate(async () => {
    const [name] = await caches.keys();
    const cache = await caches.open(name!);
    const address = document.querySelector<HTMLScriptElement>('script[type=module]')!.src;
    await cache.put(address, new Response('spoilt', { headers: { 'content-type': 'text/javascript' } }));
    return address;
  });
  await page.reload();
  await script.waitForNet();
  expect(await page.evaluate(async (address) => (await (await caches.match(address))!.text()).length, spoilt)).toBeGreaterThan(1000);
});

test('another version takes over when the visitor wants it', async () => {
  const { page, script } = visit;
  const first = await scriptOf(page);
  const other = anotherVersion();
  served = other.folder;
  await page.reload();
  await script.waitForNet();
  expect(await scriptOf(page)).toBe(first);
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction((src) => document.querySelector('script[src]')?.getAttribute('src') === src, other.script);
  await script.waitForNet();
});

test('an update that was cut off half way does not push out the version of an open page', async () => {
  const { page, script } = visit;
  const kept = () => page.evaluate(() => caches.keys());
  const [first = ''] = await kept();
  const cutOff = first.replace(/[^ ]*$/, 'cut off');
  await page.evaluate(async (name) => (await caches.open(name)).put('assets/some.js', new Response('half')), cutOff);
  const other = anotherVersion();
  served = other.folder;
  await page.reload();
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction((src) => document.querySelector('script[src]')?.getAttribute('src') === src, other.script);
  await script.waitForNet();
  const names = await kept();
  expect(names).toContain(first);
  expect(names).not.toContain(cutOff);
  expect(names).toHaveLength(2);
});

test('a version that is not whole is not taken', async () => {
  const { page, script } = visit;
  const first = await scriptOf(page);
  const other = anotherVersion();
  cpSync(join(DIST, 'index.html'), join(other.folder, 'index.html'));
  served = other.folder;
  const refused = await page.evaluate(async () => {
    const registration = (await navigator.serviceWorker.getRegistration())!;
    await registration.update();
    const worker = registration.installing!;
    while (worker.state === 'installing') await new Promise((done) => worker.addEventListener('statechange', done, { once: true }));
    return worker.state;
  });
  expect(refused).toBe('redundant');
  await page.reload();
  await script.waitForNet();
  expect(await scriptOf(page)).toBe(first);
});

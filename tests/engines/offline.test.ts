/** What the browser keeps of the page, and how the page goes over to another version, in each engine: whole or not at all. */
import { createHash } from 'node:crypto';
import { cpSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { DIST } from '../browser/site';
import { newFolder } from './temporary';
import type { Visitor } from './visitor';
import { PATIENCE, visitors } from './visitor';

let served = DIST;
const folders: ReturnType<typeof newFolder>[] = [];
const { arrive } = visitors(() => served);

let visitor: Visitor;
beforeEach(async () => {
  served = DIST;
  visitor = await arrive();
  await vi.waitUntil(() => visitor.run(() => navigator.serviceWorker.controller !== null), PATIENCE);
});
afterEach(() => folders.splice(0).forEach((folder) => folder.remove()));

const script = () => visitor.run(() => document.querySelector('script[src]')?.getAttribute('src'));
const isOffered = () =>
  visitor.run(() => [...document.querySelectorAll('button')].some(({ textContent }) => textContent === 'Reload'));
const kept = () => visitor.run(() => caches.keys());
const sha256 = (data: Buffer) => createHash('sha256').update(data).digest('base64');

/** As a later build leaves it: the page's script has another name, and so has the version. */
function anotherVersion(): { folder: string; script: string } {
  const { path: folder } = folders[folders.push(newFolder()) - 1]!;
  cpSync(DIST, folder, { recursive: true });
  const old = readdirSync(join(DIST, 'assets')).find((name) => /^index-.*\.js$/.test(name))!;
  const another = 'index-another.js';
  renameSync(join(folder, 'assets', old), join(folder, 'assets', another));
  const edit = (path: string, change: (text: string) => string) =>
    writeFileSync(join(folder, path), change(readFileSync(join(folder, path), 'utf8')));
  edit('index.html', (html) => html.replace(old, another));
  const [before, after] = [DIST, folder].map((each) => sha256(readFileSync(join(each, 'index.html'))));
  edit('service_worker.js', (text) =>
    text.replace(old, another).replace(before!, after!).replace('"version":"', '"version":"another'),
  );
  return { folder, script: `./assets/${another}` };
}

/** The visitor does as the page says about a version that came. */
async function goOver(to: { script: string }): Promise<void> {
  await visitor.driver.reload();
  await acceptOffer(to);
  await visitor.waitForNet();
}

async function acceptOffer(to: { script: string }): Promise<void> {
  // Again where another message pushed the button aside meanwhile: once it is hit, it goes.
  do await visitor.clickOn('Reload');
  while (await isOffered().catch(() => false));
  await vi.waitUntil(async () => (await script().catch(() => undefined)) === to.script, PATIENCE);
}

test('what the page had before it could be kept is kept, too', async () => {
  const { path: folder } = folders[folders.push(newFolder()) - 1]!;
  cpSync(DIST, folder, { recursive: true });
  const worker = join(folder, 'service_worker.js');
  writeFileSync(worker, '// keeps nothing');
  served = folder;
  const early = await arrive();
  const large = readdirSync(join(DIST, 'assets')).find((name) => /^rhino3dm.*\.wasm$/.test(name))!;
  await early.run(async (name) => void (await (await fetch(`assets/${name}`)).arrayBuffer()), large);
  expect(await early.run(() => navigator.serviceWorker.controller === null)).toBe(true);

  cpSync(join(DIST, 'service_worker.js'), worker);
  await early.run(async () => void (await (await navigator.serviceWorker.ready).update()));
  const isKept = () =>
    early.run(async (name) => (await caches.match(new URL(`assets/${name}`, location.href))) !== undefined, large);
  await vi.waitUntil(isKept, PATIENCE);
});

test('a file that was spoilt where it is kept is fetched anew', async () => {
  const spoilt = await visitor.run(async () => {
    const [name] = await caches.keys();
    const cache = await caches.open(name!);
    const address = document.querySelector<HTMLScriptElement>('script[type=module]')!.src;
    await cache.put(address, new Response('spoilt', { headers: { 'content-type': 'text/javascript' } }));
    return address;
  });
  await visitor.driver.reload();
  await visitor.waitForNet();
  const size = await visitor.run(async (address) => (await (await caches.match(address))!.text()).length, spoilt);
  expect(size).toBeGreaterThan(1000);
});

test('another version takes over when the visitor wants it', async () => {
  const first = await script();
  const other = anotherVersion();
  served = other.folder;
  await visitor.driver.reload();
  await visitor.waitForNet();
  expect(await script()).toBe(first);
  await goOver(other);
});

test('a window goes over to a version that another window has taken already', async () => {
  const other = anotherVersion();
  served = other.folder;
  await visitor.driver.reload();
  await vi.waitUntil(isOffered, PATIENCE);
  // What a worker is handing over when it is replaced is cut off.
  await visitor.waitForSections();
  await visitor.run(async () => {
    const { waiting } = (await navigator.serviceWorker.getRegistration())!;
    waiting!.postMessage('activate');
    while (waiting!.state !== 'activated')
      await new Promise((done) => waiting!.addEventListener('statechange', done, { once: true }));
  });
  await acceptOffer(other);
});

test('an update that was cut off half way does not push out the version of an open page', async () => {
  const [first = ''] = await kept();
  const cutOff = first.replace(/[^ ]*$/, 'cut off');
  await visitor.run(async (name) => (await caches.open(name)).put('assets/some.js', new Response('half')), cutOff);
  const other = anotherVersion();
  served = other.folder;
  await goOver(other);
  const names = await kept();
  expect(names).toContain(first);
  expect(names).not.toContain(cutOff);
  expect(names).toHaveLength(2);
});

test('a version that is not whole is not taken', async () => {
  const first = await script();
  const other = anotherVersion();
  cpSync(join(DIST, 'index.html'), join(other.folder, 'index.html'));
  served = other.folder;
  const refused = await visitor.run(async () => {
    const registration = (await navigator.serviceWorker.getRegistration())!;
    await registration.update();
    const worker = registration.installing!;
    while (worker.state === 'installing')
      await new Promise((done) => worker.addEventListener('statechange', done, { once: true }));
    return worker.state;
  });
  expect(refused).toBe('redundant');
  await visitor.driver.reload();
  await visitor.waitForNet();
  expect(await script()).toBe(first);
});

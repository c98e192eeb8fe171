/** Misfortunes, in each engine: nothing is lost, and what happened is said. */
import { availableParallelism, loadavg } from 'node:os';
import { afterAll, beforeEach, expect, test, vi } from 'vitest';
import { distance, largestError } from '../browser/geometry';
import { hashWithZeros } from '../web/hash_with_zeros';
import { ENGINE } from './engines';
import { preparedBy } from './prepared';
import { PATIENCE, visitors } from './visitor';
import type { Visitor } from './visitor';

const SHAPE = 'vault:vertices=600';

declare global {
  interface Window {
    /** Of the page, the oldest first: the solver. */
    workers: Worker[];
    graphics: WEBGL_lose_context;
    /** Of anything into any database, whether it failed or not. */
    writes: number;
    /** Nothing more can be written. */
    full: boolean;
    /** A duplicate of this tab. */
    twin: Window;
  }
}

/** It keeps nothing for the page. */
const forgetful = preparedBy(() => {
  const refuse = () => {
    throw new DOMException('The operation is insecure.', 'SecurityError');
  };
  for (const name of ['localStorage', 'sessionStorage']) Object.defineProperty(window, name, { get: refuse });
  IDBFactory.prototype.open = refuse;
  ServiceWorkerContainer.prototype.register = refuse;
});
const folder = preparedBy(() => {
  window.workers = [];
  window.Worker = class extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      window.workers.push(this);
    }
  };
  window.writes = 0;
  const { put } = IDBObjectStore.prototype;
  IDBObjectStore.prototype.put = function (...given) {
    window.writes += 1;
    if (window.full) throw new DOMException('full', 'QuotaExceededError');
    return put.apply(this, given);
  };
});
afterAll(() => {
  forgetful.remove();
  folder.remove();
});

let served = folder.path;
beforeEach(() => void (served = folder.path));
const { arrive } = visitors(() => served);

async function openShape(visitor: Visitor, recipe = SHAPE): Promise<number> {
  await visitor.openNet({ recipe });
  return (await visitor.handles()).at(-1)!;
}

const placeOf = async (visitor: Visitor, vertex: number) =>
  (await visitor.positions()).subarray(3 * vertex, 3 * vertex + 3);

/** Runs in the page: the states that the browser keeps of this tab, or of its duplicate. */
async function countKept(ofTwin = false): Promise<number> {
  const done = <T>(request: IDBRequest<T>) =>
    new Promise<T>((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  const tab = (ofTwin ? window.twin : window).sessionStorage.getItem('chebnet.tab');
  if (tab === null) return 0;
  const database = await done(indexedDB.open('chebnet'));
  const { states } = (await done(database.transaction('projects').objectStore('projects').get(tab))) as {
    states: unknown[];
  };
  database.close();
  return states.length;
}

/** Ten times what the slowest engine takes, and a thirtieth of the silence at which the page gives a solver up, ms. */
const LONGEST_LOSS = 2000;

/** So many programs take turns at a processor. */
const crowd = () => Math.max(1, loadavg()[0]! / availableParallelism());

/** Runs in the page: ends the solver, and gives the ms until it is said that the net is back. */
async function endSolver(): Promise<number> {
  const alerts = [...document.querySelectorAll('[role=alert]')];
  const isSaid = () => alerts.some(({ textContent }) => /started again.*browser ended it/.test(textContent));
  const start = performance.now();
  window.workers[0]!.terminate();
  while (!isSaid() && performance.now() - start < 60_000) await new Promise((done) => setTimeout(done, 5));
  return performance.now() - start;
}

test('the browser ends the solver in the middle of a drag: it is said in no time, the drag goes on, and the net follows', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  const before = await placeOf(visitor, vertex);
  await visitor.drag(vertex, [-60, -40], async () => {
    expect(await visitor.run(endSolver)).toBeLessThan(LONGEST_LOSS * crowd());
  });
  const target = (await visitor.run(() => window.chebnet.handles().at(-1)!)).target;
  expect(distance(target, before)).toBeGreaterThan(0.1);
  expect(distance(await placeOf(visitor, vertex), target)).toBeLessThan(1e-9);
  expect(await visitor.stats()).toMatchObject({ status: 'converged' });
  await visitor.press('Control+z');
  await expect.poll(async () => distance(await placeOf(visitor, vertex), before)).toBeLessThan(1e-6);
});

/** Runs in the page. */
function restoreGraphics(): void {
  if (document.querySelector('canvas')!.getContext('webgl2')!.isContextLost()) window.graphics.restoreContext();
}

test('the picture that the graphics card drops comes back; meanwhile there is a way out', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  // As PNG; without the net it is a small part of this. WebKit does not draw the same to the last bit.
  const sizeOfPicture = async () => (await visitor.driver.screenshot()).length;
  // They would change it.
  await visitor.run(() => void (document.getElementById('panels')!.style.visibility = 'hidden'));
  await visitor.placeInSight(vertex);
  const before = await sizeOfPicture();
  await visitor.run(() => {
    window.graphics = document.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    window.graphics.loseContext();
  });
  await visitor.read(/dropped the picture[\s\S]*Reload/, '[role=alert]');
  await expect.poll(sizeOfPicture).toBeLessThan(before / 2);
  await expect
    .poll(async () => {
      // Engines refuse while they are still busy with the loss.
      await visitor.run(restoreGraphics);
      return sizeOfPicture();
    })
    .toBeGreaterThan(0.9 * before);
  await visitor.drag(vertex, [-60, -40]);
  expect(await visitor.stats()).toMatchObject({ status: 'converged' });
});

test('text that is selected all over the page does not go away with the pointer in place of the handle', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  const before = await visitor.positions();
  await visitor.run(() => getSelection()!.selectAllChildren(document.body));
  await visitor.drag(vertex, [-60, -40]);
  expect(largestError(await visitor.positions(), before)).toBeGreaterThan(0.01);
});

test('a reload in the middle of a drag brings back the net of before it', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  await visitor.drag(vertex, [-60, -40]);
  const before = await visitor.positions();
  await expect.poll(() => visitor.run(countKept)).toBe(3);
  const { x, y } = await visitor.placeInSight(vertex);
  await visitor.driver.movePointer(x, y);
  await visitor.driver.pressButton();
  await visitor.driver.movePointer(x + 60, y + 20);
  await expect.poll(async () => largestError(await visitor.positions(), before)).toBeGreaterThan(0.01);
  await visitor.driver.reload();
  await visitor.driver.releaseButton();
  await visitor.waitForNet();
  await visitor.read('as you left it');
  expect(largestError(await visitor.positions(), before)).toBe(0);
  await visitor.drag(vertex, [30, 30]);
  expect(largestError(await visitor.positions(), before)).toBeGreaterThan(0.01);
});

test('back and forward go from link to link, however fast; undo leads back to what was done between', async () => {
  const visitor = await arrive();
  const links: string[] = [];
  const vertices: number[] = [];
  for (const size of [200, 400, 600]) {
    await visitor.openNet({ recipe: `vault:vertices=${size}` });
    links.push(await visitor.run(async () => new URL(await window.chebnet.link()).hash));
    vertices.push((await visitor.stats()).vertices);
  }
  const present = () => visitor.stats().then((stats) => stats.vertices);
  for (const link of links) {
    await visitor.run((hash) => void (location.hash = hash), link);
    await visitor.read('The link is open');
  }
  await visitor.openNet({ recipe: 'vault:vertices=300' });
  const own = await present();

  const go = (...steps: number[]) =>
    visitor.run(async (all) => {
      for (const step of all) {
        const arrived = new Promise((done) => addEventListener('hashchange', done, { once: true }));
        history.go(step);
        await arrived;
      }
    }, steps);
  await go(-1);
  await expect.poll(present).toBe(vertices[1]);
  await visitor.press('Control+z');
  await expect.poll(present).toBe(own);
  await go(-1, 1, 1, -1, -1);
  await visitor.settled();
  await expect.poll(present).toBe(vertices[0]);
  await go(1, 1);
  await expect.poll(present).toBe(vertices[2]);
});

test('a duplicate of a tab keeps a net of its own', async () => {
  const visitor = await arrive();
  await openShape(visitor);
  const before = await visitor.positions();
  await expect.poll(() => visitor.run(countKept)).toBe(2);

  // As a browser makes it: with a copy of what the tab has stored.
  await visitor.run(() => addEventListener('click', () => (window.twin = window.open(location.href)!), { once: true }));
  await visitor.clickOn('Learn');
  await waitForTwin(visitor);
  expect(await positionsOfTwin(visitor)).toEqual(before);
  await visitor.run(() =>
    window.twin.chebnet.open({ recipe: 'dome:vertices=600' }).then(() => window.twin.chebnet.settled()),
  );
  const other = await positionsOfTwin(visitor);
  await expect.poll(() => visitor.run(countKept, true)).toBe(3);

  await visitor.run(async () => {
    const before = window.twin.document;
    window.twin.location.reload();
    while (window.twin.document === before) await new Promise((done) => setTimeout(done, 10));
  });
  await waitForTwin(visitor);
  expect(await positionsOfTwin(visitor)).toEqual(other);
  await visitor.driver.reload();
  await visitor.waitForNet();
  expect(await visitor.positions()).toEqual(before);
});

async function waitForTwin(visitor: Visitor): Promise<void> {
  const hasNet = () => visitor.run(() => window.twin.chebnet?.stats().vertices > 0);
  await vi.waitUntil(hasNet, PATIENCE);
  await visitor.run(() => window.twin.chebnet.settled());
}

async function positionsOfTwin(visitor: Visitor): Promise<Float64Array> {
  return Float64Array.from(await visitor.run(() => Array.from(window.twin.chebnet.positions())));
}

test('storage that is full: it is said once, what is kept stays, the net can be dragged and saved; with room again it is kept', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor, 'vault:vertices=3000');
  await expect.poll(() => visitor.run(countKept)).toBe(2);
  await visitor.run(ENGINE === 'webkit' ? () => void (window.full = true) : fillStorage);

  await visitor.drag(vertex, [-60, -40]);
  await visitor.read('does not let the page keep');
  await visitor.clickOn('Dismiss');
  const writes = await visitor.run(() => window.writes);
  await visitor.drag(vertex, [30, 30]);
  await expect.poll(() => visitor.run(() => window.writes)).toBeGreaterThan(writes);
  await visitor.drag(vertex, [-30, 30]);
  expect(await visitor.read('')).not.toContain('does not let the page keep');
  expect(await visitor.run(countKept)).toBe(2);
  const { bytes } = await visitor.saved(() => visitor.press('Control+s'));
  expect(JSON.parse(new TextDecoder().decode(bytes)).states).toHaveLength(5);

  await visitor.run(ENGINE === 'webkit' ? () => void (window.full = false) : emptyStorage);
  await visitor.drag(vertex, [30, -30]);
  const before = await visitor.positions();
  await expect.poll(() => visitor.run(countKept)).toBe(6);
  await visitor.driver.reload();
  await visitor.waitForNet();
  expect(await visitor.positions()).toEqual(before);
});

/** Runs in the page: leaves less room than the smallest net takes. */
async function fillStorage(): Promise<void> {
  const opening = indexedDB.open('filling');
  opening.onupgradeneeded = () => opening.result.createObjectStore('filling', { autoIncrement: true });
  await new Promise((done) => (opening.onsuccess = done));
  const database = opening.result;
  const isStored = (size: number): Promise<boolean> =>
    new Promise((done) => {
      const writing = database.transaction('filling', 'readwrite');
      // What is all alike would be stored as little.
      const parts = Array.from({ length: size / 1000 }, () => crypto.getRandomValues(new Uint8Array(1000)));
      writing.objectStore('filling').put(parts);
      writing.oncomplete = () => done(true);
      writing.onabort = () => done(false);
    });
  // Firefox refuses the first write after one that was too large, whatever its size.
  for (let size = 4e6; size >= 1000; size /= 2)
    for (let i = 0; i < 2; ++i) while (await isStored(size).catch(() => false));
  database.close();
}

/** Runs in the page. */
async function emptyStorage(): Promise<void> {
  const deleting = indexedDB.deleteDatabase('filling');
  await new Promise((done) => (deleting.onsuccess = done));
}

test('a browser that keeps nothing: it is said, the net can be saved, and another language takes it along', async () => {
  served = forgetful.path;
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  await visitor.drag(vertex, [-60, -40]);
  const before = await visitor.positions();
  await visitor.read('does not let the page keep');
  const { name } = await visitor.saved(() => visitor.clickOn('Save project'));
  expect(name).toBe('vault.chebnet.json');
  await visitor.clickOn('中文');
  await expect.poll(() => visitor.run(() => document.documentElement.lang).catch(() => '')).toBe('zh-CN');
  await visitor.waitForNet();
  expect(largestError(await visitor.positions(), before)).toBeLessThan(1e-3);
  await visitor.drag(vertex, [30, 30]);
  expect(largestError(await visitor.positions(), before)).toBeGreaterThan(0.01);
});

/** Runs in the page. */
function dropHugeFile(name: string): void {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(Array<Uint8Array<ArrayBuffer>>(300).fill(new Uint8Array(1e6)), name));
  document
    .getElementById('view')!
    .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
}

test('an archive and a drawing with the name of a mesh, and a file of 300 MB, are refused in one sentence, and the net stays', async () => {
  const visitor = await arrive();
  const before = await visitor.positions();
  await visitor.dropFile('net.obj', 'PK\x03\x04\x14\0\0\0');
  await visitor.read('net.obj: this is a ZIP archive', '[role=alert]');
  await visitor.dropFile('drawing.obj', '<svg xmlns="http://www.w3.org/2000/svg"/>');
  await visitor.read('drawing.obj: this is an SVG drawing', '[role=alert]');
  await visitor.run(dropHugeFile, 'scan.obj');
  await visitor.read('scan.obj has 300 MB', '[role=alert]');
  expect(await visitor.run(() => document.querySelector('dialog') === null)).toBe(true);
  expect(largestError(await visitor.positions(), before)).toBe(0);
});

/** Firefox takes no address that is long enough for a gigabyte, and seconds for one of a megabyte. */
const INFLATED = 2e8;

test('a link that would inflate to 200 MB is refused, and shows the first net, which can be dragged', async () => {
  const visitor = await arrive(hashWithZeros({}, INFLATED));
  await visitor.read(/link/i, '[role=alert]');
  const vertex = (await visitor.handles()).at(-1)!;
  const before = await placeOf(visitor, vertex);
  await visitor.drag(vertex, [-60, -40]);
  expect(distance(await placeOf(visitor, vertex), before)).toBeGreaterThan(0.01);
});

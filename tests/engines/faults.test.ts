/** Misfortunes, in each engine: nothing is lost, and what happened is said. */
import { availableParallelism, loadavg } from 'node:os';
import { afterAll, beforeEach, expect, test } from 'vitest';
import { distance, largestError } from '../browser/geometry';
import { preparedBy } from './prepared';
import { visitors } from './visitor';
import type { Visitor } from './visitor';

const SHAPE = 'vault:vertices=600';

declare global {
  interface Window {
    /** Of the page, the oldest first. */
    workers: Worker[];
    graphics: WEBGL_lose_context;
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
});
afterAll(() => {
  forgetful.remove();
  folder.remove();
});

let served = folder.path;
beforeEach(() => void (served = folder.path));
const { arrive } = visitors(() => served);

async function openShape(visitor: Visitor): Promise<number> {
  await visitor.openNet({ recipe: SHAPE });
  return (await visitor.handles()).at(-1)!;
}

const placeOf = async (visitor: Visitor, vertex: number) => (await visitor.positions()).subarray(3 * vertex, 3 * vertex + 3);

/** Runs in the page: the states that the browser keeps of this tab. */
async function countKept(): Promise<number> {
  const done = <T>(request: IDBRequest<T>) =>
    new Promise<T>((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  const tab = sessionStorage.getItem('chebnet.tab');
  if (tab === null) return 0;
  const database = await done(indexedDB.open('chebnet'));
  const { states } = (await done(database.transaction('projects').objectStore('projects').get(tab))) as { states: unknown[] };
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
  window.workers.at(-1)!.terminate();
  while (!isSaid()) await new Promise((done) => setTimeout(done, 5));
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

test('the picture that the graphics card drops comes back; meanwhile there is a way out', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  // As PNG; without the net it is a small part of this. WebKit does not draw the same to the last bit.
  const sizeOfPicture = async () => (await visitor.driver.screenshot()).length;
  // They would change it.
  await visitor.run(() => void (document.getElementById('panels')!.style.visibility = 'hidden'));
  const before = await sizeOfPicture();
  await visitor.run(() => {
    window.graphics = document.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    window.graphics.loseContext();
  });
  await visitor.read(/dropped the picture[^]*Reload/, '[role=alert]');
  await expect.poll(sizeOfPicture).toBeLessThan(before / 2);
  await visitor.run(() => window.graphics.restoreContext());
  await expect.poll(sizeOfPicture).toBeGreaterThan(0.9 * before);
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

/** Misfortunes, in each engine: nothing is lost, and what happened is said. */
import { afterAll, expect, test } from 'vitest';
import { distance } from '../browser/geometry';
import { preparedBy } from './prepared';
import { visitors } from './visitor';
import type { Visitor } from './visitor';

const SHAPE = 'vault:vertices=600';

declare global {
  interface Window {
    /** Of the page, the oldest first. */
    workers: Worker[];
  }
}

const folder = preparedBy(() => {
  window.workers = [];
  window.Worker = class extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      window.workers.push(this);
    }
  };
});
afterAll(() => folder.remove());

const { arrive } = visitors(() => folder.path);

async function openShape(visitor: Visitor): Promise<number> {
  await visitor.openNet({ recipe: SHAPE });
  return (await visitor.handles()).at(-1)!;
}

const placeOf = async (visitor: Visitor, vertex: number) => (await visitor.positions()).subarray(3 * vertex, 3 * vertex + 3);

test('the browser ends the solver in the middle of a drag: it is said, the drag goes on, and the net follows', async () => {
  const visitor = await arrive();
  const vertex = await openShape(visitor);
  const before = await placeOf(visitor, vertex);
  await visitor.drag(vertex, [-60, -40], async () => {
    await visitor.run(() => window.workers.at(-1)!.terminate());
    await visitor.read(/started again.*browser ended it/, '[role=alert]');
  });
  const target = (await visitor.run(() => window.chebnet.handles().at(-1)!)).target;
  expect(distance(target, before)).toBeGreaterThan(0.1);
  expect(distance(await placeOf(visitor, vertex), target)).toBeLessThan(1e-9);
  expect(await visitor.stats()).toMatchObject({ status: 'converged' });
  await visitor.press('Control+z');
  await expect.poll(async () => distance(await placeOf(visitor, vertex), before)).toBeLessThan(1e-6);
});

/** The page by a link, inside of another page, and without its server, in each engine. */
import { expect, test, vi } from 'vitest';
import { distance } from '../browser/geometry';
import type { Visitor } from './visitor';
import { PATIENCE, visitors } from './visitor';

const { arrive, open, address: site, closeSite } = visitors();

test('a link opens an experiment, which goes on by one step', async () => {
  const visitor = await arrive('#experiment=long-edges');
  await visitor.read(/Figure 8: Composite majorization/);
  expect(await visitor.stats()).toMatchObject({ method: 'composite_majorization', iterations: 0 });
  await visitor.clickOn('One step');
  await expect.poll(async () => (await visitor.stats()).iterations).toBe(1);
});

test('inside of a lesson, a click wakes the editor and a drag moves its net', async () => {
  const visitor = await open('lesson.html');
  await visitor.read(/The largest dL of its/);
  await expect.poll(() => placeOfCrown(visitor)).not.toBeNull();
  const before = (await placeOfCrown(visitor))!;
  await visitor.click(before.x, before.y + 60);
  await vi.waitUntil(() => visitor.run(() => document.activeElement?.tagName === 'IFRAME'), PATIENCE);
  const { x, y, vertex } = (await placeOfCrown(visitor))!;
  const { driver } = visitor;
  await driver.movePointer(x, y);
  await driver.pressButton();
  for (let i = 1; i <= 5; ++i) await driver.movePointer(x + 6 * i, y + 6 * i);
  await driver.releaseButton();
  await expect.poll(async () => distance((await placeOfCrown(visitor))!.target, before.target)).toBeGreaterThan(0.1);
  expect((await placeOfCrown(visitor))!.vertex).toBe(vertex);
  await visitor.picture('lesson');

  await visitor.clickOn('Push the crown down');
  await visitor.read(/is (\d\.\de-\d+|below 1e-12), after [1-9]/);
});

/** The handle to drag of the frame, and where it is seen in the window; null: it is not there yet. */
function placeOfCrown(visitor: Visitor) {
  return visitor.run(() => {
    const frame = document.querySelector('iframe')!;
    const { chebnet } = frame.contentWindow as unknown as Window;
    const handle = chebnet?.handles().at(-1);
    if (handle === undefined) return null;
    const { vertex, target } = handle;
    const { left, top } = frame.getBoundingClientRect();
    const { x, y } = chebnet.screenPosition(vertex);
    return { vertex, target, x: left + x, y: top + y };
  });
}

test('after one visit the page opens without its server, a net can be dragged, and it can be read whose work it contains', async () => {
  const visitor = await arrive();
  await vi.waitUntil(() => visitor.run(() => navigator.serviceWorker.controller !== null), PATIENCE);
  // The page is left first: what it was still loading would be refused, and be no fault of the visit to come.
  await visitor.driver.goto('about:blank');
  closeSite();
  await visitor.driver.goto(site());
  await visitor.waitForNet();
  const vertex = (await visitor.handles()).at(-1)!;
  const place = async () => (await visitor.positions()).subarray(3 * vertex, 3 * vertex + 3);
  const before = await place();
  await visitor.drag(vertex, [-60, -40]);
  expect(distance(await place(), before)).toBeGreaterThan(0);
  expect((await visitor.stats()).maxDeviation).toBeLessThan(1e-6);
  // Another method comes with the whole core, which the visit before did not call for.
  await visitor.run(() => window.chebnet.setOptions({ method: 'li2022' }));

  await visitor.clickOn('Learn');
  const address = () => visitor.run(() => document.querySelector<HTMLAnchorElement>('a[href$="licences.txt"]')?.href);
  const licences = await visitor.run(
    async (link) => (await fetch(link)).text(),
    (await vi.waitUntil(address, PATIENCE))!,
  );
  expect(licences).toContain('Jean-loup Gailly');
  expect(licences).toContain('© 2010');
});

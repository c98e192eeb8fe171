/** Drags that keys keep to an axis or a plane, with a mouse and keys. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { load } from '../wasm/load';
import type { Script, Visit } from './page';
import { OUTPUT, visits } from './page';

const SHAPE = 'vault:vertices=500';
const net = (await load()).openRecipe(SHAPE);
const crown = net.suggestedHandles.at(-1)!;
const edge = net.info.meanLength;

const { share } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
});

type Point = [number, number, number];
const handles = () => visit.page.evaluate(() => window.chebnet.handles());
const target = async (vertex = crown) => (await handles()).find((each) => each.vertex === vertex)!.target;
const press = (keys: string) => visit.page.keyboard.press(keys);
const readout = () => visit.page.locator('svg.overlay .readout:not([hidden])').textContent();
const picture = (name: string) => visit.page.screenshot({ path: join(OUTPUT, `axes-${name}.png`) });
/** Of which coordinates two points differ. */
const moved = (a: Point, b: Point) => ['x', 'y', 'z'].filter((_, i) => a[i] !== b[i]).join('');

/** By a key for another view. */
async function look(key: string) {
  const place = () => script.screenPosition(net.suggestedHandles[0]!);
  const before = await place();
  await press(key);
  await expect.poll(place).not.toEqual(before);
}

/** Takes hold of a handle; returns what moves it on, from where it was taken. */
async function take(vertex = crown) {
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.mouse.move(x, y);
  await visit.page.mouse.down();
  return async (dx: number, dy: number) => {
    await visit.page.mouse.move(x + dx, y + dy, { steps: 4 });
  };
}

test('X keeps a drag to an axis, Shift and Z to the plane, once more frees it; it is one step to undo', async () => {
  const from = await target();
  const to = await take();
  await to(-20, -12);
  await expect.poll(async () => moved(await target(), from)).toBe('xyz');
  await press('x');
  await expect.poll(async () => moved(await target(), from)).toBe('x');
  expect(await readout()).toMatch(/^Along x · x /);
  await to(-45, -12);
  await picture('x');
  const along = await target();
  await press('Shift+Z');
  await expect.poll(async () => moved(await target(), from)).toBe('xy');
  expect(await readout()).toMatch(/^In the plane xy · x /);
  await picture('plane');
  await press('z');
  await expect.poll(async () => moved(await target(), from)).toBe('z');
  await press('y');
  await expect.poll(async () => moved(await target(), from)).toBe('y');
  await press('y');
  await expect.poll(async () => moved(await target(), from)).toBe('xyz');
  await expect.poll(() => visit.page.locator('svg.overlay .readout:not([hidden])').count()).toBe(0);
  await press('x');
  await expect.poll(async () => moved(await target(), from)).toBe('x');
  expect((await target())[0]).toBeCloseTo(along[0], 9);
  await visit.page.mouse.up();
  await script.settled();
  const left = await target();
  expect(moved(left, from)).toBe('x');

  // The next drag is free, and Escape gives it up.
  const again = await take();
  await again(-20, -20);
  await press('z');
  await expect.poll(async () => moved(await target(), left)).toBe('z');
  await press('Escape');
  await expect.poll(target).toEqual(left);
  await visit.page.mouse.up();
  await press('Control+z');
  await expect.poll(target).toEqual(from);
});

test('a hand beyond reach leaves its axis or plane neither as it pulls nor when it lets go; no focus is shown meanwhile', async () => {
  const from = await target();
  const to = await take();
  await to(-20, -12);
  await press('x');
  const outline = () =>
    visit.page.evaluate(() => getComputedStyle(document.querySelector('#view canvas')!).outlineStyle);
  expect(await outline()).toBe('none');
  await to(-700, -300);
  const heldBack = () =>
    visit.page.getByText('As far as the net goes: every edge keeps its length').first().isVisible();
  await expect.poll(heldBack).toBe(true);
  await script.settled();
  await picture('held-x');
  const stands = await script.position(crown);
  expect(moved(stands, from)).toBe('x');
  expect(Math.abs(stands[0] - from[0])).toBeGreaterThan(edge);
  await press('Shift+Y');
  await script.settled();
  await expect.poll(async () => moved(await script.position(crown), from)).toBe('xz');
  await visit.page.mouse.up();
  await script.settled();
  expect(await target()).toEqual(await script.position(crown));
  expect(moved(await target(), from)).toBe('xz');
  expect((await visit.page.evaluate(() => window.chebnet.stats())).maxDeviation).toBeLessThan(1e-6);
});

test('a patch keeps to it as one, within reach and on the grid, in parallel projection', async () => {
  await press('5');
  const { x, y } = await script.screenPosition(crown);
  await visit.page.mouse.click(x, y);
  await press('p');
  await expect.poll(async () => (await handles()).length).toBeGreaterThan(20);
  await script.settled();
  const patch = (await handles()).filter(({ name }) => name !== undefined);
  const moves = async () => {
    const now = new Map((await handles()).map((each) => [each.vertex, each.target]));
    return patch.map(({ vertex, target: [a, b, c] }) => {
      const [u, v, w] = now.get(vertex)!;
      return [u - a, v - b, w - c];
    });
  };
  const up = await take();
  await up(-8, -8);
  await press('z');
  // Far beyond what the net can follow.
  await up(-8, -300);
  await expect.poll(async () => (await moves())[0]![2]).toBeGreaterThan(0.01 * edge);
  await picture('reach');
  await visit.page.mouse.up();
  await script.settled();
  for (const [dx, dy] of await moves()) expect([dx, dy]).toEqual([0, 0]);
  expect((await visit.page.evaluate(() => window.chebnet.stats())).maxDeviation).toBeLessThan(1e-6);

  await visit.page.locator('summary', { hasText: /^Dragging/ }).click();
  await visit.page.getByRole('checkbox', { name: 'Snap to a grid' }).check();
  const before = await target();
  const down = await take();
  await down(4, 20);
  await press('z');
  await down(4, 60);
  await expect.poll(async () => moved(await target(), before)).toBe('z');
  const [, , z] = await target();
  expect(Math.abs(z / edge - Math.round(z / edge))).toBeLessThan(1e-9);
  expect(await readout()).toMatch(/^Along z · /);
  await picture('grid');
  await visit.page.mouse.up();
});

test.each(['perspective', 'parallel'])(
  'seen along the axis, in %s, a drag goes no farther than the pointer',
  async (view) => {
    if (view === 'parallel') await look('5');
    await look('7');
    const from = await target();
    const unit = await visit.page.evaluate(
      async ([a, b]) => {
        const [p, q] = [window.chebnet.screenPosition(a!), window.chebnet.screenPosition(b!)];
        return Math.hypot(p.x - q.x, p.y - q.y);
      },
      [crown, crown + 1],
    );
    const to = await take();
    await to(0, 10);
    await press('z');
    await to(3, 30);
    await expect.poll(async () => moved(await target(), from)).toBe('z');
    const [, , z] = await target();
    expect(z).toBeLessThan(from[2]);
    expect(from[2] - z).toBeLessThan((3 * 30 * edge) / unit);
    await picture(`top-${view}`);
    await visit.page.mouse.up();
  },
);

/** Shaping with handles on the page: several at once, by hand and by numbers, with locks, names, symmetry; with a mouse, keys
 *  and a finger. */
import { join } from 'node:path';
import { beforeEach, describe, expect, test } from 'vitest';
import { centreOf } from '../../web/src/handles/transform';
import { load } from '../wasm/load';
import { distance, dragBy, vertexAt } from './geometry';
import type { Script, Visit } from './page';
import { OUTPUT, visits } from './page';

const SHAPE = 'vault:vertices=500';

type Vec3 = [number, number, number];
const core = await load();
const net = core.openRecipe(SHAPE);
const { meanLength } = net.info;
const dragged = net.suggestedHandles.at(-1)!;
const corner = net.suggestedHandles[0]!;

const { arrive, share } = visits();
let visit: Visit;
let script: Script;

async function open(options = {}) {
  visit = await share(options);
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
}

const handles = () => visit.page.evaluate(() => window.chebnet.handles());
const targetOf = async (vertex: number) => (await handles()).find((handle) => handle.vertex === vertex)!.target;
const press = (keys: string) => visit.page.keyboard.press(keys);
const button = (name: string | RegExp) => visit.page.getByRole('button', { name, exact: true });

function rest(vertex: number): Vec3 {
  const [x = NaN, y = NaN, z = NaN] = net.restPositions.subarray(3 * vertex, 3 * vertex + 3);
  return [x, y, z];
}

function extent(axis: number): [number, number] {
  const values = net.restPositions.filter((_, i) => i % 3 === axis);
  return [Math.min(...values), Math.max(...values)];
}

/** The vertex at these parts of the net's extent. */
const at = (u: number, v: number) => vertexAt(net.restPositions, u, v);

async function click(vertex: number, keys: string[] = []) {
  const { x, y } = await script.screenPosition(vertex);
  for (const key of keys) await visit.page.keyboard.down(key);
  await visit.page.mouse.click(x, y);
  for (const key of keys) await visit.page.keyboard.up(key);
  await script.settled();
}

/** Free handles beside the anchors of the corners. */
async function addHandles(...vertices: number[]) {
  const present = await handles();
  await script.setHandles([...present, ...vertices.map((vertex) => ({ vertex, anchor: false }))]);
  await script.settled();
}

async function boxAround(...vertices: number[]) {
  const places = await Promise.all(vertices.map((vertex) => script.screenPosition(vertex)));
  const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
  const { mouse, keyboard } = visit.page;
  await keyboard.down('Shift');
  await mouse.move(Math.min(...xs) - 20, Math.min(...ys) - 20);
  await mouse.down();
  await mouse.move(Math.max(...xs) + 20, Math.max(...ys) + 20, { steps: 4 });
  await mouse.up();
  await keyboard.up('Shift');
}

/** With the pointer, an outline of six corners. */
async function drawAround(vertex: number) {
  const corners = hexagon(await script.screenPosition(vertex), 30);
  const { mouse } = visit.page;
  await mouse.move(corners[0]!.x, corners[0]!.y);
  await mouse.down();
  for (const { x, y } of corners) await mouse.move(x, y);
  await mouse.up();
}

function hexagon({ x, y }: { x: number; y: number }, radius: number) {
  return [0, 1, 2, 3, 4, 5].map((i) => ({
    x: x + radius * Math.cos(i * (Math.PI / 3)),
    y: y + radius * Math.sin(i * (Math.PI / 3)),
  }));
}

const [left, right] = [at(0.35, 0.35), at(0.65, 0.35)];
const openSection = () => visit.page.getByText(/^Handles \(/).click();
const isSelected = (vertex: number) =>
  visit.page.getByRole('button', { name: `Vertex ${vertex}`, exact: true, pressed: true });

describe('several handles', () => {
  beforeEach(() => open());

  test('in a box are selected, dragged together as far as the net can follow, and come back by one undo', async () => {
    await addHandles(left, right);
    await openSection();
    await boxAround(left, right);
    await isSelected(left).waitFor();
    await isSelected(right).waitFor();
    await visit.page.screenshot({ path: join(OUTPUT, 'handles-box.png') });

    await dragBy(script, left, [-15, -25]);
    await script.settled();
    const [a, b] = [await targetOf(left), await targetOf(right)];
    const [movedA, movedB] = [a.map((x, i) => x - rest(left)[i]!), b.map((x, i) => x - rest(right)[i]!)];
    expect(Math.hypot(...movedA)).toBeGreaterThan(0.2 * meanLength);
    expect(distance(movedA, movedB)).toBeLessThan(1e-9);
    expect(distance(await targetOf(dragged), rest(dragged))).toBeLessThan(1e-9);

    await press('Control+z');
    await script.settled();
    expect(distance(await targetOf(left), rest(left))).toBeLessThan(1e-9);
    expect(distance(await targetOf(right), rest(right))).toBeLessThan(1e-9);
    expect(await handles()).toHaveLength(net.suggestedHandles.length + 2);

    // Beyond, each stands where the net holds it, and is not torn from it.
    await dragFar(left);
    const [farA, farB] = [distance(await targetOf(left), rest(left)), distance(await targetOf(right), rest(right))];
    expect(farA).toBeGreaterThan(meanLength);
    expect(Math.abs(farA - farB)).toBeLessThan(0.1 * farA);
    expect(await script.position(right)).toEqual(await targetOf(right));
  });

  test('are selected by Shift and clicks, all by Ctrl+A, none by Escape, by a lasso; arrow keys nudge them; Escape takes a drag back', async () => {
    await addHandles(left, right);
    await openSection();
    await click(left);
    await click(right, ['Shift']);
    await isSelected(left).waitFor();
    await click(left, ['Shift']);
    await isSelected(left).waitFor({ state: 'detached' });
    await isSelected(right).waitFor();

    await press('Control+a');
    for (const { vertex } of await handles()) await isSelected(vertex).waitFor();
    // What is selected is counted, and what of it is locked.
    const bar = visit.page.getByRole('group', { name: 'Selected handles' });
    const all = (await handles()).length;
    const locked = (await handles()).filter(({ anchor }) => anchor).length;
    expect(locked).toBeGreaterThan(0);
    await bar.getByText(`${all} handles, ${locked} locked`, { exact: true }).waitFor();
    await press('l');
    expect(await visit.page.locator('.to-select').innerText()).toMatch(`${all} selected, ${locked} of them locked.`);
    await press('Escape');
    await press('Escape');
    await isSelected(right).waitFor({ state: 'detached' });

    await press('l');
    await drawAround(left);
    await click(right);
    for (const vertex of [left, right]) await isSelected(vertex).waitFor();
    await press('Escape');
    expect(await button('Select').getAttribute('aria-pressed')).toBe('false');
    await press('ArrowUp');
    await script.settled();
    const [movedA, movedB] = [
      (await targetOf(left)).map((x, i) => x - rest(left)[i]!),
      (await targetOf(right)).map((x, i) => x - rest(right)[i]!),
    ];
    expect(Math.hypot(...movedA)).toBeCloseTo(0.2 * meanLength, 6);
    expect(distance(movedA, movedB)).toBeLessThan(1e-9);

    const before = await targetOf(right);
    await dragBy(script, left, [-15, -25], { atEnd: () => press('Escape') });
    await script.settled();
    expect(distance(await targetOf(right), before)).toBeLessThan(1e-9);
  });

  test('turn and grow about their centre, by numbers and by the ring of the gizmo', async () => {
    await addHandles(left, right);
    await openSection();
    await boxAround(left, right);
    await visit.page.getByLabel('Degrees', { exact: true }).fill('30');
    await visit.page.getByRole('form', { name: 'Rotate, degrees' }).getByRole('button').click();
    await script.settled();
    const [a, b] = [await targetOf(left), await targetOf(right)];
    const arm = (from: Vec3, to: Vec3) => Math.atan2(to[1] - from[1], to[0] - from[0]);
    const turn = (arm(a, b) - arm(rest(left), rest(right))) * (180 / Math.PI);
    expect(turn).toBeCloseTo(30, 6);
    expect(distance(centreOf([a, b]), centreOf([rest(left), rest(right)]))).toBeLessThan(1e-9);

    const factor = visit.page.getByLabel('Factor', { exact: true });
    await factor.fill('0.9');
    await visit.page.getByRole('form', { name: 'Scale by' }).getByRole('button').click();
    await script.settled();
    expect(distance(await targetOf(left), await targetOf(right))).toBeCloseTo(0.9 * distance(a, b), 9);
    // From a field, too, once that has been applied; what is only typed is undone there.
    await factor.fill('0.8');
    await factor.press('Enter');
    await script.settled();
    await factor.press('Control+z');
    await script.settled();
    expect(distance(await targetOf(left), await targetOf(right))).toBeCloseTo(0.9 * distance(a, b), 9);
    await factor.press('End');
    await visit.page.keyboard.type('5');
    await factor.press('Control+z');
    expect(await factor.inputValue()).toBe('0.8');
    expect(distance(await targetOf(left), await targetOf(right))).toBeCloseTo(0.9 * distance(a, b), 9);
    await visit.page.locator('canvas').first().focus();
    for (let i = 0; i < 2; ++i) await press('Control+z');
    await script.settled();
    await visit.page.locator('canvas').first().focus();
    await press('r');
    expect(await button('Rotate').getAttribute('aria-pressed')).toBe('true');
    await dragRing();
    await script.settled();
    const turned = await targetOf(left);
    expect(distance(turned, rest(left))).toBeGreaterThan(1e-3 * meanLength);
    expect(distance(turned, await targetOf(right))).toBeCloseTo(distance(rest(left), rest(right)), 9);
    await press('Control+z');
    await script.settled();
    expect(distance(await targetOf(left), rest(left))).toBeLessThan(1e-9);
  });

  test('a boundary loop or a net line become handles in one action', async () => {
    const count = (await handles()).length;
    await click(corner);
    await button('Boundary loop').click();
    await expect.poll(async () => (await handles()).length).toBeGreaterThan(count + 40);
    await script.settled();
    await visit.page.screenshot({ path: join(OUTPUT, 'handles-boundary.png') });
    await press('Control+z');
    await expect.poll(async () => (await handles()).length).toBe(count);

    await click(left);
    await button('Net line 1').click();
    await expect.poll(async () => (await handles()).length).toBeGreaterThan(count + 10);
    await visit.page.getByTitle(/^\d\d handles selected$/).waitFor();
    await press('Delete');
    await expect.poll(async () => (await handles()).length).toBeLessThanOrEqual(count);
  });

  test('the handles of a net line are one row; a name for several makes one', async () => {
    const count = (await handles()).length;
    await openSection();
    const rows = visit.page.locator('.handles li');
    await expect.poll(() => rows.count()).toBe(count);
    await click(left);
    await button('Net line 1').click();
    const row = rows.filter({ hasText: /^Net line 1 · \d+ \(\d+\)$/ });
    await row.waitFor();
    await visit.page.screenshot({ path: join(OUTPUT, 'handles-group.png') });
    const fresh = (await handles()).length - (await rows.count()) + 1;
    expect(fresh).toBeGreaterThan(10);
    const locked = async () => (await handles()).filter(({ anchor }) => anchor).length;
    const before = await locked();
    await row.getByRole('button', { name: 'Lock' }).click();
    await expect.poll(locked).toBe(before + fresh);
    await row.getByRole('button', { name: /^Unlock: Net line 1 · \d+ \(\d+\)$/ }).click();

    const name = visit.page.getByRole('textbox', { name: 'Name' });
    await name.fill('Ridge');
    await press('Enter');
    const ridge = rows.filter({ hasText: /^Ridge \(\d+\)$/ });
    await ridge.waitFor();
    // Enter of an input method takes what it offers, and ends nothing else.
    await ridge
      .getByRole('button', { name: /^Ridge/ })
      .first()
      .press('F2');
    const renaming = ridge.getByRole('textbox');
    await renaming.evaluate((field) =>
      field.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', isComposing: true })),
    );
    expect(await renaming.isVisible()).toBe(true);
    await renaming.press('Escape');
    await renaming.waitFor({ state: 'hidden' });
    await name.fill('');
    await press('Enter');
    await expect.poll(async () => rows.count()).toBe((await handles()).length);
  });
});

describe('a handle', () => {
  beforeEach(() => open());

  test('that is locked neither moves nor goes until it is unlocked', async () => {
    await click(corner);
    await dragBy(script, corner, [-40, -30]);
    await script.settled();
    expect(await targetOf(corner)).toEqual(rest(corner));
    await click(corner);
    await press('Delete');
    await visit.page.getByText('Locked handles stay').waitFor();
    expect((await handles()).map(({ vertex }) => vertex)).toContain(corner);

    await openSection();
    // Its name says what a press does: that it is pressed would say the opposite.
    const unlock = button(`Unlock: Vertex ${corner}`);
    expect(await unlock.getAttribute('aria-pressed')).toBe(null);
    await unlock.click();
    await button(`Lock: Vertex ${corner}`).waitFor();
    await dragBy(script, corner, [-10, -10]);
    await script.settled();
    expect(distance(await targetOf(corner), rest(corner))).toBeGreaterThan(1e-3 * meanLength);
  });

  test('that are removed by key, one after another, leave the focus in the list', async () => {
    await script.setHandles([corner, left, right].map((vertex) => ({ vertex, anchor: false })));
    await openSection();
    const cross = (vertex: number) => button(`Remove the handle at vertex ${vertex}`);
    const focused = () => visit.page.evaluate(() => document.activeElement?.textContent);
    for (const [vertex, next] of [
      [left, right],
      [right, corner],
    ] as const) {
      await cross(vertex).press('Enter');
      await cross(vertex).waitFor({ state: 'detached' });
      expect(await focused()).toBe(`Vertex ${next}`);
    }
  });

  test('is added by its number, and the field is empty again as at first', async () => {
    await openSection();
    const field = visit.page.getByRole('spinbutton', { name: 'Vertex number' });
    const border = () => field.evaluate((input) => getComputedStyle(input).borderColor);
    const before = await border();
    await field.fill(String(left));
    await field.press('Enter');
    await isSelected(left).waitFor();
    await field.blur();
    expect(await field.inputValue()).toBe('');
    expect(await border()).toBe(before);
  });

  test('keeps name, softness and being hidden in a link; undo takes them back', async () => {
    await click(dragged);
    await openSection();
    await visit.page.getByRole('button', { name: `Vertex ${dragged}`, exact: true }).press('F2');
    await visit.page.keyboard.type('Crown <b>');
    await press('Enter');
    await visit.page.getByRole('checkbox', { name: 'Soft', exact: true }).locator('visible=true').check();
    await script.settled();
    const row = visit.page.getByRole('listitem').filter({ hasText: 'Crown <b>' });
    await row.getByRole('button', { name: 'Hide' }).click();
    const expected = { vertex: dragged, name: 'Crown <b>', weight: 1, hidden: true };
    expect((await handles()).at(-1)).toMatchObject(expected);

    const link = await visit.page.evaluate(() => window.chebnet.link());
    const receiver = await arrive(link);
    await receiver.script.settled();
    expect((await receiver.page.evaluate(() => window.chebnet.handles())).at(-1)).toMatchObject(expected);

    for (let i = 0; i < 3; ++i) await press('Control+z');
    await expect.poll(async () => (await handles()).at(-1)).not.toHaveProperty('name');
  });

  test('moves its mirror image, both as far as the net can follow', async () => {
    await openSection();
    await visit.page.getByLabel('Symmetry').selectOption('x');
    await click(left);
    const partner = (await handles()).at(-1)!.vertex;
    expect(partner).not.toBe(left);
    expect(await handles()).toHaveLength(net.suggestedHandles.length + 2);
    const [low, high] = extent(0);
    const mirrored = ([x, y, z]: Vec3): Vec3 => [low + high - x, y, z];
    expect(distance(mirrored(rest(left)), rest(partner))).toBeLessThan(0.5 * meanLength);

    await dragBy(script, left, [-15, -25]);
    await script.settled();
    const apart = distance(mirrored(rest(left)), rest(partner));
    expect(distance(mirrored(await targetOf(left)), await targetOf(partner))).toBeCloseTo(apart, 9);
    expect(distance(await targetOf(left), rest(left))).toBeGreaterThan(0.2 * meanLength);

    // Beyond, each stands where the net holds it, which is alike up to how near the net comes to rest.
    await dragFar(left);
    const farApart = distance(mirrored(await targetOf(left)), await targetOf(partner));
    expect(Math.abs(farApart - apart)).toBeLessThan(0.02 * meanLength);
  });
});

test('a finger drags a handle; held still, it selects; beside handles it turns the view, or draws a lasso; two fingers zoom', async () => {
  await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await addHandles(left);
  const session = await visit.page.context().newCDPSession(visit.page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: { x: number; y: number }[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  const swipe = async ({ x, y }: { x: number; y: number }, dx: number, dy: number) => {
    const moves = [1, 2, 3, 4, 5].map((i) => ({ x: x + (dx * i) / 5, y: y + (dy * i) / 5 }));
    // Not waiting for each: a finger does not linger because the page is slow.
    await Promise.all([
      touch('touchStart', [{ x, y }]),
      ...moves.map((move) => touch('touchMove', [move])),
      touch('touchEnd', []),
    ]);
    await script.settled();
  };

  const place = await script.screenPosition(dragged);
  await swipe({ x: place.x + 12, y: place.y + 12 }, -20, -30);
  expect(distance(await targetOf(dragged), rest(dragged))).toBeGreaterThan(0.2 * meanLength);

  for (const [i, vertex] of [left, dragged].entries()) {
    await touch('touchStart', [await script.screenPosition(vertex)]);
    await visit.page
      .getByRole('group', { name: 'Selected handles' })
      .getByText(['1 handle', '2 handles'][i]!, { exact: true })
      .waitFor();
    await touch('touchEnd', []);
  }
  await visit.page.screenshot({ path: join(OUTPUT, 'handles-phone.png') });
  const sizes = await visit.page
    .getByRole('group', { name: 'Selected handles' })
    .getByRole('button')
    .evaluateAll((all) =>
      all
        .map((each) => each.getBoundingClientRect())
        .filter(({ width }) => width > 0)
        .map(({ width, height }) => Math.min(width, height)),
    );
  expect(Math.min(...sizes)).toBeGreaterThanOrEqual(44);

  const before = await script.screenPosition(corner);
  await swipe({ x: 30, y: 520 }, 120, 0);
  const after = await script.screenPosition(corner);
  expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeGreaterThan(5);

  /** How much larger the net is after two fingers, of which the first moved a little before the second came, went apart. */
  const pinch = async ({ x, y }: { x: number; y: number }) => {
    const apart = async () => {
      const [a, b] = [await script.screenPosition(corner), await script.screenPosition(dragged)];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    const size = await apart();
    const second = { x: x + 60, y: y + 60 };
    await touch('touchStart', [{ x, y }]);
    await touch('touchMove', [{ x: x - 12, y }]);
    await touch('touchStart', [{ x: x - 12, y }, second]);
    for (const i of [1, 2, 3])
      await touch('touchMove', [
        { x: x - 12 - 5 * i, y },
        { x: second.x + 5 * i, y: second.y },
      ]);
    await touch('touchEnd', []);
    await script.settled();
    return (await apart()) / size;
  };
  const target = await targetOf(dragged);
  expect(await pinch(await script.screenPosition(dragged))).toBeGreaterThan(1.1);
  expect(await targetOf(dragged)).toEqual(target);

  const select = button('Select');
  const chosen = () => visit.page.locator('.to-select').innerText();
  await select.tap();
  const { x, y } = await script.screenPosition(left);
  await visit.page.touchscreen.tap(x, y);
  expect(await chosen()).toMatch(/^1 selected/);
  const corners = hexagon(await script.screenPosition(left), 40);
  await touch('touchStart', [corners[0]!]);
  for (const place of corners.slice(1)) await touch('touchMove', [place]);
  await visit.page.screenshot({ path: join(OUTPUT, 'lasso-phone.png') });
  await touch('touchEnd', []);
  expect(await chosen()).toMatch(/^2 selected/);
  expect(await pinch({ x: 60, y: 480 })).toBeGreaterThan(1.1);
  expect(await chosen()).toMatch(/^2 selected/);
  await select.tap();
  expect(await select.getAttribute('aria-pressed')).toBe('false');

  // Neither the pinch nor selecting left anything to undo: what the first finger did is the last.
  await button('Undo').tap();
  await script.settled();
  expect(distance(await targetOf(dragged), rest(dragged))).toBeLessThan(1e-9);
});

/** Farther than the net can follow; it stops before. */
async function dragFar(vertex: number) {
  const { mouse } = visit.page;
  const { x, y } = await script.screenPosition(vertex);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x - 6, y - 6, { steps: 2 });
  await expect.poll(() => targetOf(vertex)).not.toEqual(rest(vertex));
  await script.settled(); // the solver has answered, with the limits of the drag before that
  await mouse.move(x - 900, y - 900, { steps: 2 });
  await mouse.up();
  await script.settled();
  expect((await script.stats()).status).not.toBe('unreachable');
  expect(distance(await targetOf(vertex), rest(vertex))).toBeGreaterThan(meanLength);
}

/** Takes the outer ring of the gizmo, to the right of the centre, and pulls it along. */
async function dragRing() {
  const radius = 107; // on the screen, however near the camera is
  const [a, b] = [await script.screenPosition(left), await script.screenPosition(right)];
  const [x, y] = [(a.x + b.x) / 2 + radius, (a.y + b.y) / 2];
  const { mouse } = visit.page;
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x, y - 30, { steps: 5 });
  await mouse.up();
}

test('an arrow key over locked handles says that they stay; turning ends selecting', async () => {
  await open();
  await click(corner);
  await press('ArrowUp');
  await visit.page.getByText('Locked handles stay. Unlock them first.').waitFor();
  expect(await targetOf(corner)).toEqual(rest(corner));
  await press('l');
  expect(await button('Select').getAttribute('aria-pressed')).toBe('true');
  await press('r');
  expect(await button('Select').getAttribute('aria-pressed')).toBe('false');
});

test('one move of the hand is one picture, before the solver has answered', async () => {
  const { page, script } = await arrive();
  await page.evaluate(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message: { type?: string }, ...more: never[]) {
      if (message.type !== 'drag') post.call(this, message, ...more);
    };
  });
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const pictures = async () => (await script.stats()).framesPerSecond;
  await expect.poll(pictures).toBe(0);
  await page.mouse.move(x + 4, y - 10);
  await expect.poll(pictures).toBeGreaterThan(0);
  await page.waitForTimeout(300);
  expect(await pictures()).toBe(1);
  await page.mouse.up();
});

/** Taking hold of the net: patches of it, and what a drag snaps to. With a mouse, keys and a finger. */
import { createHash } from 'node:crypto';
import { join } from 'node:path';
import { beforeEach, describe, expect, test } from 'vitest';
import type { Point } from '../../wasm/chebnet';
import { throughHandles } from '../../web/src/handles/curve';
import { load } from '../wasm/load';
import { distance, dragBy, vertexAt } from './geometry';
import type { Script, Visit } from './page';
import { drawn, OUTPUT, visits } from './page';
import { pixels } from './pixels';

const SHAPE = 'vault:vertices=500';

const core = await load();
const net = core.openRecipe(SHAPE);
const { meanLength } = net.info;

const { share } = visits();
let visit: Visit;
let script: Script;

async function open(options = {}) {
  visit = await share(options);
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  await script.settled();
}

const handles = () => visit.page.evaluate(() => window.chebnet.handles());
const press = (keys: string) => visit.page.keyboard.press(keys);
const bar = () => visit.page.getByRole('group', { name: 'Selected handles' });
const button = (name: string | RegExp) => bar().getByRole('button', { name, exact: true });
const radius = () => bar().getByRole('spinbutton', { name: /^Radius/ });
const row = (name: RegExp) => visit.page.locator('.handles li').filter({ hasText: name });
const openSection = (name: RegExp) => visit.page.locator('summary', { hasText: name }).click();
/** How many vertices are pointed out. */
const previewed = () =>
  visit.page.locator('svg.overlay path.preview').evaluate((path) => path.getAttribute('d')!.split('M').length - 1);

/** The vertex at these parts of the net's extent. */
const at = (u: number, v: number) => vertexAt(net.restPositions, u, v);

async function click(vertex: number) {
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.mouse.click(x, y);
  await script.settled();
}

const place = at(0.3, 0.3);

test('a handle stays in the hand while the window gets another size', async () => {
  await open();
  const vertex = net.suggestedHandles.at(-1)!;
  const { mouse } = visit.page;
  const target = async () => (await handles()).find((each) => each.vertex === vertex)!.target;
  const { x, y } = await script.screenPosition(vertex);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 20, y - 10, { steps: 4 });
  await script.settled();
  const before = await target();
  await visit.page.setViewportSize({ width: 900, height: 600 });
  await drawn(visit.page);
  const there = await script.screenPosition(vertex);
  await mouse.move(there.x + 1, there.y);
  await script.settled();
  expect(distance(await target(), before)).toBeLessThan(meanLength);
  await mouse.up();
});

describe('a way', () => {
  beforeEach(() => open());

  test('through two handles is pointed out, taken as one row, and undone as one', async () => {
    await openSection(/^Handles \(/);
    await click(at(0.3, 0.2));
    expect(await button('Way').isVisible()).toBe(false);
    await visit.page.keyboard.down('Shift');
    await click(at(0.6, 0.7));
    await visit.page.keyboard.up('Shift');
    await script.settled();
    const before = await handles();
    await button('Way').hover();
    await expect.poll(previewed).toBeGreaterThan(8);
    const count = await previewed();
    await visit.page.screenshot({ path: join(OUTPUT, 'holding-way-preview.png') });
    await button('Way').click();
    await row(new RegExp(`^Way · \\d+ \\(${count}\\)$`)).waitFor();
    expect(await handles()).toHaveLength(before.length + count - 2);
    await script.settled();
    await press('Control+z');
    await expect.poll(async () => (await handles()).length).toBe(before.length);
  });
});

describe('a patch', () => {
  beforeEach(() => open());

  test('is what its button points out, one row of the list, dragged as one, and undone as one', async () => {
    await openSection(/^Handles \(/);
    await click(place);
    const before = await handles();
    await radius().fill('2');
    await expect.poll(previewed).toBe(13);
    await press('Tab');
    await expect.poll(previewed).toBe(0);
    await button('Patch').hover();
    await expect.poll(previewed).toBe(13);
    await visit.page.screenshot({ path: join(OUTPUT, 'holding-patch-preview.png') });
    await button('Patch').click();
    await row(/^Patch · \d+ \(13\)$/).waitFor();
    // The tools have moved, and may now stand below the pointer with what they would take next.
    await visit.page.mouse.move(5, 5);
    await expect.poll(previewed).toBe(0);
    expect(await handles()).toHaveLength(before.length + 12);
    await script.settled();

    const patch = (await handles()).filter(({ name }) => name?.startsWith('Patch'));
    await dragBy(script, place, [-5, -12]);
    await script.settled();
    await visit.page.screenshot({ path: join(OUTPUT, 'holding-patch.png') });
    const after = new Map((await handles()).map(({ vertex, target }) => [vertex, target]));
    const moves = patch.map(({ vertex, target }) => after.get(vertex)!.map((x, i) => x - target[i]!));
    expect(Math.hypot(...moves[0]!)).toBeGreaterThan(0.1 * meanLength);
    for (const move of moves) expect(distance(move, moves[0]!)).toBeLessThan(1e-9);

    await press('Control+z');
    await press('Control+z');
    await expect.poll(async () => (await handles()).length).toBe(before.length);
  });

  test('is taken by keys: P, or its radius and Enter; its row is renamed in place', async () => {
    await openSection(/^Handles \(/);
    await click(place);
    await press('p');
    await row(/^Patch · \d+ \(29\)$/).waitFor();
    await press('Control+z');
    await expect.poll(() => row(/^Patch/).count()).toBe(0);
    await radius().focus();
    await press('Control+a');
    await visit.page.keyboard.type('1');
    await press('Enter');
    const group = row(/^Patch · \d+ \(5\)$/);
    await group.waitFor();
    await script.settled();

    const rename = async (key: string, name: string, end: string) => {
      await visit.page.locator('.handles li .name').last().press(key);
      const field = visit.page.getByRole('textbox', { name: 'Name of all of them' });
      await field.fill(name);
      await field.press(end);
      await field.waitFor({ state: 'hidden' });
    };
    await rename('F2', 'Crown', 'Escape');
    await group.waitFor();
    await rename('F2', 'Crown', 'Enter');
    await row(/^Crown \(5\)$/).waitFor();
    expect((await handles()).filter(({ name }) => name === 'Crown')).toHaveLength(5);
    await expect.poll(() => visit.page.evaluate(() => document.activeElement?.textContent)).toBe('Crown (5)');
    await press('Control+z');
    await group.waitFor();
    await group.getByRole('button', { pressed: true }).first().dblclick();
    const field = visit.page.getByRole('textbox', { name: 'Name of all of them' });
    await field.waitFor();
    await field.press('Escape');

    // Also where the first click of two chooses them, and the form for several comes.
    await press('Escape');
    await expect.poll(() => group.getByRole('button', { pressed: true }).count()).toBe(0);
    await group.getByRole('button').first().dblclick();
    await field.waitFor();
  });
});

describe('a part of the net', () => {
  beforeEach(() => open());

  const far = at(0.8, 0.8);
  const notice = () => visit.page.getByText('Only a part of the net is shown.');

  /** Whether lines stand out from what is around a vertex on the screen. */
  async function isSeen(vertex: number): Promise<boolean> {
    const { x, y } = await script.screenPosition(vertex);
    await visit.page.mouse.move(5, 5);
    const clip = { x: x - 6, y: y - 6, width: 12, height: 12 };
    const colours = await pixels(visit.page, await visit.page.screenshot({ clip }));
    return colours.evaluate((data) => {
      const greens = data.filter((_, i) => i % 4 === 1);
      return Math.max(...greens) - Math.min(...greens) > 60;
    });
  }

  test('is shown alone by a button, and all of it again by another; what is hidden cannot be taken', async () => {
    await visit.page.evaluate((vertex) => window.chebnet.setHandles([...window.chebnet.handles(), { vertex }]), far);
    await script.settled();
    await expect.poll(() => isSeen(at(0.7, 0.3))).toBe(true);
    await click(place);
    const before = await handles();
    await button('Isolate').click();
    await notice().waitFor();
    await visit.page.screenshot({ path: join(OUTPUT, 'holding-isolated.png') });
    await expect.poll(() => isSeen(at(0.7, 0.3))).toBe(false);
    await expect.poll(() => isSeen(place)).toBe(true);

    // Neither a vertex nor a handle: a click there is one on nothing.
    await click(at(0.7, 0.3));
    await click(far);
    expect(await handles()).toEqual(before);
    await bar().waitFor({ state: 'hidden' });
    await press('Control+a');
    await visit.page.getByTitle('1 handle selected').waitFor();

    await visit.page.getByRole('button', { name: 'Show the whole net' }).click();
    await notice().waitFor({ state: 'detached' });
    await expect.poll(() => isSeen(at(0.7, 0.3))).toBe(true);
    await click(far);
    await bar().waitFor();
  });

  test.each([
    [1280, 800],
    [740, 360],
  ])('is said to be one beside the arrow at a crown, and over no words, at %i by %i', async (width, height) => {
    const { page } = visit;
    await page.setViewportSize({ width, height });
    await script.open({ recipe: 'dome' });
    await script.settled();
    const crown = (await handles()).at(-1)!.vertex;
    await click(crown);
    await press('i');
    await notice().waitFor();
    await drawn(page);
    await page.screenshot({ path: join(OUTPUT, 'holding-isolated-crown.png') });
    const message = (await page.locator('.part-notice .message').boundingBox())!;
    const at = await script.screenPosition(crown);
    const arrow = 0.14 * (await page.locator('#view').boundingBox())!.height;
    const isBeside = at.x + 12 < message.x || at.x - 12 > message.x + message.width;
    expect(isBeside || at.y - arrow > message.y + message.height).toBe(true);
    const lines = await page
      .locator('.title > p')
      .evaluateAll((all) =>
        all
          .filter((line) => line.textContent !== '' && getComputedStyle(line).visibility === 'visible')
          .map((line) => line.getBoundingClientRect().bottom),
      );
    expect(lines.filter((bottom) => bottom > message.y)).toEqual([]);
  });

  test('comes and goes with I, around all that is selected, and does not outlive its net', async () => {
    await click(place);
    await press('i');
    await notice().waitFor();
    await press('i');
    await notice().waitFor({ state: 'detached' });
    await press('i');
    await notice().waitFor();
    await script.open({ recipe: SHAPE });
    await notice().waitFor({ state: 'detached' });
    await expect.poll(() => isSeen(at(0.7, 0.3))).toBe(true);
  });
});

describe('a drag', () => {
  const crown = net.suggestedHandles.at(-1)!;
  const corner = net.suggestedHandles[0]!;
  const grid = () => visit.page.getByRole('checkbox', { name: 'Snap to a grid' });
  const readout = () => visit.page.locator('svg.overlay .readout:not([hidden])');
  const target = async (vertex: number) => (await handles()).find((each) => each.vertex === vertex)!.target;
  /** How far a coordinate is from the grid. */
  const offGrid = (x: number, spacing: number) => Math.abs(x - Math.round(x / spacing) * spacing);

  beforeEach(async () => {
    await open();
    await openSection(/^Dragging/);
  });

  test('snaps to a grid of so many edges or units, says where it is, and with Ctrl is free', async () => {
    await grid().check();
    await visit.page.getByRole('spinbutton', { name: 'Spacing' }).fill('0.5');
    await press('Tab');
    let [said, free] = ['', ''];
    await dragBy(script, crown, [-25, 12], {
      atEnd: async () => {
        said = (await readout().textContent())!;
        await visit.page.screenshot({ path: join(OUTPUT, 'holding-grid.png') });
        await visit.page.keyboard.down('Control');
        await expect.poll(() => readout().textContent()).not.toBe(said);
        free = (await readout().textContent())!;
        await visit.page.keyboard.up('Control');
        await expect.poll(() => readout().textContent()).toBe(said);
      },
    });
    await script.settled();
    const place = await target(crown);
    expect(said).toMatch(/^x -?[\d.]+ · y -?[\d.]+ · z -?[\d.]+$/);
    expect(free).not.toBe('');
    for (const x of place) expect(offGrid(x, 0.5 * meanLength)).toBeLessThan(1e-6 * meanLength);
    await readout().waitFor({ state: 'detached' });

    await visit.page.getByRole('combobox', { name: 'Unit of the spacing' }).selectOption('units');
    await visit.page.getByRole('spinbutton', { name: 'Spacing' }).fill('0.125');
    await press('Tab');
    await dragBy(script, crown, [12, -6]);
    await script.settled();
    for (const x of await target(crown)) expect(offGrid(x, 0.125)).toBeLessThan(1e-6);
    await press('Control+z');
    await expect.poll(async () => distance(await target(crown), place)).toBeLessThan(1e-9);
  });

  test('by arrow keys goes by steps of the grid', async () => {
    await grid().check();
    await click(crown);
    await press('ArrowDown');
    await script.settled();
    const from = await target(crown);
    await press('ArrowDown');
    await script.settled();
    const to = await target(crown);
    const steps = to.map((x, i) => (x - from[i]!) / meanLength);
    expect(steps.map(Math.abs).sort()).toEqual([expect.closeTo(0, 6), expect.closeTo(0, 6), expect.closeTo(1, 6)]);
    await grid().uncheck();
    await visit.page.locator('#view canvas').focus();
    await press('ArrowDown');
    await script.settled();
    expect(distance(await target(crown), to)).toBeCloseTo(0.2 * meanLength, 6);
  });

  test('by arrow keys moves what was chosen in the list, once G has led to the picture', async () => {
    await openSection(/^Handles \(/);
    const line = row(new RegExp(`Vertex ${crown}`));
    await line.getByRole('button').first().press('Enter');
    const from = await target(crown);
    await press('g');
    await press('ArrowUp');
    await script.settled();
    expect(distance(await target(crown), from)).toBeGreaterThan(0);
  });

  test('keeps to the border of the net as it was, or to a curve through handles; there must be one', async () => {
    const curves = visit.page.getByRole('combobox', { name: 'Keep to a curve' });
    const border = async () => {
      const positions = await script.positions();
      const { start, vertices } = net.boundaryLoops();
      const points = Array.from(
        vertices.subarray(0, start[1]),
        (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)] as Point,
      );
      return throughHandles([...points, points[0]!].map((each) => ({ target: each })))!;
    };
    await curves.selectOption('handles');
    await visit.page.getByText('Select two handles or more first').waitFor();
    expect(await curves.inputValue()).toBe('none');

    const { start, vertices } = net.boundaryLoops();
    const onBorder = (steps: number) => vertices[(vertices.indexOf(corner) + steps) % start[1]!]!;
    const foot = onBorder(6);
    await click(foot);
    const before = await border();
    const from = await target(foot);
    await curves.selectOption('net');
    const [here, there] = [await script.screenPosition(foot), await script.screenPosition(onBorder(5))];
    await dragBy(script, foot, [there.x - here.x, there.y - here.y + 15], {
      atEnd: async () => void (await visit.page.screenshot({ path: join(OUTPUT, 'holding-curve.png') })),
    });
    await script.settled();
    const to = await target(foot);
    expect(distance(to, from)).toBeGreaterThan(0.3 * meanLength);
    expect(distance(before.nearest(to as Point), to)).toBeLessThan(1e-9 * meanLength);

    // Free again.
    await curves.selectOption('none');
    await dragBy(script, foot, [0, -25]);
    await script.settled();
    const free = await target(foot);
    expect(distance(before.nearest(free as Point), free)).toBeGreaterThan(0.05 * meanLength);
  });

  test('shows the curve it keeps to in the colours of a page that has turned dark', async () => {
    const curves = visit.page.getByRole('combobox', { name: 'Keep to a curve' });
    const picture = async () => {
      await drawn(visit.page);
      return createHash('sha256')
        .update(await visit.page.locator('#view').screenshot())
        .digest('hex');
    };
    const light = await picture();
    await curves.selectOption('net');
    await expect.poll(picture).not.toBe(light);
    await visit.page.emulateMedia({ colorScheme: 'dark' });
    const turnedDark = await picture();
    await curves.selectOption('none');
    await expect.poll(picture).not.toBe(turnedDark);
    await curves.selectOption('net');
    await expect.poll(picture).toBe(turnedDark);
    await visit.page.emulateMedia({ colorScheme: 'light' });
  });

  test('snaps level with other handles, which are named', async () => {
    await visit.page.getByRole('checkbox', { name: 'Snap to other handles' }).check();
    const height = (await target(corner))[2]!;
    const low = at(0.12, 0.12);
    await click(low);
    await visit.page.getByRole('checkbox', { name: 'Keep within reach' }).check();
    const { x, y } = await script.screenPosition(low);
    await visit.page.mouse.move(x, y);
    await visit.page.mouse.down();
    // Down until it is level with the feet; what the readout says is of the frame before.
    const framesShown = () =>
      visit.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const said = async () => (await readout().count()) > 0 && (await readout().textContent())!;
    for (let by = 1; by < 120 && !/z [^·]*\(/.test((await said()) || ''); by += 2) {
      await visit.page.mouse.move(x, y + by);
      await framesShown();
    }
    expect(await said()).toMatch(/z -?[\d.]+ \(Vertex \d+\)$/);
    await visit.page.mouse.up();
    await script.settled();
    expect((await target(low))[2]).toBeCloseTo(height, 6);
  });
});

test.each([SHAPE, 'dome'])('on a phone the tools do not cover %s while the controls are open', async (recipe) => {
  await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await script.open({ recipe });
  await script.settled();
  const { vertex } = (await handles()).at(-1)!;
  const { x, y } = await script.screenPosition(vertex);
  await visit.page.touchscreen.tap(x, y);
  await bar().waitFor();
  await visit.page.getByRole('button', { name: 'Controls' }).tap();
  await visit.page.locator('.legend').waitFor({ state: 'hidden' });
  const covered = async () => {
    const box = (await bar().boundingBox())!;
    const places = await visit.page.evaluate(() =>
      Array.from({ length: window.chebnet.positions().length / 3 }, (_, i) => window.chebnet.screenPosition(i)),
    );
    const isIn = ({ x, y }: (typeof places)[0]) =>
      x > box.x && x < box.x + box.width && y > box.y && y < box.y + box.height;
    return places.filter(isIn).length;
  };
  await expect.poll(covered).toBe(0);
  await visit.page.screenshot({ path: join(OUTPUT, `holding-phone-controls-${recipe.slice(0, 4)}.png`) });
});

test('a finger takes a patch, and finds all that can be done with it', async () => {
  await open({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const { x, y } = await script.screenPosition(place);
  await visit.page.touchscreen.tap(x, y);
  await button('Patch').waitFor();
  await button('Patch').tap();
  const patch = async () => (await handles()).filter(({ name }) => name?.startsWith('Patch'));
  // The tap may have taken a neighbour at the border of the net.
  await expect.poll(async () => (await patch()).length).toBeGreaterThan(20);
  for (const each of await bar().getByRole('button').filter({ visible: true }).all()) {
    const { x: left, width } = (await each.boundingBox())!;
    expect(left).toBeGreaterThanOrEqual(0);
    expect(left + width).toBeLessThanOrEqual(360);
  }
  await visit.page.screenshot({ path: join(OUTPUT, 'holding-phone.png') });
});

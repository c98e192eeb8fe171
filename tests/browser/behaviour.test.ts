/** A net as material: whatever hands do to it in the first minute, somebody could weave it. */
import { join } from 'node:path';
import { beforeAll, beforeEach, expect, test } from 'vitest';
import type { Chebnet } from '../../wasm/chebnet';
import { decodeScene } from '../../web/src/document/share';
import { load } from '../wasm/load';
import { distance, largestDeviation } from './geometry';
import { drawn, openForResearch, OUTPUT, room, type Script, type Visit, visits } from './page';

declare global {
  interface Window {
    afterFlip: Promise<void>;
  }
}

const DOME = 'dome:vertices=2000,reach=55';

const site = visits();
let chebnet: Chebnet;
let visit: Visit;
let script: Script;
beforeAll(async () => {
  chebnet = await load();
});
beforeEach(async () => {
  visit = await site.share();
  ({ script } = visit);
});

/** Chooses from a list of the panel. */
async function choose(behaviour: RegExp): Promise<void> {
  const list = visit.page.locator('label', { hasText: 'The net' }).getByRole('combobox');
  const texts = await list.locator('option').allTextContents();
  await list.selectOption({ label: texts.find((text) => behaviour.test(text))! });
  await script.settled();
}

/** Takes the last handle and moves it by so many pixels. */
async function drag(by: [number, number], steps = 12): Promise<void> {
  const { mouse } = visit.page;
  const vertex = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);
  const { x, y } = await script.screenPosition(vertex);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + by[0], y + by[1], { steps });
  await mouse.up();
  await script.settled();
}

/** Of all corners of the quads, in degrees. */
function smallestAngle(quads: readonly (readonly number[])[], positions: Float64Array): number {
  const side = (from: number, to: number) => [0, 1, 2].map((i) => positions[3 * to + i]! - positions[3 * from + i]!);
  const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, value, i) => sum + value * b[i]!, 0);
  const angles = quads.flatMap((quad) =>
    quad.map((corner, i) => {
      const [a, b] = [side(corner, quad[(i + 1) % 4]!), side(corner, quad[(i + 3) % 4]!)];
      return (Math.acos(dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b))) * 180) / Math.PI;
    }),
  );
  return Math.min(...angles);
}

/** A sheet of n × n unit squares, as OBJ. */
function sheetText(n: number): string {
  const range = [...Array(n + 1).keys()];
  const vertices = range.flatMap((j) => range.map((i) => `v ${i} ${j} 0`));
  const at = (i: number, j: number) => j * (n + 1) + i + 1;
  const inner = range.slice(1);
  const faces = inner.flatMap((j) =>
    inner.map((i) => `f ${at(i - 1, j - 1)} ${at(i, j - 1)} ${at(i, j)} ${at(i - 1, j)}`),
  );
  return [...vertices, ...faces, ''].join('\n');
}

/** RMS of how far vertices are apart. */
function apart(a: Float64Array, b: Float64Array): number {
  return Math.sqrt(a.reduce((sum, value, i) => sum + (value - b[i]!) ** 2, 0) / (a.length / 3));
}

test('the first net stays one that could be woven: pushed down, aside and far, and back to where it was', async () => {
  const editor = chebnet.openRecipe(DOME);
  const quads = [...editor.toObj().matchAll(/^f (\d+) (\d+) (\d+) (\d+)$/gm)].map((face) =>
    face.slice(1).map((index) => Number(index) - 1),
  );
  const length = editor.info.meanLength;
  editor.dispose();

  await choose(/keeps its shape/);
  const edges = await visit.page.evaluate(() => window.chebnet.edges());
  const rest = await script.positions();
  const vertex = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);
  const home = await script.position(vertex);
  const ways: [string, [number, number]][] = [
    ['down', [0, 110]],
    ['aside', [166, -55]],
    ['far', [-460, 138]],
  ];
  for (const [way, by] of ways) {
    await drag(by);
    await visit.page.screenshot({ path: join(OUTPUT, `behaviour-${way}.png`) });
    const positions = await script.positions();
    expect(smallestAngle(quads, positions), way).toBeGreaterThan(29.99);
    expect(largestDeviation(positions, edges, length), way).toBeLessThan(1e-9);
  }
  await script.move(vertex, home);
  await script.settled();
  expect(apart(await script.positions(), rest)).toBeLessThan(0.02 * length);
});

test('neither the machine nor the hand decides the shape: one that is slow and has two pictures, one that has forty', async () => {
  await choose(/keeps its shape/);
  const editor = chebnet.openRecipe(DOME);
  const length = editor.info.meanLength;
  editor.dispose();
  const session = await visit.page.context().newCDPSession(visit.page);
  const ends: Float64Array[] = [];
  for (const { rate, steps } of [
    { rate: 1, steps: 40 },
    { rate: 8, steps: 2 },
  ]) {
    await session.send('Emulation.setCPUThrottlingRate', { rate });
    await drag([120, 70], steps);
    ends.push(await script.positions());
    await visit.page.keyboard.press('Control+Z');
    await script.settled();
  }
  await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  await session.detach();
  expect(apart(ends[0]!, await script.positions())).toBeGreaterThan(0.5 * length);
  expect(apart(ends[0]!, ends[1]!)).toBeLessThan(0.005 * length);
});

test('a hand that goes beyond what the net can reach holds it there; the handle comes back to it', async () => {
  const recipe = 'dome:vertices=500,reach=55';
  await script.open({ recipe });
  await script.settled();
  const vertex = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.vertex);
  const rest = await script.positions();
  const edges = await visit.page.evaluate(() => window.chebnet.edges());
  const length = chebnet.openRecipe(recipe).info.meanLength;
  const { mouse } = visit.page;
  const { x, y } = await script.screenPosition(vertex);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 420, y - 60, { steps: 8 });
  await script.settled();
  await visit.page
    .locator('.status-words', { hasText: 'As far as the net goes: every edge keeps its length' })
    .waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-held-back.png') });
  const held = await script.positions();
  expect(largestDeviation(held, edges, length)).toBeLessThan(1e-9);
  expect(apart(held, rest)).toBeGreaterThan(length);

  await mouse.up();
  await script.settled();
  await visit.page.locator('.status-words', { hasText: /^Every edge keeps its length/ }).waitFor();
  const letGo = await script.positions();
  expect(apart(letGo, held)).toBeLessThan(0.05 * length);
  const stands = Array.from(letGo.slice(3 * vertex, 3 * vertex + 3));
  expect(await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.target)).toEqual(stands);

  const notice = visit.page.locator('.stuck-notice');
  const said = await notice.evaluateHandle((element) => {
    const all: string[] = [];
    const note = () => all.push(element.textContent ?? '');
    new MutationObserver(note).observe(element, { subtree: true, childList: true, characterData: true });
    return all;
  });
  await notice.getByRole('button', { name: 'Let edges grow' }).click();
  await notice.getByText(/^Edges are \d+\.\d % longer\.$/).waitFor();
  await script.settled();
  // Nothing is said any more of lengths that are no longer those.
  expect((await said.jsonValue()).filter((text) => text.includes('does not reach'))).toEqual([]);
  const grown = await script.positions();
  const end = (k: 0 | 1) => grown.subarray(3 * edges[k]!, 3 * edges[k]! + 3);
  const longer = Math.hypot(...end(0).map((coordinate, axis) => coordinate - end(1)[axis]!));
  expect(longer).toBeGreaterThan(1.01 * length);
  expect(largestDeviation(grown, edges, longer)).toBeLessThan(1e-9);
  const asked = await visit.page.evaluate(() => window.chebnet.handles().at(-1)!.target);
  expect(asked).toEqual(Array.from(grown.slice(3 * vertex, 3 * vertex + 3)));
  const wayOf = (place: readonly number[]) => Math.hypot(...place.map((each, axis) => each - rest[3 * vertex + axis]!));
  expect(wayOf(asked)).toBeGreaterThan(wayOf(stands) + length);
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-grown.png') });

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  await notice.getByText('Edges are').waitFor({ state: 'detached' });
  expect(largestDeviation(await script.positions(), edges, length)).toBeLessThan(1e-9);
  expect(apart(await script.positions(), letGo)).toBeLessThan(0.05 * length);

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(apart(await script.positions(), rest)).toBeLessThan(0.01 * length);
});

test('longer edges that take the net out of the picture are followed by the view, which else stays', async () => {
  await script.open({ recipe: 'dome:vertices=500,reach=55' });
  await script.settled();
  await visit.page.getByText('History', { exact: true }).waitFor();
  const [corner, other] = await visit.page.evaluate(() => window.chebnet.handles().map(({ vertex }) => vertex));
  const edges = visit.page.getByRole('slider', { name: 'Edges' });
  const { mouse } = visit.page;
  await mouse.move(600, 760);
  await mouse.down();
  await mouse.move(480, 740, { steps: 4 });
  await mouse.up();
  const before = await script.screenPosition(corner!);
  await edges.press('ArrowRight');
  await script.settled();
  await drawn(visit.page);
  const after = await script.screenPosition(corner!);
  expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeLessThan(1e-6);

  await mouse.move(470, 400);
  while ((await room(visit.page)) > 25) {
    await mouse.wheel(0, -30);
    await drawn(visit.page);
  }
  const slope = async () => {
    const [a, b] = [await script.screenPosition(corner!), await script.screenPosition(other!)];
    return Math.atan2(b.y - a.y, b.x - a.x);
  };
  const slopeBefore = await slope();
  await edges.press('End');
  await script.settled();
  await expect.poll(() => room(visit.page)).toBeGreaterThan(40);
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-longer-edges.png') });
  expect(Math.abs((await slope()) - slopeBefore)).toBeLessThan(0.1);
});

async function lowest(): Promise<number> {
  return Math.min(...(await script.positions()).filter((_, i) => i % 3 === 2));
}

test('cloth with gravity hangs between its handles; undo takes both choices back', async () => {
  await script.open({ recipe: 'sheet:vertices=400' });
  await script.settled();
  await choose(/soft cloth/);
  await visit.page.locator('summary', { hasText: /^History/ }).click();
  await visit.page.getByText('The net is soft cloth', { exact: true }).waitFor();
  const weight = visit.page.getByRole('slider', { name: 'Gravity' });
  await weight.focus();
  for (let i = 0; i < 3; ++i) await weight.press('ArrowRight');
  await weight.blur();
  await script.settled();
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-cloth.png') });
  expect(await lowest()).toBeLessThan(-0.1);
  await visit.page.getByText('Gravity: 3 of 9', { exact: true }).waitFor();

  for (let i = 0; i < 4; ++i) await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(await lowest()).toBeGreaterThan(-1e-6);
});

/** Rhombi of this sharp angle, in degrees, with edges of length 1. */
function rhombi(size: number, angle: number): string {
  const [c, s] = [Math.cos(angle / (180 / Math.PI)), Math.sin(angle / (180 / Math.PI))];
  const places = Array.from({ length: size * size }, (_, v) => [v % size, Math.floor(v / size)] as const);
  const faces = places.flatMap(([i, j], v) =>
    i + 1 < size && j + 1 < size ? [`f ${v + 1} ${v + 2} ${v + size + 2} ${v + size + 1}`] : [],
  );
  return [...places.map(([i, j]) => `v ${i + j * c} ${j * s} 0`), ...faces].join('\n');
}

test('a net that comes nearly closed is opened, which is said, and undone where it is not wanted', async () => {
  const obj = rhombi(8, 20);
  const came = chebnet.openObj(obj).restPositions;
  await script.open({ obj, name: 'rhombi.obj' });
  await script.settled();
  const notice = visit.page.locator('.sharp-notice');
  await notice.getByText('49 quads were nearly closed').waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-opened.png') });
  expect(apart(await script.positions(), came)).toBeGreaterThan(0.1);
  await notice.getByRole('button', { name: 'Leave it as it came' }).click();
  await script.settled();
  expect(apart(await script.positions(), came)).toBeLessThan(1e-3);
  expect(await notice.innerText()).toBe('');
  const limit = async () => {
    const { options } = decodeScene(new URL(await visit.page.evaluate(() => window.chebnet.link())).hash);
    return options['shear_limit'];
  };
  expect(await limit()).toBe(0);
  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(apart(await script.positions(), came)).toBeGreaterThan(0.1);
  expect(await limit()).toBeUndefined();
});

test('edges become longer or shorter on wish, all by one factor; undo takes that back', async () => {
  const { page } = visit;
  await script.open({ recipe: DOME });
  await script.settled();
  const before = await script.positions();
  const edges = await page.evaluate(() => window.chebnet.edges());
  const length = distance(
    before.subarray(3 * edges[0]!, 3 * edges[0]! + 3),
    before.subarray(3 * edges[1]!, 3 * edges[1]! + 3),
  );
  const slider = page.getByRole('slider', { name: 'Edges' });
  expect(await slider.getAttribute('aria-valuetext')).toBe('as made');
  await slider.fill('34');
  await slider.press('ArrowRight');
  await script.settled();
  await expect.poll(() => slider.getAttribute('aria-valuetext')).toBe('+10 %');
  await page.screenshot({ path: join(OUTPUT, 'behaviour-longer.png') });
  expect(largestDeviation(await script.positions(), edges, 1.1 * length)).toBeLessThan(1e-6);
  await script.open({ recipe: 'sheet:vertices=100' });
  expect(await slider.getAttribute('aria-valuetext')).toBe('as made');
  // One after the other: while a net is opened again, undo goes nowhere.
  for (let i = 0; i < 3; ++i) {
    await page.keyboard.press('Control+z');
    await script.settled();
  }
  expect(await slider.getAttribute('aria-valuetext')).toBe('as made');
  expect(apart(await script.positions(), before)).toBeLessThan(1e-3 * length);
});

test('keys of a slider count as fast as they come; what they broke leads back to what was right', async () => {
  await script.open({ recipe: 'vault:vertices=300' });
  await script.settled();
  const before = await script.positions();
  const { page } = visit;
  const slider = page.getByRole('slider', { name: 'Edges' });
  const notice = page.locator('.stuck-notice');
  // The numbers of the page follow a few times a second.
  await page.locator('.status-words', { hasText: /^Every edge keeps its length/ }).waitFor();
  await slider.focus();
  for (let i = 0; i < 4; ++i) await slider.press('ArrowRight');
  expect(await slider.getAttribute('aria-valuetext')).toBe('+4 %');
  await script.settled();
  expect(await slider.getAttribute('aria-valuetext')).toBe('+4 %');
  // A choice, not a way out: nothing to be told.
  expect(await notice.getByText('Edges are').count()).toBe(0);
  await slider.press('Home');
  await script.settled();
  await notice.getByText(/out of reach/).waitFor();
  const link = await page.evaluate(() => window.chebnet.link());

  await notice.getByRole('button', { name: 'Back to the last good shape' }).click();
  await notice.getByRole('button').first().waitFor({ state: 'detached' });
  await script.settled();
  expect(await slider.getAttribute('aria-valuetext')).toBe('as made');
  expect(apart(await script.positions(), before)).toBeLessThan(1e-6);

  // Who gets the link is told, too; at rest edges are as they were made.
  const receiver = await site.arrive(link);
  const told = receiver.page.locator('.stuck-notice');
  await told.getByRole('button', { name: 'Let edges grow' }).waitFor();
  expect(await told.getByRole('button', { name: 'Back to the last good shape' }).count()).toBe(0);
  await receiver.page.getByRole('button', { name: 'Reset', exact: true }).click();
  await told.getByRole('button').first().waitFor({ state: 'detached' });
  expect(await receiver.page.getByRole('slider', { name: 'Edges' }).getAttribute('aria-valuetext')).toBe('as made');
  expect(apart(await receiver.script.positions(), before)).toBeLessThan(1e-6);
});

test('that no length of edges is enough stands until something is changed', async () => {
  await script.open({ recipe: 'vault:vertices=100' });
  await script.settled();
  const { vertex, target } = (await visit.page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(vertex, [target[0], target[1], target[2] + 1000]);
  await script.settled();
  const notice = visit.page.locator('.stuck-notice');
  await notice.getByRole('button', { name: 'Let edges grow' }).click();
  await notice.getByText('No length').waitFor();
  // Whatever leaves the net alone.
  await visit.page.locator('canvas').first().press('5');
  await drawn(visit.page);
  await script.settled();
  expect(await notice.getByText('No length').isVisible()).toBe(true);
  await script.move(vertex, [target[0], target[1], target[2] + 900]);
  await script.settled();
  await notice.getByText(/out of reach/).waitFor();
});

test('a net that is crumpled says so where it is, with ways out that lead to a smooth one', async () => {
  const { page } = visit;
  await script.open({ recipe: 'sheet:vertices=225' });
  await choose(/lengths alone|only its lengths/);
  await script.setHandles([{ vertex: 0 }, { vertex: 224 }]);
  await script.settled();
  const notice = page.locator('.stuck-notice');
  expect(await notice.textContent()).toBe('');
  await page.evaluate(() => {
    const [first, last] = window.chebnet.handles().map(({ target }) => target);
    const towards = (part: number) => first!.map((x, i) => x + part * (last![i]! - x)) as [number, number, number];
    return window.chebnet.move(224, towards(0.15));
  });
  await script.settled();
  await notice.getByText('crumpled').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'crumpled.png') });
  await notice.getByRole('button', { name: 'Bring it to rest' }).click();
  await script.settled();
  await expect.poll(() => notice.textContent()).toBe('');
});

test('quads that want to be square become so, and undo takes that back', async () => {
  await script.open({ obj: rhombi(6, 60), name: 'rhombi.obj' });
  await script.settled();
  await choose(/straight rods/);
  const quads = Array.from({ length: 25 }, (_, q) => {
    const corner = 6 * Math.floor(q / 5) + (q % 5);
    return [corner, corner + 1, corner + 7, corner + 6];
  });
  const came = smallestAngle(quads, await script.positions());
  expect(came).toBeCloseTo(60, 1);
  const quadsWant = visit.page.locator('label', { hasText: /^Quads/ }).getByRole('combobox');
  await quadsWant.selectOption({ label: 'square' });
  await script.settled();
  expect(smallestAngle(quads, await script.positions())).toBeGreaterThan(89);
  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(await quadsWant.inputValue()).toBe('atRest');
});

test('warp and weft of a sheet are set against each other; a net without the two is not asked for them', async () => {
  const balance = visit.page.getByRole('slider', { name: 'Warp : weft' });
  await script.open({ recipe: 'sheet:vertices=121' });
  await script.settled();
  await balance.waitFor();
  expect(await balance.getAttribute('aria-valuetext')).toBe('1 : 1');
  await drag([0, -120]);
  const alike = await script.positions();
  await balance.focus();
  await balance.press('ArrowRight');
  await balance.blur();
  await script.settled();
  expect(await balance.getAttribute('aria-valuetext')).toBe('4 : 1');
  expect(apart(await script.positions(), alike)).toBeGreaterThan(1e-3);
  await visit.page.screenshot({ path: join(OUTPUT, 'behaviour-warp.png') });
  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(await balance.getAttribute('aria-valuetext')).toBe('1 : 1');
  expect(apart(await script.positions(), alike)).toBeLessThan(1e-3);

  await script.open({ recipe: 'jack:vertices=300' });
  await script.settled();
  await balance.waitFor({ state: 'hidden' });
});

/** A flat strip of squares along x. */
function strip(long: number, wide: number): string {
  const places = Array.from({ length: long * wide }, (_, v) => [v % long, Math.floor(v / long)] as const);
  const faces = places.flatMap(([i, j], v) =>
    i + 1 < long && j + 1 < wide ? [`f ${v + 1} ${v + 2} ${v + long + 2} ${v + long + 1}`] : [],
  );
  return [...places.map(([i, j]) => `v ${i} ${j} 0`), ...faces].join('\n');
}

test('a strip that has buckled is pushed through to the other side, and back by undo; one that has not comes back', async () => {
  const [long, wide] = [16, 4];
  await script.open({ obj: strip(long, wide), name: 'strip.obj' });
  const ends = Array.from({ length: wide }, (_, j) => [j * long, j * long + long - 1]).flat();
  const middle = Math.floor(long / 2);
  const height = async () => (await script.position(middle))[2];
  const dragging = visit.page.locator('details', { hasText: 'Flip through' });
  const flip = dragging.getByRole('button', { name: 'Flip through' });

  // Pulled taut it has one shape.
  await script.setHandles(ends.map((vertex) => ({ vertex, target: [vertex % long, Math.floor(vertex / long), 0] })));
  await script.settled();
  if (!(await flip.isVisible())) await dragging.locator('summary').click();
  await flip.click();
  await dragging.getByText('It is back').waitFor();

  const pressed = (vertex: number) => ({
    vertex,
    target: [vertex % long === 0 ? 1 : long - 2, Math.floor(vertex / long), 0] as [number, number, number],
  });
  await script.setHandles([...ends.map(pressed), { vertex: middle, target: [middle, 0, 2] }]);
  await script.settled();
  await script.setHandles(ends.map(pressed));
  await script.settled();
  const before = await script.positions();
  expect(await height()).toBeGreaterThan(1);

  // Asked in the moment of the click, too, nothing is settled until it is through.
  await visit.page.evaluate(() =>
    addEventListener('click', () => (window.afterFlip = window.chebnet.settled()), { once: true }),
  );
  await flip.click();
  await visit.page.evaluate(() => window.afterFlip);
  expect(await height()).toBeLessThan(-1);
  const mirrored = before.map((x, i) => (i % 3 === 2 ? -x : x));
  expect(apart(await script.positions(), mirrored)).toBeLessThan(1e-3);
  expect(await dragging.getByText('It is back').count()).toBe(0);

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  expect(apart(await script.positions(), before)).toBeLessThan(1e-6);

  // A tube would come out crumpled; it goes back, and nothing has been done.
  await script.open({ recipe: 'tube:vertices=300' });
  await script.settled();
  const tube = await script.positions();
  await flip.click();
  await dragging.getByText('It is back').waitFor();
  expect(apart(await script.positions(), tube)).toBe(0);
});

test('a strip that stands as an arch against its weight is found to hang, once it is looked for; undo has the arch again', async () => {
  const [long, wide] = [16, 4];
  await script.open({ obj: strip(long, wide), name: 'strip.obj' });
  const middle = Math.floor(long / 2);
  const height = async () => (await script.position(middle))[2];
  const ends = Array.from({ length: wide }, (_, j) => [j * long, j * long + long - 1]).flat();
  const pressed = ends.map((vertex) => ({
    vertex,
    target: [vertex % long === 0 ? 1 : long - 2, Math.floor(vertex / long), 0] as [number, number, number],
  }));
  await visit.page.evaluate(() => window.chebnet.setOptions({ gravity: 1e-4 }));
  await script.setHandles([...pressed, { vertex: middle, target: [middle, 0, 2] }]);
  await script.settled();
  await script.setHandles(pressed);
  await script.settled();
  const arch = await script.positions();
  expect(await height()).toBeGreaterThan(1);

  const dragging = visit.page.locator('details', { hasText: 'Relax further' });
  const relax = dragging.getByRole('button', { name: 'Relax further' });
  if (!(await relax.isVisible())) await dragging.locator('summary').click();
  await relax.click();
  await dragging.getByText(/^Found: [\d.]+ % less strained/).waitFor();
  await script.settled();
  expect(await height()).toBeLessThan(-1);
  // From there no less is found.
  await relax.click();
  await dragging.getByText('No shape at rest that is less strained').waitFor();
  await script.settled();
  expect(await height()).toBeLessThan(-1);

  await visit.page.keyboard.press('Control+z');
  await script.settled();
  // Solved again, what is at rest moves by a part of what counts as rest.
  expect(apart(await script.positions(), arch)).toBeLessThan(1e-5);
});

test('a search for less strain that is stopped leaves net and history as they were', async () => {
  const { page } = visit;
  await script.open({ recipe: 'vault:vertices=4000' });
  const { vertex, target } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await script.move(vertex, [target[0] - 6, target[1] + 3, target[2] - 4]);
  await script.settled();
  const before = await script.positions();

  const relax = page.locator('.relax');
  await page.locator('details', { has: relax }).locator('summary').click();
  await relax.getByRole('button', { name: 'Relax further' }).click();
  // One way may take most of the time: what is said moves on meanwhile.
  const said = relax.getByText(/Looking… [1-9]/);
  await said.waitFor();
  const texts = new Set<string>();
  const parts = new Set<string>();
  await expect
    .poll(
      async () => {
        const text = await said.innerText();
        texts.add(text);
        parts.add(text.match(/\d+ %/)![0]);
        return texts.size;
      },
      { interval: 50 },
    )
    .toBeGreaterThan(8);
  expect(parts.size).toBeLessThan(texts.size);
  await relax.getByRole('button', { name: 'Stop looking' }).click();
  await relax.getByRole('button', { name: 'Relax further' }).waitFor();
  expect(await relax.getByRole('status').innerText()).toBe('');
  await script.settled();
  expect(apart(await script.positions(), before)).toBe(0);
  await page.locator('summary', { hasText: /^History/ }).click();
  await page.locator('.history [aria-current]', { hasText: /^Move handle/ }).waitFor();
});

test('the solver has the settings that its method reads, and no others', async () => {
  const { page } = visit;
  await openForResearch(page, 'Solver');
  const solver = page.locator('details.section', { has: page.locator('summary', { hasText: /^Solver$/ }) }).last();
  await solver.locator('summary', { hasText: 'More settings' }).click();
  const shown = () =>
    solver.locator('.row:visible > span').evaluateAll((all) => all.map((each) => each.textContent ?? ''));
  const use = (name: string) => solver.locator('select').first().selectOption(name);
  expect(await shown()).toEqual(expect.arrayContaining(['Shear limit', 'Bending weight', 'Threshold']));
  expect(await shown()).not.toContain('p start');
  await use('li2022');
  await expect.poll(shown).toContain('p start');
  expect(await shown()).not.toContain('Shear limit');
  await page.screenshot({ path: join(OUTPUT, 'solver-li2022.png') });
  await use('arap');
  await expect.poll(shown).not.toContain('p start');
  expect(await shown()).toEqual(
    expect.arrayContaining(['Threshold', 'Energy tolerance', 'Gradient tolerance', 'Max iterations', 'Length scale']),
  );
  expect(await shown()).toHaveLength(2 + 5); // with method and initialisation
});

test('stages have the names that their method gives them', async () => {
  const { page } = visit;
  await openForResearch(page, 'Convergence');
  const stage = page.locator('.numbers div', { hasText: /^Stage/ }).locator('dd');
  await page.locator('summary', { hasText: /^Convergence$/ }).click();
  for (const [method, names] of [
    ['equilibrium', /^(To the handles|To rest)$/],
    ['projection', /^(Rigid start|Springs|Exact lengths)$/],
    ['li2022', /^(Small exponent|Large exponent|Worst edges)$/],
  ] as const) {
    await page.evaluate((name) => window.chebnet.setOptions({ method: name }), method);
    await drag([-30, -20]);
    await expect.poll(() => stage.textContent(), { message: method }).toMatch(names);
  }
  await page.screenshot({ path: join(OUTPUT, 'stages.png') });
});

test('colours of the corners go up to the limit that is chosen, and a net without handles is not left to fall', async () => {
  const { page } = visit;
  await page.locator('select:has(option[value=shear])').selectOption('shear', { force: true });
  const legend = page.locator('.legend .ticks');
  await expect.poll(() => legend.textContent()).toContain('limit 60°');
  await page.getByRole('slider', { name: 'Corners' }).fill('9');
  await expect.poll(() => legend.textContent()).toContain('limit 45°');
  await script.settled();

  // As a file comes: with no handles.
  await script.open({ obj: sheetText(8), name: 'sheet.obj' });
  await script.settled();
  const before = await script.positions();
  await page.getByRole('slider', { name: 'Gravity' }).fill('5');
  await expect.poll(() => page.getByText('Nothing holds the net').isVisible()).toBe(true);
  await script.settled();
  expect(apart(await script.positions(), before)).toBeLessThan(0.01);
});

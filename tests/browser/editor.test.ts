/** What a visitor does: look, drag, cancel, add, remove, undo, open files; by real pointer, keyboard and file events. */
import { createHash } from 'node:crypto';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, test } from 'vitest';
import type { ChebnetError } from '../../wasm/chebnet';
import { load } from '../wasm/load';
import { distance, dragBy, largestDeviation, largestError } from './geometry';
import type { Script, Visit } from './page';
import { MOVING, OUTPUT, README_PICTURE, allSections, drawn, visits } from './page';

declare global {
  interface Window {
    linkMade: Promise<string>;
  }
}

const SHAPE = 'vault:vertices=1000';

const chebnet = await load();
const reference = chebnet.openRecipe(SHAPE);
const { edges, restPositions, suggestedHandles } = reference;
const { meanLength } = reference.info;
const dragged = suggestedHandles.at(-1)!;

const { address, arrive, open, share } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await share(MOVING);
  ({ script } = visit);
});

test('a visitor sees a net soon, with handles and a line that says what to do', async () => {
  const began = Date.now();
  const fresh = await arrive('', MOVING);
  const waited = Date.now() - began;
  console.log(`first net after ${waited} ms`);
  expect(waited).toBeLessThan(10_000); // about 1 s if the machine has nothing else to do
  expect((await fresh.script.stats()).handles).toBeGreaterThan(1);
  expect(await fresh.page.locator('body').innerText()).toMatch(/drag/i);
});

test('the page brings its own strict content security policy', async () => {
  const meta = visit.page.locator('meta[http-equiv="Content-Security-Policy" i]');
  const policy = (await meta.getAttribute('content')) ?? '';
  expect(policy).not.toMatch(/'unsafe-eval'/);
  const inline = await visit.page
    .locator('script:not([src])')
    .evaluateAll((all) => all.map((each) => each.textContent));
  const hashes = inline.map((text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`);
  expect(hashes).toHaveLength(1);
  expect(/script-src ([^;]*)/.exec(policy)?.[1]?.split(' ').sort()).toEqual(
    ["'self'", "'wasm-unsafe-eval'", ...hashes].sort(),
  );
});

/** The lines that are drawn of each shape in the gallery, as long as they are in pixels. */
function drawnLines(page: Page): Promise<number[]> {
  return page.locator('.gallery .picture').evaluateAll((all) =>
    all.map((picture) => {
      const [box, paths] = [picture.getBoundingClientRect(), [...picture.querySelectorAll('path')]];
      const isInside = ({ left, right, top, bottom }: DOMRect) =>
        left >= box.left && right <= box.right && top >= box.top && bottom <= box.bottom;
      if (!paths.every((path) => isInside(path.getBoundingClientRect()))) return NaN;
      return paths.reduce((sum, path) => sum + path.getTotalLength() * path.getScreenCTM()!.a, 0);
    }),
  );
}

test('every shape has its picture, and a relaxed one can be dragged', async () => {
  const { page, script } = await arrive();
  const pictures = chebnet.shapes().length - 1; // the folded torus is not shown
  const areDrawn = (lengths: number[]) => lengths.length === pictures && lengths.every((length) => length > 300);
  await expect.poll(() => drawnLines(page)).toSatisfy(areDrawn);

  await script.open({ recipe: 'teddy:vertices=1000' });
  await script.settled();
  const handles = await page.evaluate(() => window.chebnet.handles());
  await dragBy(script, handles.at(-1)!.vertex, [40, -30]);
  await script.settled();
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-6);
});

test('sliders of a shape say which of them are angles', async () => {
  const { page } = visit;
  await allSections(page);
  const unitOf = (name: string) =>
    page
      .locator('.parameters label', { hasText: name })
      .locator('output')
      .evaluate((each) => getComputedStyle(each, '::after').content);
  expect([await unitOf('Reach'), await unitOf('Vertices')]).toEqual(['"°"', '""']);
  await script.open({ recipe: 'tube' });
  expect([await unitOf('Bend'), await unitOf('Aspect')]).toEqual(['"°"', '""']);
});

test('sections that could not be loaded come with the next net', async () => {
  const { page, script: own, complaints } = await open('licences.txt');
  let isCutOff = true;
  await page.route(/late_sections-[^/]*\.js$/, (route) => (isCutOff ? route.abort('aborted') : route.continue()));
  await page.goto(address());
  await page.getByText('This part of the page could not be loaded').waitFor();
  complaints.length = 0;
  isCutOff = false;
  await own.open({ recipe: SHAPE });
  await allSections(page);
});

test('the first net can be looked at', async () => {
  await script.settled();
  await visit.page.screenshot({ path: join(OUTPUT, 'first-desktop.png') });
  await visit.page.setViewportSize({ width: 390, height: 844 });
  await drawn(visit.page);
  await visit.page.screenshot({ path: join(OUTPUT, 'first-phone.png') });
  const overflow = await visit.page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
});

test('a double click opens one dialog, also while its program is being loaded', async () => {
  for (const label of ['Share', 'Keys', 'On a surface…']) {
    const { page } = await arrive();
    await allSections(page);
    await page.getByRole('button', { name: label, exact: true }).dblclick();
    await page.locator('dialog[open]').first().waitFor();
    await drawn(page);
    expect(await page.locator('dialog[open]').count(), label).toBe(1);
  }
});

test('the sidebar can be hidden, and a section that is opened at its lower end comes into sight', async () => {
  const { page } = visit;
  const widthOf = async (selector: string) => (await page.locator(selector).boundingBox())!.width;
  const before = await widthOf('#view');
  const hide = page.getByRole('button', { name: 'Hide the controls' });
  await hide.click();
  expect(await widthOf('#view')).toBeGreaterThan(before + 250);
  expect(await page.getByText('Shape', { exact: true }).isVisible()).toBe(false);
  await hide.click();
  expect(await widthOf('#view')).toBe(before);

  await page.locator('summary', { hasText: 'Dragging' }).click();
  const last = page.getByText('Always show reach');
  const sidebar = (await page.locator('.sections').boundingBox())!;
  await expect
    .poll(async () => {
      const { y, height } = (await last.boundingBox())!;
      return y + height;
    })
    .toBeLessThan(sidebar.y + sidebar.height);

  await page.setViewportSize({ width: 820, height: 1180 });
  await expect.poll(() => widthOf('.sidebar')).toBeLessThan(0.36 * 820);
});

test('the first handle, dragged up to the tools, can be taken again: the view follows', async () => {
  const { page } = visit;
  const handle = async () => (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const { vertex } = await handle();
  const at = await script.screenPosition(vertex);
  await dragBy(script, vertex, [0, 40 - at.y]);
  await script.settled();
  const tools = (await page.getByRole('group', { name: 'Actions' }).boundingBox())!;
  await expect.poll(async () => (await script.screenPosition(vertex)).y).toBeGreaterThan(tools.y + tools.height + 10);
  const before = (await handle()).target;
  await dragBy(script, vertex, [0, 30]);
  await script.settled();
  expect(distance((await handle()).target, before)).toBeGreaterThan(0);
});

test('where corners at their limit keep it back, that is said', async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: 'sheet:vertices=400' });
  await script.settled();
  // Two opposite corners: what is between them is sheared as they go apart.
  const rest = await script.positions();
  const along = (vertex: number) => rest[3 * vertex]! + rest[3 * vertex + 1]!;
  const vertices = Array.from({ length: rest.length / 3 }, (_, vertex) => vertex).sort((a, b) => along(a) - along(b));
  const [near, far] = [vertices[0]!, vertices.at(-1)!];
  await script.setHandles([{ vertex: near }, { vertex: far, anchor: false }]);
  await script.settled();
  // From farther away there is room for that.
  await visit.page.mouse.move(450, 400);
  for (let turn = 0; turn < 4; turn++) await visit.page.mouse.wheel(0, 300);
  const ends = () => Promise.all([near, far].map((vertex) => script.screenPosition(vertex)));
  await expect.poll(async () => Math.abs((await ends()).reduce((x, end) => end.x - x, 0))).toBeLessThan(250);
  const [a, b] = await ends();
  await dragBy(script, far, [0.7 * (b!.x - a!.x), 0.7 * (b!.y - a!.y)]);
  await script.settled();
  await visit.page
    .getByText('With edges of this length and no corner sharper than 30° the net reaches no farther.')
    .waitFor();
});

test('what is said of that lies on no handle, and stays where it is while one is dragged on', async () => {
  visit = await share();
  ({ script } = visit);
  const { page } = visit;
  await script.open({ recipe: 'saddle' });
  await script.settled();
  const handles = await page.evaluate(() => window.chebnet.handles());
  await dragBy(script, handles.at(-1)!.vertex, [150, -220]);
  await script.settled();
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  const { x, y, width, height } = (await message.boundingBox())!;
  for (const { vertex } of handles) {
    const at = await script.screenPosition(vertex);
    expect([at.x - x, at.y - y, x + width - at.x, y + height - at.y].some((within) => within < -5)).toBe(true);
  }
  const { vertex } = handles.at(-1)!;
  const from = await script.screenPosition(vertex);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(x + width / 2, y + height / 2, { steps: 5 });
  expect(await message.boundingBox()).toEqual({ x, y, width, height });
  await page.mouse.up();
});

test('what is said of a net that has been pulled up lies beside it, and beside the line below the title', async () => {
  visit = await share();
  ({ script } = visit);
  const { page } = visit;
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await dragBy(script, vertex, [0, -240]);
  await script.settled();
  const message = page.locator('.stuck-notice .message');
  await message.waitFor();
  await drawn(page);
  const { x, y, width, height } = (await message.boundingBox())!;
  const net = await page.evaluate(() =>
    Array.from({ length: window.chebnet.stats().vertices }, (_, v) => window.chebnet.screenPosition(v)),
  );
  expect(net.filter((at) => at.x > x && at.x < x + width && at.y > y && at.y < y + height)).toEqual([]);
  const endOfLine = await page.locator('.title p:visible').evaluate((line) => {
    const words = document.createRange();
    words.selectNodeContents(line);
    return getComputedStyle(line).visibility === 'visible' ? words.getBoundingClientRect().right : NaN;
  });
  expect(endOfLine).toBeLessThan(x);
});

test('so far up that the net is larger than the picture: all of it is seen afterwards, and what is said can be dismissed', async () => {
  visit = await share({ viewport: { width: 390, height: 844 } });
  ({ script } = visit);
  const { page } = visit;
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const notice = page.getByText('the net reaches no farther');
  await expect
    .poll(async () => {
      const { y } = await script.screenPosition(vertex);
      await dragBy(script, vertex, [60, 30 - y]);
      await script.settled();
      return notice.isVisible();
    })
    .toBe(true);
  const outside = () =>
    page.evaluate(() => {
      const { right, bottom } = document.querySelector('#view')!.getBoundingClientRect();
      const places = Array.from({ length: window.chebnet.stats().vertices }, (_, v) =>
        window.chebnet.screenPosition(v),
      );
      return places.filter(({ x, y }) => x < 0 || x > right || y < 0 || y > bottom).length;
    });
  await expect.poll(outside).toBe(0);
  await page.screenshot({ path: join(OUTPUT, 'far-up-phone.png') });
  await page.getByRole('button', { name: 'Dismiss' }).click();
  expect(await notice.isVisible()).toBe(false);
});

test('after undo the view follows a handle that would be out of sight', async () => {
  const { page } = visit;
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  await dragBy(script, vertex, [-60, 0]);
  await script.settled();
  await page.locator('#view canvas').focus();
  for (let i = 0; i < 30; ++i) await page.keyboard.press('Shift+ArrowLeft');
  const seen = async () => (await script.screenPosition(vertex)).x;
  await expect.poll(async () => Math.abs((await seen()) - 640)).toBeGreaterThan(640);
  await page.keyboard.press('Control+z');
  const { x, width } = (await page.locator('#view').boundingBox())!;
  await expect.poll(seen).toBeLessThan(x + width);
  expect(await seen()).toBeGreaterThan(x);
});

test('standard views and parallel projection, by keys and buttons: a hand drags in the picture, and a link has both', async () => {
  const { page } = visit;
  await script.open({ recipe: SHAPE });
  await script.settled();
  await page.keyboard.press('7');
  await page.keyboard.press('5');
  /** Pixels to the right for each unit of x, from one vertex to others at other heights. */
  const scales = () =>
    page.evaluate(() => {
      const positions = window.chebnet.positions();
      const vertices = window.chebnet.handles().map(({ vertex }) => vertex);
      const [first, ...others] = vertices.map((vertex) => [
        window.chebnet.screenPosition(vertex).x,
        positions[3 * vertex]!,
      ]);
      return others.flatMap(([x, at]) =>
        Math.abs(at! - first![1]!) > 0.5 ? [(x! - first![0]!) / (at! - first![1]!)] : [],
      );
    });
  await expect.poll(async () => Math.max(...(await scales())) - Math.min(...(await scales()))).toBeLessThan(0.01);
  await page.screenshot({ path: join(OUTPUT, 'top-parallel.png') });
  const [scale = 0] = await scales();

  const [x, , z] = await script.position(dragged);
  await dragBy(script, dragged, [30, 0]);
  await script.settled();
  const [movedX, , movedZ] = await script.position(dragged);
  expect(movedX - x).toBeCloseTo(30 / scale, 2);
  expect(movedZ).toBeCloseTo(z, 3);
  const there = await arrive(await page.evaluate(() => window.chebnet.link()));
  const [here, seen] = [await script.screenPosition(dragged), await there.script.screenPosition(dragged)];
  expect(Math.hypot(here.x - seen.x, here.y - seen.y)).toBeLessThan(1);

  await page.getByText('Appearance', { exact: true }).click();
  expect(await page.getByLabel('Parallel projection').isChecked()).toBe(true);
  await page.getByRole('button', { name: 'Front', exact: true }).click();
  const height = () => page.evaluate((v) => window.chebnet.screenPosition(v).y, dragged);
  const fromTop = here.y;
  await expect.poll(height).not.toBeCloseTo(fromTop, 0);
  await page.screenshot({ path: join(OUTPUT, 'front-parallel.png') });
});

test('a net that is opened while the view coasts stands as if it had not been turned', async () => {
  const { page } = visit;
  await script.open({ recipe: SHAPE });
  await script.settled();
  const [still, canvas] = [await script.screenPosition(dragged), (await page.locator('#view canvas').boundingBox())!];
  await page.mouse.move(canvas.x + 12, canvas.y + canvas.height / 2);
  await page.mouse.down();
  const opened = page.evaluate(async (recipe) => {
    await new Promise((done) => addEventListener('pointerup', done, { once: true }));
    await window.chebnet.open({ recipe });
  }, SHAPE);
  await page.mouse.move(canvas.x + 400, canvas.y + canvas.height / 2, { steps: 2 });
  await page.mouse.up();
  await opened;
  for (let i = 0; i < 10; ++i) await drawn(page);
  const { x, y } = await script.screenPosition(dragged);
  expect(Math.hypot(x - still.x, y - still.y)).toBeLessThan(0.5);
});

test('a link that is made while the view moves knows where it goes', async () => {
  const { page } = visit;
  await page.evaluate(() => window.chebnet.link()); // What makes links has been loaded.
  await page.evaluate(() => {
    window.linkMade = new Promise((done) => addEventListener('keydown', done, { once: true })).then(() =>
      window.chebnet.link(),
    );
  });
  await page.keyboard.press('7');
  const there = await arrive(await page.evaluate(() => window.linkMade));
  const { vertex } = (await page.evaluate(() => window.chebnet.handles())).at(-1)!;
  const [here, seen] = [await script.screenPosition(vertex), await there.script.screenPosition(vertex)];
  expect(Math.hypot(here.x - seen.x, here.y - seen.y)).toBeLessThan(1);
});

test('edges as rods, live in a drag; a section plane leaves out what is beyond it, also for clicks, but no handle', async () => {
  const { page } = visit;
  await script.open({ recipe: SHAPE });
  await script.settled();
  const picture = () => page.locator('#view canvas').screenshot();
  await page.getByText('Appearance', { exact: true }).click();
  const lines = await picture();
  await page.getByLabel('Edges as rods').check();
  await expect.poll(picture).not.toEqual(lines);
  expect(await page.getByLabel('Thickness').inputValue()).toBe('12');
  await page.screenshot({ path: join(OUTPUT, 'rods.png') });
  const thin = await picture();
  await page.getByLabel('Thickness').fill('30');
  await expect.poll(picture).not.toEqual(thin);
  const still = await picture();
  await dragBy(script, dragged, [-30, -30], { atEnd: () => expect.poll(picture).not.toEqual(still) });
  await script.settled();

  const whole = await picture();
  await page.getByLabel('Section').selectOption('x');
  await expect.poll(picture).not.toEqual(whole);
  await page.screenshot({ path: join(OUTPUT, 'section.png') });
  const [first, last] = [restPositions.length / 6, restPositions.length / 3 - 1].map((vertex) => Math.floor(vertex));
  const count = async () => (await script.stats()).handles;
  const before = await count();
  const beyond = suggestedHandles.find((vertex) => restPositions[3 * vertex]! > meanLength)!;
  const inside = (x: number) => {
    for (let v = first!; v < last!; ++v) if (Math.abs(restPositions[3 * v]! - x) < meanLength) return v;
    throw new Error('no such vertex');
  };
  const clickOn = async (vertex: number) => {
    const { x, y } = await script.screenPosition(vertex);
    await page.mouse.click(x, y);
  };
  await clickOn(inside(restPositions[3 * beyond]! / 2));
  await clickOn(beyond); // a handle: it is selected
  await page.getByRole('group', { name: 'Selected handles' }).waitFor();
  expect(await count()).toBe(before);
  await clickOn(inside(-restPositions[3 * beyond]! / 2));
  await expect.poll(count).toBe(before + 1);

  const there = await arrive(await page.evaluate(() => window.chebnet.link()));
  await there.page.getByText('Appearance', { exact: true }).click();
  expect(await there.page.getByLabel('Thickness').inputValue()).toBe('30');
  expect(await there.page.getByLabel('Section').inputValue()).toBe('x');
});

describe('on a vault', () => {
  beforeEach(async () => {
    await script.open({ recipe: SHAPE });
    await script.settled();
  });

  test('the page shows the net that was asked for', async () => {
    const stats = await script.stats();
    expect(stats).toMatchObject({ vertices: reference.info.vertices, edges: reference.info.edges });
    expect(stats.handles).toBe(suggestedHandles.length);
    expect(largestError(await script.positions(), restPositions)).toBeLessThan(1e-9);
  });

  test('dragging a handle moves the net, and every edge keeps its length', async () => {
    const before = await script.position(dragged);
    const frames: number[] = [];
    await dragBy(script, dragged, [-70, -50], {
      during: async () => void frames.push((await script.stats()).iterations),
    });
    await script.settled();
    const stats = await script.stats();
    const positions = await script.positions();
    await visit.page.screenshot({ path: join(OUTPUT, 'dragged-desktop.png') });

    expect(stats.status).toBe('converged');
    expect(stats.maxDeviation).toBeLessThan(1e-6);
    expect(stats.milliseconds).toBeGreaterThan(0);
    expect(stats.framesPerSecond).toBeGreaterThan(0);
    expect(stats.memory).toBeGreaterThan(1e6);
    expect(stats.method).toBe('equilibrium');
    expect(largestDeviation(positions, edges, meanLength)).toBeLessThan(1.001e-6);
    expect(distance(await script.position(dragged), before)).toBeGreaterThan(meanLength);
    for (const anchor of suggestedHandles.slice(0, -1)) {
      const rest = Array.from(restPositions.subarray(3 * anchor, 3 * anchor + 3));
      expect(distance(await script.position(anchor), rest)).toBeLessThan(1e-9);
    }
  });

  test('the net follows while the pointer is still down', async () => {
    const before = await script.positions();
    const free = [...before.keys()].filter((i) => !suggestedHandles.includes(Math.floor(i / 3)));
    const moved = async () => {
      const during = await script.positions();
      return Math.max(...free.map((i) => Math.abs(before[i]! - during[i]!)));
    };
    await dragBy(script, dragged, [-60, -40], {
      atEnd: () => expect.poll(moved).toBeGreaterThan(0.1 * meanLength),
    });
  });

  test('Escape cancels a drag', async () => {
    const before = await script.position(dragged);
    await dragBy(script, dragged, [-70, -50], { atEnd: () => visit.page.keyboard.press('Escape') });
    await script.settled();
    expect(distance(await script.position(dragged), before)).toBeLessThan(1e-9);
    expect((await script.stats()).status).toBe('converged');
  });

  test('no menu opens in a drag, and one whose release the page was not told of ends with the next move', async () => {
    const { mouse } = visit.page;
    const menus = await visit.page.evaluateHandle(() => {
      const prevented: boolean[] = [];
      addEventListener('contextmenu', (event) => prevented.push(event.defaultPrevented));
      addEventListener('pointerup', (event) => event.stopImmediatePropagation(), { capture: true, once: true });
      return prevented;
    });
    const pressRight = async () => {
      await mouse.down({ button: 'right' });
      await mouse.up({ button: 'right' });
    };
    await dragBy(script, dragged, [-70, -50], { atEnd: pressRight });
    expect(await menus.jsonValue()).toEqual([true]);
    const cursor = () => visit.page.locator('#view canvas').evaluate((canvas) => canvas.style.cursor);
    expect(await cursor()).toBe('grabbing');
    const { x, y } = await script.screenPosition(dragged);
    await mouse.move(x - 40, y);
    expect(await cursor()).not.toBe('grabbing');
    await script.settled();
    expect(Math.abs((await script.screenPosition(dragged)).x - x)).toBeLessThan(20);
  });

  const pixelsFrom = async (place: { x: number; y: number }) => {
    const { x, y } = await script.screenPosition(dragged);
    return Math.hypot(x - place.x, y - place.y);
  };

  test('what is in hand when another net opens stays with the one before', async () => {
    const before = await script.screenPosition(dragged);
    await dragBy(script, dragged, [-60, -40], { atEnd: () => script.open({ recipe: SHAPE }) });
    await visit.page.mouse.move(before.x - 90, before.y);
    await script.settled();
    await expect.poll(() => pixelsFrom(before)).toBeLessThan(1);
  });

  test('while another net is being opened no handle is taken', async () => {
    const { page } = visit;
    const before = await script.screenPosition(dragged);
    await page.evaluate(() => void window.chebnet.open({ recipe: 'jack:vertices=100000' }).catch(() => {}));
    await dragBy(script, dragged, [-60, -40]);
    await page.getByRole('button', { name: 'Cancel', exact: true }).press('Enter');
    await script.settled();
    expect(await pixelsFrom(before)).toBeLessThan(1);
    expect(await page.evaluate(() => document.activeElement?.tagName)).toBe('CANVAS');
  });

  test('undo takes back a whole drag, redo repeats it', async () => {
    const before = await script.positions();
    await dragBy(script, dragged, [-70, -50]);
    await script.settled();
    const after = await script.positions();
    await visit.page.keyboard.press('Control+z');
    await script.settled();
    expect(largestError(await script.positions(), before)).toBeLessThan(1e-6 * meanLength);
    await visit.page.keyboard.press('Control+Shift+z');
    await script.settled();
    expect(largestError(await script.positions(), after)).toBeLessThan(1e-6 * meanLength);
  });

  test('a click adds a handle, Delete removes the one selected, undo brings it back', async () => {
    const { keyboard, mouse } = visit.page;
    const place = await script.screenPosition(freeVertex());
    const handle = await script.screenPosition(dragged);
    const count = suggestedHandles.length;
    const cursor = () => visit.page.locator('#view canvas').evaluate((canvas) => canvas.style.cursor);
    await mouse.move(place.x, place.y);
    await expect.poll(cursor).toBe('crosshair'); // what adds a handle is promised
    await mouse.click(place.x, place.y);
    await expectHandles(count + 1);
    await keyboard.press('Delete');
    await expectHandles(count);
    await keyboard.press('Control+z');
    await expectHandles(count + 1);
    await mouse.click(handle.x, handle.y);
    await keyboard.press('Delete');
    await expectHandles(count);
    await mouse.click(handle.x, handle.y);
    await expectHandles(count + 1);
  });

  test('dragging beside the net turns the view and moves nothing', async () => {
    const before = await script.screenPosition(dragged);
    const canvas = (await visit.page.locator('canvas').first().boundingBox())!;
    await visit.page.mouse.move(canvas.x + 12, canvas.y + canvas.height / 2);
    await visit.page.mouse.down();
    await visit.page.mouse.move(canvas.x + 120, canvas.y + canvas.height / 2, { steps: 5 });
    await visit.page.mouse.up();
    const turned = async () => {
      const after = await script.screenPosition(dragged);
      return Math.hypot(after.x - before.x, after.y - before.y);
    };
    await expect.poll(turned).toBeGreaterThan(5);
    expect(largestError(await script.positions(), restPositions)).toBeLessThan(1e-9);
  });

  test('a handle out of reach is named, and the net recovers', async () => {
    const home = await script.position(dragged);
    await script.move(dragged, [home[0], home[1], home[2] + 12]);
    await script.settled();
    expect((await script.stats()).status).toBe('unreachable');
    expect((await script.positions()).every(Number.isFinite)).toBe(true);
    const ways = visit.page.locator('.stuck-notice');
    await ways.getByRole('button').first().waitFor();
    const pair = new RegExp(`${suggestedHandles.slice(0, -1).join('|')}`);
    const text = await visit.page.locator('body').innerText();
    expect(text).toMatch(new RegExp(`\\b${dragged}\\b`));
    expect(text).toMatch(pair);
    expect(text).toMatch(/reach/i);
    await visit.page.locator('.status-words', { hasText: 'Out of reach: holding the best shape' }).waitFor();
    const marks = visit.page.locator('svg.overlay .marks');
    expect(await marks.getAttribute('d')).toMatch(/^M.*Z$/);
    // Whichever axis is up.
    await visit.page.getByText('Appearance', { exact: true }).click();
    for (const axis of ['y', 'z']) {
      await visit.page.getByLabel('Up axis').selectOption(axis);
      expect(await marks.getAttribute('d')).toMatch(/^M.*Z$/);
    }
    await visit.page.screenshot({ path: join(OUTPUT, 'unreachable.png') });
    await ways.getByRole('button', { name: 'Make the handle soft' }).click();
    await script.settled();
    expect((await script.stats()).status).toBe('converged');
    await ways.getByRole('button').first().waitFor({ state: 'detached' });
    expect(await marks.getAttribute('d')).toBe('');
    await visit.page.keyboard.press('Control+z');
    await script.settled();
    await ways.getByRole('button', { name: 'Back to the last good shape' }).click();
    await script.settled();
    expect((await script.stats()).status).toBe('converged');
    expect(largestError(await script.positions(), restPositions)).toBeLessThan(1e-9);
    await ways.getByRole('button').first().waitFor({ state: 'detached' });

    // Another net knows nothing of it.
    await script.move(dragged, [home[0], home[1], home[2] + 12]);
    await ways.getByRole('button').first().waitFor();
    await script.open({ recipe: 'vault:vertices=300' });
    await ways.getByRole('button').first().waitFor({ state: 'detached' });
    await script.open({ recipe: SHAPE });

    await script.move(dragged, home);
    await script.settled();
    expect((await script.stats()).status).toBe('converged');
    expect(largestDeviation(await script.positions(), edges, meanLength)).toBeLessThan(1.001e-6);
  });

  test('an OBJ opens by script and by file', async () => {
    const small = chebnet.openRecipe('vault:vertices=300');
    const { vertices } = small.info;
    const obj = small.toObj();
    small.dispose();
    await script.open({ obj });
    expect((await script.stats()).vertices).toBe(vertices);

    const file = { name: 'vault.obj', mimeType: 'model/obj', buffer: Buffer.from(reference.toObj()) };
    const chooser = visit.page.waitForEvent('filechooser');
    await visit.page.getByRole('button', { name: /open/i }).first().click();
    await (await chooser).setFiles(file);
    await visit.page.getByRole('button', { name: 'Open', exact: true }).click();
    await visit.page.waitForFunction((count) => window.chebnet.stats().vertices === count, reference.info.vertices);
  });

  test('a bad OBJ is refused with code and message, and the net stays', async () => {
    const refused = await visit.page.evaluate(() =>
      window.chebnet.open({ obj: 'v 0 0 0\nf 1 2 3\n' }).then(
        () => null,
        (error: ChebnetError) => ({ isError: error instanceof Error, code: error.code, message: error.message }),
      ),
    );
    expect(refused).toMatchObject({ isError: true, code: 'index_out_of_range' });
    expect(refused?.message).toMatch(/2/);
    expect((await script.stats()).vertices).toBe(reference.info.vertices);
  });
});

test.runIf(process.env['CHEBNET_SCREENSHOT'])('the picture for the README', async () => {
  const behaviour = visit.page.locator('label', { hasText: 'The net' }).getByRole('combobox');
  await behaviour.selectOption({ label: 'keeps its shape' });
  await script.settled();
  const handles = await visit.page.evaluate(() => window.chebnet.handles());
  await dragBy(script, handles.at(-1)!.vertex, [-120, -15]);
  await script.settled();
  await visit.page.mouse.move(5, 5);
  await expect.poll(() => drawnLines(visit.page)).toSatisfy((lengths: number[]) => lengths.every((each) => each > 0));
  await visit.page.waitForTimeout(1000);
  await visit.page.screenshot({ path: README_PICTURE });
});

/** A vertex in plain sight, a quarter of the way from the second handle to the third, far from any handle. */
function freeVertex(): number {
  const at = (vertex: number) => restPositions.subarray(3 * vertex, 3 * vertex + 3);
  const [from, to] = [at(suggestedHandles[1]!), at(suggestedHandles[2]!)];
  const place = from.map((coordinate, k) => coordinate + 0.25 * (to[k]! - coordinate));
  const far = (vertex: number) => Math.hypot(at(vertex)[0]! - place[0]!, at(vertex)[1]! - place[1]!);
  const vertices = [...Array(reference.info.vertices).keys()];
  return vertices.reduce((best, vertex) => (far(vertex) < far(best) ? vertex : best), 0);
}

async function expectHandles(count: number) {
  await expect.poll(async () => (await script.stats()).handles, { timeout: 5000 }).toBe(count);
  await script.settled();
}

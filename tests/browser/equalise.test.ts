/** Equalising: a mesh with unequal edges is dropped, equalised in sight, and opened as a net whose edges have one length. */
import { join } from 'node:path';
import { beforeEach, expect, test } from 'vitest';
import { meanLength } from '../../web/src/equalize/before_after';
import { load } from '../wasm/load';
import { uneven } from '../web/nets';
import { largestDeviation, largestError } from './geometry';
import type { Script, Visit } from './page';
import { OUTPUT, dropFile, visits } from './page';

const chebnet = await load();
const SHEET = uneven(14, 11);
const sheet = chebnet.openObj(SHEET);
const mean = meanLength(sheet.restPositions, sheet);
/** All ten pairs of five vertices joined: space has no five points at one distance from each other. */
const FIVE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n';

/** Six squares of n × n quads, blown up to a sphere. */
function cubeSphere(n: number): string {
  const numbers = new Map<string, number>();
  const lines: string[] = [];
  const vertex = (place: number[]): number => {
    const known = numbers.get(place.join());
    if (known) return known;
    const raised = place.map((x) => Math.tan((Math.PI / 4) * ((2 * x) / n - 1)));
    lines.push(`v ${raised.map((x) => x / Math.hypot(...raised)).join(' ')}`);
    numbers.set(place.join(), numbers.size + 1);
    return numbers.size;
  };
  for (let axis = 0; axis < 3; ++axis)
    for (const far of [0, n])
      for (let i = 0; i < n; ++i)
        for (let j = 0; j < n; ++j) {
          const corner = (a: number, b: number) =>
            vertex([0, 1, 2].map((k) => [far, i + a, j + b][(k - axis + 3) % 3]!));
          const around = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          lines.push(`f ${(far > 0 ? around : around.reverse()).join(' ')}`);
        }
  return lines.join('\n');
}

/** Its outer edges are three times as long as the inner ones: no net near it is fair. */
function flatRing(around: number, rows: number): string {
  const places = Array.from({ length: around * (rows + 1) }, (_, v) => [Math.floor(v / around), v % around] as const);
  const vertex = (row: number, k: number) => around * row + (k % around) + 1;
  const vertices = places.map(([row, k]) => {
    const [radius, angle] = [1 + (2 * row) / rows, (2 * Math.PI * k) / around];
    return `v ${radius * Math.cos(angle)} ${radius * Math.sin(angle)} 0`;
  });
  const faces = places
    .slice(0, around * rows)
    .map(([row, k]) => `f ${vertex(row, k)} ${vertex(row, k + 1)} ${vertex(row + 1, k + 1)} ${vertex(row + 1, k)}`);
  return [...vertices, ...faces].join('\n');
}

const { arrive, share } = visits();
let visit: Visit;
let script: Script;
beforeEach(async () => {
  visit = await share();
  ({ script } = visit);
});

const dialog = (name: RegExp) => visit.page.getByRole('dialog', { name });
const equalizer = () => dialog(/^Equalise /);
const press = (name: string) => equalizer().getByRole('button', { name, exact: true }).click();
const picture = () => equalizer().locator('canvas').screenshot();

async function dropAndEqualise(name: string, content: Uint8Array | string, open = 'Equalise…') {
  await dropFile(visit.page, name, content);
  const report = dialog(/\.(obj|ply)$/);
  await report.getByRole('radio', { name: /Equalise/ }).check();
  await report.getByRole('button', { name: open, exact: true }).click();
  await equalizer().waitFor();
}

async function waitForVertices(count: number) {
  await visit.page.waitForFunction((expected) => window.chebnet.stats().vertices === expected, count);
}

/** Of the net that is open: the worst dL against the mean of its edges, and this mean. */
async function measured() {
  const around = Int32Array.from(await visit.page.evaluate(() => Array.from(window.chebnet.edges())));
  const positions = await script.positions();
  const length = meanLength(positions, { edges: around });
  return { positions, length, deviation: largestDeviation(positions, around, length) };
}

test('an uneven mesh is equalised, seen before and after, and opened; link and undo keep it', async () => {
  const { vertices: first } = await script.stats();
  await dropAndEqualise('sheet.obj', SHEET);
  await equalizer().getByText('Largest dL in the picture: 0.').waitFor();
  const before = await picture();
  await visit.page.screenshot({ path: join(OUTPUT, 'equalise-before.png') });
  await press('Equalise');
  await equalizer()
    .getByText(/^Every edge has the length/)
    .waitFor();
  expect(await equalizer().innerText()).toMatch(
    /Average move\s+0\.\d+ edge lengths\s+Farthest move\s+[\d.]+ edge lengths/,
  );
  expect(await equalizer().innerText()).toMatch(/Largest dL in the picture: (< )?\S+e-\d+/);
  const after = await picture();
  expect(after.equals(before)).toBe(false);
  await visit.page.screenshot({ path: join(OUTPUT, 'equalise-after.png') });

  const slider = equalizer().getByRole('slider', { name: /^Between/ });
  await slider.focus();
  await visit.page.keyboard.press('Home');
  expect(await slider.getAttribute('aria-valuetext')).toBe('Original');
  await equalizer().getByText('Largest dL in the picture: 0.').waitFor();

  await press('Open the equalised net');
  await waitForVertices(sheet.info.vertices);
  await equalizer().waitFor({ state: 'detached' });
  await script.settled();
  await visit.page.getByRole('group', { name: 'Surface: sheet.obj' }).waitFor();
  const { positions, deviation, length } = await measured();
  expect(deviation).toBeLessThan(1e-9);
  expect(length / mean - 1).toBeLessThan(1e-6);
  expect(positions.length).toBe(sheet.restPositions.length);

  const link = await visit.page.evaluate(() => window.chebnet.link());
  const { script: there } = await arrive(link);
  await there.settled();
  expect(largestError(await there.positions(), positions)).toBe(0);

  await visit.page.keyboard.press('Control+z');
  await waitForVertices(first);
  await visit.page.keyboard.press('Control+Shift+z');
  await waitForVertices(sheet.info.vertices);
  expect(largestError(await script.positions(), positions)).toBe(0);
});

test('what cannot be is refused with its reason, and nothing is opened', async () => {
  const { vertices: first } = await script.stats();
  await dropAndEqualise('five.obj', FIVE);
  await press('Equalise');
  await equalizer()
    .getByText(/no such net near this mesh.*The worst edge, from vertex \d to \d, is .* Nothing was changed\./)
    .waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'equalise-refused.png') });
  expect(await equalizer().getByRole('button', { name: 'Open the equalised net' }).isVisible()).toBe(false);
  await press('Cancel');
  // Back at the report, whose other choices are left.
  expect(
    await dialog(/^five\.obj$/)
      .getByRole('radio', { name: /Equalise/ })
      .isChecked(),
  ).toBe(true);
  await visit.page.keyboard.press('Escape');
  await dialog(/^five\.obj$/).waitFor({ state: 'detached' });
  expect((await script.stats()).vertices).toBe(first);
});

test('the net that is open is equalised where it stands, and keeps its handles', async () => {
  await script.open({ obj: SHEET, name: 'sheet.obj' });
  await script.setHandles([{ vertex: 0 }, { vertex: 13, anchor: false }, { vertex: 153 }]);
  await script.settled();
  await visit.page.getByRole('button', { name: 'Equalise…' }).click();
  await equalizer().getByRole('checkbox', { name: 'Hold the 3 handles where they are' }).check();
  await equalizer().getByRole('spinbutton', { name: 'Another length' }).fill('0.01');
  await press('Equalise');
  await equalizer()
    .getByText(/handles \d+ and \d+ are .* apart, and with this length the net between them reaches only/)
    .waitFor();
  await equalizer()
    .getByRole('radio', { name: /^The mean/ })
    .check();
  await press('Equalise');
  await press('Open the equalised net');
  await expect.poll(async () => (await measured()).deviation).toBeLessThan(1e-9);
  const handles = await visit.page.evaluate(() => window.chebnet.handles());
  expect(handles.map(({ vertex, anchor }) => [vertex, anchor])).toEqual([
    [0, true],
    [13, false],
    [153, true],
  ]);
  for (const { vertex, target } of handles)
    expect(largestError(Float64Array.from(target), sheet.restPositions.subarray(3 * vertex, 3 * vertex + 3))).toBe(0);
});

test('a net that folds sharply says so, and leads to a new net on the surface of its mesh', async () => {
  await dropAndEqualise('cube-sphere.obj', cubeSphere(12));
  await press('Equalise');
  await equalizer()
    .getByText(/^The net folds sharply/)
    .waitFor();
  expect(await equalizer().innerText()).toMatch(/Folds over 60°\s+\d+, before 0/);
  await visit.page.screenshot({ path: join(OUTPUT, 'equalise-folds.png') });
  await press('A new net on this surface…');
  await equalizer().waitFor({ state: 'detached' });
  await dialog(/^A net on a surface$/)
    .locator('.results .facts:not(.stale)', { hasText: 'Largest dL' })
    .waitFor();
});

test('where edges become equal but corners stay too sharp, it says how many quads have one', async () => {
  const ring = flatRing(30, 10);
  const native = chebnet.equalizer(chebnet.readMesh(new TextEncoder().encode(ring), 'ring.obj'), {
    method: 'equilibrium',
  });
  const { status, quadsBeyondLimit } = native.solve();
  native.dispose();
  expect(status).toBe('exact');
  expect(quadsBeyondLimit).toBeGreaterThan(0);

  await dropAndEqualise('ring.obj', ring);
  await equalizer()
    .getByRole('radio', { name: /^The mean of the original/ })
    .check();
  await press('Equalise');
  const said = `No net was found whose corners all keep to 30°. Quads with a sharper one: ${quadsBeyondLimit}.`;
  await equalizer().getByText(said, { exact: true }).waitFor();
  await equalizer().locator('.verdict').waitFor();
});

test('beside a surface the net is equalised near that, unless told otherwise', async () => {
  await script.open({ obj: SHEET, name: 'sheet.obj' });
  await script.setHandles([]);
  // Free of it by itself, and off by about an edge: near one is not near the other.
  await visit.page.evaluate(() => window.chebnet.setOptions({ guide_mode: 0 }));
  const positions = sheet.restPositions.map((x, i) => (i % 3 === 2 ? x + mean : x));
  const mesh = { positions, faceStart: sheet.faceStart, faceVertices: sheet.faceVertices };
  const surface = chebnet.openSurface(mesh);
  const vertices = Array.from({ length: positions.length / 3 }, (_, v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  const faces = Array.from({ length: sheet.faceStart.length - 1 }, (_, f) => [
    ...sheet.faceVertices.subarray(sheet.faceStart[f], sheet.faceStart[f + 1]),
  ]);
  await visit.page.evaluate((given) => window.chebnet.setGuide({ ...given, name: 'roof' } as never), {
    vertices,
    faces,
  });
  const near = equalizer().getByRole('checkbox', { name: 'Near the surface, fair, no corner below 30°' });
  const guided = equalizer().getByRole('checkbox', { name: 'Near the surface beside it, roof' });
  /** Of the net as it is opened then, from the roof. */
  const distanceOnce = async (isGuided: boolean) => {
    await visit.page.getByRole('button', { name: 'Equalise…' }).click();
    expect([await near.isChecked(), await guided.isChecked()]).toEqual([true, true]);
    if (!isGuided) await guided.click();
    await press('Equalise');
    await equalizer()
      .getByText(/^Every edge has the length/)
      .waitFor();
    const facts = await equalizer().locator('.facts').innerText();
    expect(Number(/Smallest corner\s+([\d.]+)/.exec(facts)![1])).toBeGreaterThan(29.9);
    await visit.page.screenshot({ path: join(OUTPUT, `equalise-guide-${isGuided}.png`) });
    await press('Open the equalised net');
    await expect.poll(async () => (await measured()).deviation).toBeLessThan(1e-9);
    const { positions: after, length } = await measured();
    return surface.measure({ ...mesh, positions: after }).meanDistance / length;
  };
  const own = await distanceOnce(false);
  await visit.page.keyboard.press('Control+z');
  await expect.poll(async () => (await measured()).deviation).toBeGreaterThan(1e-3);
  expect(await distanceOnce(true)).toBeLessThan(own / 5);
  await visit.page.getByRole('group', { name: 'Surface: roof' }).waitFor();

  await visit.page.getByRole('button', { name: 'Equalise…' }).click();
  await near.click();
  expect(await guided.isDisabled()).toBe(true);
  surface.dispose();
});

test('equalising a large mesh can be stopped at once', async () => {
  const large = chebnet.openRecipe('vault:vertices=100000');
  large.setPositions(large.restPositions.map((x, i) => x + 0.2 * large.info.meanLength * Math.sin(7 * i)));
  await dropAndEqualise('large.ply', large.toFile('ply'));
  large.dispose();
  await press('Equalise');
  await visit.page.waitForFunction(stopOnceUnderWay);
  expect(await equalizer().getByRole('button', { name: 'Equalise', exact: true }).isVisible()).toBe(true);
  await press('Equalise');
  await visit.page.keyboard.press('Escape');
  await equalizer().waitFor({ state: 'detached' });
  await dialog(/^large\.ply$/)
    .getByRole('button', { name: 'Cancel' })
    .click();
  await dialog(/./).waitFor({ state: 'detached' });
});

/** In the page, for a hand may be too slow. */
function stopOnceUnderWay(): boolean {
  const underWay = /^Iteration \d+, largest dL/.test(document.querySelector('.equalize .progress')?.textContent ?? '');
  const stop = [...document.querySelectorAll<HTMLButtonElement>('.equalize button')].find(
    (button) => button.textContent === 'Stop',
  );
  if (underWay) stop?.click();
  return underWay;
}

test('the length may be another, and it fits every screen', async () => {
  await dropAndEqualise('a rather long name of a mesh that came from somewhere.obj', SHEET);
  await equalizer().getByRole('spinbutton', { name: 'Another length' }).fill('0');
  await press('Equalise');
  expect(await equalizer().getByRole('button', { name: 'Stop' }).isVisible()).toBe(false);
  await equalizer().getByText('Allowed: a number above 0.').waitFor();
  await equalizer().getByRole('spinbutton', { name: 'Another length' }).fill('2.5');
  await press('Equalise');
  await equalizer().getByText('Every edge has the length 2.5.').waitFor();
  for (const [colorScheme, width, height] of [
    ['light', 390, 844],
    ['dark', 390, 844],
    ['dark', 1280, 800],
  ] as const) {
    await visit.page.emulateMedia({ colorScheme });
    await visit.page.setViewportSize({ width, height });
    await visit.page.screenshot({ path: join(OUTPUT, `equalise-${colorScheme}-${width}.png`) });
    const box = (await equalizer().boundingBox())!;
    expect([box.x, box.y].every((edge) => edge >= 0)).toBe(true);
    expect([box.x + box.width <= width, box.y + box.height <= height]).toEqual([true, true]);
    expect(
      await equalizer()
        .locator('.body')
        .evaluate((body) => body.scrollWidth - body.clientWidth),
    ).toBeLessThanOrEqual(0);
  }
  await equalizer()
    .getByRole('radio', { name: /^The best fit/ })
    .check();
  expect(await equalizer().getByRole('button', { name: 'Open the equalised net' }).isVisible()).toBe(false);
  await press('Equalise');
  await press('Open the equalised net');
  await waitForVertices(sheet.info.vertices);
  expect((await measured()).deviation).toBeLessThan(1e-9);
});

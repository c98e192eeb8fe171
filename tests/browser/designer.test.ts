/** What a designer does from a mesh to the workshop, in one go; and a basic edit by the keyboard alone. */
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import rhino3dm from 'rhino3dm';
import { expect, test } from 'vitest';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { glbParts } from '../web/glb_parts';
import { uneven } from '../web/nets';
import { load } from '../wasm/load';
import { distance, dragBy, largestDeviation, largestError } from './geometry';
import type { Visit } from './page';
import { OUTPUT, allSections, dropFile, visits } from './page';

const chebnet = await load();
const sheet = chebnet.openObj(uneven(14, 11));
const { edges, faceStart, faceVertices } = sheet;
const { vertices } = sheet.info;
const HELD = [0, 13];
const DRAGGED = 146;

const { arrive } = visits();

/** Drops the mesh, makes it a Chebyshev net and opens that. */
async function importEqualised({ page, script }: Visit) {
  await dropFile(page, 'sheet.obj', uneven(14, 11));
  const report = page.getByRole('dialog', { name: /^sheet\.obj$/ });
  await report.getByText('Mean length').waitFor();
  expect(await report.innerText()).toMatch(/Boundary loops\s+1/);
  await report.getByRole('radio', { name: /Equalise/ }).check();
  await report.getByRole('button', { name: 'Equalise…', exact: true }).click();
  const equalizer = page.getByRole('dialog', { name: /^Equalise / });
  await equalizer.getByRole('button', { name: 'Equalise', exact: true }).click();
  await equalizer.getByText(/^Every edge has the length/).waitFor();
  await equalizer.getByRole('button', { name: 'Open the equalised net' }).click();
  await page.waitForFunction((count) => window.chebnet.stats().vertices === count, vertices);
  await script.settled();
}

/** Takes hold of a vertex by a click. */
async function takeHold({ page, script }: Visit, vertex: number) {
  const { x, y } = await script.screenPosition(vertex);
  await page.mouse.click(x, y);
  await expect.poll(async () => (await handles(page)).includes(vertex)).toBe(true);
  await script.settled();
}

const handles = (page: Page) => page.evaluate(() => window.chebnet.handles().map(({ vertex }) => vertex));

async function save(page: Page, format: string): Promise<Uint8Array<ArrayBuffer>> {
  const menu = page.getByRole('group', { name: 'Export as' });
  if (!(await menu.isVisible())) await page.getByRole('button', { name: 'Export', exact: true }).click();
  const download = page.waitForEvent('download');
  await menu.getByRole('button', { name: format }).click();
  return Uint8Array.from(await readFile(await (await download).path()));
}

/** Worst dL of the sheet at some positions, against the mean of its edges there. */
function deviation(positions: Float64Array): number {
  const lengths = edgeLengths(positions, edges);
  return largestDeviation(positions, edges, lengths.reduce((sum, length) => sum + length, 0) / lengths.length);
}

test('a mesh becomes a net, is shaped, kept, carried into other programs and shown to somebody else', async () => {
  const visit = await arrive();
  const { page, script } = visit;
  const first = await script.stats();
  await importEqualised(visit);
  for (const vertex of [...HELD, DRAGGED]) await takeHold(visit, vertex);
  const stood = [await script.positions()];
  for (const by of [
    [0, -60],
    [40, 20],
    [-30, 30],
  ] as const) {
    await dragBy(script, DRAGGED, [...by]);
    await script.settled();
    stood.push(await script.positions());
  }
  for (const [i, positions] of stood.entries()) {
    expect(deviation(positions)).toBeLessThan(1e-6);
    if (i > 0) expect(largestError(positions, stood[i - 1]!)).toBeGreaterThan(0.01);
  }
  const shaped = stood.at(-1)!;

  const steps = 1 + HELD.length + 1 + 3;
  for (let i = 0; i < steps; ++i) {
    await page.keyboard.press('Control+z');
    await script.settled();
  }
  expect((await script.stats()).vertices).toBe(first.vertices);
  for (let i = 0; i < steps; ++i) {
    await page.keyboard.press('Control+Shift+z');
    await script.settled();
  }
  expect(await script.positions()).toEqual(shaped);

  await page.waitForTimeout(1500); // what is kept is kept a moment after the last change
  await page.reload();
  await script.waitForNet();
  await expect.poll(async () => (await script.stats()).vertices).toBe(vertices);
  await script.settled();
  expect(await script.positions()).toEqual(shaped);

  await checkFiles(page, shaped);
  await page.screenshot({ path: join(OUTPUT, 'designer.png') });

  const link = await page.evaluate(() => window.chebnet.link());
  const { script: there } = await arrive(link);
  await there.settled();
  expect(largestError(await there.positions(), shaped)).toBeLessThan(1e-4);
  expect(deviation(await there.positions())).toBeLessThan(1e-6);
});

/** Each format, read back: faces, order and places as shown. */
async function checkFiles(page: Page, shaped: Float64Array) {
  for (const format of ['OBJ', 'PLY', 'OFF']) {
    const mesh = chebnet.readMesh(await save(page, format), `sheet.${format.toLowerCase()}`);
    expect(mesh.faceStart).toEqual(faceStart);
    expect(mesh.faceVertices).toEqual(faceVertices);
    expect(mesh.positions).toEqual(shaped);
  }
  const stl = await save(page, 'STL');
  expect(new DataView(stl.buffer).getUint32(80, true)).toBe(2 * sheet.info.faces);
  expect(glbParts(await save(page, 'GLB')).faces.positions).toEqual(Float32Array.from(shaped));

  const rhino = await rhino3dm();
  const mesh = rhino.File3dm.fromByteArray(await save(page, '3DM'))
    .objects()
    .get(0)
    .geometry() as InstanceType<typeof rhino.Mesh>;
  expect(Array.from({ length: sheet.info.faces }, (_, f) => mesh.faces().get(f)).flat()).toEqual([...faceVertices]);
  const points = Array.from({ length: vertices }, (_, v) => mesh.vertices().point3dAt(v)).flat();
  expect(largestError(Float64Array.from(points), shaped)).toBe(0);

  const [, ...rows] = new TextDecoder()
    .decode(await save(page, 'CSV'))
    .trim()
    .split('\n');
  expect(rows.flatMap((row) => row.split(',').slice(1, 3).map(Number))).toEqual([...edges]);
  expect(new TextDecoder().decode(await save(page, 'SVG'))).toMatch(/<svg [^>]*mm/);
  expect([...(await save(page, 'PNG')).subarray(1, 4)]).toEqual([...'PNG'].map((letter) => letter.charCodeAt(0)));
}

/** Goes on by Tab until a control of this kind and name is reached. */
async function tabTo(page: Page, control: RegExp) {
  for (let i = 0; i < 150; ++i) {
    await page.keyboard.press('Tab');
    const reached = await page.evaluate(() => {
      const { ariaLabel, textContent, tagName } = document.activeElement!;
      return `${tagName} ${ariaLabel ?? ''} ${textContent}`;
    });
    if (control.test(reached)) return;
  }
  throw new Error(`Tab does not lead to ${control}`);
}

test('a basic edit by the keyboard alone: a shape, a handle by its number, a move, undo, a link', async () => {
  const { page, script } = await arrive();
  await allSections(page);
  const { vertices } = await script.stats();
  await tabTo(page, /^BUTTON.*Vault/);
  await page.keyboard.press('Enter');
  await page.waitForFunction((count) => window.chebnet.stats().vertices !== count, vertices);
  await script.settled();

  const free = (await handles(page)).includes(DRAGGED) ? DRAGGED + 1 : DRAGGED;
  await tabTo(page, /^SUMMARY.*Handles/);
  await page.keyboard.press('Enter');
  await tabTo(page, /^INPUT Vertex number/);
  await page.keyboard.type(String(free));
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await handles(page)).includes(free)).toBe(true);
  await script.settled();
  const before = await script.position(free);

  await tabTo(page, /^CANVAS/);
  await page.keyboard.press('ArrowUp');
  await script.settled();
  const moved = await script.position(free);
  expect(distance(moved, before)).toBeGreaterThan(0.01);
  expect((await script.stats()).maxDeviation).toBeLessThan(1e-6);
  await page.keyboard.press('Control+z');
  await script.settled();
  expect(distance(await script.position(free), before)).toBeLessThan(1e-9);
  await page.keyboard.press('Control+y');
  await script.settled();

  await tabTo(page, /^BUTTON.*Share/);
  await page.keyboard.press('Enter');
  await page.getByText('The link is copied.').waitFor();
  const { script: there } = await arrive(await page.evaluate(() => navigator.clipboard.readText()));
  await there.settled();
  expect(distance(await there.position(free), moved)).toBeLessThan(1e-4);
});

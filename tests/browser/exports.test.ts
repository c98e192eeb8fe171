/** What leaves the page: each file is saved by hand, read back, and holds the net that is shown. */
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import rhino3dm from 'rhino3dm';
import { beforeEach, expect, test } from 'vitest';
import { glbParts } from '../web/glb_parts';
import { load } from '../wasm/load';
import { dragBy, largestDeviation, largestError } from './geometry';
import { uneven } from '../web/nets';
import type { Visit } from './page';
import { OUTPUT, dropFile, visits } from './page';

const chebnet = await load();
const reference = chebnet.openRecipe('vault:vertices=300');
const { edges, faceVertices, info } = reference;

const { share, address } = visits();
let visit: Visit;
beforeEach(async () => {
  visit = await share();
});

const press = (name: string | RegExp) => visit.page.getByRole('button', { name, exact: true }).click();
const menu = () => visit.page.getByRole('group', { name: 'Export as' });

async function save(format: string): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> }> {
  if (!(await menu().isVisible())) await press('Export');
  const download = visit.page.waitForEvent('download');
  await menu().getByRole('button', { name: format }).click();
  const saved = await download;
  await visit.page.getByRole('status').getByText(`Exported: ${saved.suggestedFilename()}`, { exact: true }).waitFor();
  return { name: saved.suggestedFilename(), bytes: Uint8Array.from(await readFile(await saved.path())) };
}

/** A vault that was dragged, and where it stands. */
async function draggedVault(): Promise<Float64Array> {
  await visit.script.open({ recipe: 'vault:vertices=300' });
  await dragBy(visit.script, reference.suggestedHandles.at(-1)!, [-50, -40]);
  await visit.script.settled();
  return visit.script.positions();
}

test('3DM and GLB hold the net as it was dragged', async () => {
  const positions = await draggedVault();
  const model = await save('3DM');
  expect(model.name).toBe('vault.3dm');
  const rhino = await rhino3dm();
  const objects = rhino.File3dm.fromByteArray(model.bytes).objects();
  const mesh = objects.get(0).geometry() as InstanceType<typeof rhino.Mesh>;
  expect(Array.from({ length: info.faces }, (_, f) => mesh.faces().get(f)).flat()).toEqual([...faceVertices]);
  const places = Float64Array.from(
    Array.from({ length: info.vertices }, (_, v) => mesh.vertices().point3dAt(v)).flat(),
  );
  expect(largestError(places, positions)).toBe(0);
  expect(objects.count).toBeGreaterThan(30);

  const { name, bytes } = await save('GLB');
  expect(name).toBe('vault.glb');
  const { faces, lines } = glbParts(bytes);
  expect(faces.positions).toEqual(Float32Array.from(positions));
  expect([...lines.indices]).toEqual([...edges]);
  expect(largestDeviation(Float64Array.from(faces.positions), edges, info.meanLength)).toBeLessThan(1.001e-6);
  // The colour of a good edge, nearly everywhere.
  const [red, , blue] = faces.colours!;
  expect(blue).toBeGreaterThan(red!);

  // The page reads both again: 3DM with its quads, GLB as the triangles that it has, with y up.
  await dropFile(visit.page, 'back.3dm', model.bytes);
  const back = visit.page.getByRole('dialog', { name: 'back.3dm' });
  await back.getByText(`${info.faces} quads`).waitFor();
  await back.getByRole('button', { name: 'Cancel' }).click();
  await dropFile(visit.page, 'back.glb', bytes);
  const triangles = visit.page.getByRole('dialog', { name: 'back.glb' });
  await triangles.getByRole('radio', { name: /^A surface/, checked: true }).waitFor();
  await triangles.getByRole('radio', { name: 'y is up', checked: true }).waitFor();
  await triangles.getByRole('button', { name: 'Make a net on it…' }).click();
  await visit.page
    .getByRole('dialog', { name: 'A net on a surface' })
    .getByRole('combobox', { name: 'Surface' })
    .getByRole('option', { name: 'back.glb' })
    .waitFor({ state: 'attached' });
});

test('CSV lists the edges, or the rods to cut', async () => {
  await visit.script.open({ recipe: 'vault:vertices=300' });
  const text = async () => new TextDecoder().decode((await save('CSV')).bytes).split('\n', 1)[0];
  expect(await text()).toMatch(/^edge,/);
  await press('Export');
  await menu().getByLabel('What the table lists').selectOption('rods');
  const { name, bytes } = await save('CSV');
  expect(name).toBe('vault.rods.csv');
  const rows = new TextDecoder().decode(bytes).trimEnd().split('\n').slice(1);
  const edges = rows.reduce((sum, row) => sum + Number(row.split(',')[1]), 0);
  expect(edges).toBe((await visit.script.stats()).edges);
});

test('the pattern of a net in millimetres is of its own size', async () => {
  const edge = menu().getByLabel('Length of an edge on the pattern in millimetres');
  for (const [length, shown] of [
    [0.25, '10'],
    [290, '290'],
    [2000, '10'],
  ] as const) {
    await visit.script.open({ obj: square(length) });
    await press('Export');
    await expect.poll(() => edge.inputValue(), { message: `edges of ${length}` }).toBe(shown);
    await visit.page.keyboard.press('Escape');
  }
  await visit.script.open({ obj: square(290) });
  await visit.page.evaluate(() => window.chebnet.setOptions({ length_scale: 1.12 }));
  await visit.script.settled();
  await press('Export');
  await expect.poll(() => edge.inputValue()).toBe('324.8');
});

function square(side: number): string {
  return `v 0 0 0\nv ${side} 0 0\nv ${side} ${side} 0\nv 0 ${side} 0\nf 1 2 3 4\n`;
}

test('a vault has a flat pattern of the size asked for, a torus once it is cut, which is a step to be undone', async () => {
  await visit.script.open({ recipe: 'vault:vertices=300' });
  await press('Export');
  await menu().getByLabel('Length of an edge on the pattern in millimetres').fill('25');
  const { name, bytes } = await save('SVG');
  expect(name).toBe('vault.svg');
  const drawing = await visit.page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const count = (selector: string): number => root.querySelectorAll(selector).length;
    return {
      tag: root.tagName,
      width: root.getAttribute('width'),
      height: root.getAttribute('height'),
      marks: count('circle'),
    };
  }, new TextDecoder().decode(bytes));
  const { handles } = await visit.script.stats();
  expect(drawing).toEqual({
    tag: 'svg',
    width: expect.stringMatching(/^\d+mm$/),
    height: expect.stringMatching(/^\d+mm$/),
    marks: handles,
  });
  const cells = (length: string | null, margins: number): number => parseInt(length!, 10) / 25 - margins;
  expect(cells(drawing.width, 2) * cells(drawing.height, 3)).toBe(info.faces);

  await visit.script.open({ recipe: 'torus:vertices=300' });
  await press('Export');
  await menu().getByRole('button', { name: 'SVG' }).click();
  await visit.page.getByText('As it is the net does not lie flat: it closes on itself.').waitFor();
  const { vertices, faces } = await visit.script.stats();
  const [download] = await Promise.all([
    visit.page.waitForEvent('download'),
    visit.page.getByRole('button', { name: 'Cut it into flat pieces and save' }).click(),
  ]);
  const svg = await readFile((await download.path())!, 'utf8');
  // Both sides of two cuts.
  expect([...svg.matchAll(/>([A-Z])<\/text>/g)].map(([, letter]) => letter)).toEqual(['A', 'A', 'B', 'B']);
  const cut = await visit.script.stats();
  expect(cut.faces).toBe(faces);
  expect(cut.vertices).toBeGreaterThan(vertices);
  await visit.page.keyboard.press('Control+z');
  await expect.poll(async () => (await visit.script.stats()).vertices).toBe(vertices);
});

test.each([
  ['with a mouse', () => menu().getByRole('button', { name: 'SVG' }).click()],
  [
    'by keys',
    async () => {
      await menu().getByRole('button', { name: 'SVG' }).focus();
      await visit.page.keyboard.press('Enter');
    },
  ],
])('a flat pattern of a size that cannot be is refused beside its field, %s', async (_, order) => {
  await visit.script.open({ recipe: 'vault:vertices=300' });
  const saved: string[] = [];
  visit.page.on('download', (file) => saved.push(file.suggestedFilename()));
  await press('Export');
  const edge = menu().getByLabel('Length of an edge on the pattern in millimetres');
  const allowed = menu().getByText('Allowed: a number from 1 to 1,000.');
  for (const size of ['-4', '0', '1001', '']) {
    await edge.fill(size);
    await order();
    await allowed.waitFor();
    expect(await edge.evaluate((field) => field === document.activeElement)).toBe(true);
    expect(await edge.inputValue()).toBe(size);
  }
  await visit.page.screenshot({ path: join(OUTPUT, 'export-refused.png') });
  // Other kinds are not of that size.
  expect((await save('CSV')).name).toBe('vault.csv');
  await press('Export');
  await edge.fill('2.5');
  await allowed.waitFor({ state: 'hidden' });
  expect((await save('SVG')).name).toBe('vault.svg');
  expect(saved).toEqual(['vault.csv', 'vault.svg']);
});

test('a picture can have more pixels than the screen, which stays as it is', async () => {
  const size = (): Promise<number[]> =>
    visit.page
      .locator('#view canvas')
      .evaluate(({ width, height, style }: HTMLCanvasElement) => [width, height, parseInt(style.width, 10)]);
  const before = await size();
  const widthOf = (png: Uint8Array): number => new DataView(png.buffer).getUint32(16);
  expect(widthOf((await save('PNG')).bytes)).toBe(before[0]);
  await press('Export');
  await menu().getByLabel('Size of the picture').selectOption('2');
  expect(widthOf((await save('PNG')).bytes)).toBe(2 * before[0]!);
  expect(await size()).toEqual(before);
});

test('a drag is recorded and saved as a video', async () => {
  await visit.script.open({ recipe: 'vault:vertices=300' });
  await press('Export');
  await menu().getByRole('button', { name: 'Video' }).click();
  const notice = visit.page.getByRole('group', { name: 'Recording' });
  await dragBy(visit.script, reference.suggestedHandles.at(-1)!, [-50, -40]);
  await notice.getByText(/0:\d[1-9] \/ 1:00/).waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'recording.png') });
  // Asked for again it goes on, on its background, and leads to its end.
  const opacity = () =>
    visit.page.locator('#view canvas').evaluate((canvas: HTMLCanvasElement) => {
      canvas.dispatchEvent(new KeyboardEvent('keydown', { key: '+' }));
      const copy = document.createElement('canvas').getContext('2d')!;
      // After the picture that the key asks for, and before it is shown.
      return new Promise<number>((resolve) =>
        requestAnimationFrame(() => {
          copy.drawImage(canvas, 0, 0);
          resolve(copy.getImageData(0, 0, 1, 1).data[3]!);
        }),
      );
    });
  expect(await opacity()).toBe(255);
  await press('Export');
  await menu().getByRole('button', { name: 'Video' }).click();
  const stop = notice.getByRole('button', { name: 'Stop and save' });
  await expect.poll(() => stop.evaluate((button) => button === document.activeElement)).toBe(true);
  expect(await opacity()).toBe(255);
  const download = visit.page.waitForEvent('download');
  await stop.click();
  const saved = await download;
  await notice.waitFor({ state: 'detached' });
  await expect.poll(opacity).toBe(0);
  expect(saved.suggestedFilename()).toMatch(/^vault\.(webm|mp4)$/);
  const bytes = await readFile(await saved.path());
  // A Matroska file says so; and an empty one has a few hundred bytes.
  if (saved.suggestedFilename().endsWith('webm')) expect(bytes.readUInt32BE(0)).toBe(0x1a45dfa3);
  expect(bytes.length).toBeGreaterThan(5000);
});

test('the link comes as a QR code, and as a frame for another page', async () => {
  await press('Share');
  const dialog = visit.page.getByRole('dialog', { name: 'Share' });
  await dialog.getByText('The link is copied.').waitFor();
  const clipboard = (): Promise<string> => visit.page.evaluate(() => navigator.clipboard.readText());
  const link = await clipboard();
  expect(link).toMatch(new RegExp(`^${address()}#v2=`));
  await dialog.getByRole('img', { name: 'QR code' }).waitFor();
  await visit.page.screenshot({ path: join(OUTPUT, 'share.png') });
  expect(await dialog.getByRole('textbox').inputValue()).toContain(`<iframe src="${link.replace('#', '?embed#')}"`);
  await dialog.getByRole('button', { name: 'Copy code' }).click();
  await dialog.getByText('The code is copied.').waitFor();
  expect(await clipboard()).toMatch(/^<iframe /);
  await dialog.getByRole('button', { name: 'Copy link' }).click();
  await dialog.getByText('The link is copied.').waitFor();
  expect(await clipboard()).toBe(link);
  await visit.page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });

  await visit.page.evaluate(() => window.chebnet.setOptions({ method: 'projection' }));
  const [x, y, z] = await visit.script.position(0);
  await visit.script.move(0, [x, y, z - 5]);
  await visit.script.settled();
  await press('Share');
  await dialog.getByText('The code leaves out the shape of the moment').waitFor();
  await dialog.getByRole('img', { name: 'QR code' }).waitFor();
  await visit.page.keyboard.press('Escape');

  await visit.script.open({ obj: uneven(40, 40) });
  await press('Share');
  await dialog.getByText('The link is too long for a QR code.').waitFor();
});

test.each([
  ['light', 390],
  ['dark', 1280],
] as const)('menu and link fit a %s screen of %d pixels', async (colorScheme, width) => {
  await visit.page.emulateMedia({ colorScheme });
  await visit.page.setViewportSize({ width, height: width === 390 ? 844 : 800 });
  await press('Export');
  await expectInside(menu());
  await visit.page.screenshot({ path: join(OUTPUT, `save-${colorScheme}-${width}.png`) });
  await visit.page.keyboard.press('Escape');
  await press('Share');
  await visit.page.getByRole('img', { name: 'QR code' }).waitFor();
  await expectInside(visit.page.getByRole('dialog'));
  await visit.page.screenshot({ path: join(OUTPUT, `share-${colorScheme}-${width}.png`) });
});

/** Once the page is laid out for the size that the window has. */
async function expectInside(part: ReturnType<typeof menu>) {
  const { width, height } = visit.page.viewportSize()!;
  const isInside = async () => {
    const box = (await part.boundingBox())!;
    return box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height;
  };
  await expect.poll(isInside).toBe(true);
}

test('"File" has all that people look for there: open, save, export, share', async () => {
  const { page } = visit;
  const file = page.getByRole('group', { name: 'Project' });
  await press('File');
  const entries = await file.getByRole('button').allInnerTexts();
  expect(entries.map((text) => text.split(/\s{2,}|\n/)[0])).toEqual(
    expect.arrayContaining(['Open…', 'Save project', 'Export…', 'Share…']),
  );
  await file.getByRole('button', { name: /^Export…/ }).click();
  await menu().waitFor();
  expect(await file.isVisible()).toBe(false);
  const download = page.waitForEvent('download');
  await menu().getByRole('button', { name: 'OBJ' }).click();
  expect((await download).suggestedFilename()).toMatch(/\.obj$/);
  await press('File');
  await file.getByRole('button', { name: /^Share…/ }).click();
  await page.getByRole('dialog').waitFor();
});

test('arrow keys, Home and End go through a menu, and Escape gives the focus back', async () => {
  const { page } = visit;
  const { keyboard } = page;
  const focused = () => page.evaluate(() => document.activeElement!.textContent);
  for (const [name, first, last] of [
    ['File', /^New/, /^Share/],
    ['Export', /^OBJ/, /^Video/],
  ] as const) {
    const button = page.getByRole('button', { name, exact: true });
    await button.focus();
    await keyboard.press('ArrowDown');
    await expect.poll(focused).toMatch(first);
    await keyboard.press('ArrowUp');
    expect(await focused()).toMatch(last);
    await keyboard.press('ArrowDown');
    expect(await focused()).toMatch(first);
    await keyboard.press('ArrowDown');
    expect(await focused()).not.toMatch(first);
    await keyboard.press('End');
    expect(await focused()).toMatch(last);
    await keyboard.press('Home');
    expect(await focused()).toMatch(first);
    await keyboard.press('Escape');
    expect(await page.locator('.menu:popover-open').count()).toBe(0);
    expect(await focused()).toBe(name);
  }
});

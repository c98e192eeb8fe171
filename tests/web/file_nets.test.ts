/** The net of a file: arrays that every state of the history shares, text where it leaves the page. */
import { expect, test } from 'vitest';
import type { Mesh } from '../../wasm/chebnet';
import { freshScene } from '../../web/src/document/defaults';
import type { FileNet, NetSource } from '../../web/src/document/document';
import { parseProject, projectText, readProject, writeProject } from '../../web/src/document/project';
import { HANDLE_BYTES, Measure } from '../../web/src/document/undo';
import { hashOf, sceneOf } from '../../web/src/projects/link';
import { load } from '../wasm/load';
import { uneven } from './nets';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

const core = await load();
const SHEET = uneven(9, 7);
const meshOf = (text: string): Mesh => core.readMesh(new TextEncoder().encode(text), 'net.obj');
const mesh = meshOf(SHEET);
const BYTES = mesh.positions.byteLength + mesh.faceStart.byteLength + mesh.faceVertices.byteLength;

const netsOf = ({ app }: Page): NetSource[] => app.project()!.entries.map(({ state }) => state.net);
const netOf = ({ app }: Page): FileNet => app.opening!.document.net as FileNet;

/** With a history of the net, of so many entries. */
async function pageWith(net: NetSource, entries = 6): Promise<Page> {
  const page = await openPage(core);
  await page.app.openScene(freshScene(net));
  await page.solve();
  for (let i = 1; i < entries; ++i) {
    await page.app.handles.set([{ vertex: 0, target: [0, 0, i / 100], anchor: false }]);
    await page.solve();
  }
  return page;
}

/** Of a history in all, and of what else there is than its net. */
function bytesOf(page: Page): { bytes: number; besideNet: number } {
  const states = page.app.project()!.entries.map(({ state }) => state);
  const measure = new Measure();
  for (const state of states) measure.add(state);
  const positions = new Set(states.map((state) => state.positions)).size * 8 * 3 * 63;
  const handles = [...new Set(states.map((state) => state.handles))].flat().length * HANDLE_BYTES;
  return { bytes: measure.bytes, besideNet: positions + handles };
}

test.each<[string, NetSource]>([
  ['arrays', { mesh, name: 'sheet.obj' }],
  ['text', { obj: SHEET, name: 'sheet.obj' }],
])('that came as %s is held once by a long history, as arrays', async (_, net) => {
  const page = await pageWith(net);
  expect(new Set(netsOf(page)).size).toBe(1);
  expect(netsOf(page)).toHaveLength(6);
  expect(netOf(page)).toEqual({ mesh, name: 'sheet.obj' });
  const { bytes, besideNet } = bytesOf(page);
  expect(bytes).toBe(BYTES + besideNet);
});

test('that came as text costs a document nothing: the page has the arrays anyway', async () => {
  const page = await pageWith({ obj: SHEET, name: 'sheet.obj' }, 1);
  const { restPositions, faceStart, faceVertices } = page.app.opening!.net;
  expect(netOf(page).mesh.positions).toBe(restPositions);
  expect(netOf(page).mesh.faceStart).toBe(faceStart);
  expect(netOf(page).mesh.faceVertices).toBe(faceVertices);
});

test('is text in the file of a project, until an entry that has it is gone to', async () => {
  const before = await pageWith({ mesh, name: 'sheet.obj', restLengths: 'own' }, 3);
  await before.app.openNet({ mesh: meshOf(uneven(4, 4)), name: 'small.obj' });
  await before.solve();
  const project = parseProject(projectText(before.app.project()!));
  const [sheet, , , small] = project.entries.map(({ state }) => state.net);
  expect(sheet).toEqual({ obj: SHEET, name: 'sheet.obj', restLengths: 'own' });
  expect(small).toEqual({ obj: uneven(4, 4), name: 'small.obj' });

  const page = await openPage(core);
  await page.app.openProject(project);
  expect(netsOf(page)).toEqual([sheet, sheet, sheet, { mesh: meshOf(uneven(4, 4)), name: 'small.obj' }]);
  page.app.goTo(1);
  await page.solve();
  expect(netOf(page)).toEqual({ mesh, name: 'sheet.obj', restLengths: 'own' });
  expect(new Set(netsOf(page)).size).toBe(2);
  expect(netsOf(page).some((net) => 'obj' in net)).toBe(false);
  expect(page.said).toEqual([]);
});

test('is arrays in what the browser keeps, which are not copied', async () => {
  const page = await pageWith({ mesh, name: 'sheet.obj' }, 3);
  const record = writeProject(page.app.project()!, Infinity);
  expect(record).toMatchObject({ chebnet: 3, nets: [{ mesh, name: 'sheet.obj' }] });
  expect((record['nets'] as FileNet[])[0]!.mesh.positions).toBe(netOf(page).mesh.positions);
  expect(readProject(structuredClone(record))).toEqual(page.app.project());
});

test('without which the browser keeps what pages of before can open, too', async () => {
  const page = await pageWith({ recipe: 'dome:vertices=100' }, 1);
  expect(writeProject(page.app.project()!, Infinity)).toMatchObject({ chebnet: 2 });
});

test.each([
  ['positions', [0, 0, 0]],
  ['positions', new Float32Array(3)],
  ['faceStart', undefined],
  ['faceVertices', 'AAAA'],
])('whose %s are none is refused, and it is said where', async (field, value) => {
  const page = await pageWith({ mesh, name: 'sheet.obj' }, 1);
  const record = writeProject(page.app.project()!, Infinity);
  const damaged = { ...record, nets: [{ mesh: { ...mesh, [field]: value }, name: 'sheet.obj' }] };
  expect(() => readProject(damaged)).toThrow(`nets[0].mesh.${field} must be`);
});

test('is text in a link', async () => {
  const page = await pageWith({ mesh, name: 'sheet.obj' }, 1);
  const { hash } = hashOf(page.app);
  expect((await sceneOf(hash!)).net).toEqual({ obj: SHEET, name: 'sheet.obj' });
});

test('is what a worker goes on with after one that was lost', async () => {
  const page = await pageWith({ mesh, name: 'sheet.obj' }, 2);
  const { positions } = page.app.opening!.frame;
  page.loseWorker();
  await page.solve();
  expect(page.app.opening!.frame.positions).toEqual(positions);
});

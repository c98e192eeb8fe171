/** Makes the golden files of this day's page that are not there yet. Those that are there stay: they are what visitors have. */
import type { Chebnet } from '../../wasm/chebnet';
import { whereDragged } from '../../web/src/app/state';
import type { Replay, SolverSettings, Vec3 } from '../../web/src/document/document';
import type { ChangeName } from '../../web/src/document/naming';
import { projectText, writeProject } from '../../web/src/document/project';
import type { Project } from '../../web/src/document/project';
import { encodeEdit } from '../../web/src/document/share';
import { hashOf, sceneOf } from '../../web/src/projects/link';
import { freshScene } from '../../web/src/document/defaults';
import { isMade, keptText, projectWithText, withText, writeGolden } from './golden_files';
import type { ExpectedLink } from './golden_files';
import { CHANGES, goldenLinks, pulled, SMALL } from './golden_scenes';
import type { GoldenLink } from './golden_scenes';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

/** @param folder of the version that is written, e.g. `v1`. */
export async function makeGoldens(core: Chebnet, folder: string): Promise<void> {
  for (const [title, link] of Object.entries(goldenLinks(core))) {
    const name = `${folder}/${title}`;
    if (!isMade(name, 'link')) writeGolden({ name, ...(await makeLink(core, link)) }, 'link');
  }
  for (const [title, make] of Object.entries(projects(core))) {
    const name = `${folder}/${title}`;
    if (isMade(name, 'chebnet.json')) continue;
    const project = await make(core);
    const expected = projectWithText(project);
    writeGolden({ name, text: projectText(project), expected }, 'chebnet.json');
    writeGolden({ name, text: keptText(writeProject(project, Infinity)), expected }, 'kept.json');
  }
}

/** What is not there yet. */
export function missingGoldens(core: Chebnet, folder: string): string[] {
  const links = Object.keys(goldenLinks(core)).filter((title) => !isMade(`${folder}/${title}`, 'link'));
  return [...links, ...Object.keys(projects(core)).filter((title) => !isMade(`${folder}/${title}`, 'chebnet.json'))];
}

// --------------------------------------------------------------------------------------------------------------- links

async function makeLink(
  core: Chebnet,
  { scene, drag, unsolved, replay, largest }: GoldenLink,
): Promise<{ text: string; expected: ExpectedLink }> {
  const page = await openPage(core);
  await page.app.openScene(scene);
  if (!unsolved) await page.solve();
  if (drag) await dragLast(page, drag, replay !== undefined);
  const document = withText(page.app.toShare()!.document);
  const shared = replay ? { hash: hashWithDrag(page, replay), positions: false } : hashOf(page.app, largest);
  if (shared.hash === null) throw new Error('too large for a link');
  const opened = await openPage(core);
  await opened.app.openScene(await sceneOf(shared.hash));
  if (replay) await opened.solve();
  const { document: again, frame } = opened.app.opening!;
  // A net that was packed, and handles that rest on it, are a little elsewhere.
  const known = { ...document, net: withText(again).net, handles: again.handles };
  const expected = shared.positions
    ? { ...known, positions: document.positions! }
    : { ...known, positions: frame.positions, settled: replay !== undefined };
  return {
    text: shared.hash,
    expected: { document: expected, deviations: Array.from(frame.fields.deviation, (x) => Number(x.toPrecision(6))) },
  };
}

function hashWithDrag({ app }: Page, replay: Replay): string {
  const { document, net } = app.toShare()!;
  const handles = document.handles.map((handle) => ({ ...handle, target: whereDragged(handle.target) }));
  return encodeEdit({ ...document, net: document.net as { recipe: string }, handles }, net, replay);
}

async function dragLast(page: Page, [dx, dy, dz]: Vec3, inHand = false): Promise<void> {
  const {
    vertex,
    target: [x, y, z],
  } = page.app.opening!.document.handles.at(-1)!;
  await page.app.handles.move([{ vertex, target: [x + dx, y + dy, z + dz] }], 'drag', inHand);
  await page.solve();
}

// ------------------------------------------------------------------------------------------------------------ histories

/** A change, a method or an option more is a file more. */
function projects(core: Chebnet): Record<string, (core: Chebnet) => Promise<Project>> {
  return {
    lesson,
    file,
    guided,
    turned,
    [`${names().length}-changes`]: changes,
    [`${allSettings(core).length}-settings`]: settings,
  };
}

/** Of two nets, with two changes undone. */
async function lesson(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  const { app } = page;
  await app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
  await page.solve();
  await dragLast(page, [0.3, -0.2, -0.4]);
  app.handles.setLocality(4);
  await dragLast(page, [0.1, 0, 0.1]);
  app.handles.setLocality(undefined);
  app.handles.setSymmetry({ axis: 'x', through: 'centre' });
  await app.openNet({ recipe: 'vault:vertices=100' });
  await page.solve();
  await app.setOptions({ method: 'li2022', initialisation: 'local_global:2', options: { threshold: 1e-7 } });
  await dragLast(page, [0.5, 0.25, -0.125]);
  await app.reset();
  await page.solve();
  app.undo();
  await page.solve();
  app.undo();
  await page.solve();
  return app.project()!;
}

/** Of a net that came from a file. */
async function file(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  await page.app.openScene(pulled({ ...SMALL, restLengths: 'equal' }, 8, [2, 2, 0.5]).scene);
  await page.solve();
  await dragLast(page, [0.1, -0.1, 0]);
  return page.app.project()!;
}

/** Beside a surface that a visitor brought, then beside one of ours, then beside none. */
async function guided(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  await page.app.openScene(pulled(SMALL, 8, [2, 2, 0.5]).scene);
  await page.solve();
  const mesh = {
    positions: Float64Array.of(-1, -1, 0.1, 4, -1, 0, 4, 4, 0.1 + 0.2, -1, 4, 0),
    faceStart: Int32Array.of(0, 4),
    faceVertices: Int32Array.of(0, 1, 2, 3),
  };
  await page.app.setGuide({ name: 'scan 面.obj', mesh });
  await page.solve();
  await page.app.setGuide({ own: 'hypar' });
  await page.solve();
  await page.app.setGuide(undefined);
  await page.solve();
  page.app.undo();
  await page.solve();
  page.app.undo();
  await page.solve();
  return page.app.project()!;
}

/** Between two nets with their y axis up, one with z. */
async function turned(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  const { app } = page;
  await app.openNet({ ...SMALL, name: 'lies.obj' });
  app.setView({ upAxis: 'y' });
  await page.solve();
  await app.openNet({ recipe: 'dome:vertices=100' });
  await page.solve();
  await app.openNet(SMALL, 'y');
  await page.solve();
  app.undo();
  await page.solve();
  return app.project()!;
}

/** Of one state, by all names that a change can have. */
async function changes(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  await page.app.openScene(freshScene(SMALL));
  await page.solve();
  const { entries, view } = page.app.project()!;
  const { state } = entries[0]!;
  return { entries: names().map((name) => ({ name, state })), present: 3, view };
}

function names(): ChangeName[] {
  return ['Words of an older page', ...Object.values(CHANGES).flat()];
}

/** Under every one of them. */
async function settings(core: Chebnet): Promise<Project> {
  const page = await openPage(core);
  await page.app.openScene(freshScene(SMALL));
  await page.solve();
  for (const each of allSettings(core)) await page.app.setOptions(each);
  await page.solve();
  return page.app.project()!;
}

/** Every method, initialisation and option. */
function allSettings(core: Chebnet): SolverSettings[] {
  const usual: SolverSettings = { method: 'projection', initialisation: 'naive', options: {} };
  const methods = core.methods().map(({ name }) => ({ ...usual, method: name }));
  const starts = core
    .initialisations()
    .map(({ name, counted }) => ({ ...usual, initialisation: counted ? `${name}:2` : name }));
  const options = core
    .options()
    .map(({ name, kind, value }) => ({ ...usual, options: { [name]: kind === 'flag' ? value === 0 : 2 * value } }));
  return [...methods, ...starts, ...options];
}

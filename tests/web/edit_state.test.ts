/** The state of an edit, every field of it, on each way it can take: to the other module, through undo, a link and a project,
 *  and to the worker after one that was lost. */
import { beforeEach, expect, test, vi } from 'vitest';
import type { EditState, Editor, Editors } from '../../wasm/chebnet';
import { freshScene } from '../../web/src/document/defaults';
import type { ChebnetDocument, Scene } from '../../web/src/document/document';
import { sentenceOf } from '../../web/src/document/naming';
import { parseProject, projectText } from '../../web/src/document/project';
import { codeOf, Failure } from '../../web/src/failure';
import { hashOf, sceneOf } from '../../web/src/projects/link';
import { largestDistance, load, loadFirst } from '../wasm/load';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

type Place = [number, number, number];

const [first, whole] = await Promise.all([loadFirst(), load()]);
const recipe = 'vault:vertices=300';
const fresh = whole.openRecipe(recipe);
const dragged = fresh.suggestedHandles.at(-1) ?? -1;
const anchors = Array.from(fresh.suggestedHandles).slice(0, -1);

const exactHandles = [
  ...anchors.map((vertex) => ({ vertex, target: at(vertex), anchor: true })),
  { vertex: dragged, target: at(dragged), anchor: false, name: 'crown' },
];

/** Nothing as in a net just opened. */
const scene: Scene = {
  ...freshScene({ recipe }),
  handles: [...exactHandles, { vertex: 5, target: at(5, 0.5), anchor: false, weight: 0.25, hidden: true }],
  initialisation: 'arap:3',
  options: { threshold: 1e-8, max_iterations: 150, adaptive_p: false },
  locality: 5,
  symmetry: { axis: 'x', through: 'centre' },
  experiment: 'fig-locking',
  compare: ['li2022', 'dp4'],
};

let editors: Editor[];
let page: Page;

function at(vertex: number, up = 0): Place {
  const [x = NaN, y = NaN, z = NaN] = fresh.restPositions.subarray(3 * vertex, 3 * vertex + 3);
  return [x, y, z + up];
}

/** The core, which keeps the editors it opens where the test can see them. */
function watched(core: Editors): Editors {
  const keep = (editor: Editor): Editor => editors[editors.push(editor) - 1]!;
  return { ...core, openRecipe: (from) => keep(core.openRecipe(from)) };
}

function editor(): Editor {
  return editors.at(-1) ?? expect.fail('no net is open');
}

/** A copy: of what is to come back nothing may be shared. */
function present(): ChebnetDocument {
  return structuredClone(page.app.toShare()!.document);
}

/** What the solver has of the document, at rest: a locality is that of a drag. */
async function expectBack(document: ChebnetDocument, state: EditState): Promise<void> {
  await page.solve();
  expect(present()).toEqual(document);
  expect(editor().state()).toEqual({ ...state, locality: null });
}

beforeEach(() => openAndDrag(scene));

async function openAndDrag(opened: Scene): Promise<void> {
  editors = [];
  page = await openPage(watched(first), watched(whole));
  await page.app.openScene(opened);
  await page.solve();
  await page.app.handles.move([{ vertex: dragged, target: at(dragged, -0.5) }]);
  await page.solve();
  expect(page.app.opening?.frame.status).toBe('converged');
}

test('is nowhere as in a net just opened, but for the method of the first module', () => {
  const [state, usual] = [editor().state(), fresh.state()];
  for (const field of Object.keys(state) as (keyof EditState)[]) {
    if (field !== 'method') expect(state[field], field).not.toEqual(usual[field]);
  }
  expect(state).toMatchObject({ initialisation: 'arap:3', options: scene.options, locality: { radius: 5 } });
  expect(state.locality?.heldAt).not.toEqual(state.positions);
  expect(state.handles).toContainEqual({ vertex: 5, target: at(5, 0.5), weight: 0.25 });
});

test('goes to the other module, and on from there bit for bit', async () => {
  // An initialisation is followed by a method that the first module lacks, which has no soft handles either.
  const { locality: _, ...everywhere } = scene;
  await openAndDrag({ ...everywhere, handles: exactHandles, initialisation: 'naive' });
  expect(editors).toHaveLength(1);
  const before = editor().state();
  const stayed = first.openRecipe(recipe);
  stayed.setState(before);
  await page.app.exported('obj');
  expect(editors).toHaveLength(2);
  expect(editor().state()).toEqual(before);
  for (const each of [stayed, editor()]) {
    each.moveHandle(dragged, at(dragged, -0.6));
    expect(each.solve().status).toBe('converged');
  }
  expect(editor().state()).toEqual(stayed.state());
});

test('comes back by undo, and again by redo', async () => {
  const [document, state] = [present(), editor().state()];
  const { app } = page;
  await app.handles.set([{ vertex: 0, target: at(0, 1), anchor: false }]);
  await app.setOptions({ method: 'li2022', initialisation: 'naive', options: {} });
  app.handles.setLocality(undefined);
  app.handles.setSymmetry(undefined);
  await page.solve();
  const [otherDocument, otherState] = [present(), editor().state()];
  expect(otherState).toMatchObject({ method: 'li2022', options: fresh.options() });
  app.goTo(app.history.present - 4);
  await expectBack(document, state);
  app.goTo(app.history.present + 4);
  await expectBack(otherDocument, otherState);
});

test('comes back from a link, positions so exact that the net stays solved', async () => {
  const [document, state] = [present(), editor().state()];
  const { hash } = hashOf(page.app);
  const before = editor();
  await page.app.openScene(await sceneOf(hash ?? expect.fail('no link')));
  await page.solve();
  expect(editor()).not.toBe(before);
  const { positions } = editor().state();
  expect(largestDistance(positions, state.positions)).toBeLessThan(1e-4 * fresh.info.meanLength);
  expect(Math.max(...editor().fields().deviation)).toBeLessThan(1e-8);
  await expectBack({ ...document, positions }, { ...state, positions });
});

test('comes back from a project', async () => {
  const [document, state] = [present(), editor().state()];
  const before = editor();
  await page.app.openProject(parseProject(projectText(page.app.project()!)));
  expect(editor()).not.toBe(before);
  await expectBack(document, state);
});

test('comes back in the worker after one that was lost, be it just told or not', async () => {
  const [document, state] = [present(), editor().state()];
  const before = editor();
  page.loseWorker();
  await expectBack(document, state);
  const second = editor();
  expect(second).not.toBe(before);
  expect(page.said).toHaveLength(1);

  const handles = document.handles.slice(1);
  const telling = page.app.handles.set(handles);
  page.loseWorker();
  await telling;
  await expectBack({ ...document, handles }, { ...state, handles: state.handles.slice(1) });
  expect(editor()).not.toBe(second);
  page.app.undo();
  await expectBack(document, state);
});

test('has options and moves that a lost worker had not answered, in the next one', async () => {
  const { locality: _, ...everywhere } = scene;
  await openAndDrag({ ...everywhere, initialisation: 'naive' });
  const [document, state] = [present(), editor().state()];
  const { method, initialisation } = document;
  const options = { ...document.options, max_iterations: 77 };
  const asked = [
    page.app.setOptions({ method, initialisation, options }),
    page.app.handles.move([{ vertex: dragged, target: at(dragged, -0.4) }]),
  ];
  page.loseWorker();
  await Promise.all(asked);
  await page.solve();
  expect(present().options).toEqual(options);
  expect(editor().state().options).toEqual({ ...state.options, max_iterations: 77 });
  expect(editor().state().handles).toContainEqual({ vertex: dragged, target: at(dragged, -0.4) });
  page.app.undo();
  page.app.undo();
  await expectBack(document, state);
});

test('is not said to be lost with what waited for it one by one; what another worker fails with is said', async () => {
  const { app, said } = page;
  const solving = app.step().catch((error: unknown) => app.report(error));
  page.loseWorker();
  await solving;
  await page.solve();
  expect(said).toHaveLength(1);
  app.report(new Failure('worker_lost', 'no change'));
  expect(said.slice(1)).toEqual(['No change.']);
});

test('what is asked of a net while another is being opened is refused, and reaches neither', async () => {
  const { app } = page;
  const opening = app.openScene({ ...freshScene({ recipe: 'dome:vertices=100' }), handles: [] });
  const before = present();
  const { method, initialisation } = before;
  const refused = [
    app.handles.set([{ vertex: 7, target: at(7), anchor: false }]),
    app.handles.move([{ vertex: 7, target: at(7, 1) }]),
    app.setOptions({ method, initialisation, options: { max_iterations: 7 } }),
    app.setGuide({ own: 'hypar' }),
    app.adaptLengths(() => {}),
    app.flip(),
    app.searchRest(() => {}),
    app.reset(),
    app.moveWhole(),
  ].map((each) => each.then(() => 'taken', codeOf));
  app.handles.change([dragged], { name: 'top' });
  app.handles.beginDrag();
  app.handles.drag([{ vertex: dragged, target: at(dragged, 1) }]);
  expect(present()).toEqual(before);
  expect(new Set(await Promise.all(refused))).toEqual(new Set(['cancelled']));
  await opening;
  await page.solve();
  expect([editor().state().handles, present().handles]).toEqual([[], []]);
  expect(editor().state().options).toEqual(fresh.options());
  expect(page.said).toHaveLength(1); // that there are no handles
});

test('a net pushed through that finds no rest goes back, unless a hand has taken hold of it meanwhile', async () => {
  const { app } = page;
  /** Until the net is on its way. */
  const pushThrough = async () => {
    const { present: place } = app.history;
    const end = app.flip();
    await vi.waitFor(() => expect(app.history.present).toBe(place + 1));
    return { end };
  };
  await app.setOptions({ method: 'equilibrium', initialisation: 'naive', options: { max_iterations: 1 } });
  await page.solve();
  const before = present();
  const back = await pushThrough();
  await page.solve();
  expect(await back.end).toBe(0);
  await page.solve();
  expect(present()).toEqual(before);

  const taken = await pushThrough();
  app.handles.beginDrag();
  app.handles.drag([{ vertex: dragged, target: at(dragged, -0.3) }]);
  const letGo = taken.end.finally(() => app.handles.endDrag(false));
  await page.solve();
  expect(await letGo).toBeNull();
  await page.solve();
  expect(app.history.names.slice(-2).map((name) => sentenceOf(name))).toEqual(['Flip through', 'Move handle crown']);
});

test('with anything wrong in it changes nothing', async () => {
  const before = editor().state();
  const refused: [Partial<EditState>, string][] = [
    [{ handles: [{ vertex: 1e6, target: [0, 0, 0] }] }, 'index_out_of_range'],
    [{ handles: [{ vertex: 1, target: [0, 0, 0], weight: -1 }] }, 'bad_option'],
    [{ method: 'magic' }, 'bad_option'],
    [{ initialisation: 'arap:0' }, 'bad_option'],
    [{ options: { p_end: 1000 } }, 'bad_option'],
    [{ options: { magic: 1 } }, 'bad_option'],
    [{ locality: { radius: 0, origins: [1] } }, 'bad_option'],
    [{ locality: { radius: 3, origins: [1], heldAt: new Float64Array(3) } }, 'index_out_of_range'],
    [{ positions: new Float64Array(3) }, 'index_out_of_range'],
    [{ positions: before.positions.map(() => NaN) }, 'non_finite'],
  ];
  for (const [change, code] of refused) {
    // None of the rest is as the editor has it.
    expect(() => editor().setState({ ...fresh.state(), ...change }), Object.keys(change).join()).toThrow(
      expect.objectContaining({ code }),
    );
    expect(editor().state()).toEqual(before);
  }
});

test('is seen anew where another axis is to be up, and only then', async () => {
  const { app } = page;
  const camera = { position: at(0, 9), target: at(0) };
  const seen = () => [app.opening!.document.view.upAxis, app.opening!.document.view.camera];
  app.setView({ camera });
  app.setView({ upAxis: 'z', behind: true });
  expect(seen()).toEqual(['z', camera]);
  app.setView({ upAxis: 'y' });
  expect(seen()).toEqual(['y', null]);
  expect(app.opening!.document.view.behind).toBeUndefined();
});

test('hangs downwards as it is seen, which a net opened after it does, too', async () => {
  const { app } = page;
  const isYUp = () => app.opening!.document.options.y_up === true;
  const height = (axis: number) => {
    const along = Array.from(present().positions!).filter((_, i) => i % 3 === axis);
    return along.reduce((sum, x) => sum + x) / along.length;
  };
  await app.setOptions({ method: 'equilibrium', initialisation: 'naive', options: { gravity: 0.01 } });
  await page.solve();
  const [upright, onItsSide] = [height(2), height(1)];
  app.setView({ upAxis: 'y' });
  await page.solve();
  expect(isYUp()).toBe(true);
  expect(height(2)).toBeGreaterThan(upright);
  expect(height(1)).toBeLessThan(onItsSide);
  app.undo();
  await page.solve();
  expect(isYUp()).toBe(false); // without weight
  app.setView({ upAxis: 'z' });
  app.setView({ upAxis: 'y' });
  app.redo();
  await page.solve();
  expect(isYUp()).toBe(true);

  await app.openNet({ recipe: 'sheet:vertices=100' }, 'y');
  expect(isYUp()).toBe(true);
  await app.openNet({ recipe });
  expect(isYUp()).toBe(false);
  app.setView({ upAxis: 'y' });
  expect(isYUp()).toBe(true);
  app.setView({ upAxis: 'z' });
  expect(isYUp()).toBe(false);
});

test('goes by one step to rest with other options, and to all of the net moving; one undo brings it back', async () => {
  const { app } = page;
  for (const doing of [() => app.reset({ shear_limit: 0 }), () => app.moveWhole()]) {
    const [before, { present: place }] = [present(), app.history];
    await doing();
    await page.solve();
    expect(app.history.present).toBe(place + 1);
    expect(present()).not.toEqual(before);
    expect(editor().options()).toMatchObject(app.opening!.document.options);
    app.undo();
    await page.solve();
    expect(present()).toEqual(before);
  }
});

test('keeps a name that is given while other lengths are looked for, also when those are taken back', async () => {
  const { app } = page;
  const { locality: _, ...whole } = scene;
  await app.openScene({ ...whole, method: 'equilibrium', initialisation: 'naive', options: {} });
  await page.solve();
  await app.handles.move([{ vertex: dragged, target: at(dragged, 20) }]);
  await page.solve();
  const growing = app.adaptLengths(() => {});
  app.handles.change([dragged], { name: 'top' });
  await page.solve();
  expect(await growing).toBeGreaterThan(1);
  await page.solve();
  const name = () => app.opening!.document.handles.find(({ vertex }) => vertex === dragged)?.name;
  expect(name()).toBe('top');
  app.undo();
  await page.solve();
  expect(app.opening!.document.options).not.toHaveProperty('length_scale');
  expect(name()).toBe('top');
});

test('says of a net that did not come to rest so, where undo, a project, a link or another worker bring it back', async () => {
  const { app } = page;
  const status = () => app.opening!.frame.status;
  await app.setOptions({ method: 'equilibrium', initialisation: 'naive', options: { max_iterations: 2 } });
  await app.handles.move([{ vertex: dragged, target: at(dragged, -0.9) }]);
  await page.solve();
  expect(status()).toBe('max_iterations');
  const [left, project] = [present(), parseProject(projectText(app.project()!))];

  await app.setOptions({ method: 'equilibrium', initialisation: 'naive', options: { max_iterations: 500 } });
  await app.handles.move([{ vertex: dragged, target: at(dragged, -0.8) }]);
  await page.solve();
  expect(status()).toBe('converged');
  app.goTo(app.history.present - 2);
  await page.solve();
  expect([present(), status()]).toEqual([left, 'max_iterations']);
  page.loseWorker();
  await page.solve();
  expect(status()).toBe('max_iterations');
  app.goTo(app.history.present + 2);
  await page.solve();
  expect(status()).toBe('converged');

  const other = await openPage(first, whole);
  await other.app.openProject(project);
  await other.solve();
  expect(other.app.opening!.frame.status).toBe('max_iterations');
  await other.app.openScene(await sceneOf(hashOf(other.app).hash ?? expect.fail('no link')));
  await other.solve();
  expect(other.app.opening!.frame.status).toBe('max_iterations');
});

test('has the surface beside the net, which undo, a project and a worker after the first keep', async () => {
  page = await openPage(watched(first), watched(whole));
  await page.app.openScene({ ...scene, method: 'equilibrium', initialisation: 'naive', options: {} });
  await page.solve();
  const { app } = page;
  const height = () => Math.hypot(...app.opening!.frame.fields.height);
  expect(height()).toBe(0);
  const mesh = {
    positions: Float64Array.of(-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0),
    faceStart: Int32Array.of(0, 4),
    faceVertices: Int32Array.of(0, 1, 2, 3),
  };
  await app.setGuide({ name: 'floor.obj', mesh });
  await page.solve();
  const near = height();
  expect(near).toBeGreaterThan(0);
  expect(sentenceOf(app.history.names.at(-1)!)).toBe('Surface floor.obj');
  await app.setOptions({ method: 'equilibrium', initialisation: 'naive', options: { guide_mode: 0 } });
  await app.handles.move([{ vertex: dragged, target: at(dragged, 0.4) }]);
  await page.solve();
  expect(height()).toBeGreaterThan(near);

  page.loseWorker();
  await page.solve();
  expect(height()).toBeGreaterThan(near);
  expect((await app.handles.guide())?.positions).toHaveLength(12);
  await app.putHandlesOnGuide();
  expect(app.opening!.document.handles.find(({ vertex }) => vertex === dragged)?.target[2]).toBe(0);
  expect(app.opening!.document.handles.find(({ anchor }) => anchor)?.target[2]).not.toBe(0);
  app.undo();
  await page.solve();
  const project = parseProject(projectText(app.project()!));
  const other = await openPage(first, whole);
  await other.app.openProject(project);
  await other.solve();
  expect(other.app.opening!.document.guide).toEqual({ name: 'floor.obj', mesh });
  expect(Math.hypot(...other.app.opening!.frame.fields.height)).toBeCloseTo(height(), 5);
  for (let i = 0; i < 3; i++) {
    other.app.undo();
    await other.solve();
  }
  expect(other.app.opening!.document).not.toHaveProperty('guide');
  expect(Math.hypot(...other.app.opening!.frame.fields.height)).toBe(0);
  expect(await other.app.handles.guide()).toBeNull();
});

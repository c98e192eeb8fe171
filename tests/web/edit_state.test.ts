/** The state of an edit, every field of it, on each way it can take: to the other module, through undo, a link and a project,
 *  and to the worker after one that was lost. */
import { beforeEach, expect, test } from 'vitest';
import type { EditState, Editor, Editors } from '../../wasm/chebnet';
import { DEFAULT_VIEW, freshScene } from '../../web/src/document/defaults';
import type { ChebnetDocument, Scene } from '../../web/src/document/document';
import { parseProject, projectText } from '../../web/src/document/project';
import { decodeScene, encodeScene } from '../../web/src/document/share';
import { Client } from '../../web/src/worker/client';
import type { WorkerLike } from '../../web/src/worker/client';
import type { Request } from '../../web/src/worker/protocol';
import { Session } from '../../web/src/worker/session';
import { largestDistance, load, loadFirst } from '../wasm/load';

type Place = [number, number, number];

const [first, whole] = await Promise.all([loadFirst(), load()]);
const recipe = 'vault:vertices=300';
const fresh = whole.openRecipe(recipe);
const suggested = Array.from(fresh.suggestedHandles);
const dragged = suggested.at(-1) ?? -1;
const locality = { radius: 5, origins: [dragged] };

/** Nothing as in a net just opened. */
const scene: Scene = {
  ...freshScene({ recipe }),
  handles: [
    ...suggested.map((vertex) => ({ vertex, target: at(vertex), anchor: false })),
    { vertex: 5, target: at(5, 0.5), anchor: false, weight: 0.25 },
  ],
  initialisation: 'arap:3',
  options: { threshold: 1e-8, max_iterations: 150, adaptive_p: false },
  settled: true,
};

let editors: Editor[];
let tasks: (() => void)[];
let workers: WorkerLike[];
let client: Client;

function at(vertex: number, up = 0): Place {
  const [x = NaN, y = NaN, z = NaN] = fresh.restPositions.subarray(3 * vertex, 3 * vertex + 3);
  return [x, y, z + up];
}

/** The core, which keeps the editors it opens where the test can see them. */
function watched(core: Editors): Editors {
  const keep = (editor: Editor): Editor => editors[editors.push(editor) - 1]!;
  return { ...core, openRecipe: (from) => keep(core.openRecipe(from)) };
}

/** A session behind the messages of a worker. */
function newWorker(): WorkerLike {
  const worker: WorkerLike = { onmessage: null, onerror: null, onmessageerror: null, terminate: () => {}, postMessage };
  const session = new Session(watched(first), {
    post: (response) => worker.onmessage?.({ data: response } as MessageEvent),
    soon: (task) => tasks.push(task),
    now: () => 0,
    wholeCore: () => Promise.resolve(watched(whole)),
  });
  function postMessage(request: Request): void {
    queueMicrotask(() => session.handle(request));
  }
  workers.push(worker);
  return worker;
}

function present(): Editor {
  return editors.at(-1) ?? expect.fail('no net is open');
}

/** What undo, links and projects keep of the net as it stands. */
function documentOf(editor: Editor): ChebnetDocument {
  const handles = editor.handles().map((handle) => ({ ...handle, anchor: false }));
  const { net, method, initialisation, options, settled } = scene;
  return { net, method, initialisation, options, settled, handles, positions: editor.positions(), view: DEFAULT_VIEW };
}

async function solved(): Promise<void> {
  const idle = client.idle();
  await new Promise((resolve) => setTimeout(resolve));
  while (tasks.length > 0) tasks.shift()?.();
  await idle;
}

beforeEach(async () => {
  editors = [];
  tasks = [];
  workers = [];
  client = new Client(newWorker, { frame: () => {}, restarted: () => {}, gaveUp: (why) => expect.fail(why.message) });
  await client.open(scene);
  await client.setLocality(locality.radius, locality.origins);
  await client.drag([{ vertex: dragged, target: at(dragged, -1) }]);
  await solved();
});

/** What every way but that to the other module leaves behind: a locality is that of a drag. */
function atRest(state: EditState): EditState {
  return { ...state, locality: null };
}

test('is nowhere as in a net just opened, but for the method of the first module', () => {
  const [state, usual] = [present().state(), fresh.state()];
  for (const field of Object.keys(state) as (keyof EditState)[]) {
    if (field !== 'method') expect(state[field], field).not.toEqual(usual[field]);
  }
  expect(state).toMatchObject({ initialisation: 'arap:3', options: scene.options, locality });
  expect(state.locality?.heldAt).not.toEqual(state.positions);
  expect(state.handles).toContainEqual({ vertex: 5, target: at(5, 0.5), weight: 0.25 });
});

test('goes to the other module, and on from there bit for bit', async () => {
  const before = present().state();
  const stayed = first.openRecipe(recipe);
  stayed.setState(before);
  await client.exportFile('obj');
  expect(editors).toHaveLength(2);
  expect(present().state()).toEqual(before);
  for (const editor of [stayed, present()]) {
    editor.moveHandle(dragged, at(dragged, -1.1));
    expect(editor.solve().status).toBe('converged');
  }
  expect(present().state()).toEqual(stayed.state());
});

test('comes back by undo', async () => {
  const [before, document] = [present().state(), documentOf(present())];
  await client.setHandles([{ vertex: 0, target: at(0, 1) }]);
  await client.setOptions({ method: 'li2022', initialisation: 'naive', options: {} });
  await solved();
  expect(present().state()).toMatchObject({ method: 'li2022', options: fresh.options() });
  await client.restore(document);
  await solved();
  expect(present().state()).toEqual(atRest(before));
});

test('comes back from a link, positions so exact that the net stays solved', async () => {
  const before = atRest(present().state());
  const { hash } = encodeScene(documentOf(present()), present(), 1e-8);
  await client.open(decodeScene(hash ?? expect.fail('no link')));
  const { positions, ...rest } = present().state();
  expect(editors).toHaveLength(2);
  expect({ ...rest, positions: before.positions }).toEqual(before);
  expect(largestDistance(positions, before.positions)).toBeLessThan(1e-4 * fresh.info.meanLength);
  expect(Math.max(...present().deviations())).toBeLessThan(1e-8);
});

test('comes back from a project', async () => {
  const before = atRest(present().state());
  const { view, ...state } = documentOf(present());
  const { entries } = parseProject(projectText({ entries: [{ name: 'move', state }], present: 0, view }));
  await client.open(entries[0]?.state ?? expect.fail('no entry'));
  expect(editors).toHaveLength(2);
  expect(present().state()).toEqual(before);
});

test('comes back in the worker after one that was lost', async () => {
  const before = atRest(present().state());
  workers[0]?.onerror?.({ message: 'lost' } as ErrorEvent);
  await solved();
  expect(workers).toHaveLength(2);
  expect(editors).toHaveLength(2);
  expect(present().state()).toEqual(before);
});

test('with anything wrong in it changes nothing', async () => {
  const before = present().state();
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
    expect(() => present().setState({ ...fresh.state(), ...change }), Object.keys(change).join()).toThrow(expect.objectContaining({ code }));
    expect(present().state()).toEqual(before);
  }
});

/** The server over the core for a first net, and what it does when that is not enough. */
import { beforeEach, expect, test } from 'vitest';
import type { Editors } from '../../wasm/chebnet';
import { freshScene } from '../../web/src/document/defaults';
import type { HandleSeed, Vec3 } from '../../web/src/document/document';
import { pointOf } from '../../web/src/document/point_of';
import type { Request, Response } from '../../web/src/worker/protocol';
import type { WholeCore } from '../../web/src/worker/whole_core';
import { Server } from '../../web/src/worker/server';
import { load, loadFirst } from '../wasm/load';
import { wholeCoreOf } from './whole_core_of';

type Body<T = Request> = T extends unknown ? Omit<T, 'id'> : never;

const [first, whole] = await Promise.all([loadFirst(), load()]);
const recipe = 'vault:vertices=300';
const reference = first.openRecipe(recipe);
const dragged = reference.suggestedHandles.at(-1) ?? -1;
const [x = NaN, y = NaN, z = NaN] = reference.restPositions.subarray(3 * dragged, 3 * dragged + 3);
const drag: Body = { type: 'drag', inHand: false, targets: [{ vertex: dragged, target: [x, y, z - 1] }] };
/** Beyond what the net reaches. */
const farDrag: Body<Extract<Request, { type: 'drag' }>> = {
  type: 'drag',
  inHand: false,
  targets: [{ vertex: dragged, target: [x, y, z - 100] }],
};
const li2022: Body = {
  type: 'options',
  settings: { method: 'li2022', initialisation: 'arap:3', options: { p_end: 30 } },
};

let server: Server;
let said: Response[];
let tasks: (() => void)[];
let lastId: number;
let wanted: number;
let arrive: (core: Editors) => void;
let fail: (error: Error) => void;

beforeEach(() => {
  said = [];
  tasks = [];
  lastId = 0;
  wanted = 0;
  server = newServer(first);
  ask({ type: 'open', scene: { ...freshScene({ recipe }), settled: true } });
});

function newServer(core: Editors): Server {
  const wholeCore = () => {
    wanted += 1;
    return new Promise<WholeCore>((resolve, reject) => {
      arrive = (core) => resolve(wholeCoreOf(core));
      fail = reject;
    });
  };
  const host = { post: (response: Response) => said.push(response), soon: (task: () => void) => tasks.push(task) };
  return new Server(core, { ...host, now: () => 0, wholeCore });
}

function ask(body: Body): number {
  server.handle({ id: ++lastId, ...body } as Request);
  return lastId;
}

function solve(): void {
  while (tasks.length > 0) tasks.shift()?.();
}

function settled(): Extract<Response, { type: 'settled' }> {
  return (
    said.flatMap((response) => (response.type === 'settled' ? [response] : [])).at(-1) ?? expect.fail('not settled')
  );
}

/** Lets what waits for a promise run. */
async function turn(): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
}

test('a first drag does without it', () => {
  ask(drag);
  solve();
  expect(settled().frame).toMatchObject({ status: 'converged', method: 'equilibrium' });
  expect(wanted).toBe(0);
});

test('a relaxed shape opens with it', async () => {
  const id = ask({ type: 'open', scene: { ...freshScene({ recipe: 'teddy:vertices=300' }), settled: true } });
  expect(wanted).toBe(1);
  arrive(whole);
  await turn();
  expect(said).toContainEqual(expect.objectContaining({ id, type: 'opened' }));
});

test('a link whose drag is made again opens with it: taut, short of where the hand was', async () => {
  const handles = Array.from(
    reference.suggestedHandles,
    (vertex): HandleSeed => ({ vertex, target: null, anchor: true }),
  );
  const far: Vec3 = [x, y, z + 9];
  const seeds = [...handles.slice(0, -1), { vertex: dragged, target: far, anchor: false }];
  const id = ask({ type: 'open', scene: { ...freshScene({ recipe }), handles: seeds, replay: [10, 3] } });
  expect(wanted).toBe(1);
  arrive(whole);
  await turn();
  const opened = said.find((response) => response.type === 'opened' && response.id === id);
  expect(opened).toMatchObject({ frame: { holdsBack: true } });
  solve();
  const { handles: stand, positions, maxDeviation } = settled().frame;
  expect(maxDeviation).toBeLessThan(1e-6);
  expect(stand.at(-1)).toEqual({ vertex: dragged, target: pointOf(positions, dragged) });
  expect(pointOf(positions, dragged)[2]).toBeGreaterThan(z + 0.5);
  expect(pointOf(positions, dragged)[2]).toBeLessThan(far[2] - 1);
  for (const { vertex } of handles.slice(0, -1))
    expect(pointOf(positions, vertex)).toEqual(pointOf(reference.restPositions, vertex));
});

test('another method moves the net over as it stands, and is answered before what came after it', async () => {
  ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: [x, y, z - 0.5] }] });
  solve();
  const before = settled().frame;
  const id = ask(li2022);
  const after = ask({ type: 'reach', vertices: [dragged] });
  expect(said.filter((response) => response.id >= id)).toEqual([]);
  arrive(whole);
  await turn();
  expect(said.filter((response) => response.id >= id).map((response) => [response.id, response.type])).toEqual([
    [id, 'done'],
    [id, 'settled'],
    [after, 'reach'],
  ]);
  expect(settled().frame).toMatchObject({ method: 'li2022', handles: before.handles, positions: before.positions });
  expect(wanted).toBe(1);
  ask(li2022);
  expect(wanted).toBe(1);
});

test('a locality comes with it, and goes on holding what lies beyond it', async () => {
  ask({ type: 'locality', radius: 3, origins: [dragged] });
  ask(drag);
  arrive(whole);
  await turn();
  solve();
  const { positions } = settled().frame;
  const mobility = whole.openRecipe(recipe).mobility(3, [dragged]);
  const beyond = [...mobility.keys()].filter((v) => mobility[v] === 0);
  expect(beyond.length).toBeGreaterThan(0);
  expect(beyond.every((v) => positions[3 * v] === reference.restPositions[3 * v])).toBe(true);
  expect(positions[3 * dragged + 2]).toBe(z - 1);
});

test('a solve under way goes on there', async () => {
  ask(drag);
  const id = ask({ type: 'export', format: 'obj' });
  arrive(whole);
  await turn();
  expect(said).toContainEqual(expect.objectContaining({ id, type: 'exported' }));
  solve();
  expect(settled().frame).toMatchObject({ status: 'converged', method: 'equilibrium' });
});

test('a solve goes on there when it leaves to projection what the first core cannot do', async () => {
  const id = ask(farDrag);
  solve();
  expect(wanted).toBe(1);
  const after = ask({ type: 'measure' });
  arrive(whole);
  await turn();
  expect(said).toContainEqual(expect.objectContaining({ id: after, type: 'measured' }));
  solve();
  expect(settled()).toMatchObject({ id, frame: { method: 'equilibrium' } });
  expect(settled().frame.iterations).toBeGreaterThan(0);
});

test('what is in hand stays in hand there, held back, and its drag is answered once', async () => {
  const cannotSolve = (from: string) => {
    const editor = first.openRecipe(from);
    editor.solve = () => {
      throw Object.assign(new Error('left out'), { code: 'left_out' });
    };
    return editor;
  };
  server = newServer({ ...first, openRecipe: cannotSolve });
  ask({ type: 'open', scene: { ...freshScene({ recipe }), settled: true } });
  const id = ask({ ...farDrag, inHand: true });
  solve();
  expect(wanted).toBe(1);
  arrive(whole);
  await turn();
  solve();
  expect(settled()).toMatchObject({ id, frame: { status: 'converged', holdsBack: true } });
  expect(said.filter((response) => response.id === id && response.type === 'done')).toHaveLength(1);
});

test('if it does not come, the net stays and the solve ends', async () => {
  const id = ask(farDrag);
  solve();
  fail(new Error('no network'));
  await turn();
  expect(settled()).toMatchObject({ id, frame: { status: 'unreachable' } });
  expect(said.at(-1)).toMatchObject({ id, type: 'error', code: 'not_loaded' });
});

test('a net from a file opens with it', async () => {
  const id = ask({
    type: 'open',
    scene: freshScene({ obj: 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n', name: 'square.obj' }),
  });
  arrive(whole);
  await turn();
  expect(said.at(-1)).toMatchObject({ id, type: 'opened', net: { info: { vertices: 4 } } });
});

test('if it does not come, the request fails, the net stays, and the next one tries again', async () => {
  const id = ask(li2022);
  const after = ask(drag);
  fail(new Error('no network'));
  await turn();
  expect(said).toContainEqual({
    id,
    type: 'error',
    code: 'not_loaded',
    message: 'The rest of the solver could not be loaded: no network',
  });
  solve();
  expect(settled()).toMatchObject({ id: after, frame: { status: 'converged', method: 'equilibrium' } });
  const again = ask(li2022);
  arrive(whole);
  await turn();
  expect(settled()).toMatchObject({ id: again, frame: { method: 'li2022' } });
});

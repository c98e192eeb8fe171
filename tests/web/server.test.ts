/** The server over the real core, its time in the hands of the test. */
import { beforeEach, describe, expect, test } from 'vitest';
import type { Chebnet, Editor, Handle } from '../../wasm/chebnet';
import { freshScene } from '../../web/src/document/defaults';
import { ENDINGS } from '../../web/src/document/document';
import type { Ending, Scene, SolverOptions } from '../../web/src/document/document';
import { packPositions } from '../../web/src/document/packing';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { PROTOCOL_VERSION } from '../../web/src/worker/protocol';
import type { FrameData, Request, Response } from '../../web/src/worker/protocol';
import { Server } from '../../web/src/worker/server';
import { largestDistance, load } from '../wasm/load';
import { wholeCoreOf } from './whole_core_of';

type Body<T = Request> = T extends unknown ? Omit<T, 'id'> : never;

const core = await load();
/** The core with slices of one iteration each, however fast the machine is. */
const patientCore: Chebnet = { ...core, openRecipe: patientEditor };
const recipe = 'vault:vertices=300';
const reference = core.openRecipe(recipe);
const dragged = reference.suggestedHandles.at(-1) ?? -1;
const home = at(reference.restPositions, dragged);
const away: [number, number, number] = [home[0] + 0.5, home[1], home[2] - 1];

let server: Server;
let said: Response[];
let tasks: (() => void)[];
let time: number;
let lastId: number;
/** Searches come with it, in the next task. */
const wholeCoreIsThere = () => new Promise((next) => setTimeout(next));
const host = {
  soon: (task: () => void) => tasks.push(task),
  now: () => time,
  wholeCore: () => Promise.resolve(wholeCoreOf(core)),
};

beforeEach(() => {
  said = [];
  tasks = [];
  time = 0;
  lastId = 0;
  server = new Server(patientCore, { post: (response) => said.push(response), ...host });
});

function patientEditor(from: string): Editor {
  const editor = core.openRecipe(from);
  const solve = editor.solve.bind(editor);
  editor.solve = () => solve({ iterations: 1 });
  return editor;
}

function at(positions: Float64Array, vertex: number): [number, number, number] {
  const [x = NaN, y = NaN, z = NaN] = positions.subarray(3 * vertex, 3 * vertex + 3);
  return [x, y, z];
}

/** Of the edges of a face. */
function lengthsOf(positions: Float64Array, face: number[]): number[] {
  const edges = face.flatMap((vertex, k) => [vertex, face[(k + 1) % face.length] ?? -1]);
  return Array.from(edgeLengths(positions, Int32Array.from(edges)));
}

function ask(body: Body): number {
  server.handle({ id: ++lastId, ...body } as Request);
  return lastId;
}

function setOptions(options: SolverOptions): number {
  return ask({ type: 'options', settings: { method: 'li2022', initialisation: 'naive', options } });
}

function restore(positions: Float64Array, handles: readonly Handle[]): void {
  const seeds = handles.map((handle) => ({ ...handle, anchor: false }));
  ask({ type: 'restore', scene: { ...freshScene({ recipe }), positions, handles: seeds, settled: true } });
}

function open(change: Partial<Scene> = {}): number {
  return ask({ type: 'open', scene: { ...freshScene({ recipe }), ...change } });
}

/** Lets slices run, each `milliseconds` long, until none is left or `count` have run. */
function run(milliseconds = 20, count = 1000): void {
  for (; tasks.length > 0 && count > 0; --count) {
    time += milliseconds;
    tasks.shift()?.();
  }
}

function frames(type: 'frame' | 'settled'): FrameData[] {
  return said.flatMap((response) => (response.type === type ? [response.frame] : []));
}

function settled(): { id: number; frame: FrameData } {
  const last = said.flatMap((response) => (response.type === 'settled' ? [response] : [])).at(-1);
  return last ?? expect.fail('not settled');
}

test('a frame has the fields of the core', () => {
  open({
    handles: [
      { vertex: 0, target: null, anchor: true },
      { vertex: dragged, target: away, anchor: false },
    ],
  });
  run();
  const { fields, maxDeviation, positions } = settled().frame;
  expect(fields.angle).toHaveLength(positions.length / 3);
  expect(maxDeviation).toBe(Math.max(...fields.deviation));
});

test('says hello with the tables, to a page of the same version', () => {
  ask({ type: 'hello', version: PROTOCOL_VERSION });
  expect(said).toMatchObject([
    {
      type: 'ready',
      shapes: core.shapes(),
      formats: core.formats(),
      methods: core.methods(),
      initialisations: core.initialisations(),
      options: core.options(),
    },
  ]);
  ask({ type: 'hello', version: PROTOCOL_VERSION + 1 });
  expect(said.at(-1)).toMatchObject({ type: 'error', code: 'version' });
});

describe('a scene', () => {
  test('moves its arrays to the page, and keeps what it needs itself', () => {
    const moved: Transferable[][] = [];
    const post = (response: Response, transfer: Transferable[]) => {
      moved.push(transfer);
      said.push(structuredClone(response, { transfer }));
    };
    server = new Server(patientCore, { post, ...host });
    open();
    run();
    const { edges, faceStart, faceVertices, restPositions } = reference;
    const vertices = restPositions.length / 3;
    expect(said[0]).toMatchObject({ type: 'opened', net: { edges, faceStart, faceVertices, restPositions } });
    expect(said[0]).toHaveProperty('net.triangles.length', 3 * (faceVertices.length - 2 * (faceStart.length - 1)));
    expect(moved[0]).toHaveLength(13 + Object.keys(reference.fields()).length);
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    expect(settled().frame.status).toBe('converged');
    expect(settled().frame.positions).toHaveLength(3 * vertices);
  });

  test('opens with the handles of its recipe', () => {
    const id = open();
    run();
    expect(said[0]).toMatchObject({ id, type: 'opened', net: { info: reference.info } });
    expect(settled()).toMatchObject({ id, frame: { status: 'converged', method: freshScene({ recipe }).method } });
    expect(settled().frame.handles.map(({ vertex }) => vertex)).toEqual([...reference.suggestedHandles]);
  });

  test('is solved for its targets', () => {
    open({
      handles: [
        { vertex: 0, target: null, anchor: true },
        { vertex: dragged, target: away, anchor: false },
      ],
    });
    run();
    expect(settled().frame.status).toBe('converged');
    expect(at(settled().frame.positions, dragged)).toEqual(away);
  });

  test('that is settled stays as it is, bit for bit', () => {
    const positions = reference.restPositions.map((x) => x + 0.001);
    open({ positions, handles: [], settled: true });
    run();
    expect(settled().frame.positions).toEqual(positions);
    expect(settled().frame).toMatchObject({ status: 'converged', iterations: 0 });
  });

  test('opens with packed positions', () => {
    const positions = reference.restPositions.map((x) => 1.1 * x);
    open({ positions: { packed: packPositions(positions, reference, 1e-6) }, handles: [], settled: true });
    run();
    expect(largestDistance(settled().frame.positions, positions)).toBeLessThan(1e-4 * reference.info.meanLength);
    expect(settled().frame.status).toBe('running');
  });

  test('of a file keeps the lengths that are asked for', () => {
    const obj = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n';
    open({ net: { obj, name: 'oblong.obj', restLengths: 'own' }, handles: [] });
    run();
    expect(lengthsOf(settled().frame.positions, [0, 1, 2, 3])).toEqual([2, 1, 2, 1]);
    open({ net: { obj, name: 'oblong.obj', restLengths: 'equal' }, handles: [] });
    run();
    expect(settled().frame.status).toBe('converged');
    for (const length of lengthsOf(settled().frame.positions, [0, 1, 2, 3])) expect(length).toBeCloseTo(1.5, 2);
  });

  test.each<[string, Partial<Scene>]>([
    ['bad_option', { net: { recipe: 'cathedral' } }],
    ['bad_option', { net: { obj: '', name: 'empty.obj', restLengths: 'none' as never } }],
    ['bad_option', { method: 'magic' }],
    ['bad_option', { initialisation: 'magic' }],
    ['bad_option', { options: { magic: 1 } }],
    ['bad_option', { options: { threshold: -1 } }],
    ['index_out_of_range', { handles: [{ vertex: 9999, target: null, anchor: false }] }],
    ['repeated_vertex', { handles: [0, 0].map((vertex) => ({ vertex, target: null, anchor: false })) }],
    ['bad_link', { positions: { packed: new Uint8Array(99) } }],
    ['non_finite', { positions: reference.restPositions.map(() => NaN) }],
    ['no_faces', { net: { obj: '', name: 'empty.obj' } }],
  ])('that is wrong (%s) is refused, and the net before stays', (code, change) => {
    open();
    run();
    const id = open(change);
    expect(said.at(-1)).toMatchObject({ id, type: 'error', code });
    const again = ask({ type: 'solve' });
    run();
    expect(settled()).toMatchObject({ id: again, frame: { status: 'converged' } });
  });
});

test('nothing works without a net', () => {
  for (const body of [{ type: 'solve' }, { type: 'cancel' }, { type: 'handles', handles: [] }] as Body[]) {
    ask(body);
    expect(said.at(-1)).toMatchObject({ type: 'error', code: 'no_net' });
  }
});

describe('a drag', () => {
  beforeEach(() => {
    open();
    run();
    said = [];
  });

  test('moves several handles with one request', () => {
    const [first = -1] = reference.suggestedHandles;
    const rest = at(reference.restPositions, first);
    const targets = [
      { vertex: dragged, target: away },
      { vertex: first, target: [rest[0], rest[1], rest[2] + 0.1] as [number, number, number] },
    ];
    ask({ type: 'drag', inHand: false, targets });
    run();
    expect(settled().frame.status).toBe('converged');
    for (const { vertex, target } of targets) expect(at(settled().frame.positions, vertex)).toEqual(target);
  });

  test('in hand and beyond reach shows nets only, and leaves the handle where the net goes when let go', () => {
    const [x, y, z] = home;
    ask({ type: 'drag', inHand: true, targets: [{ vertex: dragged, target: [x, y, z + 100] }] });
    run();
    for (const { maxDeviation } of frames('frame')) expect(maxDeviation).toBeLessThan(1e-6);
    expect(settled().frame).toMatchObject({ holdsBack: true, status: expect.stringMatching(/converged|exact/) });
    const id = ask({ type: 'release' });
    run();
    expect(settled()).toMatchObject({ id, frame: { holdsBack: false } });
    const { handles, positions } = settled().frame;
    expect(handles.at(-1)).toMatchObject({ vertex: dragged, target: at(positions, dragged) });
    expect(at(positions, dragged)[2]).toBeLessThan(z + 50);
  });

  test('beyond reach, then all edges grow until the handle stands where the hand was', async () => {
    const [x, y, z] = home;
    const far: [number, number, number] = [x, y, z + 8];
    ask({ type: 'drag', inHand: true, targets: [{ vertex: dragged, target: far }] });
    ask({ type: 'release' });
    run();
    expect(settled().frame).toMatchObject({ holdsBack: false, fellShort: true });
    const id = ask({ type: 'search', what: 'lengths' });
    await wholeCoreIsThere();
    run();
    const adapted = said.find((response) => response.type === 'searched');
    expect(adapted).toMatchObject({ id });
    expect(adapted?.type === 'searched' && adapted.found).toBeGreaterThan(1.01);
    expect(settled()).toMatchObject({ id, frame: { fellShort: false } });
    expect(at(settled().frame.positions, dragged)).toEqual(far);
    expect(settled().frame.maxDeviation).toBeLessThan(1e-9);
  });

  test('a search for another rest that finds none leaves the net as it is, and tells how far it has come', async () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    const before = settled().frame.positions.slice();
    const id = ask({ type: 'search', what: 'rest' });
    await wholeCoreIsThere();
    run();
    expect(said.find((response) => response.type === 'searched')).toMatchObject({ id, found: null });
    expect(settled()).toMatchObject({ id, frame: { status: 'converged' } });
    const moved = settled().frame.positions.map((x, i) => Math.abs(x - before[i]!));
    expect(Math.max(...moved)).toBeLessThan(1e-5);
    const told = said.flatMap((response) => (response.type === 'searching' ? [response.progress] : []));
    expect(told.every(({ reached }, k) => reached >= (told[k - 1]?.reached ?? 0) && reached <= 1)).toBe(true);
    expect(told.every(({ iterations }, k) => iterations > (told[k - 1]?.iterations ?? 0))).toBe(true);
  });

  test('a search for other lengths ends when the net is touched', async () => {
    const [x, y, z] = home;
    ask({ type: 'drag', inHand: true, targets: [{ vertex: dragged, target: [x, y, z + 8] }] });
    ask({ type: 'release' });
    run();
    const id = ask({ type: 'search', what: 'lengths' });
    ask({ type: 'cancel' });
    await wholeCoreIsThere();
    run();
    expect(said.find((response) => response.id === id)).toMatchObject({ type: 'error', code: 'cancelled' });
    expect(settled().frame).toMatchObject({ fellShort: true });
  });

  test('a search for other lengths that is ended in vain lets the solve go on that it interrupted', async () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run(1, 1);
    const before = frames('settled').length;
    ask({ type: 'search', what: 'lengths' });
    ask({ type: 'open', scene: freshScene({ recipe: 'no such shape' }) });
    await wholeCoreIsThere();
    run();
    expect(frames('settled').length).toBe(before + 1);
    expect(at(settled().frame.positions, dragged)).toEqual(away);
  });

  test('is answered at once and ends settled', () => {
    const id = ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    expect(said).toEqual([{ id, type: 'done' }]);
    run();
    expect(settled()).toMatchObject({ id, frame: { status: 'converged' } });
    expect(at(settled().frame.positions, dragged)).toEqual(away);
    expect(settled().frame.maxDeviation).toBeLessThan(1e-6);
  });

  test('is interrupted by the next once it had its share of time, and only the last one settles', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run(20, 1);
    const id = ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: home }] });
    expect(said).not.toContainEqual({ id, type: 'done' });
    run(20, 1);
    expect(said).toContainEqual({ id, type: 'done' });
    run();
    expect(frames('settled')).toHaveLength(1);
    expect(settled()).toMatchObject({ id, frame: { status: 'converged' } });
  });

  test('that waits for its turn goes before what is asked after it', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    const waiting = ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: home }] });
    const after = ask({ type: 'cancel' });
    expect(said.map(({ id }) => id)).toEqual([waiting - 1, waiting, after, after]);
    expect(at(settled().frame.positions, dragged)).toEqual(home);
  });

  test('of a vertex that is no handle is refused, and what goes on goes on', () => {
    const id = ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    const wrong = ask({ type: 'drag', inHand: false, targets: [{ vertex: 5, target: home }] });
    run(40);
    expect(said).toContainEqual(expect.objectContaining({ id: wrong, type: 'error', code: 'index_out_of_range' }));
    expect(settled()).toMatchObject({ id, frame: { status: 'converged' } });
  });

  test('sends no frame before the last was seen, and none faster than a display shows', () => {
    ask({ type: 'seen' });
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run(40, 2);
    expect(frames('frame')).toHaveLength(1);
    ask({ type: 'seen' });
    run(1, 1);
    expect(frames('frame')).toHaveLength(2);
    ask({ type: 'seen' });
    run(1, 1);
    expect(frames('frame')).toHaveLength(2);
  });

  test('gives each row of the trace once', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    while (tasks.length > 0) {
      run(20, 1);
      ask({ type: 'seen' });
    }
    const rows = said.flatMap((each) => ('frame' in each ? each.frame.trace : []));
    expect(rows.map(({ iteration }) => iteration)).toEqual(rows.map((_, i) => i + 1));
    expect(settled().frame).toMatchObject({ iterations: rows.length, stage: rows.at(-1)?.stage });
  });
});

describe('by hand', () => {
  beforeEach(() => {
    open();
    run();
  });

  test('a step is one iteration, a cancel none', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    ask({ type: 'cancel' });
    run();
    expect(settled().frame).toMatchObject({ status: 'running', iterations: 0 });
    ask({ type: 'step' });
    run();
    expect(settled().frame).toMatchObject({ status: 'running', iterations: 1 });
    ask({ type: 'step' });
    expect(settled().frame).toMatchObject({ iterations: 2, trace: [{ iteration: 2 }] });
    ask({ type: 'solve' });
    run();
    expect(settled().frame.status).toBe('converged');
  });

  test('a locality holds what lies beyond it until the net is set anew; reach and mobility are told', () => {
    ask({ type: 'locality', radius: 3, origins: [dragged] });
    expect(said.at(-1)).toMatchObject({ type: 'done' });
    ask({ type: 'mobility', radius: 3, origins: [dragged] });
    const { mobility } = said.at(-1) as { mobility: Float32Array };
    expect(mobility[dragged]).toBe(1);
    ask({ type: 'reach', vertices: [dragged] });
    const { balls } = said.at(-1) as unknown as { balls: { vertex: number }[][] };
    expect(balls[0]!.map(({ vertex }) => vertex)).toEqual(
      expect.arrayContaining([...reference.suggestedHandles].slice(0, -1)),
    );
    expect(balls[0]!.length).toBeGreaterThan(reference.suggestedHandles.length);
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    const { positions } = settled().frame;
    const beyond = [...mobility.keys()].filter((v) => mobility[v] === 0);
    expect(beyond.length).toBeGreaterThan(0);
    expect(beyond.every((v) => positions[3 * v] === reference.restPositions[3 * v])).toBe(true);
  });

  test('options are all or none', () => {
    setOptions({ p_end: 30 });
    setOptions({ p_start: 3, threshold: NaN });
    expect(said.at(-1)).toMatchObject({ type: 'error', code: expect.stringMatching(/bad_option|non_finite/) });
    setOptions({ threshold: 1e-30 });
    expect(settled().frame.status).not.toBe('stalled');
  });

  test('reset and restore bring back what was', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    const { positions, handles } = settled().frame;
    ask({ type: 'reset' });
    expect(settled().frame).toMatchObject({ positions: reference.restPositions, status: 'converged' });
    restore(positions, handles);
    run();
    expect(settled().frame).toMatchObject({ positions, handles, status: 'converged', iterations: 0 });
  });

  test('of how a solve ended it is not believed what the edges do not show', () => {
    const { restPositions: rest } = reference;
    const stretched = rest.map((x) => 1.5 * x);
    const statusOf = (positions: Float64Array, ending?: Ending) => {
      ask({ type: 'restore', scene: { ...freshScene({ recipe }), handles: [], positions, settled: true, ending } });
      return settled().frame.status;
    };
    expect(ENDINGS.map((ending) => statusOf(rest, ending))).toEqual(ENDINGS);
    expect(statusOf(rest)).toBe('converged');
    expect(ENDINGS.map((ending) => statusOf(stretched, ending))).toEqual(
      ENDINGS.map((ending) => (ending === 'exact' ? 'running' : ending)),
    );
  });

  test('restore brings back method and options with the rest', () => {
    ask({
      type: 'restore',
      scene: { ...freshScene({ recipe }), handles: [], method: 'li2022', options: { threshold: 1e-8 }, settled: true },
    });
    expect(settled().frame).toMatchObject({ positions: reference.restPositions, method: 'li2022' });
    ask({
      type: 'restore',
      scene: { ...freshScene({ recipe }), handles: [{ vertex: 1e6, target: [0, 0, 0], anchor: false }] },
    });
    expect(said.at(-1)).toMatchObject({ type: 'error', code: 'index_out_of_range' });
  });

  test('what is out of reach is said so', () => {
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: [0, 0, 500] }] });
    run();
    expect(settled().frame.status).toBe('unreachable');
    expect(settled().frame.unreachable[0]).toMatchObject({ vertexB: dragged });
    const { positions, handles } = settled().frame;
    ask({ type: 'reset' });
    restore(positions, handles);
    expect(settled().frame.status).toBe('unreachable');
  });

  test('of all that is out of reach the worst goes with a frame', () => {
    const { positions } = settled().frame;
    const count = positions.length / 3;
    const scattered = Array.from({ length: count }, (_, vertex) => ({
      vertex,
      target: [vertex, vertex ** 2 % 17, 500 * (vertex % 2)] as [number, number, number],
      anchor: false,
    }));
    restore(positions, scattered);
    const { status, unreachable } = settled().frame;
    expect(status).toBe('unreachable');
    expect(count).toBeGreaterThan(100);
    expect(unreachable).toHaveLength(100);
    const strains = unreachable.map(({ distance, reach }) => Math.max(distance / reach, reach / distance));
    expect(strains).toEqual([...strains].sort((a, b) => b - a));
  });

  test('a net that is too large for a method stays as it is, and the next edit begins anew', () => {
    const refusing = core.openRecipe(recipe);
    const solve = refusing.solve.bind(refusing);
    let room = false;
    refusing.solve = (budget) => {
      if (room) return solve(budget);
      throw Object.assign(new Error('too many vertices'), { code: 'too_large' });
    };
    server = new Server({ ...core, openRecipe: () => refusing }, { post: (response) => said.push(response), ...host });
    ask({ type: 'open', scene: { ...freshScene({ recipe }), settled: true } });
    said = [];
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    expect(said.map(({ type }) => type)).toEqual(['done', 'settled', 'error']);
    expect(settled().frame.status).toBe('running');
    expect(said.at(-1)).toMatchObject({ code: 'too_large', message: 'too many vertices' });
    room = true;
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    expect(settled().frame.status).toBe('converged');
  });

  test('each format is exported as the core writes it', () => {
    for (const { name: format } of core.formats()) {
      ask({ type: 'export', format });
      expect(said.at(-1)).toMatchObject({ type: 'exported', bytes: reference.toFile(format) });
    }
    const solved = core.openRecipe(recipe);
    solved.setHandles(
      Array.from(solved.suggestedHandles, (vertex) => ({ vertex, target: at(solved.restPositions, vertex) })),
    );
    solved.solve(); // of which the table has the forces
    ask({ type: 'export', format: 'edges' });
    expect(said.at(-1)).toMatchObject({ type: 'exported', bytes: new TextEncoder().encode(solved.edgeTable()) });
  });

  describe('is made ready for a hand', () => {
    let solves: number;
    function openWatched(from: string, change: Partial<Scene> = {}): Editor {
      const watched = core.openRecipe(from);
      const solve = watched.solve.bind(watched);
      solves = 0;
      watched.solve = (budget) => {
        solves++;
        return solve(budget);
      };
      server = new Server({ ...core, openRecipe: () => watched }, { post: (response) => said.push(response), ...host });
      said = [];
      ask({
        type: 'open',
        scene: { ...freshScene({ recipe: from }), method: 'equilibrium', settled: true, ...change },
      });
      run();
      expect(said).toMatchObject([{ type: 'opened' }, { type: 'settled' }]);
      said = [];
      return watched;
    }

    test('and stays as it is, whether it is at rest or merely has its lengths', () => {
      const pulled = core.openRecipe(recipe);
      pulled.setHandles(
        [...reference.suggestedHandles].map((vertex) => ({ vertex, target: at(reference.restPositions, vertex) })),
      );
      pulled.moveHandle(dragged, away);
      while (pulled.solve().status === 'running');
      const elsewhere: Partial<Scene> = {
        positions: pulled.positions(),
        handles: pulled.handles().map((handle) => ({ ...handle, anchor: false })),
        options: { shear_weight: 5 },
      };
      for (const change of [{}, elsewhere]) {
        const watched = openWatched(recipe, change);
        const before = watched.state();
        server.getReady();
        expect(solves).toBe(1);
        expect(said).toEqual([]);
        expect(watched.state()).toEqual(before);
        ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: home }] });
        run();
        expect(settled().frame.status).toBe('converged');
      }
    });

    test('unless it is large, or being solved', () => {
      openWatched('sheet:vertices=10500');
      server.getReady();
      expect(solves).toBe(0);
      openWatched(recipe);
      ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
      server.getReady();
      expect(solves).toBe(0);
    });
  });

  test('the table of edges has the forces of a net at rest, however it came there', () => {
    open({ method: 'equilibrium' });
    ask({ type: 'drag', inHand: false, targets: [{ vertex: dragged, target: away }] });
    run();
    const { positions, handles } = settled().frame;
    const exported = (format: string) => {
      ask({ type: 'export', format });
      const answer = said.at(-1)!;
      return answer.type === 'exported' ? new TextDecoder().decode(answer.bytes) : expect.fail(answer.type);
    };
    const [solved, shape] = [exported('edges'), exported('obj')];
    expect(solved).toMatch(/,force\n/);
    const seeds = handles.map((handle) => ({ ...handle, anchor: false }));
    const scene = { ...freshScene({ recipe }), method: 'equilibrium', positions, handles: seeds, settled: true };
    ask({ type: 'restore', scene });
    expect(exported('edges').split('\n')[0]).toBe(solved.split('\n')[0]);
    expect(exported('obj')).toBe(shape);
  });

  test('an export does not touch the net', () => {
    said = [];
    ask({ type: 'export', format: 'obj' });
    expect(said).toMatchObject([{ type: 'exported', bytes: reference.toFile('obj') }]);
  });
});

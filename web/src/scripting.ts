/**
 * `window.chebnet`: the page for scripts, as teachers, embedders and tests use it. For example, in the console:
 *
 *     await chebnet.open({ recipe: 'dome:vertices=1000' });
 *     const { vertex, target: [x, y, z] } = chebnet.handles().at(-1);
 *     await chebnet.move(vertex, [x, y, z + 1]);
 *     await chebnet.settled();
 *     chebnet.stats().maxDeviation; // below 1e-6
 *
 * Vertices count from 0. Every failure is a rejected promise: an `Error` whose `code` is "bad_arguments" or a name from
 * core/base/error.h, e.g. "index_out_of_range", and whose message says what was wrong in the visitor's language. All waits
 * for the page to be ready. Calls need not be awaited: changes are made in the order they were asked for, and what gives a
 * promise tells of the net after those before it.
 */
import type { ChebnetError, DrapeReport, RemeshOptions, Status, SurfaceReport, ToRest } from '../../wasm/chebnet';
import type { App, AppEvent } from './app/app';
import { noNet } from './app/state';
import type { HandleData, SolverOptions, Vec3 } from './document/document';
import { Untrusted } from './document/untrusted';
import type { Watch } from './drape/asking';
import { linking } from './projects/linking';
import type { ScriptHandle, ScriptNet, ScriptOptions, ScriptSurface } from './script_arguments';
import { lazy } from './lazy';
import type { Opening } from './worker/opening';
import type { OpenedNet } from './worker/protocol';
import type { LaidReport, ScriptDrape, WholeReport } from './surface_script';

const reading = lazy(() => import('./script_arguments'));
const surfaces = lazy(() => import('./surface_script'));

export interface Stats {
  vertices: number;
  edges: number;
  faces: number;
  handles: number;
  /** `running` also if the solve was stopped before its end. */
  status: Status;
  /** Largest dL of all edges. */
  maxDeviation: number;
  /** Of the last solve, or of the one under way. */
  iterations: number;
  /** Likewise; time spent in the solver. */
  milliseconds: number;
  /** Pictures drawn in the last second; none is drawn while nothing moves. */
  framesPerSecond: number;
  method: string;
  /** What is left until the net is at rest; null: the method does not bring it there, or has not come so far. */
  toRest: ToRest | null;
  /** Bytes that the solver's WebAssembly has taken; it gives none back while the page is open. */
  memory: number;
}

export interface Scripting {
  /** Opens a net of a recipe, with the handles it suggests, or of OBJ text, without handles. */
  open(net: ScriptNet): Promise<void>;
  /** Replaces the handles; the net is solved for their targets. */
  setHandles(handles: readonly ScriptHandle[]): Promise<void>;
  /** Moves a handle. Resolves when the solver has taken the target, or a newer one for the same vertex. */
  move(vertex: number, target: Vec3): Promise<void>;
  /** How far from a handle being moved the net moves with it, in edge lengths along the net; null: everywhere. */
  setLocality(radius: number | null): Promise<void>;
  /** Puts a surface beside the net, one of our own or polygons, or takes it away; what it does the options `guide_mode` and
   *  `guide_weight` say. */
  setGuide(surface: ScriptSurface | null): Promise<void>;
  /** What a surface is like, and what can be expected of one net on it. */
  describe(surface: ScriptSurface): Promise<SurfaceReport>;
  /** Lays one piece of a net on a surface, with steps as `ScriptDrape` says, and opens it with the surface beside it. Resolves with
   *  how it lies. */
  drape(surface: ScriptSurface, options?: ScriptDrape): Promise<LaidReport>;
  /** The same with a net over the whole surface, which may take seconds: `watch` is told how far it is, and can give it up with a
   *  signal; no net is opened then. A page around a frame has no watch. */
  remesh(surface: ScriptSurface, options?: RemeshOptions, watch?: Watch): Promise<WholeReport>;
  /** How the open net lies now on the surface beside it. */
  report(): Promise<DrapeReport>;
  /** Resolves when nothing is under way and the net is settled. */
  settled(): Promise<void>;
  /** Where the vertices stand, 3 numbers each; a copy. */
  positions(): Float64Array;
  /** 2 vertices an edge; a copy. */
  edges(): Int32Array;
  handles(): HandleData[];
  stats(): Stats;
  /** Chooses method and initialisation (`naive`, `arap:N`, `local_global:N`) and sets the solver's options; others stay as
   *  they are. */
  setOptions(options: ScriptOptions): Promise<void>;
  /** `listener` is called for each new frame, whenever the net has settled, or with each error shown to the user.
   *  Returns what ends this. */
  on(event: 'frame' | 'settled', listener: () => void): () => void;
  on(event: 'error', listener: (error: ChebnetError) => void): () => void;
  /** Where a vertex is seen, in CSS pixels from the top left of the page. */
  screenPosition(vertex: number): { x: number; y: number };
  /** Link to the present scene. */
  link(): Promise<string>;
}

declare global {
  interface Window {
    chebnet: Scripting;
  }
}

/** @param ready resolves when the first net is open, or could not be. */
export function createScripting(app: App, ready: Promise<void>): Scripting {
  /** Ends when the changes asked for so far have. */
  let earlier = ready;
  /** Changes are made one after another, in the order they were asked for, whatever each has to load first. */
  const change = <T>(making: () => Promise<T>): Promise<T> => {
    const made = earlier.then(making);
    earlier = made.then(nothing, nothing);
    return made;
  };
  return {
    open: (net) =>
      change(async () => {
        const given = (await reading()).readNet(argument('net', net));
        await app.openNet('recipe' in given ? given : { name: 'net.obj', ...given });
      }),
    setHandles: (handles) =>
      change(async () => {
        const given = (await reading()).readHandles(argument('handles', handles));
        await app.handles.set(given.map((handle) => handleOf(app, handle)));
      }),
    // No other change waits for it: of many moves the newest win.
    move: async (vertex, target) => {
      const given = { vertex: readVertex(vertex), target: argument('target', target).point() };
      await earlier;
      await app.handles.move([given], `move ${vertex}`);
    },
    setLocality: (radius) =>
      change(async () => {
        const given = (await reading()).readLocality(argument('radius', radius));
        // Where there is no net to be changed this fails; a control would do nothing.
        app.netToChange();
        app.handles.setLocality(given ?? undefined);
      }),
    setGuide: (surface) =>
      change(async () => {
        const { guideOf, readGuide } = await reading();
        const given = readGuide(argument('surface', surface));
        await app.setGuide(given === null ? undefined : guideOf(given));
      }),
    describe: async (surface) => (await surfaces()).describe(argument('surface', surface)),
    drape: (surface, options = {}) =>
      change(async () => (await surfaces()).drape(app, argument('surface', surface), argument('options', options))),
    remesh: (surface, options = {}, watch = {}) =>
      change(async () =>
        (await surfaces()).remesh(
          app,
          argument('surface', surface),
          argument('options', options),
          argument('watch', watch),
        ),
      ),
    report: async () => {
      await earlier;
      return (await surfaces()).report(app);
    },
    settled: async () => {
      await earlier;
      await app.settled();
    },
    positions: () => Float64Array.from(app.opening?.frame.positions ?? []),
    edges: () => Int32Array.from(app.opening?.net.edges ?? []),
    handles: () => structuredClone(app.opening?.document.handles ?? []),
    stats: () => stats(app),
    setOptions: (options) =>
      change(async () => setOptions(app, (await reading()).readOptions(argument('options', options)))),
    on: (event: AppEvent, listener: (error: ChebnetError) => void) => {
      const call = argument('listener', listener).function<typeof listener>();
      return app.on(argument('event', event).oneOf(['frame', 'settled', 'error']), (error) =>
        call(error as ChebnetError),
      );
    },
    screenPosition: (vertex) => app.screenPosition(vertexOf(openIn(app).net, readVertex(vertex))),
    link: async () => {
      await earlier;
      return (await linking()).linkTo(app);
    },
  };
}

function nothing(): void {}

/** What a script gave as the argument that messages call `name`. */
function argument(name: string, value: unknown): Untrusted {
  return new Untrusted(value, name, 'bad_arguments');
}

/** Whether the net has it, the core says. */
function readVertex(vertex: unknown): number {
  return argument('vertex', vertex).index(2 ** 31);
}

/** For what the core is not asked. */
function vertexOf({ info }: OpenedNet, vertex: number): number {
  return new Untrusted(vertex, 'vertex', 'index_out_of_range').index(info.vertices);
}

function openIn(app: App): Opening {
  if (app.opening === null) throw noNet();
  return app.opening;
}

function handleOf(app: App, { vertex, target, anchor, name, hidden, weight, slides }: ScriptHandle): HandleData {
  return {
    vertex,
    target: target ?? app.handles.positionOf(vertex),
    anchor: anchor ?? target === undefined,
    ...(name ? { name } : {}),
    ...(hidden ? { hidden } : {}),
    ...(weight === undefined ? {} : { weight }),
    ...(slides === undefined ? {} : { slides }),
  };
}

async function setOptions(app: App, given: ScriptOptions): Promise<void> {
  const present = openIn(app).document;
  const { method = present.method, initialisation = present.initialisation, ...options } = given;
  await app.setOptions({ method, initialisation, options: { ...present.options, ...(options as SolverOptions) } });
}

function stats(app: App): Stats {
  const { opening, framesPerSecond } = app;
  const { vertices = 0, edges = 0, faces = 0 } = opening?.net.info ?? {};
  const { status = 'running', maxDeviation = 0, iterations = 0, milliseconds = 0 } = opening?.frame ?? {};
  const { method = '', toRest = null, memory = 0 } = opening?.frame ?? {};
  const handles = opening?.document.handles.length ?? 0;
  const solved = { status, maxDeviation, iterations, milliseconds, framesPerSecond, method, toRest, memory };
  return { vertices, edges, faces, handles, ...solved };
}

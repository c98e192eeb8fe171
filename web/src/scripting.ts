/**
 * `window.chebnet`: the page for scripts, as teachers, embedders and tests use it. For example, in the console:
 *
 *     await chebnet.open({ recipe: 'dome:vertices=1000' });
 *     const { vertex, target: [x, y, z] } = chebnet.handles().at(-1);
 *     await chebnet.move(vertex, [x, y, z + 1]);
 *     await chebnet.settled();
 *     chebnet.stats().maxDeviation; // below 1e-6
 *
 * Vertices count from 0. Every failure is a rejected promise: an `Error` whose `code` is a name from core/base/error.h,
 * e.g. "index_out_of_range", and whose message says what was wrong in the visitor's language. All waits for the page to be ready.
 */
import type { ChebnetError, Status } from '../../wasm/chebnet';
import type { App, AppEvent } from './app/app';
import { type HandleData, LONGEST_NAME, type NetSource, type Vec3 } from './document/document';
import { linking } from './projects/linking';
import { Failure } from './failure';

export interface ScriptHandle {
  vertex: number;
  /** Without it, where the vertex stands. */
  target?: Vec3;
  /** Locked: drawn apart, and no hand moves it. Without it, a handle without a target is locked. */
  anchor?: boolean;
  /** See HandleData. */
  name?: string;
  hidden?: boolean;
  weight?: number;
}

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
}

export interface Scripting {
  /** Opens a net of a recipe, with the handles it suggests, or of OBJ text, without handles. */
  open(net: { recipe: string } | { obj: string; name?: string }): Promise<void>;
  /** Replaces the handles; the net is solved for their targets. */
  setHandles(handles: readonly ScriptHandle[]): Promise<void>;
  /** Moves a handle. Resolves when the solver has taken the target, or a newer one for the same vertex. */
  move(vertex: number, target: Vec3): Promise<void>;
  /** How far from a handle being moved the net moves with it, in edge lengths along the net; null: everywhere. */
  setLocality(radius: number | null): Promise<void>;
  /** Resolves when nothing is under way and the net is settled. */
  settled(): Promise<void>;
  /** Where the vertices stand, 3 numbers each; a copy. */
  positions(): Float64Array;
  /** 2 vertices an edge; a copy. */
  edges(): Int32Array;
  handles(): HandleData[];
  stats(): Stats;
  /** Chooses method and initialisation (`naive`, `arap:N`, `local_global:N`) and sets the solver's options by the names in core/solve/options.h; others stay as they are. */
  setOptions(
    options: { method?: string; initialisation?: string } & Record<string, number | boolean | string | undefined>,
  ): Promise<void>;
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
  return {
    open: async (net) => {
      await ready;
      await app.openNet(readNet(net));
    },
    setHandles: async (handles) => {
      await ready;
      if (!Array.isArray(handles)) throw new Failure('bad_syntax', 'handles must be given as a list');
      await app.handles.set(handles.map((handle: ScriptHandle) => readHandle(app, handle)));
    },
    move: async (vertex, target) => {
      await ready;
      await app.handles.move([{ vertex, target }], `move ${vertex}`);
    },
    setLocality: async (radius) => {
      await ready;
      if (radius !== null && !(radius > 0 && radius < Infinity))
        throw new Failure('bad_option', 'a locality must be a number above 0, or null');
      app.handles.setLocality(radius ?? undefined);
    },
    settled: async () => {
      await ready;
      await app.settled();
    },
    positions: () => Float64Array.from(app.opening?.frame.positions ?? []),
    edges: () => Int32Array.from(app.opening?.net.edges ?? []),
    handles: () => structuredClone(app.opening?.document.handles ?? []),
    stats: () => stats(app),
    setOptions: async (options) => {
      await ready;
      await setOptions(app, options);
    },
    on: (event: AppEvent, listener: (error: ChebnetError) => void) =>
      app.on(event, (error) => listener(error as ChebnetError)),
    screenPosition: (vertex) => app.screenPosition(vertex),
    link: async () => {
      await ready;
      const { hashOf } = await linking();
      const { hash } = hashOf(app);
      if (hash === null) throw new Failure('too_large', 'This net is too large for a link.');
      return new URL(hash, location.href).href;
    },
  };
}

function readNet(net: Parameters<Scripting['open']>[0]): NetSource {
  if ('recipe' in net) return { recipe: net.recipe };
  return { obj: net.obj, name: net.name ?? 'net.obj' };
}

function readHandle(app: App, { vertex, target, anchor, name, hidden, weight }: ScriptHandle): HandleData {
  return {
    vertex,
    target: target ?? app.handles.positionOf(vertex),
    anchor: anchor ?? target === undefined,
    ...(name ? { name: String(name).slice(0, LONGEST_NAME) } : {}),
    ...(hidden ? { hidden: true } : {}),
    ...(weight === undefined ? {} : { weight: readWeight(weight, vertex) }),
  };
}

function readWeight(weight: unknown, vertex: number): number {
  if (typeof weight === 'number' && Number.isFinite(weight) && weight > 0) return weight;
  throw new Failure('bad_option', `the weight of the handle at vertex ${vertex} must be a number above 0`);
}

async function setOptions(app: App, wished: Parameters<Scripting['setOptions']>[0]): Promise<void> {
  const present = app.opening?.document;
  if (present === undefined) throw new Failure('no_net', 'No net is open.');
  const { method = present.method, initialisation = present.initialisation, ...options } = wished;
  const given = Object.entries(options).map(([name, value]): [string, number | boolean] => {
    if (typeof value === 'number' || typeof value === 'boolean') return [name, value];
    throw new Failure('bad_option', `option ${name} must be a number or true or false`);
  });
  await app.setOptions({ method, initialisation, options: { ...present.options, ...Object.fromEntries(given) } });
}

function stats(app: App): Stats {
  const { opening, framesPerSecond } = app;
  const { vertices = 0, edges = 0, faces = 0 } = opening?.net.info ?? {};
  const { status = 'running', maxDeviation = 0, iterations = 0, milliseconds = 0, method = '' } = opening?.frame ?? {};
  const handles = opening?.document.handles.length ?? 0;
  return { vertices, edges, faces, handles, status, maxDeviation, iterations, milliseconds, framesPerSecond, method };
}

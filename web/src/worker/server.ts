/** The other side of client.ts, in the worker: answers requests, and solves in slices between them. */
import type { EditState, Editor, Editors, Handle, SolveReport, Surface, ToRest, TraceRow } from '../../../wasm/chebnet';
import { numberingOf } from '../document/numbering';
import { unpackPositions } from '../document/packing';
import { targetsOf } from '../document/document';
import type { GuideSource, HandleSeed } from '../document/document';
import { pointOf } from '../document/point_of';
import { arrayBuffers } from './array_buffers';
import { handleBy } from './handlers';
import type { Handlers } from './handlers';
import { describe, openNet, openSurface } from './opened_net';
import type { Search } from './search';
import type { WholeCore } from './whole_core';
import { CRASHED, LEFT_OUT, PROTOCOL_VERSION, TOO_LARGE, touchesNet } from './protocol';
import type { DrawnSurface, FrameData, OpenedNet, Request, Response } from './protocol';
import { Failure, codeOf, messageOf } from '../failure';

/** Milliseconds of solving between two checks for messages; at least one iteration. */
const SLICE = 12;
/**
 * Milliseconds that a solve has before its first frame is sent or the next target interrupts it. A net that is solved
 * within this time is only ever shown solved, and still seems to follow at once.
 */
const SHARE = 32;
/** The same if every edge has its length by then: what is left of the solve goes on in the frames that follow. */
const EXACT_SHARE = SLICE;
/** A larger net is made ready by its first edit: nobody is to wait for what may not come. */
const MOST_VERTICES_MADE_READY = 10_000;
/** Pairs of handles that go with a frame: of thousands of handles tens of thousands may be out of reach. */
const MOST_PAIRS = 100;

/** Requests after which the count of iterations goes on. */
const GOES_ON: ReadonlySet<Request['type']> = new Set(['step', 'solve', 'cancel', 'release']);

type Drag = Extract<Request, { type: 'drag' }>;
type OpenScene = Extract<Request, { type: 'open' }>['scene'];
type Answer = Response extends infer R ? (R extends { id: number } ? Omit<R, 'id'> : never) : never;

/** What the server needs of the worker around it; tests have their own. */
interface ServerHost {
  post(response: Response, transfer: Transferable[]): void;
  /** Runs `task` after the messages that wait already. */
  soon(task: () => void): void;
  now(): number;
  /** The core with all that the one given has left out; see wasm/editors.d.ts. */
  wholeCore(): Promise<WholeCore>;
}

/**
 * One net being edited. Requests are answered in the order they come; a request that touches the net interrupts the
 * solve between two iterations and the solve begins anew from where the net stands. What the core at hand has left out
 * waits, with all requests after it, until the whole core is there and the net has moved over.
 */
export class Server {
  #core: Editors;
  readonly #host: ServerHost;
  /** Requests that wait for the whole core; null: it is not being loaded. */
  #late: Request[] | null = null;
  #editor: Editor | null = null;
  /** Where the editor's net is from. */
  #source: OpenScene['net'] | null = null;
  /** The last request that touched the net. */
  #touch = 0;
  /** The last surface beside a net; undo may come back to it. */
  #guide: { source: GuideSource; surface: Surface } | null = null;
  /** Whether it is beside the present net. */
  #isGuided = false;
  #solving = false;
  #sliceWaits = false;
  /** When the present solve began, or sent its last frame. */
  #shareStart = 0;
  /** Targets that wait until the present solve has had its milliseconds. */
  #nextDrag: Drag | null = null;
  /** What is in hand; null: nothing. */
  #inHand: Drag | null = null;
  /** What the last hand asked for. */
  #asked: readonly Handle[] = [];
  /** null: it is not loaded. */
  #whole: WholeCore | null = null;
  /** The last one. */
  #search: Search | null = null;
  #status: FrameData['status'] = 'running';
  /** The newest row of the present solve; null before its first iteration. */
  #row: TraceRow | null = null;
  /** Of the call that made that row. */
  #toRest: ToRest | null = null;
  #unsentRows: TraceRow[] = [];
  #stepFrom: Float64Array | null = null;
  #frameSeen = true;

  constructor(core: Editors, host: ServerHost) {
    this.#core = core;
    this.#host = host;
  }

  get isSolving(): boolean {
    return this.#solving;
  }

  /** Factors and whatever else the first edit needs, for a net at rest that has had none: half of the time of its first move. */
  getReady(): void {
    const editor = this.#editor;
    if (editor === null || editor.info.vertices > MOST_VERTICES_MADE_READY || this.#late !== null) return;
    if (this.#row === null && !this.#solving && this.#status === 'converged') beginSolve(editor);
  }

  handle(request: Request): void {
    if (this.#late !== null) {
      this.#late.push(request);
      return;
    }
    if (request.type !== 'seen') this.#takeNextDrag();
    if (touchesNet(request.type)) this.#search?.giveUp(new Failure('cancelled', 'The net is being edited.'));
    try {
      handleBy(this.#answers, request);
    } catch (error) {
      if (codeOf(error) === LEFT_OUT)
        void this.#goOnInWholeCore(
          () => this.handle(request),
          (failure) => this.#refuse(request.id, failure),
        );
      else this.#refuse(request.id, error);
    }
  }

  readonly #answers: Handlers<Request> = {
    hello: (request) => this.#reply(request, this.#hello(request.version)),
    open: ({ id, scene }) => this.#open(id, scene),
    handles: (request) => {
      this.#asked = [];
      this.#net().setHandles(request.handles);
      this.#accept(request, true);
    },
    drag: (request) => {
      if (this.#solving && !this.#hadItsShare()) this.#nextDrag = request;
      else this.#drag(request);
    },
    release: (request) => {
      this.#net().releaseHandles();
      // A net that has come home settles anew; one whose solve was stopped stays.
      this.#accept(request, this.#solving || this.#net().holdsBack || this.#status !== 'running');
    },
    search: (request) => this.#beginSearch(request),
    locality: (request) => {
      this.#net().setLocality(request.radius ?? Infinity, request.origins);
      this.#reply(request, { type: 'done' });
    },
    options: (request) => {
      this.#net().changeState(request.settings);
      if (!this.#solving) this.#assess();
      this.#accept(request, this.#solving);
    },
    solve: (request) => this.#accept(request, true),
    step: (request) => {
      this.#step();
      this.#accept(request, false);
    },
    cancel: (request) => this.#accept(request, false),
    reset: (request) => {
      this.#asked = [];
      this.#net().reset();
      this.#assess();
      this.#accept(request, false);
    },
    restore: (request) => {
      this.#restore(request);
      this.#accept(request, !request.scene.settled);
    },
    seen: () => {
      this.#frameSeen = true;
    },
    export: ({ id, format }) => this.#export(id, format),
    measure: (request) => this.#reply(request, this.#measured()),
    reach: (request) => {
      const balls = request.vertices.map((vertex) => this.#net().reach(vertex));
      this.#reply(request, { type: 'reach', balls });
    },
    flipped: (request) => this.#reply(request, { type: 'flipped', positions: this.#net().flipped() }),
    pattern: (request) => this.#reply(request, { type: 'pattern', pattern: this.#net().flatPattern() }),
    rods: (request) => this.#reply(request, { type: 'rods', rods: this.#net().rods() }),
    mobility: (request) => this.#mobility(request),
    nearest: (request) => {
      const surface = this.#surface;
      const points = request.points.map((point) => surface?.nearest(point).position ?? point);
      this.#reply(request, { type: 'nearest', points });
    },
    guide: (request) => this.#reply(request, { type: 'guide', surface: this.#surface && drawn(this.#surface) }),
  };

  // ------------------------------------------------------------------------------------------------------- requests

  #hello(version: number): Answer {
    if (version !== PROTOCOL_VERSION) {
      throw new Failure('version', 'Page and solver are of different versions; load the page again.');
    }
    const { shapes, methods, initialisations, formats, options } = this.#core;
    const tables = {
      shapes: shapes(),
      methods: methods(),
      initialisations: initialisations(),
      formats: formats(),
      options: options(),
    };
    return { type: 'ready', version, ...tables };
  }

  #open(id: number, scene: OpenScene): void {
    const editor = openNet(this.#core, scene.net);
    try {
      checkNumbering(editor, scene);
      goTo(scene, editor);
      this.#setGuide(editor, scene.guide);
      if (scene.replay) this.#neededWhole.replay(editor, scene.replay);
    } catch (error) {
      editor.dispose();
      throw error;
    }
    this.#editor?.dispose();
    this.#editor = editor;
    this.#source = scene.net;
    this.#asked = [];
    this.#touch = id;
    this.#forgetSolve();
    this.#assess(scene);
    const frame = this.#frame();
    const net = describe(editor);
    this.#post({ id, type: 'opened', net, frame }, [...buffersOf(net), ...buffersOf(frame)]);
    this.#go(!scene.settled);
  }

  #drag(request: Drag): void {
    this.#moveHandles(request);
    this.#asked = request.inHand ? (request.asked ?? request.targets) : [];
    this.#accept(request, true);
    this.#inHand = request.inHand ? request : null;
  }

  #moveHandles({ targets, inHand, along }: Drag): void {
    const net = this.#net();
    for (const { vertex, target } of targets) {
      if (inHand) net.dragHandle(vertex, target, along);
      else net.moveHandle(vertex, target);
    }
  }

  #takeNextDrag(): void {
    const drag = this.#nextDrag;
    this.#nextDrag = null;
    if (drag === null) return;
    try {
      this.#drag(drag);
    } catch (error) {
      this.#refuse(drag.id, error);
    }
  }

  #step(): void {
    const from = this.#net().positions();
    const report = this.#net().solve({ iterations: 1 });
    this.#note(report);
    this.#stepFrom = report.trace.length > 0 ? from : null;
  }

  #restore({ scene }: Extract<Request, { type: 'restore' }>): void {
    const editor = this.#net();
    this.#setGuide(editor, scene.guide);
    goTo(scene, editor);
    this.#asked = [];
    this.#assess(scene);
  }

  // ---------------------------------------------------------------------------------------------------- searches

  #beginSearch({ id, what }: Extract<Request, { type: 'search' }>): void {
    const editor = this.#net();
    const asked = this.#asked.filter(({ vertex }) => editor.handles().some((handle) => handle.vertex === vertex));
    const goesOn = this.#solving;
    this.#search = new this.#neededWhole.Search(what, editor, asked, (task) => this.#host.soon(task), {
      passes: (progress) => this.#post({ id, type: 'searching', progress }),
      ended: (found) => {
        if (what === 'lengths' && found !== null) this.#asked = [];
        this.#searched(id, found);
      },
      givenUp: (why) => {
        this.#refuse(id, why);
        // Nothing has come of it, so the solve that it interrupted goes on.
        if (goesOn) this.#go(true);
      },
    });
    this.#solving = false;
  }

  #searched(id: number, found: number | null): void {
    this.#forgetSolve();
    this.#touch = id;
    this.#post({ id, type: 'searched', found });
    this.#go(true);
  }

  /** Whether handles stand elsewhere than the last hand asked. */
  #fellShort(handles: readonly Handle[]): boolean {
    const known = new Map(handles.map((handle) => [handle.vertex, handle]));
    const isOff = ({ vertex, target }: Handle): boolean => {
      const handle = known.get(vertex);
      const holds = (axis: string): boolean => !handle?.slides?.includes(axis);
      return handle?.target.some((x, i) => x !== target[i] && holds('xyz'[i]!)) ?? false;
    };
    return !this.#solving && this.#asked.some(isOff);
  }

  /** The surface beside the net; it is kept open as long as it is the same. */
  #setGuide(editor: Editor, source: GuideSource | undefined): void {
    if (source === undefined) editor.setGuide(null);
    else if (this.#guide !== null && isSameGuide(this.#guide.source, source)) editor.setGuide(this.#guide.surface);
    else {
      const surface = openSurface(this.#core, source);
      editor.setGuide(surface);
      this.#guide?.surface.dispose();
      this.#guide = { source, surface };
    }
    this.#isGuided = source !== undefined;
  }

  /** Beside the present net; null: there is none. */
  get #surface(): Surface | null {
    return this.#isGuided ? (this.#guide?.surface ?? null) : null;
  }

  #export(id: number, format: string): void {
    if (format === 'edges') this.#learnForces();
    const bytes = fileOf(this.#net(), format);
    this.#post({ id, type: 'exported', bytes }, [bytes.buffer]);
  }

  /** They are those of a solve, and a net that was brought back has had none. */
  #learnForces(): void {
    const editor = this.#net();
    if (editor.forces() !== null || this.#solving || this.#status !== 'converged') return;
    beginSolve(editor);
  }

  #mobility({ id, radius, origins }: Extract<Request, { type: 'mobility' }>): void {
    const mobility = this.#net().mobility(radius, origins);
    this.#post({ id, type: 'mobility', mobility }, [mobility.buffer as ArrayBuffer]);
  }

  #measured(): Answer {
    const editor = this.#net();
    return {
      type: 'measured',
      measures: { bend: editor.bend(), smallestAngle: editor.smallestAngle(), handleError: editor.handleError() },
    };
  }

  // ---------------------------------------------------------------------------------------------------- the whole core

  /** A request for what comes with it waits until it is there. */
  get #neededWhole(): WholeCore {
    if (this.#whole === null) throw new Failure(LEFT_OUT, 'the whole core');
    return this.#whole;
  }

  /** All requests wait meanwhile. */
  async #goOnInWholeCore(goOn: () => void, refuse: (error: unknown) => void): Promise<void> {
    const late: Request[] = [];
    this.#late = late;
    let next = goOn;
    try {
      this.#whole = await this.#host.wholeCore();
      this.#moveTo(this.#whole.core);
    } catch (error) {
      const message = `The rest of the solver could not be loaded: ${messageOf(error)}`;
      next = () => refuse(new Failure('not_loaded', message));
    }
    this.#late = null;
    next();
    if (this.#solving) this.#sliceSoon();
    for (const each of late) this.handle(each);
  }

  /** A solve under way begins anew there, from where the net stands. */
  #moveTo(core: Editors): void {
    if (this.#editor !== null && this.#source !== null) {
      const editor = openNet(core, this.#source);
      editor.setState(this.#editor.state());
      this.#editor.dispose();
      this.#editor = editor;
    }
    this.#core = core;
  }

  // --------------------------------------------------------------------------------------------------------- solving

  /** Takes a request that touches the net: its id is that of the news from now on. */
  #accept(request: Request, solve: boolean): void {
    this.#net();
    if (!GOES_ON.has(request.type)) this.#row = null;
    this.#inHand = null;
    this.#touch = request.id;
    this.#post({ id: request.id, type: 'done' });
    this.#go(solve);
  }

  #go(solve: boolean): void {
    this.#solving = solve;
    if (!solve) return this.#settle();
    this.#status = 'running';
    this.#shareStart = this.#host.now();
    this.#sliceSoon();
  }

  #sliceSoon(): void {
    if (this.#sliceWaits) return;
    this.#sliceWaits = true;
    this.#host.soon(() => {
      this.#sliceWaits = false;
      if (!this.#solving || this.#late !== null) return;
      try {
        this.#slice();
      } catch (error) {
        this.#solving = false;
        // Of the methods that the default one falls back on, the core for a first net has the words only.
        if (codeOf(error) === LEFT_OUT)
          void this.#goOnInWholeCore(
            () => this.#solveAnew(),
            (failure) => this.#endSolve(failure),
          );
        else this.#solveFailed(error);
      }
    });
  }

  /** The net has moved over without what is in hand. */
  #solveAnew(): void {
    if (this.#inHand !== null) this.#moveHandles(this.#inHand);
    this.#go(true);
  }

  #solveFailed(error: unknown): void {
    const code = codeOf(error, CRASHED);
    // Hard problems end with a status; an exception is a fault.
    if (code === TOO_LARGE) this.#endSolve(error);
    else this.#post({ id: this.#touch, type: 'error', code: CRASHED, message: messageOf(error) });
  }

  #endSolve(error: unknown): void {
    this.#assess();
    this.#settle();
    this.#refuse(this.#touch, error);
  }

  #slice(): void {
    const report = this.#net().solve({ milliseconds: SLICE });
    this.#note(report);
    if (report.status !== 'running') this.#settle();
    else this.#sliceSoon();
    if (this.#solving && !this.#hadItsShare()) return;
    if (this.#solving && this.#frameSeen) this.#send('frame');
    this.#takeNextDrag();
  }

  #hadItsShare(): boolean {
    const isExact = (this.#row?.maxDeviation ?? Infinity) < Number(this.#net().options().threshold);
    return this.#host.now() - this.#shareStart >= (isExact ? EXACT_SHARE : SHARE);
  }

  #note(report: SolveReport): void {
    this.#status = report.status;
    this.#row = report.trace.at(-1) ?? this.#row;
    this.#toRest = report.toRest;
    this.#unsentRows.push(...report.trace);
  }

  #settle(): void {
    this.#solving = false;
    this.#send('settled');
  }

  #forgetSolve(): void {
    this.#row = null;
    this.#unsentRows = [];
  }

  /** The status of a net whose positions were set rather than solved. @param as it was left before; of edges that do not have
   *  their length nothing else is believed. */
  #assess({ settled, ending }: Pick<OpenScene, 'settled' | 'ending'> = { settled: false }): void {
    const editor = this.#net();
    const isExact = largest(editor.fields().deviation) < Number(editor.options().threshold);
    const before = settled ? ending : undefined;
    if (isExact) this.#status = before ?? 'converged';
    else if (editor.unreachablePairs().length > 0) this.#status = 'unreachable';
    else this.#status = before === 'exact' ? 'running' : (before ?? 'running');
  }

  // --------------------------------------------------------------------------------------------------------- answers

  #send(type: 'frame' | 'settled'): void {
    this.#frameSeen = false;
    this.#shareStart = this.#host.now();
    const frame = this.#frame();
    this.#post({ id: this.#touch, type, frame }, buffersOf(frame));
  }

  #frame(): FrameData {
    const editor = this.#net();
    const fields = editor.fields();
    const [trace, stepFrom] = [this.#unsentRows, this.#stepFrom];
    this.#unsentRows = [];
    this.#stepFrom = null;
    const handles = editor.handles();
    return {
      positions: editor.positions(),
      lengthScale: Number(editor.options().length_scale),
      fields,
      handles,
      holdsBack: editor.holdsBack,
      fellShort: this.#fellShort(handles),
      status: this.#status,
      maxDeviation: largest(fields.deviation),
      iterations: this.#row?.iteration ?? 0,
      milliseconds: this.#row?.totalMs ?? 0,
      stage: this.#row?.stage ?? 0,
      method: editor.method,
      toRest: this.#row && this.#toRest,
      trace,
      stepFrom,
      unreachable: editor.unreachablePairs().slice(0, MOST_PAIRS),
      memory: this.#core.memory(),
    };
  }

  #net(): Editor {
    if (this.#editor === null) throw new Failure('no_net', 'No net is open.');
    return this.#editor;
  }

  #reply(request: Request, answer: Answer): void {
    this.#post({ id: request.id, ...answer } as Response);
  }

  #post(response: Response, transfer: Transferable[] = []): void {
    this.#host.post(response, transfer);
  }

  #refuse(id: number, error: unknown): void {
    this.#post({ id, type: 'error', code: codeOf(error, CRASHED), message: messageOf(error) });
  }
}

/** Begins a solve, which ends with that if the net is at rest. In any case the net stays. */
function beginSolve(editor: Editor): void {
  const before = editor.state();
  if (editor.solve({ iterations: 1 }).iterations > 0) editor.setState(before);
}

function checkNumbering(editor: Editor, { numbering }: OpenScene): void {
  if (numbering === undefined || numbering === numberingOf(editor)) return;
  throw new Failure(
    'other_numbering',
    'This net is numbered otherwise than when it was saved: shape and handles belong to other vertices.',
  );
}

function fileOf(editor: Editor, format: string): Uint8Array<ArrayBuffer> {
  if (format === 'edges') return new TextEncoder().encode(editor.edgeTable());
  return format === 'rods' ? new TextEncoder().encode(editor.rodTable()) : editor.toFile(format);
}

/** Of messages, which copy what they carry. */
function isSameGuide(a: GuideSource, b: GuideSource): boolean {
  if ('own' in a || 'own' in b) return 'own' in a && 'own' in b && a.own === b.own;
  const same = (p: Float64Array | Int32Array, q: Float64Array | Int32Array): boolean =>
    p.length === q.length && p.every((each, i) => each === q[i]);
  return same(a.mesh.positions, b.mesh.positions) && same(a.mesh.faceVertices, b.mesh.faceVertices);
}

function drawn({ positions, normals, triangles }: Surface): DrawnSurface {
  return { positions, normals, triangles };
}

/** A scene that says nothing of positions is the net as it is, grown where its edges are longer. */
function goTo(scene: Omit<OpenScene, 'net'>, editor: Editor): void {
  const state = stateOf(scene, editor);
  if (scene.positions === null) editor.changeState(state);
  else editor.setState(state);
}

/** The editor's state for a scene. */
function stateOf(scene: Omit<OpenScene, 'net'>, editor: Editor): EditState {
  const { method, initialisation, options, positions } = scene;
  const rest = editor.restPositions;
  const seeds =
    scene.handles === 'suggested'
      ? Array.from(editor.suggestedHandles, (vertex) => ({ vertex, target: null }))
      : scene.handles;
  const handles = seeds.map(({ vertex, target, weight, slides }: Omit<HandleSeed, 'anchor'>) => ({
    vertex,
    // A vertex that is out of range gets a target, too: the core then refuses it with its message.
    target: target ?? pointOf(rest, vertex),
    weight,
    slides,
  }));
  const stands = positions !== null && 'packed' in positions ? unpackPositions(positions.packed, editor) : positions;
  // Packing has taken digits from the positions, which what slides has in its target.
  if (stands !== null && stands !== positions)
    for (const { vertex, target, slides } of handles)
      if (slides && 3 * vertex < stands.length) stands.set(target, 3 * vertex);
  return { method, initialisation, options, handles: targetsOf(handles), locality: null, positions: stands ?? rest };
}

function buffersOf(message: OpenedNet | FrameData): Transferable[] {
  return [message, ...('fields' in message ? [message.fields] : [])].flatMap(arrayBuffers);
}

/** The largest of numbers ≥ 0, or NaN if there is one. */
function largest(numbers: Float32Array): number {
  let largest = 0;
  for (let i = 0; i < numbers.length; i++) largest = Math.max(largest, numbers[i]!);
  return largest;
}

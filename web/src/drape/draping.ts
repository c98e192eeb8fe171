/** The page's side of the draping worker. While it is busy the latest request of each kind waits, and all for new marks. */
import type { DrapeReport, Mesh, Point, RemeshOptions, RemeshPhase, SurfacePlace } from '../../../wasm/chebnet';
import { Failure } from '../failure';
import { words } from '../language/language';
import { handleBy } from '../worker/handlers';
import type { Handlers } from '../worker/handlers';
import type {
  Cut,
  DrapedNet,
  DrapeRequest,
  DrapeResponse,
  DrapeSettings,
  DrawnKind,
  Proposal,
  ProposalSettings,
  Ray,
  RemeshedNet,
  ShownSurface,
  SurfaceSource,
} from './drape_protocol';

/** A net that has stood still for so many milliseconds is measured: that takes longer than laying it. */
const STILL_MS = 120;

/** What is still wanted when a net that was being made is given up: answers to these come from the next worker. */
const OUTLASTING: readonly DrapeRequest['type'][] = ['propose', 'trace', 'place'];

type MeasureRequest = Extract<DrapeRequest, { type: 'measure' }>;

/** The part of a `Worker` that is used. */
export interface DrapeWorkerLike {
  postMessage(request: DrapeRequest): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<DrapeResponse>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

export interface DrapingEvents {
  /** @param length of edges that suits the surface. */
  opened(surface: ShownSurface, length: number): void;
  /** The best first. */
  proposed(proposals: Proposal[]): void;
  /** A cut through the points that were asked for, without those beside the surface. */
  traced(cut: Cut, revision: number): void;
  /** The shortest one that was asked for. */
  cutFound(cut: Cut, revision: number): void;
  /** Where a mark is to stand; null: for a new one. */
  placed(place: SurfacePlace, mark: number | null, revision: number): void;
  /** Cuts that help; `coverage` is one longer, without them and with each further one. */
  cutsProposed(cuts: Cut[], coverage: number[]): void;
  draped(net: DrapedNet): void;
  /** The seed is beside the surface; the net of before stays. */
  missed(): void;
  /** @param done of the phase, 0 … 1. */
  progressed(phase: RemeshPhase, done: number): void;
  remeshed(net: RemeshedNet): void;
  /** Of the last net. @param milliseconds that it took to measure it. */
  measured(report: DrapeReport, milliseconds: number): void;
  /** With the core's sentence; the net of before stays.
   *  @param request that is refused; null: the worker is lost, and with it whatever was asked for. */
  refused(error: Failure, request: DrapeRequest['type'] | null): void;
}

export class Draping {
  readonly #spawn: () => DrapeWorkerLike;
  readonly #events: DrapingEvents;
  #worker: DrapeWorkerLike;
  #source: SurfaceSource | null = null;
  /** The surface that is being opened was open before, in a worker that has been stopped. */
  #isReopening = false;
  #isLost = false;
  /** Not answered yet. */
  #asked: DrapeRequest | null = null;
  /** At most one of each kind, in the order in which they came; with another surface all before it are gone. */
  #waiting: readonly DrapeRequest[] = [];
  /** Asks how the last net lies, as long as that is not known; null: it is, or there is none. */
  #unmeasured: MeasureRequest | null = null;
  #still: ReturnType<typeof setTimeout> | undefined;

  constructor(spawn: () => DrapeWorkerLike, events: DrapingEvents) {
    this.#spawn = spawn;
    this.#events = events;
    this.#worker = this.#start();
  }

  /** Whether the net that was last asked for, of one piece, is yet to come. */
  get isLaying(): boolean {
    return this.#asked?.type === 'drape' || this.#waits('drape');
  }

  open(source: SurfaceSource): void {
    if (this.#isLost) this.#begin();
    this.#source = source;
    this.#isReopening = false;
    this.#unmeasured = null;
    this.#ask({ type: 'open', source });
  }

  propose(settings: ProposalSettings): void {
    this.#ask({ type: 'propose', settings });
  }

  trace(line: DrawnKind, points: (Point | Ray)[], revision: number): void {
    this.#askOfSurface({ type: 'trace', line, points, revision });
  }

  /** From a point to the border, or between two borders; the cuts that are there are border, too. */
  findShortestCut(from: Point | null, cuts: Point[][], revision: number): void {
    this.#askOfSurface({ type: 'shortestCut', from, cuts, revision });
  }

  /** Where a ray, or what is nearest to a point, is on the surface: for a mark there, or for a new one, null. */
  place(at: Point | Ray, mark: number | null, revision: number): void {
    this.#askOfSurface({ type: 'place', at, mark, revision });
  }

  /** Takes a while. */
  proposeCuts(settings: DrapeSettings): void {
    this.#askOfSurface({ type: 'proposeCuts', settings });
  }

  drape(settings: DrapeSettings): void {
    this.#askOfSurface({ type: 'drape', settings });
  }

  /** A net over the whole surface, which takes a while. */
  remesh(options: RemeshOptions): void {
    this.#askOfSurface({ type: 'remesh', options });
  }

  /** Gives up what is being made, and cuts that were to be proposed; the surface stays open.
   *  @param shown the net of before, which the next worker does not know. */
  stop(shown: Mesh | null = null): void {
    const wanted = [this.#asked, ...this.#waiting].filter((each) => each !== null && OUTLASTING.includes(each.type));
    this.close();
    this.#begin();
    if (this.#source === null) return;
    this.#isReopening = true;
    this.#ask({ type: 'open', source: this.#source });
    for (const request of wanted) this.#ask(request!);
    if (this.#unmeasured !== null) this.#unmeasured = shown && { type: 'measure', mesh: shown };
    if (this.#unmeasured !== null) this.#ask(this.#unmeasured);
  }

  close(): void {
    clearTimeout(this.#still);
    this.#worker.onmessage = null; // some may be on their way
    this.#worker.terminate();
  }

  #start(): DrapeWorkerLike {
    const worker = this.#spawn();
    worker.onmessage = ({ data }) => this.#receive(data);
    worker.onerror = ({ message }) => this.#lose(message || words.page.programMissing);
    return worker;
  }

  /** With another worker, which has nothing to do. */
  #begin(): void {
    this.#worker = this.#start();
    this.#isLost = false;
    this.#asked = null;
    this.#waiting = [];
  }

  /** There is another worker once a surface is opened: one after the other might be lost. */
  #lose(message: string): void {
    this.close();
    this.#isLost = true;
    this.#asked = null;
    this.#waiting = [];
    this.#unmeasured = null;
    this.#events.refused(new Failure('worker_lost', message), null);
  }

  /** While another surface is to be opened, or is being, it would be of the surface before. */
  #askOfSurface(request: DrapeRequest): void {
    const isOpening = this.#asked?.type === 'open' && !this.#isReopening;
    if (!isOpening && !this.#waits('open')) this.#ask(request);
  }

  #ask(request: DrapeRequest): void {
    clearTimeout(this.#still);
    if (this.#asked === null) this.#post(request);
    else if (request.type === 'open') this.#waiting = [request];
    else this.#waiting = [...this.#waiting.filter((each) => !replaces(request, each)), request];
  }

  #post(request: DrapeRequest): void {
    this.#asked = request;
    this.#worker.postMessage(request);
  }

  #waits(...types: DrapeRequest['type'][]): boolean {
    return this.#waiting.some(({ type }) => types.includes(type));
  }

  #receive(response: DrapeResponse): void {
    const request = this.#asked;
    if (response.type === 'progress') return handleBy(this.#tellers, response, request?.type ?? null);
    this.#asked = null;
    const isOld = this.#waits('open') || (response.type === 'measured' && this.#waits('drape', 'remesh'));
    if (!isOld && (response.type === 'draped' || response.type === 'remeshed')) this.#unmeasured = { type: 'measure' };
    if (!isOld && request?.type === 'measure') this.#unmeasured = null;
    const [next, ...others] = this.#waiting;
    this.#waiting = others;
    if (next !== undefined) this.#post(next);
    if (!isOld) handleBy(this.#tellers, response, request?.type ?? null);
    const unmeasured = this.#unmeasured;
    if (this.#asked === null && unmeasured !== null) this.#still = setTimeout(() => this.#ask(unmeasured), STILL_MS);
  }

  readonly #tellers: Handlers<DrapeResponse, void, [request: DrapeRequest['type'] | null]> = {
    opened: ({ surface, length }) => this.#tellOpened(surface, length),
    proposed: ({ proposals }) => this.#events.proposed(proposals),
    traced: ({ cut, revision }) => this.#events.traced(cut, revision),
    cutFound: ({ cut, revision }) => this.#events.cutFound(cut, revision),
    placed: ({ place, mark, revision }) => this.#tellPlaced(place, mark, revision),
    cutsProposed: ({ cuts, coverage }) => this.#events.cutsProposed(cuts, coverage),
    draped: (net) => this.#events.draped(net),
    progress: ({ phase, done }) => this.#events.progressed(phase, done),
    missed: () => this.#events.missed(),
    remeshed: (net) => this.#events.remeshed(net),
    measured: ({ report, milliseconds }) => this.#events.measured(report, milliseconds),
    error: ({ code, message }, request) =>
      this.#events.refused(new Failure(code, words.core.failure(code, message)), request),
  };

  #tellPlaced(place: SurfacePlace | null, mark: number | null, revision: number): void {
    if (place !== null) this.#events.placed(place, mark, revision);
  }

  #tellOpened(surface: ShownSurface, length: number): void {
    if (!this.#isReopening) this.#events.opened(surface, length);
    this.#isReopening = false;
  }
}

/** Whether a request makes one that waits needless: not for another line or mark, nor, for a new mark, at all. */
function replaces(request: DrapeRequest, waiting: DrapeRequest): boolean {
  if (request.type === 'place' && waiting.type === 'place')
    return request.mark !== null && request.mark === waiting.mark;
  if (request.type === 'trace' && waiting.type === 'trace') return request.line === waiting.line;
  return request.type === waiting.type;
}

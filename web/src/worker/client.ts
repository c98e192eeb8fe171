/** The page's side of the worker: requests as promises, frames as events, one drag in flight, and a new worker if the
 *  old one is lost. Failures have the core's code and message, or "worker_lost", or "cancelled", by `cancelOpening`. */
import type { Axes, Ball, FlatPattern, Handle, PatternFault, VertexLists } from '../../../wasm/chebnet';
import type { Scene, SolverSettings, Vec3 } from '../document/document';
import { words } from '../language/language';
import { CRASHED, PROTOCOL_VERSION, touchesNet } from './protocol';
import type { DrawnSurface, FrameData, OpenedNet, Request, Response, SearchFor, SearchProgress } from './protocol';
import { Failure, codeOf } from '../failure';

/** The part of a `Worker` that the client uses. */
export interface WorkerLike {
  postMessage(request: Request): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Response>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

/** The page, as the client knows it. */
interface ClientHost {
  /** The net that is open, for the worker after one that is lost; null: none is. */
  document(): OpenScene | null;
  /** News of the net; `settled`: nothing is left to be solved. Frames from before the last open, restore or reset do not come. */
  frame(frame: FrameData, settled: boolean): void;
  /** A worker was lost, or ended by `cancelOpening`. Another has opened the document; unless `isBack`, it could not, and no
   *  net is open. */
  restarted(why: Failure, isBack: boolean): void;
  /** A solve was given up; the net stays as the last frame has it. */
  gaveUp(why: Failure): void;
}

/** Whether it failed because it was cancelled. */
export function isCancelled(error: unknown): boolean {
  return codeOf(error) === 'cancelled';
}

export interface Opened {
  net: OpenedNet;
  frame: FrameData;
}

type OpenScene = Omit<Scene, 'view'>;
/** What of the document is to be said otherwise when another worker opens it again. */
type Returning = Pick<OpenScene, 'settled' | 'ending'>;
type Answered<T extends Response['type']> = Extract<Response, { type: T }>;
type News = Pick<Answered<'frame'>, 'id' | 'frame'>;
type WithoutId<T> = T extends unknown ? Omit<T, 'id'> : never;
type Body = WithoutId<Request>;

interface Waiting {
  type: Request['type'];
  resolve(response: Response): void;
  reject(error: Failure): void;
}

/** Of a drag: where the hand is, if targets are kept nearer, and the axes to which it is kept. */
interface HandSays {
  asked?: readonly Handle[];
  along?: Axes | undefined;
}

interface PendingDrag {
  /** The latest target of each vertex. */
  targets: Map<number, Vec3>;
  inHand: boolean;
  hand: HandSays;
  taken(): void;
  refused(error: unknown): void;
  promise: Promise<void>;
}

const SILENT_PARTS = 20;

export class Client {
  readonly #spawn: () => WorkerLike;
  readonly #host: ClientHost;
  readonly #patience: number;
  #worker: WorkerLike | null = null;
  /** The worker has answered something already: if it is lost, it is worth starting another. */
  #proven = false;
  #lastId = 0;
  readonly #waiting = new Map<number, Waiting>();
  /** To be sent when the drag under way is answered. */
  #pendingDrag: PendingDrag | null = null;
  #dragsUnderWay = 0;
  /** The last request answered that touched the net, and the last of which the news says that it is settled. */
  #touched = 0;
  #settled = 0;
  /** The last news, at rest, if a change that is unanswered keeps it from counting as that. */
  #withheld: News | null = null;
  /** News of requests before this one is outdated. */
  #barrier = 0;
  /** The worker has a net. */
  #hasNet = false;
  /** Why the last worker was lost; null: none was. */
  #loss: Failure | null = null;
  /** How a new worker opens the document in place of one that was lost; null: none does. */
  #returning: Returning | null = null;
  #silence: ReturnType<typeof setInterval> | undefined;
  #whenIdle: (() => void)[] = [];
  #searching: (progress: SearchProgress) => void = () => {};

  /** @param patience milliseconds of silence, while the worker is busy, after which it counts as lost. */
  constructor(spawn: () => WorkerLike, host: ClientHost, patience = 60_000) {
    this.#spawn = spawn;
    this.#host = host;
    this.#patience = patience;
  }

  /** Whether requests wait or the net is being solved. */
  get busy(): boolean {
    return this.#waiting.size > 0 || this.#pendingDrag !== null || this.solving;
  }

  /** Whether requests that change the net are unanswered, or it is being solved; queries do not count. */
  get changing(): boolean {
    const touching = [...this.#waiting.values()].some(({ type }) => touchesNet(type));
    return touching || this.#pendingDrag !== null || this.solving;
  }

  /** Whether the net is yet to settle. */
  get solving(): boolean {
    return this.#touched > this.#settled;
  }

  /** Whether a new worker is opening the document in place of one that was lost. */
  get returning(): boolean {
    return this.#returning !== null;
  }

  /** Whether it is what all that waited for a lost worker failed with. */
  isLoss(error: unknown): boolean {
    return error === this.#loss;
  }

  /** Resolves when no request that changes the net waits and the net is settled; pictures of other nets may be under way. */
  async idle(): Promise<void> {
    if (this.changing) await new Promise<void>((resolve) => this.#whenIdle.push(resolve));
  }

  /** The tables of what the solver can do. */
  hello(): Promise<Answered<'ready'>> {
    return this.#ask({ type: 'hello', version: PROTOCOL_VERSION }, 'ready');
  }

  /** If it fails, the net opened before stays. */
  async open(scene: OpenScene): Promise<Opened> {
    this.#sendDrag();
    const { net, frame } = await this.#ask({ type: 'open', scene }, 'opened');
    this.#hasNet = true;
    return { net, frame };
  }

  /** Cancels openings; the net opened before stays. A worker cannot be interrupted while it opens a net: it is terminated
   *  and replaced. */
  cancelOpening(): void {
    if (![...this.#waiting.values()].some(({ type }) => type === 'open')) return;
    const why = new Failure('cancelled', words.solver.openingCancelled);
    const back = this.#hasNet ? { settled: !this.solving } : this.#returning;
    this.#endWorker(why);
    if (back !== null) this.#bringBack(back, why);
    this.#rest();
  }

  setHandles(handles: Handle[]): Promise<void> {
    return this.#tell({ type: 'handles', handles });
  }

  /**
   * Targets of the moment. At most one request is under way; of the targets that come meanwhile the newest of each vertex
   * are sent together. Resolves when the worker has taken these targets or newer ones.
   * @param inHand whether they are held back where no net leads there, until `release`.
   */
  drag(targets: readonly Handle[], inHand = false, hand: HandSays = {}): Promise<void> {
    const pending = (this.#pendingDrag ??= newPendingDrag());
    pending.inHand = inHand;
    pending.hand = hand;
    for (const { vertex, target } of targets) pending.targets.set(vertex, target);
    if (this.#dragsUnderWay === 0) this.#sendDrag();
    return pending.promise;
  }

  /** The hand lets go; see `drag`. */
  release(): Promise<void> {
    return this.#tell({ type: 'release' });
  }

  /** What may move from now on: `radius` in edge lengths, null: everything. */
  setLocality(radius: number | null, origins: readonly number[]): Promise<void> {
    return this.#tell({ type: 'locality', radius, origins: [...origins] });
  }

  setOptions(settings: SolverSettings): Promise<void> {
    return this.#tell({ type: 'options', settings });
  }

  /** Puts the open net into an earlier state. */
  restore(scene: Omit<OpenScene, 'net'>): Promise<void> {
    return this.#tell({ type: 'restore', scene });
  }

  /** All edges grow by one factor, as little as brings handles to where they, or a hand that was held back, are to be. The
   *  option `length_scale` then; null if none does. Fails as "cancelled" where the net is touched meanwhile. */
  adaptLengths(progress: (passed: SearchProgress) => void): Promise<number | null> {
    return this.#search('lengths', progress);
  }

  /** Another net at rest: the part of the energy that it has; null if none has less. Fails as "cancelled" likewise. */
  searchRest(progress: (passed: SearchProgress) => void): Promise<number | null> {
    return this.#search('rest', progress);
  }

  async #search(what: SearchFor, progress: (passed: SearchProgress) => void): Promise<number | null> {
    this.#sendDrag();
    this.#searching = progress;
    return (await this.#ask({ type: 'search', what }, 'searched')).found;
  }

  solve(): Promise<void> {
    return this.#tell({ type: 'solve' });
  }

  step(): Promise<void> {
    return this.#tell({ type: 'step' });
  }

  cancel(): Promise<void> {
    return this.#tell({ type: 'cancel' });
  }

  reset(): Promise<void> {
    return this.#tell({ type: 'reset' });
  }

  /** The net as the bytes of a file. */
  async exportFile(format: string): Promise<Uint8Array<ArrayBuffer>> {
    this.#sendDrag();
    return (await this.#ask({ type: 'export', format }, 'exported')).bytes;
  }

  async reach(vertices: readonly number[]): Promise<Ball[][]> {
    return (await this.#ask({ type: 'reach', vertices: [...vertices] }, 'reach')).balls;
  }

  async mobility(radius: number, origins: readonly number[]): Promise<Float32Array> {
    return (await this.#ask({ type: 'mobility', radius, origins: [...origins] }, 'mobility')).mobility;
  }

  /** Where the net's other equilibrium may be. */
  async flipped(): Promise<Float64Array> {
    return (await this.#ask({ type: 'flipped' }, 'flipped')).positions;
  }

  /** What is drawn of the surface beside the net; null: there is none. */
  async guide(): Promise<DrawnSurface | null> {
    return (await this.#ask({ type: 'guide' }, 'guide')).surface;
  }

  /** Of each point the nearest one of that surface. */
  async nearest(points: readonly Vec3[]): Promise<Vec3[]> {
    return (await this.#ask({ type: 'nearest', points: [...points] }, 'nearest')).points;
  }

  async flatPattern(): Promise<FlatPattern | PatternFault> {
    return (await this.#ask({ type: 'pattern' }, 'pattern')).pattern;
  }

  async rods(): Promise<VertexLists> {
    return (await this.#ask({ type: 'rods' }, 'rods')).rods;
  }

  // -------------------------------------------------------------------------------------------------------- requests

  /** For requests without a result. A waiting drag is sent first, which keeps the order of the user's actions. */
  async #tell(body: Body): Promise<void> {
    this.#sendDrag();
    await this.#ask(body, 'done');
  }

  #ask<T extends Response['type']>(body: Body, answer: T): Promise<Answered<T>> {
    const id = ++this.#lastId;
    if (body.type === 'open' || body.type === 'restore' || body.type === 'reset') this.#barrier = id;
    return new Promise((resolve, reject) => {
      const take = (response: Response): void => {
        if (response.type === answer) resolve(response as Answered<T>);
        else reject(new Failure('internal', `The solver answered "${body.type}" with "${response.type}".`));
      };
      this.#waiting.set(id, { type: body.type, resolve: take, reject });
      this.#post({ id, ...body } as Request);
      this.#watch();
    });
  }

  #sendDrag(): void {
    if (this.#pendingDrag === null) return;
    const { targets, inHand, hand, taken, refused } = this.#pendingDrag;
    this.#pendingDrag = null;
    this.#dragsUnderWay += 1;
    const onward = (): void => {
      this.#dragsUnderWay -= 1;
      if (this.#dragsUnderWay === 0) this.#sendDrag();
    };
    const list = Array.from(targets, ([vertex, target]) => ({ vertex, target }));
    const { asked, along } = hand;
    const said = { ...(asked && { asked: [...asked] }), ...(along && { along }) };
    this.#ask({ type: 'drag', targets: list, inHand, ...said }, 'done')
      .then(taken, refused)
      .finally(onward);
  }

  // -------------------------------------------------------------------------------------------------------- answers

  #receive(response: Response): void {
    if (response.type === 'error' && response.code === CRASHED)
      return this.#lose(words.core.failure(CRASHED, response.message));
    this.#proven = true;
    // Whatever goes wrong in the page that is told of it.
    try {
      if (response.type === 'frame' || response.type === 'settled') this.#news(response);
      else if (response.type === 'searching') this.#searching(response.progress);
      else this.#answered(response);
    } finally {
      this.#rest();
    }
  }

  #news({ id, type, frame }: Answered<'frame' | 'settled'>): void {
    if (type === 'settled') this.#settled = Math.max(this.#settled, id);
    this.#post({ id: ++this.#lastId, type: 'seen' });
    this.#pass({ id, frame });
  }

  /** While a change is unanswered, targets are newer than those of the frame: it settles nothing, unless the change is refused. */
  #pass(news: News): void {
    this.#withheld = this.changing && !this.solving ? news : null;
    if (news.id >= this.#barrier) this.#host.frame(news.frame, !this.changing);
  }

  #answered(response: Response): void {
    const waiting = this.#waiting.get(response.id);
    this.#waiting.delete(response.id);
    if (response.type === 'error') {
      const why = new Failure(response.code, words.core.failure(response.code, response.message));
      if (waiting === undefined) return this.#host.gaveUp(why);
      // A failed request changed nothing, so news of those before is still valid.
      if (this.#barrier === response.id) this.#barrier = 0;
      waiting.reject(why);
      if (this.#withheld !== null && !this.changing) this.#pass(this.#withheld);
    } else if (waiting !== undefined) {
      if (touchesNet(waiting.type)) this.#touched = Math.max(this.#touched, response.id);
      waiting.resolve(response);
    }
  }

  // ---------------------------------------------------------------------------------------------------------- workers

  #post(request: Request): void {
    this.#worker ??= this.#start();
    this.#worker.postMessage(request);
  }

  #start(): WorkerLike {
    const worker = this.#spawn();
    const lose = (reason: string): void => {
      if (worker === this.#worker) this.#lose(reason);
    };
    worker.onmessage = ({ data }) => {
      if (worker === this.#worker) this.#receive(data);
    };
    worker.onerror = ({ message }) => lose(message || words.solver.notStarted);
    worker.onmessageerror = () => lose(words.solver.garbled);
    this.#proven = false;
    return worker;
  }

  /** Counts the silence anew, if there is anything to wait for; in parts, all but one of which a page misses that is suspended,
   *  and its worker with it. */
  #watch(): void {
    clearInterval(this.#silence);
    if (!this.busy) return;
    let left = SILENT_PARTS;
    this.#silence = setInterval(() => {
      if (--left === 0) this.#lose(words.solver.silent);
    }, this.#patience / SILENT_PARTS);
  }

  /** The net is not solved any further: that may be what broke the worker. */
  #lose(reason: string): void {
    const why = (this.#loss = new Failure('worker_lost', reason));
    const [hadNet, hopeful] = [this.#hasNet, this.#proven];
    const stopped = this.solving ? ({ ending: 'running' } as const) : {};
    this.#endWorker(why);
    if (hadNet && hopeful) this.#bringBack({ settled: true, ...stopped }, why);
    else if (hadNet) this.#host.restarted(why, false);
    this.#rest();
  }

  #endWorker(why: Failure): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#hasNet = false;
    this.#settled = this.#touched;
    this.#withheld = null;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of waiting) reject(why);
    this.#pendingDrag?.refused(why);
    this.#pendingDrag = null;
  }

  /** Opens the document in a new worker. */
  #bringBack(back: Returning, why: Failure): void {
    const document = this.#host.document();
    if (document === null) return;
    this.#returning = back;
    const end = (isBack: boolean): void => {
      this.#returning = null;
      this.#host.restarted(why, isBack);
    };
    // If this worker is terminated, too, the next begins anew.
    this.open({ ...document, ...back }).then(
      () => end(true),
      (error: unknown) => isCancelled(error) || end(false),
    );
  }

  /** Resolves idle() if it is. */
  #rest(): void {
    this.#watch();
    if (!this.changing) for (const resolve of this.#whenIdle.splice(0)) resolve();
  }
}

function newPendingDrag(): PendingDrag {
  let taken = (): void => {};
  let refused = (_error: unknown): void => {};
  const promise = new Promise<void>((resolve, reject) => {
    taken = resolve;
    refused = reject;
  });
  return { targets: new Map(), inHand: false, hand: {}, taken, refused, promise };
}

/** A worker for comparisons: it solves one scene after another while the user's own worker stays free for edits. */
import type { Scene } from '../document/document';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { WorkerLike } from '../worker/client';
import type { FrameData, Measures, OpenedNet, Request, Response } from '../worker/protocol';
import { Failure } from '../failure';

export type RunScene = Omit<Scene, 'view'>;

type Body = Request extends infer R ? (R extends { id: number } ? Omit<R, 'id'> : never) : never;

export class RunSolver {
  readonly #worker: WorkerLike;
  #lastId = 0;
  #take: (response: Response) => void = () => {};
  #reject: (error: Failure) => void = () => {};

  constructor(spawn: () => WorkerLike) {
    this.#worker = spawn();
    this.#worker.onmessage = ({ data }) => this.#receive(data);
    this.#worker.onerror = ({ message }) =>
      this.#reject(new Failure('worker_lost', message || words.solver.notStarted));
    this.#worker.onmessageerror = () => this.#reject(new Failure('worker_lost', words.solver.garbled));
  }

  /** Opens a scene and solves it to its end, or for about `milliseconds`; `news` sees the start and each frame. Returns the
   *  net. */
  solve(scene: RunScene, news: (frame: FrameData) => void, milliseconds?: number): Promise<OpenedNet> {
    const id = this.#post({ type: 'open', scene });
    const stop = () => this.#post({ type: 'cancel' });
    const timer = milliseconds === undefined ? undefined : setTimeout(stop, milliseconds);
    const solved = new Promise<OpenedNet>((resolve, reject) => {
      let net: OpenedNet;
      this.#reject = reject;
      this.#take = (response) => {
        if (response.id < id) return; // of the scene before
        if (response.type === 'opened') ({ net } = response);
        if ('frame' in response) news(response.frame);
        if (response.type === 'settled') resolve(net);
      };
    });
    return solved.finally(() => clearTimeout(timer));
  }

  /** Of the net as it stands. */
  measure(): Promise<Measures> {
    this.#post({ type: 'measure' });
    return new Promise((resolve, reject) => {
      this.#reject = reject;
      this.#take = (response) => {
        if (response.type === 'measured') resolve(response.measures);
      };
    });
  }

  /** Terminates the worker at once; pending promises reject. Not usable afterwards. */
  dispose(): void {
    this.#worker.terminate();
    this.#reject(new Failure('cancelled', panelWords.comparison.wasCancelled));
  }

  #receive(response: Response): void {
    if (response.type === 'error')
      return this.#reject(new Failure(response.code, words.core.failure(response.code, response.message)));
    if (response.type === 'frame' || response.type === 'settled') this.#post({ type: 'seen' });
    this.#take(response);
  }

  #post(body: Body): number {
    const id = ++this.#lastId;
    this.#worker.postMessage({ id, ...body } as Request);
    return id;
  }
}

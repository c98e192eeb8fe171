/** The page's side of the changing worker. */
import { Failure } from '../failure';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import type { ChangedNet, ChangeRequest, ChangeResponse } from './change_protocol';

/** The part of a `Worker` that is used. */
interface ChangeWorkerLike {
  postMessage(request: ChangeRequest): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<ChangeResponse>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** One net being changed, in a worker of its own: to stop is to terminate the worker. */
export class Changing {
  /** Null: it was stopped. Rejects with the core's sentence, or as "not_exact" where no net was found. */
  readonly result: Promise<ChangedNet | null>;
  readonly #worker: ChangeWorkerLike;
  #end!: (changed: null) => void;

  constructor(worker: ChangeWorkerLike, request: ChangeRequest, progress: (iterations: number) => void) {
    this.#worker = worker;
    this.result = new Promise<ChangedNet | null>((resolve, reject) => {
      this.#end = resolve;
      worker.onmessage = ({ data }) => {
        if (data.type === 'news') progress(data.iterations);
        else if (data.type === 'ended' && data.changed !== null) resolve(data.changed);
        else if (data.type === 'ended') reject(new Failure('not_exact', dialogWords.change.notExact));
        else reject(new Failure(data.code, words.core.failure(data.code, data.message)));
      };
      worker.onerror = ({ message }) => reject(new Failure('worker_lost', message || words.page.programMissing));
    }).finally(() => {
      worker.onmessage = null; // some may be on their way
      this.#worker.terminate();
    });
    worker.postMessage(request);
  }

  stop(): void {
    this.#end(null);
  }
}

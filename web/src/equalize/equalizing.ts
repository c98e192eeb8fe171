/** The page's side of the equalizing worker. */
import { words } from '../language/language';
import type { EqualizeEnd, EqualizeNews, EqualizeRequest, EqualizeResponse } from './equalize_protocol';
import { Failure } from '../failure';

/** The part of a `Worker` that is used. */
export interface EqualizeWorkerLike {
  postMessage(request: EqualizeRequest): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<EqualizeResponse>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** One mesh being equalised, in a worker of its own: to cancel is to terminate the worker. */
export class Equalizing {
  readonly #worker: EqualizeWorkerLike;

  constructor(spawn: () => EqualizeWorkerLike) {
    this.#worker = spawn();
  }

  /** Rejects with the core's sentence. */
  run(request: EqualizeRequest, news: (news: EqualizeNews) => void): Promise<EqualizeEnd> {
    const ended = new Promise<EqualizeEnd>((resolve, reject) => {
      this.#worker.onmessage = ({ data }) => {
        if (data.type === 'news') news(data);
        else if (data.type === 'ended') resolve(data);
        else reject(new Failure(data.code, words.core.failure(data.code, data.message)));
      };
      this.#worker.onerror = ({ message }) => reject(new Failure('worker_lost', message || words.page.programMissing));
    });
    this.#worker.postMessage(request);
    return ended.finally(() => this.close());
  }

  /** At any time; pending promises then never settle. */
  close(): void {
    this.#worker.onmessage = null; // some may be on their way
    this.#worker.terminate();
  }
}

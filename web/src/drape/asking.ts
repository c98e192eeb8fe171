/** The draping worker for callers that wait for each answer before they ask again. */
import type { RemeshPhase } from '../../../wasm/chebnet';
import { Failure } from '../failure';
import { words } from '../language/language';
import type { DrapeRequest, DrapeResponse } from './drape_protocol';
import type { DrapeWorkerLike } from './draping';

type Answer<Type> = Extract<DrapeResponse, { type: Type }>;

/** For what takes long. */
export interface Watch {
  /** How far a phase is, from 0 to 1. */
  progress?(phase: RemeshPhase, done: number): void;
  /** Gives it up, with the signal's reason. */
  signal?: AbortSignal;
}

export class AskedDraper {
  readonly #worker: DrapeWorkerLike;

  constructor(worker: DrapeWorkerLike) {
    this.#worker = worker;
  }

  /** @param type of the answer. @param watch is told of progress before it, and may give up waiting; the worker is to be closed
   *  then. */
  ask<Type extends DrapeResponse['type']>(
    request: DrapeRequest,
    type: Type,
    { progress, signal }: Watch = {},
  ): Promise<Answer<Type>> {
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
      this.#worker.onerror = ({ message }) => reject(new Failure('worker_lost', message || words.page.programMissing));
      this.#worker.onmessage = ({ data }) => {
        if (data.type === type) resolve(data as Answer<Type>);
        else if (data.type === 'error') reject(new Failure(data.code, words.core.failure(data.code, data.message)));
        else if (data.type === 'progress') progress?.(data.phase, data.done);
        else reject(new Failure('internal', `an answer of type ${data.type}`));
      };
      this.#worker.postMessage(request);
    });
  }

  close(): void {
    this.#worker.terminate();
  }
}

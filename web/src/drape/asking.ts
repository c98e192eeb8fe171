/** The draping worker for callers that wait for each answer before they ask again. */
import { Failure } from '../failure';
import { words } from '../language/language';
import type { DrapeRequest, DrapeResponse } from './drape_protocol';
import type { DrapeWorkerLike } from './draping';

type Answer<Type> = Extract<DrapeResponse, { type: Type }>;

export class AskedDraper {
  readonly #worker: DrapeWorkerLike;

  constructor(worker: DrapeWorkerLike) {
    this.#worker = worker;
  }

  /** @param type of the answer; news of progress before it are passed over. */
  ask<Type extends DrapeResponse['type']>(request: DrapeRequest, type: Type): Promise<Answer<Type>> {
    return new Promise((resolve, reject) => {
      this.#worker.onerror = ({ message }) => reject(new Failure('worker_lost', message));
      this.#worker.onmessage = ({ data }) => {
        if (data.type === type) resolve(data as Answer<Type>);
        else if (data.type === 'error') reject(new Failure(data.code, words.core.failure(data.code, data.message)));
        else if (data.type !== 'progress') reject(new Failure('internal', `an answer of type ${data.type}`));
      };
      this.#worker.postMessage(request);
    });
  }

  close(): void {
    this.#worker.terminate();
  }
}

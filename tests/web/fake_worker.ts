import type { Editors } from '../../wasm/chebnet';
import type { WorkerLike } from '../../web/src/worker/client';
import type { Request, Response } from '../../web/src/worker/protocol';
import { Server } from '../../web/src/worker/server';
import { wholeCoreOf } from './whole_core_of';

/** A worker in this process, which gives its messages in turn with others. */
export class FakeWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  terminated = false;
  readonly #server: Server;

  constructor(core: Editors) {
    this.#server = new Server(core, {
      post: (response) => this.#later(() => this.onmessage?.({ data: response } as MessageEvent<Response>)),
      soon: (task) => this.#later(task),
      now: () => performance.now(),
      wholeCore: () => Promise.resolve(wholeCoreOf(core)),
    });
  }

  postMessage(request: Request): void {
    this.#later(() => this.#server.handle(request));
  }

  terminate(): void {
    this.terminated = true;
  }

  #later(task: () => void): void {
    setTimeout(() => this.terminated || task());
  }
}

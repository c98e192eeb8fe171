/** The page without its pictures: the app, its client and a server over the real core, all in this process. A net is solved
 *  when a test says so. */
import type { Editors } from '../../wasm/chebnet';
import { App } from '../../web/src/app/app';
import type { AppParts, AppServices } from '../../web/src/app/app';
import type { PanelEvents } from '../../web/src/panels';
import type { WorkerLike } from '../../web/src/worker/client';
import type { Request, Response } from '../../web/src/worker/protocol';
import { Server } from '../../web/src/worker/server';
import { wholeCoreOf } from './whole_core_of';

export interface Page {
  app: App;
  /** What panels can do. */
  events: PanelEvents;
  /** What the workers were asked for. */
  asked: Request['type'][];
  /** What the user was told. */
  said: string[];
  /** Solves until nothing is left to be solved. */
  solve(): Promise<void>;
  /** The worker breaks. */
  loseWorker(): void;
}

/** @param whole what the worker goes over to where `core` has left something out. */
export async function openPage(core: Editors, whole = core): Promise<Page> {
  const tasks: (() => void)[] = [];
  const workers: WorkerHere[] = [];
  const said: string[] = [];
  const asked: Request['type'][] = [];
  let events!: PanelEvents;
  const panels: unknown = Object.assign(Object.create(silent), { say: (message: string) => said.push(message) });
  const parts = {
    createView: () =>
      Object.assign(Object.create(silent), { behind: false, unframed: () => null, screenPositions: nowhere }),
    createBeside: () => silent,
    createPanels: (given: PanelEvents) => {
      events = given;
      return panels;
    },
    spawnWorker: () => workers[workers.push(new WorkerHere(core, whole, tasks, asked)) - 1],
  };
  const app = new App(parts as unknown as AppParts, {} as AppServices);
  const solve = async () => {
    for (; !app.isQuiet; await new Promise((resolve) => setImmediate(resolve))) tasks.shift()?.();
  };
  const loseWorker = () => workers.at(-1)?.onerror?.({ message: 'lost' } as ErrorEvent);
  await app.start();
  return { app, events, asked, said, solve, loseWorker };
}

const nowhere = (vertices: readonly number[]) => vertices.map(() => ({ x: 0, y: 0 }));

/** Has every method, none of which does anything. */
const silent = new Proxy({}, { get: () => () => {} });

class WorkerHere implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  readonly #server: Server;
  readonly #asked: Request['type'][];
  #isEnded = false;

  constructor(core: Editors, whole: Editors, tasks: (() => void)[], asked: Request['type'][]) {
    this.#asked = asked;
    const post = (response: Response): void => {
      const data = structuredClone(response);
      queueMicrotask(() => this.onmessage?.({ data } as MessageEvent<Response>));
    };
    const soon = (task: () => void) => tasks.push(() => void (this.#isEnded || task()));
    this.#server = new Server(core, {
      post,
      soon,
      now: () => 0,
      wholeCore: () => Promise.resolve(wholeCoreOf(whole)),
    });
  }

  postMessage(request: Request): void {
    this.#asked.push(request.type);
    this.#server.handle(structuredClone(request));
  }

  terminate(): void {
    this.#isEnded = true;
  }
}

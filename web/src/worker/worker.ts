/** The module worker: loads the core for a first net and starts the server (server.ts). */
import wasmUrl from '../../../build/wasm/chebnet_editor.wasm?url';
import { loadEditors } from '../../../wasm/editors.js';
import type { Editors } from '../../../wasm/chebnet';
import { holdOwnLock } from './life';
import { CRASHED } from './protocol';
import type { Request, Response } from './protocol';
import { Server } from './server';
import { warmUp } from './warm_up';
import type { WholeCore } from './whole_core';
import { messageOf } from '../failure';

const WARM_UP_DELAY = 100;

const queue: Request[] = [];
let server: Server | null = null;

function post(response: Response, transfer: Transferable[]): void {
  self.postMessage(response, { transfer });
}

// A message to itself is queued behind those that wait already; a timer would be clamped to 4 ms.
const channel = new MessageChannel();
let tasks: (() => void)[] = [];
channel.port1.onmessage = () => {
  const due = tasks;
  tasks = [];
  for (const task of due) task();
};

function soon(task: () => void): void {
  tasks.push(task);
  channel.port2.postMessage(null);
}

self.onmessage = ({ data }: MessageEvent<Request>) => {
  if (server) server.handle(data);
  else queue.push(data);
};

function start(core: Editors): void {
  server = new Server(core, { post, soon, now: () => performance.now(), wholeCore });
  for (const request of queue.splice(0)) server.handle(request);
  // After the first net is shown; on most machines it is over before a user finds a handle.
  setTimeout(() => warm(core), WARM_UP_DELAY);
}

/** Nobody needs to hear that it failed: what is wrong with the solver the first edit says. */
function warm(core: Editors): void {
  warmUp(core, idle).catch(() => {});
}

/** Resolves after the messages that wait already, and no solve is under way. */
async function idle(): Promise<void> {
  await new Promise<void>(soon);
  while (server?.isSolving) await new Promise((next) => setTimeout(next, WARM_UP_DELAY));
}

async function wholeCore(): Promise<WholeCore> {
  const { loadWholeCore } = await import('./whole_core');
  const whole = await loadWholeCore();
  warm(whole.core);
  return whole;
}

Promise.all([loadEditors({ wasmUrl }), holdOwnLock()])
  .then(([core]) => start(core))
  .catch((error: unknown) => {
    const message = `The solver could not be loaded: ${messageOf(error)}`;
    post({ id: 0, type: 'error', code: CRASHED, message }, []);
  });

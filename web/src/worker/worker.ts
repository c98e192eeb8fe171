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

/** Milliseconds after a net is there, and shown: a hand is not there yet. */
const READY_DELAY = 100;

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
  if (server) take(data, server);
  else queue.push(data);
};

function take(request: Request, by: Server): void {
  by.handle(request);
  if (request.type === 'open') setTimeout(() => unheard(() => by.getReady()), READY_DELAY);
}

function start(core: Editors): void {
  server = new Server(core, { post, soon, now: () => performance.now(), wholeCore });
  for (const request of queue.splice(0)) take(request, server);
  // On most machines it is over before a user finds a handle.
  setTimeout(() => warm(core), READY_DELAY);
}

function warm(core: Editors): void {
  unheard(() => warmUp(core, idle));
}

/** Nobody needs to hear that it failed: what is wrong with the solver the first edit says. */
function unheard(task: () => void | Promise<void>): void {
  Promise.resolve()
    .then(task)
    .catch(() => {});
}

/** Resolves after the messages that wait already, and no solve is under way. */
async function idle(): Promise<void> {
  await new Promise<void>(soon);
  while (server?.isSolving) await new Promise((next) => setTimeout(next, READY_DELAY));
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

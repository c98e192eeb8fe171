/**
 * What a page that embeds the editor and the editor say to each other. The editor is embedded as
 *
 *     <iframe src="https://…/index.html?embed#v1=…" title="…"></iframe>
 *
 * and after it has said `{ chebnet: 1, event: 'ready' }` it takes calls of the names, arguments and results of
 * `window.chebnet` (web/src/scripting.ts):
 *
 *     frame.contentWindow.postMessage({ chebnet: 1, id: 7, call: 'move', args: [12, [0, 0, 3]] }, origin);
 *     // answered with { chebnet: 1, id: 7, result: undefined } or { chebnet: 1, id: 7, error: { code, message } }
 *
 * `lesson.ts` is an example. Only the page that holds the frame is listened to, and answers go to it alone.
 */
import type { Scripting, Stats } from '../scripting';

export type EmbedEvent = 'frame' | 'settled' | 'error';

/** What can be called: the methods of `window.chebnet`; `on` and `off` take the name of an event and no listener. */
export type CallName = Exclude<keyof Scripting, 'on'> | 'on' | 'off';

export interface HostCall {
  chebnet: 1;
  /** Comes back with the answer: a number, or a text of up to 64 characters. */
  id: number | string;
  call: CallName;
  args?: readonly unknown[];
}

export type Answer =
  | { chebnet: 1; id: number | string; result: unknown }
  | { chebnet: 1; id: number | string; error: Failure };

/** `code` as in core/net/error.h; besides, `unknown_call`, `bad_arguments` and `busy`. */
export interface Failure {
  code: string;
  message: string;
}

/** Once, then after `on`. */
export type News =
  | { chebnet: 1; event: 'ready' }
  | { chebnet: 1; event: 'frame' | 'settled'; stats: Stats }
  | { chebnet: 1; event: 'error'; error: Failure };

/**
 * What a page that embeds the editor and the editor say to each other. The editor is embedded as
 *
 *     <iframe src="https://…/index.html?embed#v2=…" title="…"></iframe>
 *
 * and after it has said `{ chebnet: 1, event: 'ready' }`, with its first net open, it takes calls of the names, arguments and
 * results of `window.chebnet` (web/src/scripting.ts):
 *
 *     frame.contentWindow.postMessage({ chebnet: 1, id: 7, call: 'move', args: [12, [0, 0, 3]] }, origin);
 *     // answered with { chebnet: 1, id: 7, result: undefined } or { chebnet: 1, id: 7, error: { code, message } }
 *
 * `lesson.ts` is an example. Only the page that holds the frame is listened to, and answers go to it alone: neither other
 * frames beside it, nor a page that holds the page, nor windows opened from here.
 *
 * Whoever holds the frame may see and do with its net what a visitor could; nothing else of the site: no call reads what the
 * browser keeps, starts a download, opens a window or an address. The calls, and what each may be given at most:
 *
 *     open({ recipe } | { obj, name? })   a recipe of 1000 characters, an OBJ of 20 million
 *     setHandles([{ vertex, target?, anchor?, name?, hidden?, weight?, slides? }])   10,000 handles
 *     move(vertex, [x, y, z]), setLocality(edges | null), setOptions({ name: value })
 *     setGuide({ own } | { vertices, faces, name? } | null)   100,000 vertices and faces
 *     describe(surface), drape(surface, options?), remesh(surface, options?)   likewise; report()
 *     settled(), positions(), edges(), handles(), stats(), screenPosition(vertex), link()
 *     on('frame' | 'settled' | 'error'), off(…)
 *
 * A record with a field that is not among these is refused.
 *
 * Calls may be sent together: those that change the net are carried out in this order, and `settled`, `report` and `link` tell
 * of what came of those before. `positions`, `edges`, `handles`, `stats` and `screenPosition` are answered at once.
 *
 * At most 100 calls may wait for their answers; more are refused as `busy`.
 *
 * A frame with a `sandbox` needs `allow-scripts allow-same-origin`. Without the second a browser gives the page no origin and
 * lets it load neither modules nor workers: instead of `ready` the host then gets the event `error` with the code `no_origin`,
 * and the frame says so.
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
  | { chebnet: 1; id: number | string; error: HostFailure };

/** `code` as in core/base/error.h; besides, `unknown_call`, `bad_arguments`, `busy`, `cancelled` and `no_origin`. Of calls that
 *  there are not, or are too many, only who writes the host hears: in English. The rest is in the visitor's language. */
export interface HostFailure {
  code: string;
  message: string;
}

/** Once, then after `on`. */
export type News =
  | { chebnet: 1; event: 'ready' }
  | { chebnet: 1; event: 'frame' | 'settled'; stats: Stats }
  | { chebnet: 1; event: 'error'; error: HostFailure };

/** Answers the page that embeds this one; see protocol.ts. */
import type { RemeshOptions } from '../../../wasm/chebnet';
import { Untrusted } from '../document/untrusted';
import { codeOf, Failure, messageOf } from '../failure';
import type { Scripting } from '../scripting';
import type { ScriptDrape } from '../surface_script';
import {
  readEvent,
  readGuide,
  readHandles,
  readLocality,
  readNet,
  readOptions,
  readSurface,
  readVertex,
} from '../script_arguments';
import type { Answer, CallName, EmbedEvent, HostCall, HostFailure, News } from './protocol';

/** Calls of a host that have no answer yet. */
const MOST_UNANSWERED = 100;
const LONGEST_ID = 64;
/** Of a call. Those that it does not take are ignored. */
const MOST_ARGUMENTS = 10;
const LONGEST_OBJ = 20e6;
const MOST_HANDLES = 10_000;
const MOST_OF_SURFACE = 100_000;
const BAD_ARGUMENTS = 'bad_arguments';

type Post = (message: Answer | News) => void;

export class Host {
  readonly #calls: Record<CallName, (first: Untrusted, second: Untrusted) => unknown>;
  readonly #post: Post;
  readonly #subscriptions = new Map<EmbedEvent, () => void>();
  #unanswered = 0;

  constructor(script: Scripting, post: Post) {
    this.#post = post;
    this.#calls = {
      open: (net) => script.open(readNet(net, LONGEST_OBJ)),
      setHandles: (handles) => script.setHandles(readHandles(handles, MOST_HANDLES)),
      move: (vertex, target) => script.move(readVertex(vertex), target.point()),
      setLocality: (radius) => script.setLocality(readLocality(radius)),
      setGuide: (surface) => script.setGuide(readGuide(surface, MOST_OF_SURFACE)),
      describe: (surface) => script.describe(readSurface(surface, MOST_OF_SURFACE)),
      // What is in the options is read by the call.
      drape: (surface, options) => script.drape(readSurface(surface, MOST_OF_SURFACE), options.value as ScriptDrape),
      remesh: (surface, options) =>
        script.remesh(readSurface(surface, MOST_OF_SURFACE), options.value as RemeshOptions),
      report: () => script.report(),
      settled: () => script.settled(),
      positions: () => script.positions(),
      edges: () => script.edges(),
      handles: () => script.handles(),
      stats: () => script.stats(),
      setOptions: (options) => script.setOptions(readOptions(options)),
      screenPosition: (vertex) => script.screenPosition(readVertex(vertex)),
      link: () => script.link(),
      on: (event) => this.#subscribe(script, readEvent(event)),
      off: (event) => this.#unsubscribe(readEvent(event)),
    };
  }

  /** Messages that are no calls are ignored: other parts of the host may send some, too. */
  async receive(data: unknown): Promise<void> {
    const call = readCall(data);
    if (call === null) return;
    const { id } = call;
    try {
      this.#post({ chebnet: 1, id, result: await this.#run(call) });
    } catch (error) {
      this.#post({ chebnet: 1, id, error: failureOf(error) });
    }
  }

  async #run({ call, args = [] }: HostCall): Promise<unknown> {
    if (!Object.hasOwn(this.#calls, call)) throw new Failure('unknown_call', 'there is no such call');
    const given = new Untrusted(args, 'args', BAD_ARGUMENTS).list(MOST_ARGUMENTS);
    const argument = (i: number) => given[i] ?? new Untrusted(undefined, `args[${i}]`, BAD_ARGUMENTS);
    if (this.#unanswered >= MOST_UNANSWERED)
      throw new Failure('busy', `${MOST_UNANSWERED} calls wait for their answers`);
    this.#unanswered += 1;
    try {
      return await this.#calls[call](argument(0), argument(1));
    } finally {
      this.#unanswered -= 1;
    }
  }

  #subscribe(script: Scripting, event: EmbedEvent): void {
    if (this.#subscriptions.has(event)) return;
    const stop =
      event === 'error'
        ? script.on(event, (error) => this.#post({ chebnet: 1, event, error: failureOf(error) }))
        : script.on(event, () => this.#post({ chebnet: 1, event, stats: script.stats() }));
    this.#subscriptions.set(event, stop);
  }

  #unsubscribe(event: EmbedEvent): void {
    this.#subscriptions.get(event)?.();
    this.#subscriptions.delete(event);
  }
}

function readCall(data: unknown): HostCall | null {
  if (typeof data !== 'object' || data === null) return null;
  const { chebnet, id, call } = data as Partial<HostCall>;
  const named = Number.isFinite(id) || (typeof id === 'string' && id.length <= LONGEST_ID);
  return chebnet === 1 && named && call !== undefined ? (data as HostCall) : null;
}

function failureOf(error: unknown): HostFailure {
  return { code: codeOf(error), message: messageOf(error) };
}

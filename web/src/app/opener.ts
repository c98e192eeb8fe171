/** Opens nets and goes through the history: one at a time; until the next net is open the present one stays. */
import { type NamedChange, netChange, netTitle } from '../document/changes';
import { asMade, freshScene, hanging, turned, usualMethod, weighed } from '../document/defaults';
import type { NetSource, Scene, UpAxis, ViewPlace, ViewState } from '../document/document';
import type { Project } from '../document/project';
import type { Entry, Snapshot } from '../document/undo';
import { words } from '../language/language';
import type { Client, Opened } from '../worker/client';
import type { State } from './state';

/** Delay before the opening notice, in milliseconds. */
const NOTICE_MS = 250;

/** How a net lies, and from where it is seen: what of the view is that of its net. */
type NetView = ViewPlace & Pick<ViewState, 'upAxis'>;

/** Callbacks to the app. */
interface OpenerEvents {
  /** Before a net replaces the present one. */
  leaving(): void;
  opened(): void;
  say(message: string): void;
  /** What was said is of a state that is left. */
  unsay(): void;
  /** Shows or hides the notice that a net is being opened, with or without a button to cancel. */
  notice(isShown: boolean, canCancel: boolean): void;
}

/** The part of the client that it uses. */
export type OpenerClient = Pick<Client, 'open' | 'cancelOpening' | 'restore' | 'returning'>;

type Restored = Parameters<Client['restore']>[0];

/** A net that is being opened. */
interface Request {
  scene: Scene;
  /** That of the net of before when this one was asked for, or as that net came after that; undefined: there was none. */
  viewBefore: ViewState | undefined;
}

/** A net that is there. */
interface Arrival extends Request {
  opened: Opened;
}

export class Opener {
  readonly #client: OpenerClient;
  readonly #state: State;
  readonly #events: OpenerEvents;
  /** Of nets that have been left, here or by whoever made the project. */
  readonly #seen = new WeakMap<NetSource, NetView>();
  readonly #underWay = new Set<Request>();
  /** Steps through the history that wait until a net is there, unless another is asked for meanwhile. */
  #waiting: (() => void)[] = [];
  /** A state to which the present net has gone back while another one was being opened: the solver is told of it if that fails. */
  #untold: Restored | null = null;

  constructor(client: OpenerClient, state: State, events: OpenerEvents) {
    this.#client = client;
    this.#state = state;
    this.#events = events;
  }

  get isOpening(): boolean {
    return this.#underWay.size > 0;
  }

  /** Whether a net is being opened, and can be cancelled in favour of the present one. */
  get canCancel(): boolean {
    return this.isOpening && this.#state.opening !== null;
  }

  /** Cancels the opening; the present net stays. */
  cancel(): void {
    if (this.canCancel) this.#client.cancelOpening();
  }

  /** Opens a scene in place of the present one, to which undo returns. If it fails, the present one stays.
   *  @param change what the history calls it. */
  async openScene(
    scene: Scene,
    { name, key }: NamedChange = { name: ['open', netTitle(scene.net)], key: null },
  ): Promise<void> {
    this.#waiting = []; // they would take this net back
    const wasSettled = this.#state.isSettled; // once the answer is here, the solver is at work on the next net
    const arrival = await this.#request(scene);
    this.#events.leaving();
    const before = this.#state.snapshot();
    this.#take(arrival);
    if (before) this.#state.history.record({ ...before, settled: wasSettled }, name, key);
    else this.#state.history.begin([{ name, state: this.#state.snapshot()! }], 0);
    if (this.#state.handles.length === 0) this.#events.say(words.intro.noHandles);
  }

  /** Opens a project with its history in place of the present one. If it fails, the present one stays. */
  async openProject({ entries, present, view }: Project): Promise<void> {
    this.#waiting = [];
    await this.#reopen({ ...entries[present]!.state, view }, () => {
      for (const { state, upAxis } of entries)
        if (upAxis) this.#seen.set(state.net, { camera: null, ...turned(upAxis) });
      this.#state.history.begin(entries, present);
    });
  }

  /** The history with what is known of how its nets lie; that of the present one, the view says. */
  entries(now: Snapshot): Entry[] {
    return this.#state.history.entries(now).map((entry) => {
      const seen = entry.state.net === now.net ? undefined : this.#seen.get(entry.state.net);
      return seen ? { ...entry, upAxis: seen.upAxis ?? 'z' } : entry;
    });
  }

  /** Opens a net at rest, with the settings and the view of the present document; with its usual method, if the present one
   *  has its own. */
  openNet(net: NetSource, upAxis: UpAxis = 'z'): Promise<void> {
    const fresh = freshScene(net);
    if (this.#state.opening === null) return this.openScene(fresh);
    const { document } = this.#state.opening;
    const { initialisation } = document;
    const options = weighed(asMade(document.options), upAxis);
    const { upAxis: __, behind: ___, ...view } = document.view;
    const method = document.method === usualMethod(document.net) ? fresh.method : document.method;
    const scene = {
      ...fresh,
      method,
      initialisation,
      options,
      view: { ...view, ...turned(upAxis), camera: null },
    };
    return this.openScene(scene, netChange(document.net, net));
  }

  /** Goes so many entries on: from the net that is being opened, if one is. */
  async goBy(steps: number): Promise<void> {
    while (this.isOpening) await new Promise<void>((resolve) => this.#waiting.push(resolve));
    await this.goTo(this.#state.history.present + steps);
  }

  /** Goes to an entry of the history. */
  async goTo(index: number): Promise<void> {
    const { history } = this.#state;
    const now = this.#state.snapshot();
    const from = history.present;
    const state = now === null || this.isOpening ? null : history.stateAt(index);
    if (now === null || state === null) return;
    this.#events.unsay();
    try {
      // Until then the present entry is that of the net that is open.
      await this.restore(state, () => history.goTo(index, now));
    } catch (error) {
      // A history from a file may hold states that no net can take.
      if (history.goTo(from, state)) await this.restore(now);
      throw error;
    }
  }

  /** @param leave is called when the present state is about to go. */
  async restore(snapshot: Snapshot, leave: () => void = () => {}): Promise<void> {
    if (this.#state.opening === null) return;
    const { net, view } = this.#state.opening.document;
    if (snapshot.net !== net) {
      const seen = this.#viewOf(snapshot.net, view);
      return this.#reopen(hanging({ ...snapshot, view: seen }, seen.upAxis), leave);
    }
    leave();
    const state = hanging(snapshot, view.upAxis);
    this.#state.restore(state);
    const { net: _, ...rest } = state;
    // It would take it for the net that it is just opening.
    if (this.isOpening) this.#untold = rest;
    else await this.#client.restore(rest);
  }

  /** The present net stays. A solver that replaces a lost one has its state from the document. */
  #tell(): void {
    const untold = this.#untold;
    if (untold === null || this.isOpening) return;
    this.#untold = null;
    // It was in this state before; if it is lost now, that is said by whoever replaces it.
    if (!this.#client.returning) this.#client.restore(untold).catch(() => {});
  }

  /** How a net is to be seen after another: as it was left. One of which nothing is known, in a project of before, is taken to lie
   *  as the other does. */
  #viewOf(net: NetSource, { behind: _, upAxis, ...look }: ViewState): ViewState {
    return { ...look, ...(this.#seen.get(net) ?? { camera: null, ...turned(upAxis) }) };
  }

  /** @param leave is called when the present net is about to go. */
  async #reopen(scene: Scene, leave: () => void): Promise<void> {
    const arrival = await this.#request(scene);
    this.#events.leaving();
    leave();
    this.#take(arrival);
  }

  #take(arrival: Arrival): void {
    this.#untold = null;
    const left = this.#state.opening?.document;
    if (left) {
      const { camera, behind, upAxis } = left.view;
      this.#seen.set(left.net, { camera, behind, ...turned(upAxis) });
      for (const each of [arrival, ...this.#underWay]) each.scene = withChoices(left.view, each);
    }
    const { scene, opened } = arrival;
    this.#state.open(scene, opened);
    // The view of this net is no choice for those to come.
    for (const each of this.#underWay) each.viewBefore = scene.view;
    this.#events.opened();
  }

  /** Shows the notice if it takes long. */
  async #request(scene: Scene): Promise<Arrival> {
    const request: Request = { scene, viewBefore: this.#state.opening?.document.view };
    this.#underWay.add(request);
    const notice = setTimeout(() => this.#events.notice(true, this.canCancel), NOTICE_MS);
    try {
      const opened = await this.#client.open(scene);
      return { ...request, opened };
    } catch (error) {
      this.#waiting = []; // there is nothing to go back from
      this.#underWay.delete(request);
      this.#tell();
      throw error;
    } finally {
      clearTimeout(notice);
      this.#events.notice(false, false);
      this.#underWay.delete(request);
      // Once the net has been taken, too.
      setTimeout(() => {
        for (const go of this.#waiting.splice(0)) go();
      });
    }
  }
}

/** What the user has chosen since the net was asked for holds for it, but not how the one before lies and is seen. */
function withChoices(now: ViewState, { scene, viewBefore: before = now }: Request): Scene {
  const { camera, behind, upAxis } = before;
  const chosen = Object.entries({ ...now, camera, behind, upAxis }).filter(
    ([name, value]) => value !== before[name as keyof ViewState],
  );
  return { ...scene, view: { ...scene.view, ...Object.fromEntries(chosen) } };
}

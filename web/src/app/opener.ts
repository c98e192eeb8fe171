/** Opens nets and goes through the history: one net is on its way at a time, and until it is there the other one stays. */
import { type NamedChange, netChange, netTitle } from '../document/changes';
import { freshScene } from '../document/defaults';
import type { NetSource, Scene } from '../document/document';
import type { Project } from '../document/project';
import type { Snapshot } from '../document/undo';
import { words } from '../language/language';
import type { Client, Opened } from '../worker/client';
import type { State } from './state';

/** Delay before the user is told that a net is on its way. */
const NOTICE_MS = 250;

/** What is told of it. */
export interface OpenerEvents {
  /** Before a net takes the place of the present one. */
  leaving(): void;
  opened(): void;
  say(message: string): void;
  /** Whether the notice is to be seen, and offers to give up the net on its way. */
  notice(isShown: boolean, canCancel: boolean): void;
}

export class Opener {
  readonly #client: Pick<Client, 'open' | 'cancelOpening' | 'restore'>;
  readonly #state: State;
  readonly #events: OpenerEvents;
  /** Nets on their way. */
  #underWay = 0;

  constructor(client: Pick<Client, 'open' | 'cancelOpening' | 'restore'>, state: State, events: OpenerEvents) {
    this.#client = client;
    this.#state = state;
    this.#events = events;
  }

  get isOpening(): boolean {
    return this.#underWay > 0;
  }

  /** Whether a net is on its way that can be given up for the one that is open. */
  get canCancel(): boolean {
    return this.isOpening && this.#state.opening !== null;
  }

  /** Gives up the net on its way; the one that is open stays. */
  cancel(): void {
    if (this.canCancel) this.#client.cancelOpening();
  }

  /** Opens a scene in place of the present one, to which undo returns. If it fails, the present one stays.
   *  @param change what the history calls it. */
  async openScene(
    scene: Scene,
    { name, key }: NamedChange = { name: ['open', netTitle(scene.net)], key: null },
  ): Promise<void> {
    const opened = await this.#request(scene);
    this.#events.leaving();
    const before = this.#state.snapshot();
    this.#take(scene, opened);
    if (before) this.#state.history.record(before, name, key);
    else this.#state.history.begin([{ name, state: this.#state.snapshot()! }], 0);
    if (this.#state.handles.length === 0) this.#events.say(words.intro.noHandles);
  }

  /** Opens a project with its history in place of the present one. If it fails, the present one stays. */
  async openProject({ entries, present, view }: Project): Promise<void> {
    await this.#reopen({ ...entries[present]!.state, view });
    this.#state.history.begin(entries, present);
  }

  /** Opens a net as it comes, to be solved and shown as the present one is. */
  openNet(net: NetSource): Promise<void> {
    const fresh = freshScene(net);
    if (this.#state.opening === null) return this.openScene(fresh);
    const { document } = this.#state.opening;
    const { method, initialisation, options, view } = document;
    const scene = { ...fresh, method, initialisation, options, view: { ...view, camera: null } };
    return this.openScene(scene, netChange(document.net, net));
  }

  /** Goes to an entry of the history. */
  async goTo(index: number): Promise<void> {
    const { history } = this.#state;
    const now = this.#state.snapshot();
    const from = history.present;
    const state = now === null || this.isOpening ? null : history.goTo(index, now);
    if (now === null || state === null) return;
    try {
      await this.restore(state);
    } catch (error) {
      // A history from a file may hold what no net can be.
      if (history.goTo(from, state)) await this.restore(now);
      throw error;
    }
  }

  async restore(snapshot: Snapshot): Promise<void> {
    if (this.#state.opening === null) return;
    const { net, view } = this.#state.opening.document;
    const { net: wanted, ...rest } = snapshot;
    if (wanted !== net) return this.#reopen({ ...snapshot, view: { ...view, camera: null } });
    this.#state.restore(snapshot);
    await this.#client.restore(rest);
  }

  async #reopen(scene: Scene): Promise<void> {
    const opened = await this.#request(scene);
    this.#events.leaving();
    this.#take(scene, opened);
  }

  #take(scene: Scene, opened: Opened): void {
    this.#state.open(scene, opened);
    this.#events.opened();
  }

  /** Says so if it takes long. */
  async #request(scene: Scene): Promise<Opened> {
    this.#underWay += 1;
    const notice = setTimeout(() => this.#events.notice(true, this.canCancel), NOTICE_MS);
    try {
      return await this.#client.open(scene);
    } finally {
      clearTimeout(notice);
      this.#events.notice(false, false);
      this.#underWay -= 1;
    }
  }
}

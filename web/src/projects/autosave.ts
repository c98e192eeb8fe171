/** Stores the document in the browser soon after each change; while a drag or a solve is under way, now and then. */
import type { App } from '../app/app';
import type { Project } from '../document/project';
import { Measure, numberOf } from '../document/undo';
import { projectFormat } from './format';
import { enlist, hasName, isOwn, keep, keepView, newId, release } from './kept';
import { lazy } from '../lazy';

const collection = lazy(() => import('./collection'));

const PAUSE_MS = 400;
/** What goes on without a pause is stored after so long all the same. */
const LONGEST_MS = 20_000;
/** Bytes of nets, positions and handles of the history that are stored beside the present state: so many are written in some
 *  milliseconds. */
const LARGEST_HISTORY = 8e6;

export class Autosave {
  #id = newId();
  /** The revision of the history that was stored last, and the view as text: it is made anew whenever it is asked for. */
  #revision = -1;
  #view: string | null = null;
  /** The latest change that has been looked at, counted from the first there ever was: see #startAnother. */
  #since = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** When the first change was that has not been stored; null: all have. */
  #waitsSince: number | null = null;
  /** The write under way, or the last one. */
  #writing = Promise.resolve();
  /** Of whole projects, how many are under way. */
  #wholes = 0;
  #refused = false;
  readonly #app: App;
  readonly #failed: () => void;
  readonly #keeps: boolean;

  /**
   * @param failed called when the browser refuses.
   * @param keeps false: it never keeps anything.
   */
  constructor(app: App, failed: () => void, keeps: boolean) {
    this.#app = app;
    this.#failed = failed;
    this.#keeps = keeps;
    if (!keeps) return;
    app.on('changed', () => this.#soon());
    document.addEventListener('visibilitychange', () => void this.#keep());
    addEventListener('pagehide', () => void this.#keep());
  }

  get id(): string {
    return this.#id;
  }

  /** The browser has refused to store the present net. */
  get refused(): boolean {
    return this.#refused;
  }

  /** Nothing has the present net but the page. */
  get keepsNothing(): boolean {
    return this.#refused || !this.#keeps;
  }

  /** Stores the present net under `id` from now on; unless it is `worth` it already, only after the next change. */
  begin(id: string, worth: boolean): void {
    if (id !== this.#id) release(this.#id);
    this.#id = id;
    this.#since = numberOf(this.#app.history);
    this.#revision = worth ? -1 : this.#app.history.revision;
    this.#view = null;
    this.#soon();
  }

  /** Stores the present net at once, also while something is under way: it may be about to go. */
  async save(): Promise<void> {
    if (!this.#keeps) return;
    clearTimeout(this.#timer);
    await this.#keep();
  }

  /** Does nothing if nothing changed. What is stored while something is under way is stored again after that. */
  async #keep(): Promise<void> {
    this.#waitsSince = null;
    const { revision } = this.#app.history;
    const project = this.#app.project();
    if (project === null) return;
    const view = JSON.stringify(project.view);
    const isStored = revision === this.#revision;
    const hasRecord = isOwn(this.#id);
    if (hasRecord) this.#view ??= view;
    const seenAnew = this.#view !== null && this.#view !== view;
    if (isStored && !seenAnew) return this.#writing;
    this.#view = view;
    if (isStored && hasRecord && this.#wholes === 0) this.#writing = this.#writeView(project);
    else {
      this.#revision = this.#app.isQuiet ? revision : -1;
      this.#writing = this.#write(project);
    }
    return this.#writing;
  }

  /** Of a project of which nothing else has changed since it was stored. */
  async #writeView({ view }: Project): Promise<void> {
    try {
      const { writeView } = await projectFormat();
      await keepView(this.#id, writeView(view));
    } catch {
      this.#noteRefusal();
    }
  }

  async #write(project: Project): Promise<void> {
    const present = new Measure();
    present.add(project.entries[project.present]!.state);
    const id = this.#id;
    this.#wholes += 1;
    try {
      const { writeProject } = await projectFormat();
      await keep(id, writeProject(project, present.bytes + LARGEST_HISTORY));
      this.#refused = false;
      await enlist(id);
      // Only then the list of projects can show it.
      await this.#noteLook(id);
    } catch {
      this.#noteRefusal();
    } finally {
      this.#wholes -= 1;
    }
  }

  #noteRefusal(): void {
    this.#refused = true;
    // So that the next occasion tries again.
    this.#revision = -1;
    this.#failed();
  }

  /** Another net is no further state of a project that has a name: that stays as it was. */
  async #startAnother(): Promise<void> {
    const { history } = this.#app;
    const id = this.#id;
    const first = Math.max(0, this.#since + 1 - history.forgotten);
    const fresh = history.names.slice(first, history.present + 1);
    const isAnother = fresh.some(([what]) => what === 'open' || what === 'link');
    this.#since = numberOf(history);
    if (isAnother && (await hasName(id).catch(() => false)) && id === this.#id) this.begin(newId(), true);
  }

  /** For the list of projects, which does without if need be. */
  async #noteLook(id: string): Promise<void> {
    const { opening } = this.#app;
    if (opening)
      await collection()
        .then(({ noteLook }) => noteLook(id, opening))
        .catch(() => {});
  }

  #soon(): void {
    void this.#startAnother();
    clearTimeout(this.#timer);
    this.#waitsSince ??= Date.now();
    const waits = this.#waitsSince + LONGEST_MS - Date.now();
    this.#timer = setTimeout(() => this.#pause(), Math.min(PAUSE_MS, Math.max(0, waits)));
  }

  #pause(): void {
    // When the page is left there is no time to load it.
    projectFormat().catch(() => {});
    const isLate = this.#waitsSince !== null && Date.now() - this.#waitsSince >= LONGEST_MS;
    if (this.#app.isQuiet || isLate) void this.save();
    else this.#soon();
  }
}

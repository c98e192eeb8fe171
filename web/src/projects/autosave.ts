/** Stores the document in the browser soon after each change, unless a drag or a solve is under way. */
import type { App } from '../app/app';
import type { Project } from '../document/project';
import { Measure, numberOf } from '../document/undo';
import { projectFormat } from './format';
import { enlist, hasName, keep, newId, release } from './kept';
import { lazy } from '../lazy';

const collection = lazy(() => import('./collection'));

const PAUSE_MS = 400;
/** Bytes of nets and positions of the history that are stored beside the present state: so many are written in some
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
  /** The write under way, or the last one. */
  #writing = Promise.resolve();
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
    const { revision } = this.#app.history;
    const project = this.#app.project();
    if (project === null) return;
    const view = JSON.stringify(project.view);
    const seenAnew = this.#view !== null && this.#view !== view;
    if (revision === this.#revision && !seenAnew) return this.#writing;
    this.#revision = this.#app.isQuiet ? revision : -1;
    this.#view = view;
    this.#writing = this.#write(project);
    return this.#writing;
  }

  async #write(project: Project): Promise<void> {
    const present = new Measure();
    present.add(project.entries[project.present]!.state);
    const id = this.#id;
    try {
      const { writeProject } = await projectFormat();
      await keep(id, writeProject(project, present.bytes + LARGEST_HISTORY));
      this.#refused = false;
      await enlist(id);
      // Only then the list of projects can show it.
      await this.#noteLook(id);
    } catch {
      this.#refused = true;
      // So that the next occasion tries again.
      this.#revision = -1;
      this.#failed();
    }
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
    this.#timer = setTimeout(() => {
      // When the page is left there is no time to load it.
      projectFormat().catch(() => {});
      if (this.#app.isQuiet) void this.save();
      else this.#soon();
    }, PAUSE_MS);
  }
}

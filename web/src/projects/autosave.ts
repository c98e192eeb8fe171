/** Keeps the document in the browser, soon after each change, while nothing is under way. */
import type { App } from '../app';
import type { ViewState } from '../document/document';
import { writeProject } from '../document/project';
import { Measure } from '../document/undo';
import { keep, newId } from './kept';

const PAUSE_MS = 400;
/** Bytes of nets and positions beyond those of the present state: as much of the history is kept. Writing takes some
 *  milliseconds. */
const LARGEST_HISTORY = 8e6;

export class Autosave {
  #id = newId();
  /** What is kept is of this revision of the history, and of this view. */
  #revision = -1;
  #view: ViewState | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * @param failed called when the browser refuses.
   * @param keeps false: it never keeps anything.
   */
  constructor(
    private readonly app: App,
    private readonly failed: () => void,
    private readonly keeps: boolean,
  ) {
    if (!keeps) return;
    app.on('changed', () => this.#soon());
    document.addEventListener('visibilitychange', () => void this.save());
    addEventListener('pagehide', () => void this.save());
  }

  get id(): string {
    return this.#id;
  }

  /** The present net is kept under `id` from now on; if it is not `worth` it yet, once something was done to it. */
  begin(id: string, worth: boolean): void {
    this.#id = id;
    this.#revision = worth ? -1 : this.app.history.revision;
    this.#view = null;
    this.#soon();
  }

  /** Keeps the present net at once, unless it is kept as it is. */
  async save(): Promise<void> {
    clearTimeout(this.#timer);
    const { revision } = this.app.history;
    const project = this.keeps && this.app.isQuiet ? this.app.project() : null;
    if (project === null) return;
    const seenAnew = this.#view !== null && this.#view !== project.view;
    if (revision === this.#revision && !seenAnew) return;
    this.#revision = revision;
    this.#view = project.view;
    const present = new Measure();
    present.add(project.entries[project.present]!.state);
    await keep(this.#id, writeProject(project, present.bytes + LARGEST_HISTORY)).catch(this.failed);
  }

  #soon(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (this.app.isQuiet ? void this.save() : this.#soon()), PAUSE_MS);
  }
}

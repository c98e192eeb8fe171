/** Placeholders for the experiments, which are loaded on demand: their list in the sidebar, and over the view the note on the
 *  one that is open. */
import type { ChebnetDocument } from '../document/document';
import { words } from '../language/language';
import { lazy } from '../lazy';
import { make, makeSection } from '../elements/dom';
import type { ExperimentGuide } from './experiment_guide';
import type { Panel, PanelEvents } from '../panels';
import './experiments_place.css';

const loadGuide = lazy(() => import('./experiment_guide'));

export class ExperimentsPlace implements Panel {
  readonly note = make('section', { class: 'experiment', hidden: true });
  readonly element = makeSection(words.sections.experiments, false);
  #guide: ExperimentGuide | null = null;
  #document: ChebnetDocument | null = null;
  readonly #events: PanelEvents;
  readonly #failed: (error: unknown) => void;

  /** @param failed is called if they cannot be loaded. */
  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.#failed = failed;
    this.element.addEventListener('toggle', () => this.element.open && this.#load());
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    if (this.#guide) return this.#guide.setDocument(document);
    if (document.experiment === undefined) return;
    // At once: the view leaves space for it when it fits the net.
    this.note.hidden = false;
    this.#load();
  }

  #load(): void {
    if (!this.#guide) this.#open().catch(this.#failed);
  }

  async #open(): Promise<void> {
    const { ExperimentGuide } = await loadGuide();
    if (this.#guide) return;
    this.#guide = new ExperimentGuide(this.note, this.#events, this.#failed);
    this.element.append(...this.#guide.content);
    if (this.#document) this.#guide.setDocument(this.#document);
  }
}

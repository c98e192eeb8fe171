/** Looks for another net at rest, less strained than that which the drags have led to. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { METHOD_AT_REST } from '../document/defaults';
import { make, makeButton, setText } from '../elements/dom';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';

export class RelaxControl implements Panel {
  readonly element = make('div', { class: 'relax' });
  readonly #button: HTMLButtonElement;
  readonly #outcome = make('p', { class: 'quiet', role: 'status' });
  #isSearching = false;

  constructor(events: Pick<PanelEvents, 'searchRest' | 'cancel'>) {
    const { label, hint } = panelWords.relax;
    this.#button = makeButton(label, () => void (this.#isSearching ? events.cancel() : this.#search(events)), {
      title: hint,
    });
    this.element.append(this.#button, this.#outcome);
  }

  async #search(events: Pick<PanelEvents, 'searchRest'>): Promise<void> {
    const { label, stop, looking } = panelWords.relax;
    this.#isSearching = true;
    setText(this.#button, stop);
    setText(this.#outcome, looking(0));
    const gain = await events.searchRest((done) => setText(this.#outcome, looking(done)));
    this.#isSearching = false;
    setText(this.#button, label);
    setText(this.#outcome, outcomeOf(gain));
  }

  setNet(): void {
    if (!this.#isSearching) setText(this.#outcome, '');
  }

  setDocument({ method }: ChebnetDocument): void {
    this.element.hidden = method !== METHOD_AT_REST;
  }

  setHandles(handles: readonly HandleData[]): void {
    this.#button.disabled = handles.length === 0;
  }
}

function outcomeOf(gain: number | null | undefined): string {
  const { none, found, foundAny } = panelWords.relax;
  if (gain === undefined) return '';
  if (gain === null) return none;
  return gain < 1 ? found(gain) : foundAny;
}

/** Looks for another net at rest, less strained than that which the drags have led to. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { METHOD_AT_REST } from '../document/defaults';
import { make, makeButton, setText } from '../elements/dom';
import { count } from '../language/numbers';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';

export class RelaxControl implements Panel {
  readonly element = make('div', { class: 'relax' });
  readonly #button: HTMLButtonElement;
  /** Its numbers change all the time, which nobody wants to be told. */
  readonly #progress = make('p', { class: 'quiet' });
  readonly #outcome = make('p', { class: 'quiet', role: 'status' });
  #isSearching = false;

  constructor(events: Pick<PanelEvents, 'searchRest' | 'cancel'>) {
    const { label, hint } = panelWords.relax;
    this.#button = makeButton(label, () => void (this.#isSearching ? events.cancel() : this.#search(events)), {
      title: hint,
    });
    this.element.append(this.#button, this.#progress, this.#outcome);
  }

  async #search(events: Pick<PanelEvents, 'searchRest'>): Promise<void> {
    const { label, stop, looking } = panelWords.relax;
    this.#isSearching = true;
    setText(this.#button, stop);
    setText(this.#outcome, '');
    const tell = (reached: number, iterations: number): void =>
      setText(this.#progress, looking(reached, count(iterations)));
    tell(0, 0);
    const gain = await events.searchRest(({ reached, iterations }) => tell(reached, iterations));
    this.#isSearching = false;
    setText(this.#button, label);
    setText(this.#progress, '');
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

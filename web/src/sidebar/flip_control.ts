/** Pushes a net that has buckled through between its handles; says so when it comes back, for want of another equilibrium. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { METHOD_AT_REST } from '../document/defaults';
import { make, makeButton, setText } from '../elements/dom';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';

/** In edge lengths: a net that has moved no farther has come back. */
const NEAR = 0.05;

export class FlipControl implements Panel {
  readonly element = make('div', { class: 'flip' });
  readonly #button: HTMLButtonElement;
  readonly #outcome = make('p', { class: 'quiet', role: 'status' });

  constructor(events: PanelEvents) {
    this.#button = makeButton(panelWords.flip.label, () => void this.#flip(events), { title: panelWords.flip.hint });
    this.element.append(this.#button, this.#outcome);
  }

  async #flip(events: PanelEvents): Promise<void> {
    setText(this.#outcome, '');
    const move = await events.flip();
    if (move !== null && move < NEAR) setText(this.#outcome, panelWords.flip.back);
  }

  setNet(): void {
    setText(this.#outcome, '');
  }

  setDocument({ method }: ChebnetDocument): void {
    this.element.hidden = method !== METHOD_AT_REST;
  }

  setHandles(handles: readonly HandleData[]): void {
    this.#button.disabled = !handles.some(({ weight }) => weight === undefined);
  }
}

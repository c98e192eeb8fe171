/** Says over the picture that another net is on its way, and gives it up. */
import { words } from '../language/language';
import { make, makeButton } from '../elements/dom';
import type { Panel } from '../panels';
import './messages.css';

export class OpeningNotice implements Panel {
  // In the page before anything is said, or screen readers miss it.
  readonly element = make('div', { class: 'opening-notice', role: 'status' });
  readonly #cancel: HTMLButtonElement;
  readonly #line: HTMLElement;

  constructor(cancel: () => void) {
    this.#cancel = makeButton(words.opening.cancel, cancel);
    this.#line = make('p', { class: 'message' }, make('span', {}, words.opening.underWay), this.#cancel);
  }

  setOpening(isUnderWay: boolean, canCancel: boolean): void {
    this.#cancel.hidden = !canCancel;
    this.element.replaceChildren(...(isUnderWay ? [this.#line] : []));
  }
}

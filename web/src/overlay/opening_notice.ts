/** A notice over the view that another net is being opened, with a button to cancel. */
import { words } from '../language/language';
import { make, makeButton } from '../elements/dom';
import { showLine } from '../elements/leave';
import type { Panel } from '../panels';
import './messages.css';

export class OpeningNotice implements Panel {
  // In the page from the start: screen readers announce changes of what is there.
  readonly element = make('div', { class: 'opening-notice', role: 'status' });
  readonly #cancel: HTMLButtonElement;
  readonly #line: HTMLElement;

  constructor(cancel: () => void) {
    this.#cancel = makeButton(words.opening.cancel, cancel);
    this.#line = make('p', { class: 'message' }, make('span', {}, words.opening.underWay), this.#cancel);
  }

  setOpening(isUnderWay: boolean, canCancel: boolean): void {
    showLine(this.element, this.#line, isUnderWay);
    this.#cancel.hidden = !canCancel;
  }
}

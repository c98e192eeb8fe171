/** Toasts, read out by screen readers. An error stays until it is dismissed, and no message outlives what it speaks of. */
import { words } from '../language/language';
import { make, makeButton } from '../elements/dom';
import type { Action, Panel } from '../panels';
import './messages.css';

const INFO_MS = 6000;
/** How long a message with a button stays: there is a decision to make. */
const OFFER_MS = 20_000;

export class Messages implements Panel {
  // All are in the page from the start: screen readers announce changes of what is there.
  readonly #infos = make('div', { role: 'status' });
  readonly #offers = make('div', { role: 'status' });
  readonly #errors = make('div', { role: 'alert' });
  readonly element = make('div', { class: 'messages' }, this.#infos, this.#offers, this.#errors);
  #timer = 0;
  #hasNet = false;

  say(message: string, kind: 'info' | 'error', action?: Action): void {
    if (kind === 'error') this.#sayError(message);
    else this.#sayInfo(message, action);
  }

  /** What was said is of another one; before the first, it is why that is shown. */
  setNet(): void {
    if (this.#hasNet) this.unsay();
    this.#hasNet = true;
  }

  /** Takes away all but what is offered. */
  unsay(): void {
    for (const place of [this.#infos, this.#errors]) place.replaceChildren();
  }

  /** A message that stays until the user accepts or dismisses it. */
  offer(message: string, button: string, accept: () => void): void {
    const line = make('p', { class: 'message' }, make('span', {}, message));
    line.append(
      makeAct(line, { label: button, run: accept }),
      makeDismiss(() => line.remove()),
    );
    this.#offers.append(line);
  }

  #sayInfo(message: string, action?: Action): void {
    const line = make('p', { class: 'message' }, make('span', {}, message));
    if (action) line.append(makeAct(line, action));
    this.#infos.replaceChildren(line);
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => line.remove(), action ? OFFER_MS : INFO_MS);
  }

  #sayError(message: string): void {
    const line = make('p', { class: 'message error' }, make('span', {}, message));
    line.append(makeDismiss(() => line.remove()));
    this.#errors.replaceChildren(line);
  }
}

/** The cross of what may be put away. */
export function makeDismiss(run: () => void): HTMLButtonElement {
  return makeButton('×', run, { class: 'plain', 'aria-label': words.messages.dismiss });
}

/** The button of a message, which goes once its decision is made. */
function makeAct(line: HTMLElement, { label, run }: Action): HTMLButtonElement {
  const act = (): void => {
    line.remove();
    run();
  };
  return makeButton(label, act, { class: 'plain link' });
}

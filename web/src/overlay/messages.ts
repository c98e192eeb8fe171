/** Toasts, read out by screen readers. An error stays until it is dismissed, and no message outlives what it speaks of. */
import { words } from '../language/language';
import { make, makeButton } from '../elements/dom';
import { leave, takeAway } from '../elements/leave';
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
  /** By what they say. */
  readonly #offered = new Map<string, HTMLElement>();
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
    for (const place of [this.#infos, this.#errors]) fill(place);
  }

  /** A message that stays until the user accepts or dismisses it, or the same is offered again. */
  offer(message: string, button: string, accept: () => void): void {
    const line = make('p', { class: 'message' }, make('span', {}, message));
    const before = this.#offered.get(message);
    if (before) takeAway(before);
    this.#offered.set(message, line);
    line.append(
      makeAct(line, { label: button, run: accept }),
      makeDismiss(() => takeAway(line)),
    );
    this.#offers.append(line);
  }

  #sayInfo(message: string, action?: Action): void {
    const line = make('p', { class: 'message' }, make('span', {}, message));
    if (action) line.append(makeAct(line, action));
    fill(this.#infos, line);
    this.#takeAwayLater(line, action ? OFFER_MS : INFO_MS);
  }

  /** Not while its button has the focus: whoever has come there is about to decide. */
  #takeAwayLater(line: HTMLElement, delay: number): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(
      () => (line.contains(document.activeElement) ? this.#takeAwayLater(line, INFO_MS) : line.remove()),
      delay,
    );
  }

  #sayError(message: string): void {
    const line = make('p', { class: 'message error' }, make('span', {}, message));
    line.append(makeDismiss(() => takeAway(line)));
    fill(this.#errors, line);
  }
}

/** In place of what was said there. */
function fill(place: HTMLElement, ...lines: HTMLElement[]): void {
  leave(place);
  place.replaceChildren(...lines);
}

/** The cross of what may be put away. */
export function makeDismiss(run: () => void): HTMLButtonElement {
  return makeButton('×', run, { class: 'plain', 'aria-label': words.messages.dismiss });
}

/** The button of a message, which goes once its decision is made. */
function makeAct(line: HTMLElement, { label, run }: Action): HTMLButtonElement {
  const act = (): void => {
    takeAway(line);
    run();
  };
  return makeButton(label, act, { class: 'plain link' });
}

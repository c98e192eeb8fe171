/** The history as a list: the present entry is highlighted, and a click on another goes there. */
import { sentenceOf } from '../document/naming';
import type { HistoryView } from '../document/undo';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSection, setText } from '../elements/dom';
import type { Panel } from '../panels';
import './history_panel.css';

export class HistoryPanel implements Panel {
  readonly element: HTMLDetailsElement;
  readonly #list = make('ol', { class: 'history' });
  #buttons: HTMLButtonElement[] = [];
  #history: HistoryView | null = null;
  readonly #goTo: (index: number) => void;

  constructor(goTo: (index: number) => void) {
    this.#goTo = goTo;
    this.element = makeSection(
      panelWords.history.title,
      false,
      this.#list,
      make('p', { class: 'quiet' }, panelWords.history.hint),
    );
    this.element.addEventListener('toggle', () => this.#refresh());
    this.#list.addEventListener('keydown', (event) => this.#pressKey(event));
  }

  setHistory(history: HistoryView): void {
    this.#history = history;
    this.#refresh();
  }

  /** Updates only while unfolded, and makes only new entries. */
  #refresh(): void {
    if (!this.element.open || this.#history === null) return;
    const { names, present } = this.#history;
    for (const button of this.#buttons.splice(names.length)) button.parentElement?.remove();
    while (this.#buttons.length < names.length) this.#append();
    this.#buttons.forEach((button, i) => {
      setText(button, sentenceOf(names[i]!));
      button.classList.toggle('undone', i > present);
      button.tabIndex = i === present ? 0 : -1;
    });
    this.#mark(present);
  }

  #append(): void {
    const index = this.#buttons.length;
    const button = makeButton('', () => this.#goTo(index), { class: 'plain' });
    this.#buttons.push(button);
    this.#list.append(make('li', {}, button));
  }

  #mark(present: number): void {
    const marked = this.#list.querySelector('[aria-current]');
    const button = this.#buttons[present];
    if (marked === button) return;
    marked?.removeAttribute('aria-current');
    button?.setAttribute('aria-current', 'step');
    if (button) this.#list.scrollTop = button.offsetTop - this.#list.clientHeight / 2;
  }

  /** The list is one stop of the tab key; the arrows go through it. */
  #pressKey(event: KeyboardEvent): void {
    const at = this.#buttons.indexOf(document.activeElement as HTMLButtonElement);
    const last = this.#buttons.length - 1;
    const next = { ArrowUp: at - 1, ArrowDown: at + 1, Home: 0, End: last }[event.key];
    if (next === undefined || at === -1) return;
    event.preventDefault();
    this.#buttons[Math.min(last, Math.max(0, next))]?.focus();
  }
}

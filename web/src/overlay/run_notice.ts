/** Says over the picture that the net in it is not one's own, and leads back. */
import type { Run } from '../compare/run';
import { words } from '../language/language';
import { make, makeButton, setText } from '../elements/dom';
import './messages.css';

export class RunNotice {
  // In the page before anything is said, or screen readers miss it.
  readonly element = make('div', { class: 'run-notice', role: 'status' });
  private readonly words = make('span');
  private readonly line: HTMLElement;

  constructor(back: () => void) {
    this.line = make('p', { class: 'message' }, this.words, makeButton(words.comparison.back, back));
  }

  show(run: Run | null, beside: readonly Run[]): void {
    if (run === null && beside.length === 0) return this.element.replaceChildren();
    const names = [run?.label ?? words.comparison.yourNet, ...beside.map(({ label }) => label)];
    setText(this.words, beside.length === 0 ? words.comparison.showing(names[0]!) : words.comparison.showingAll(names));
    this.element.replaceChildren(this.line);
  }
}

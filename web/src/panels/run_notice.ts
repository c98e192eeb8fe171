/** Says over the picture that the net in it is not one's own, and leads back. */
import type { Run } from '../compare/run';
import { words } from '../language/language';
import { make, makeButton, setText } from './dom';

export class RunNotice {
  // In the page before anything is said, or screen readers miss it.
  readonly element = make('div', { class: 'run-notice', role: 'status' });
  private readonly words = make('span');
  private readonly line: HTMLElement;

  constructor(back: () => void) {
    this.line = make('p', { class: 'message' }, this.words, makeButton(words.comparison.back, back));
  }

  show(run: Run | null, beside: Run | null): void {
    if (run === null && beside === null) return this.element.replaceChildren();
    const left = run ? words.core.method(run.method) : words.comparison.yourNet;
    const right = beside && words.core.method(beside.method);
    setText(this.words, right ? words.comparison.showingBoth(left, right) : words.comparison.showing(left));
    this.element.replaceChildren(this.line);
  }
}

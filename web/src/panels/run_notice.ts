/** Says over the picture that the net in it is not one's own, and leads back. */
import type { Run } from '../compare/run';
import { make, makeButton, setText } from './dom';
import { methodTitle } from './words';

export class RunNotice {
  // In the page before anything is said, or screen readers miss it.
  readonly element = make('div', { class: 'run-notice', role: 'status' });
  private readonly words = make('span');
  private readonly line: HTMLElement;

  constructor(back: () => void) {
    this.line = make('p', { class: 'message' }, this.words, makeButton('Back to your net', back));
  }

  show(run: Run | null, beside: Run | null): void {
    if (run === null && beside === null) return this.element.replaceChildren();
    const left = run ? methodTitle(run.method) : 'your net';
    setText(this.words, beside ? `Left: ${left}. Right: ${methodTitle(beside.method)}` : `Showing the result of ${left}`);
    this.element.replaceChildren(this.line);
  }
}

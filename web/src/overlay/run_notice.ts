/** A notice over the view that it shows the net of a run, with a button back to the user's own. */
import type { Run } from '../compare/run';
import { make, makeButton, setText } from '../elements/dom';
import { showLine } from '../elements/leave';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import './run_notice.css';

const WORDS = panelWords.comparison.ofRuns;

export class RunNotice implements Panel {
  // In the page from the start: screen readers announce changes of what is there.
  readonly element = make('div', { class: 'run-notice', role: 'status' });
  readonly #words = make('span');
  readonly #line: HTMLElement;

  constructor(events: PanelEvents) {
    const back = (): void => {
      events.showRun(null);
      events.showBeside([]);
    };
    this.#line = make('p', { class: 'message' }, this.#words, makeButton(WORDS.back, back));
  }

  setRuns(run: Run | null, beside: readonly Run[]): void {
    const names = [run?.label ?? WORDS.yourNet, ...beside.map(({ label }) => label)];
    setText(this.#words, beside.length === 0 ? WORDS.showing(names[0]!) : WORDS.showingAll(names));
    showLine(this.element, this.#line, run !== null || beside.length > 0);
  }
}

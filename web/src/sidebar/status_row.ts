/** The row above the sections: status of the solver, and two buttons. */
import { make, makeButton, setText } from '../elements/dom';
import { words } from '../language/language';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData } from '../worker/protocol';
import { standing } from './status';

export class StatusRow implements Panel {
  readonly element: HTMLElement;
  readonly #light = make('i', { class: 'light', 'data-status': 'running' });
  readonly #status = make('span', { class: 'status-words' }, words.status.loading);

  /** @param folds buttons that show and hide the sections: on a phone this row is all that is seen of them at first. */
  constructor(events: PanelEvents, folds: readonly HTMLElement[]) {
    const keys = makeButton('?', () => events.showKeys(), {
      class: 'keys-button',
      'aria-label': words.keys.title,
      title: words.keys.hint,
    });
    this.element = make('div', { class: 'status' }, this.#light, this.#status, keys, ...folds);
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    const now = standing(frame, solving);
    this.#light.dataset.status = now;
    setText(this.#status, words.status[now]);
  }
}

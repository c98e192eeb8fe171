/** Beside the line that says how the solver stands: ends a solve that takes long, as Escape does then (keys.ts). */
import { makeButton } from '../elements/dom';
import { setHidden } from '../elements/leave';
import type { HistoryView } from '../document/undo';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData } from '../worker/protocol';

/** Most solves are over before anybody could end them. */
const PATIENCE_MS = 1000;

export class StopButton implements Panel {
  readonly element: HTMLButtonElement;
  /** While a hand drags, it says when the net is to rest. That a drag begins is no news of the history, which knows. */
  #history: Pick<HistoryView, 'inGesture'> | null = null;
  #patience: ReturnType<typeof setTimeout> | undefined;

  constructor(events: Pick<PanelEvents, 'cancel'>) {
    const { stop, stopHint } = panelWords.solver;
    this.element = makeButton(stop, () => events.cancel(), { class: 'stop', title: stopHint, hidden: true });
  }

  setHistory(history: HistoryView): void {
    this.#history = history;
  }

  setFrame(_frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving && !this.#history?.inGesture) {
      this.#patience ??= setTimeout(() => setHidden(this.element, false), PATIENCE_MS);
      return;
    }
    clearTimeout(this.#patience);
    this.#patience = undefined;
    setHidden(this.element, true);
  }
}

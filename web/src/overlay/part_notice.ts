/** A notice over the view that it shows a part of the net, with a button back to all of it. */
import type { HandleData } from '../document/document';
import { make, makeButton } from '../elements/dom';
import { showLine } from '../elements/leave';
import type { Choice } from '../handles/commands';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import './messages.css';
import './part_notice.css';

const TEXT = panelWords.selection;

export class PartNotice implements Panel {
  readonly element = make('div', { class: 'part-notice', role: 'status' });
  readonly #line: HTMLElement;

  constructor({ handles }: PanelEvents) {
    const back = makeButton(TEXT.showWhole, () => handles.around((surroundings) => surroundings.isolate()), {
      title: TEXT.showWholeHint,
    });
    this.#line = make('p', { class: 'message' }, make('span', {}, TEXT.isolated), back);
  }

  setHandles(_handles: readonly HandleData[], { part }: Choice): void {
    showLine(this.element, this.#line, part !== undefined);
  }
}

/** The name of the page, and below it a hint what can be done with the net. */
import type { HandleData } from '../document/document';
import { make, setText } from '../elements/dom';
import type { Choice } from '../handles/commands';
import { words } from '../language/language';
import type { Panel } from '../panels';

export class Title implements Panel {
  readonly element: HTMLElement;
  readonly #toDrag = makeDragLine();
  readonly #toClick = make('p', { hidden: true }, words.intro.click);
  readonly #toSelect = make('p', { class: 'to-select', role: 'status' });

  /** @param note is placed below. */
  constructor(note: HTMLElement) {
    const name = make('h1', {}, 'chebnet');
    this.element = make('header', { class: 'title' }, name, this.#toDrag, this.#toClick, this.#toSelect, note);
  }

  setHandles(handles: readonly HandleData[], { selecting, selection }: Choice): void {
    const draggable = handles.some(({ anchor }) => !anchor);
    this.#toDrag.hidden = selecting || !draggable;
    this.#toClick.hidden = selecting || draggable;
    setText(this.#toSelect, selecting ? words.intro.select(selection.length) : '');
  }
}

function makeDragLine(): HTMLElement {
  const { before, sphere, after } = words.intro.drag;
  return make('p', {}, before, make('em', {}, sphere), after);
}

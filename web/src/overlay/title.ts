/** The name of the page, and below it a hint what can be done with the net. */
import type { HandleData } from '../document/document';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import type { Choice } from '../handles/commands';
import { chosen, type Selection } from '../handles/selection';
import { words } from '../language/language';
import type { Panel, PanelEvents } from '../panels';

export class Title implements Panel {
  readonly element: HTMLElement;
  readonly #toDrag = makeDragLine();
  readonly #toClick = make('p', { hidden: true }, words.intro.click);
  readonly #propose: HTMLButtonElement;
  readonly #toSelect = make('p', { class: 'to-select', role: 'status' });

  /** @param note is placed below. */
  constructor({ handles }: PanelEvents, note: HTMLElement) {
    const name = make('h1', {}, 'chebnet');
    this.#propose = makeButton(words.intro.propose, () => handles.propose(), {
      class: 'plain link propose',
      hidden: true,
    });
    const lines = [this.#toDrag, this.#toClick, this.#propose, this.#toSelect];
    this.element = make('header', { class: 'title' }, name, ...lines, note);
  }

  setHandles(handles: readonly HandleData[], { selecting, selection }: Choice): void {
    const draggable = handles.some(({ anchor }) => !anchor);
    this.#toDrag.hidden = selecting || !draggable;
    this.#toClick.hidden = selecting || draggable;
    setHidden(this.#propose, selecting || handles.length > 0);
    setText(this.#toSelect, selecting ? words.intro.select(selection.length, lockedOf(selection, handles)) : '');
  }
}

/** How many of those selected are locked. */
function lockedOf(selection: Selection, handles: readonly HandleData[]): number {
  return chosen(selection, handles).filter(({ anchor }) => anchor).length;
}

function makeDragLine(): HTMLElement {
  const { before, sphere, after } = words.intro.drag;
  return make('p', {}, before, make('em', {}, sphere), after);
}

/** Handles of one name, as one row of the list: its name to select them by, eye, lock and cross for all of them. */
import { type HandleData, LONGEST_NAME } from '../document/document';
import { make, makeButton, makeIcon, setText } from '../elements/dom';
import { ICONS } from '../elements/icons';
import type { HandleTraits } from '../handles/commands';
import { panelWords } from '../language/panels';
import { makeRowTitle } from './row_title';
import { Toggle } from './toggle';

interface GroupEvents {
  /** `adds`: beside what is selected already. */
  select(vertices: readonly number[], adds: boolean): void;
  change(vertices: readonly number[], traits: HandleTraits): void;
  remove(vertices: readonly number[]): void;
}

export class HandleGroupRow {
  readonly element: HTMLLIElement;
  readonly #title = make('span');
  readonly #select: HTMLButtonElement;
  /** In the place of the title while they are renamed. */
  readonly #name = make('input', {
    type: 'text',
    maxlength: LONGEST_NAME,
    'aria-label': panelWords.handles.renameGroup,
    hidden: true,
  });
  readonly #eye: Toggle;
  readonly #lock: Toggle;
  readonly #remove: HTMLButtonElement;
  #vertices: number[] = [];
  #shown = '';

  constructor(events: GroupEvents) {
    this.#select = makeRowTitle(this.#title, {
      select: (adds) => events.select(this.#vertices, adds),
      rename: () => this.#rename(),
    });
    this.#name.addEventListener('change', () =>
      events.change(this.#vertices, { name: this.#name.value.trim() || undefined }),
    );
    this.#name.addEventListener('blur', () => this.#setRenaming(false));
    this.#name.addEventListener('keydown', (event) => this.#typed(event));
    this.#eye = new Toggle(ICONS.eye, ICONS.eyeOff, [panelWords.handles.hide, panelWords.handles.show], (hidden) =>
      events.change(this.#vertices, { hidden: hidden || undefined }),
    );
    this.#lock = new Toggle(
      ICONS.unlocked,
      ICONS.locked,
      [panelWords.handles.lock, panelWords.handles.unlock],
      (anchor) => events.change(this.#vertices, { anchor }),
    );
    this.#remove = makeButton(makeIcon(ICONS.cross), () => events.remove(this.#vertices), {
      class: 'plain tool',
      title: panelWords.handles.remove,
    });
    this.element = make(
      'li',
      {},
      make('div', { class: 'line' }, this.#select, this.#name, this.#eye.button, this.#lock.button, this.#remove),
    );
  }

  /** What only some of them are, hidden or locked or soft, the row does not show. */
  update(handles: readonly HandleData[], selected: boolean): void {
    this.#vertices = handles.map(({ vertex }) => vertex);
    this.#shown = handles[0]?.name ?? '';
    const title = panelWords.handles.group(this.#shown, handles.length);
    setText(this.#title, title);
    this.#remove.setAttribute('aria-label', panelWords.handles.removeGroup(title));
    const [hidden, locked] = [handles.every((each) => each.hidden), handles.every(({ anchor }) => anchor)];
    const { classList } = this.element;
    classList.toggle('selected', selected);
    classList.toggle('locked', locked);
    classList.toggle(
      'soft',
      handles.every(({ weight }) => weight !== undefined),
    );
    classList.toggle('unseen', hidden);
    this.#select.setAttribute('aria-pressed', String(selected));
    this.#eye.set(hidden, title);
    this.#lock.set(locked, title);
  }

  focus(): void {
    this.#select.focus();
  }

  #rename(): void {
    this.#name.value = this.#shown;
    this.#setRenaming(true);
    this.#name.select();
  }

  /** A field that loses the focus reports what was changed in it; with Esc that is nothing. */
  #typed(event: KeyboardEvent): void {
    // Of what an input method offers, Enter takes and Esc drops one.
    if (isOfInputMethod(event)) return;
    if (event.key === 'Escape') this.#name.value = this.#shown;
    else if (event.key !== 'Enter') return;
    // Or else Enter would press the button that has the focus afterwards.
    event.preventDefault();
    this.#name.blur();
    this.#select.focus();
  }

  #setRenaming(on: boolean): void {
    this.#name.hidden = !on;
    this.#select.hidden = on;
  }
}

/** Safari says that the composition has ended before it tells of the key that ended it: only its code shows whose it was. */
function isOfInputMethod({ isComposing, keyCode }: KeyboardEvent): boolean {
  return isComposing || keyCode === 229;
}

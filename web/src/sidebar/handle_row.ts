/** A handle of the list by itself: its name to select it by, eye, lock and cross; while it alone is selected, its fields. */
import { type HandleData, LONGEST_NAME, type Vec3 } from '../document/document';
import { AXES } from '../handles/transform';
import type { HandleTraits } from '../handles/commands';
import { panelWords } from '../language/panels';
import { make, makeButton, makeIcon, setText, setValue } from '../elements/dom';
import { makeNumberInput } from '../elements/number_input';
import { ICONS } from '../elements/icons';
import { Sliding, type Slipway } from './sliding';
import { Softness } from './softness';
import { Toggle } from './toggle';
import { coordinate } from '../language/numbers';
import { makeRowTitle } from './row_title';

interface RowEvents {
  /** `adds`: beside what is selected already. */
  select(adds: boolean): void;
  change(traits: HandleTraits): void;
  place(target: Vec3): void;
  remove(): void;
}

export class HandleRow {
  readonly element: HTMLLIElement;
  readonly #title = make('span');
  readonly #select: HTMLButtonElement;
  readonly #eye: Toggle;
  readonly #lock: Toggle;
  readonly #name = make('input', { type: 'text', maxlength: LONGEST_NAME, 'aria-label': panelWords.handles.name });
  readonly #inputs: HTMLInputElement[];
  readonly #softness: Softness;
  readonly #sliding: Sliding;
  readonly #fields: HTMLDivElement;
  #handle: HandleData | null = null;
  #shown = '';
  readonly #events: RowEvents;

  constructor(vertex: number, events: RowEvents) {
    this.#events = events;
    this.#select = makeRowTitle(this.#title, { select: events.select, rename: () => this.#rename() });
    this.#eye = new Toggle(ICONS.eye, ICONS.eyeOff, [panelWords.handles.hide, panelWords.handles.show], (hidden) =>
      events.change({ hidden: hidden || undefined }),
    );
    this.#lock = new Toggle(
      ICONS.unlocked,
      ICONS.locked,
      [panelWords.handles.lock, panelWords.handles.unlock],
      (anchor) => events.change({ anchor }),
    );
    const remove = makeButton(makeIcon(ICONS.cross), () => events.remove(), {
      class: 'plain tool',
      'aria-label': panelWords.handles.removeAt(vertex),
      title: panelWords.handles.remove,
    });
    this.#name.placeholder = panelWords.handles.vertex(vertex);
    this.#name.addEventListener('change', () => events.change({ name: this.#name.value.trim() || undefined }));
    this.#inputs = AXES.map((_, axis) => this.#makeCoordinate(axis));
    this.#softness = new Softness(events.change);
    this.#sliding = new Sliding(events.change);
    const nameRow = make('label', { class: 'row' }, make('span', {}, panelWords.handles.name), this.#name);
    this.#fields = make(
      'div',
      { class: 'fields' },
      nameRow,
      makeCoordinates(this.#inputs),
      ...this.#softness.rows,
      ...this.#sliding.rows,
    );
    const line = make('div', { class: 'line' }, this.#select, this.#eye.button, this.#lock.button, remove);
    this.element = make('li', {}, line, this.#fields);
  }

  /** `alone`: nothing else is selected. Fields are for one handle at a time. */
  update(
    [handle]: readonly HandleData[],
    selected: boolean,
    alone: boolean,
    edgeLength: number,
    slipway: Slipway,
  ): void {
    if (handle === undefined) return;
    const state = `${selected} ${alone} ${slipway.up} ${slipway.slides}`;
    // Fields that are in sight may hold what was refused.
    if (!alone && handle === this.#handle && state === this.#shown) return;
    [this.#handle, this.#shown] = [handle, state];
    const { target, anchor, hidden, weight, slides } = handle;
    const title = titleOf(handle);
    setText(this.#title, title);
    const { classList } = this.element;
    classList.toggle('selected', selected);
    classList.toggle('locked', anchor);
    classList.toggle('soft', weight !== undefined);
    classList.toggle('slides', slides !== undefined);
    classList.toggle('unseen', hidden === true);
    this.#select.setAttribute('aria-pressed', String(selected));
    this.#select.setAttribute('aria-expanded', String(alone));
    this.#eye.set(hidden === true, title);
    this.#lock.set(anchor, title);
    this.#fields.hidden = !alone;
    if (!alone) return;
    setValue(this.#name, handle.name ?? '');
    this.#inputs.forEach((input, axis) => {
      input.disabled = anchor || handle.slides?.includes(AXES[axis]!) === true;
      setValue(input, coordinate(target[axis]!, edgeLength));
    });
    this.#softness.setWeight(weight);
    this.#sliding.set([handle], slipway);
  }

  focus(): void {
    this.#select.focus();
  }

  #rename(): void {
    if (this.#fields.hidden) this.#events.select(false);
    this.#name.focus();
    this.#name.select();
  }

  #makeCoordinate(axis: number): HTMLInputElement {
    const input = makeNumberInput({ step: 'any', required: true });
    input.addEventListener('change', () => {
      if (!this.#handle || !input.checkValidity()) return;
      // The other two keep digits that their fields do not show.
      const target: Vec3 = [...this.#handle.target];
      target[axis] = input.valueAsNumber;
      this.#events.place(target);
    });
    return input;
  }
}

export function titleOf({ vertex, name }: HandleData): string {
  return name ?? panelWords.handles.vertex(vertex);
}

export function makeCoordinates(inputs: readonly HTMLInputElement[]): HTMLDivElement {
  const labels = inputs.map((input, axis) => make('label', {}, make('span', {}, AXES[axis]!), input));
  return make('div', { class: 'coordinates' }, ...labels);
}

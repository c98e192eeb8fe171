/** Several selected handles by numbers: where their centre is, and how far to move, turn or scale them. */
import { type HandleData, LONGEST_NAME, type Vec3 } from '../document/document';
import { type Selection, unlocked } from '../handles/selection';
import { AXES, type Axis, centreOf, type Motion } from '../handles/transform';
import type { Choice } from '../handles/commands';
import { panelWords } from '../language/panels';
import { make, setText, setValue } from '../elements/dom';
import { makeNumberInput } from '../elements/number_input';
import { makeCoordinates } from './handle_row';
import type { PanelEvents } from '../panels';
import { Sliding, type Slipway } from './sliding';
import { Softness } from './softness';
import { coordinate } from '../language/numbers';

export class SelectionForm {
  readonly element: HTMLElement;
  readonly #count = make('h2');
  readonly #name = make('input', { type: 'text', maxlength: LONGEST_NAME, title: panelWords.handles.groupHint });
  readonly #centre = AXES.map(() => numberField(''));
  readonly #by = AXES.map(() => numberField('0'));
  readonly #axis = make(
    'select',
    { 'aria-label': panelWords.handles.axis },
    ...AXES.map((axis) => make('option', { value: axis }, axis)),
  );
  readonly #degrees = numberField('90', panelWords.handles.degrees);
  readonly #factor = numberField('1.1', panelWords.handles.factor);
  readonly #motions: HTMLFieldSetElement;
  readonly #softness: Softness;
  readonly #sliding: Sliding;
  #place: Vec3 = [0, 0, 0];
  #selection: Selection = [];
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    this.#axis.value = 'z';
    this.#name.addEventListener('change', () =>
      events.handles.change(this.#selection, { name: this.#name.value.trim() || undefined }),
    );
    this.#centre.forEach((input, axis) => input.addEventListener('change', () => this.#moveCentre(axis)));
    this.#motions = make(
      'fieldset',
      {},
      make(
        'div',
        { class: 'motion', role: 'group', 'aria-label': panelWords.handles.centre },
        make('span', {}, panelWords.handles.centre),
        makeCoordinates(this.#centre),
      ),
      this.#motion(
        panelWords.handles.moveBy,
        () => ({ kind: 'move', by: this.#by.map((input) => input.valueAsNumber) as Vec3 }),
        makeCoordinates(this.#by),
      ),
      this.#motion(
        panelWords.handles.rotate,
        () => ({ kind: 'rotate', axis: this.#axis.value as Axis, degrees: this.#degrees.valueAsNumber }),
        make('div', { class: 'pair' }, this.#axis, this.#degrees),
      ),
      this.#motion(
        panelWords.handles.scale,
        () => ({ kind: 'scale', factor: this.#factor.valueAsNumber }),
        this.#factor,
      ),
    );
    this.#softness = new Softness((traits) => events.handles.change(this.#selection, traits));
    this.#sliding = new Sliding((traits) => events.handles.change(this.#selection, traits));
    this.element = make(
      'section',
      { class: 'selection', 'aria-label': panelWords.selection.label },
      this.#count,
      make('label', { class: 'row' }, make('span', {}, panelWords.handles.name), this.#name),
      this.#motions,
      ...this.#softness.rows,
      ...this.#sliding.rows,
    );
  }

  update(
    selected: readonly HandleData[],
    { selection }: Pick<Choice, 'selection'>,
    edgeLength: number,
    slipway: Slipway,
  ): void {
    this.element.hidden = selected.length < 2;
    if (this.element.hidden) return;
    this.#selection = selection;
    this.#softness.setWeight(selected.every(({ weight }) => weight !== undefined) ? selected[0]?.weight : undefined);
    this.#sliding.set(selected, slipway);
    const [first] = selected;
    setValue(this.#name, (selected.every(({ name }) => name === first?.name) && first?.name) || '');
    setText(this.#count, panelWords.selection.count(selected.length));
    const moving = unlocked(selection, selected);
    this.#motions.disabled = moving.length === 0;
    this.#place = centreOf((moving.length > 0 ? moving : selected).map(({ target }) => target));
    this.#centre.forEach((input, axis) => setValue(input, coordinate(this.#place[axis]!, edgeLength)));
  }

  #moveCentre(axis: number): void {
    const input = this.#centre[axis]!;
    if (!input.checkValidity()) return;
    const by: Vec3 = [0, 0, 0];
    by[axis] = input.valueAsNumber - this.#place[axis]!;
    this.#events.handles.transform({ kind: 'move', by });
  }

  #motion(label: string, read: () => Motion, fields: HTMLElement): HTMLFormElement {
    const form = make(
      'form',
      { class: 'motion', 'aria-label': label },
      make('span', {}, label),
      fields,
      make('button', {}, panelWords.handles.apply),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#events.handles.transform(read());
    });
    return form;
  }
}

function numberField(value: string, label = ''): HTMLInputElement {
  return makeNumberInput({
    step: 'any',
    required: true,
    value,
    ...(label ? { 'aria-label': label, title: label } : {}),
  });
}

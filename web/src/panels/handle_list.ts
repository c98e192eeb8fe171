/** The handles as a table: select, hold as anchor, put to exact coordinates, remove; and add one by its number. */
import type { HandleData, Vec3 } from '../document/document';
import { words } from '../language/language';
import { make, makeButton, makeIcon, setValue } from './dom';
import type { PanelEvents } from './panels';
import { coordinate } from './words';

const AXES = ['x', 'y', 'z'] as const;
const CROSS = 'M4 4l8 8M12 4l-8 8';

interface Row {
  element: HTMLLIElement;
  select: HTMLButtonElement;
  anchor: HTMLInputElement;
  fields: HTMLDivElement;
  inputs: HTMLInputElement[];
}

export class HandleList {
  private readonly list = make('ul', { class: 'handles' });
  private readonly empty = make('p', { class: 'quiet' }, words.handles.none);
  private readonly number = make('input', { type: 'number', min: 0, step: 1, required: true, placeholder: words.handles.number, 'aria-label': words.handles.vertexNumber });
  readonly content: HTMLElement[];
  private rows = new Map<number, Row>();
  private handles: readonly HandleData[] = [];
  private edgeLength = 1;

  constructor(private readonly events: PanelEvents) {
    const form = make('form', { class: 'add-handle' }, this.number, make('button', {}, words.handles.add));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.add(this.number.valueAsNumber);
    });
    this.content = [this.list, this.empty, form];
  }

  showNet(vertices: number, edgeLength: number): void {
    this.number.max = String(vertices - 1);
    this.edgeLength = edgeLength;
  }

  show(handles: readonly HandleData[], selected: number | null): void {
    this.handles = handles;
    this.empty.hidden = handles.length > 0;
    if (handles.length !== this.rows.size || handles.some(({ vertex }) => !this.rows.has(vertex))) this.rebuild();
    for (const handle of handles) this.update(this.rows.get(handle.vertex)!, handle, handle.vertex === selected);
  }

  private add(vertex: number): void {
    this.number.value = '';
    if (this.rows.has(vertex)) this.events.selectHandle(vertex);
    else this.events.addHandle(vertex);
  }

  private rebuild(): void {
    this.rows = new Map(this.handles.map(({ vertex }) => [vertex, this.rows.get(vertex) ?? this.makeRow(vertex)]));
    this.list.replaceChildren(...[...this.rows.values()].map(({ element }) => element));
  }

  private update({ element, select, anchor, fields, inputs }: Row, handle: HandleData, selected: boolean): void {
    element.classList.toggle('selected', selected);
    element.classList.toggle('anchor', handle.anchor);
    select.setAttribute('aria-expanded', String(selected));
    anchor.checked = handle.anchor;
    fields.hidden = !selected;
    if (selected) inputs.forEach((input, axis) => setValue(input, coordinate(handle.target[axis]!, this.edgeLength)));
  }

  private makeRow(vertex: number): Row {
    const select = makeButton('', () => this.toggle(vertex), { class: 'plain name' });
    select.append(make('i', { class: 'mark' }), words.handles.vertex(vertex));
    const anchor = make('input', { type: 'checkbox', class: 'switch' });
    anchor.addEventListener('change', () => this.events.setAnchor(vertex, anchor.checked));
    const remove = makeButton(makeIcon(CROSS), () => this.events.deleteHandle(vertex), {
      class: 'plain',
      'aria-label': words.handles.removeAt(vertex),
      title: words.handles.remove,
    });
    const inputs = AXES.map((_, axis) => this.makeField(vertex, axis));
    const fields = make('div', { class: 'coordinates' });
    inputs.forEach((input, axis) => fields.append(make('label', {}, make('span', {}, AXES[axis]!), input)));
    const line = make('div', { class: 'line' }, select, make('label', {}, make('span', {}, words.handles.anchor), anchor), remove);
    return { element: make('li', {}, line, fields), select, anchor, fields, inputs };
  }

  private makeField(vertex: number, axis: number): HTMLInputElement {
    const input = make('input', { type: 'number', step: 'any', required: true });
    input.addEventListener('change', () => {
      const handle = this.handles.find((each) => each.vertex === vertex);
      if (!handle || !input.checkValidity()) return;
      // The other two keep digits that their fields do not show.
      const target: Vec3 = [...handle.target];
      target[axis] = input.valueAsNumber;
      this.events.setHandleTarget(vertex, target);
    });
    return input;
  }

  private toggle(vertex: number): void {
    const open = this.rows.get(vertex)!.element.classList.contains('selected');
    this.events.selectHandle(open ? null : vertex);
  }
}

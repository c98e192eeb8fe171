/** The handles as a list, what can be done with several of them, and one more by its vertex number. */
import type { HandleData, Symmetry } from '../document/document';
import { toggled } from '../handles/selection';
import type { Choice } from '../handles/wishes';
import { words } from '../language/language';
import { make } from './dom';
import { HandleRow } from './handle_row';
import type { PanelEvents } from './panels';
import { SelectionForm } from './selection_form';
import { SymmetryChoice } from './symmetry_choice';

export class HandleList {
  private readonly list = make('ul', { class: 'handles' });
  private readonly empty = make('p', { class: 'quiet' }, words.handles.none);
  private readonly several = make('p', { class: 'quiet' }, words.handles.several);
  private readonly number = make('input', { type: 'number', min: 0, step: 1, required: true, placeholder: words.handles.number, 'aria-label': words.handles.vertexNumber });
  private readonly form: SelectionForm;
  private readonly symmetry: SymmetryChoice;
  readonly content: HTMLElement[];
  private rows = new Map<number, HandleRow>();
  private handles: readonly HandleData[] = [];
  private choice: Pick<Choice, 'selection'> = { selection: [] };
  private edgeLength = 1;
  /** The handle last scrolled to. */
  private inSight: number | null = null;

  constructor(private readonly events: PanelEvents) {
    const add = make('form', { class: 'add-handle' }, this.number, make('button', {}, words.handles.add));
    add.addEventListener('submit', (event) => {
      event.preventDefault();
      this.add(this.number.valueAsNumber);
    });
    this.form = new SelectionForm(events);
    this.symmetry = new SymmetryChoice((symmetry) => events.handles.setSymmetry(symmetry));
    this.content = [this.form.element, this.list, this.empty, this.several, add, ...this.symmetry.rows];
  }

  showNet(vertices: number, edgeLength: number): void {
    this.number.max = String(vertices - 1);
    this.edgeLength = edgeLength;
  }

  showSymmetry(symmetry: Symmetry | undefined): void {
    this.symmetry.show(symmetry);
  }

  show(handles: readonly HandleData[], choice: Choice): void {
    this.handles = handles;
    this.choice = choice;
    this.empty.hidden = handles.length > 0;
    this.several.hidden = handles.length < 2 || choice.selection.length > 1;
    if (handles.length !== this.rows.size || handles.some(({ vertex }) => !this.rows.has(vertex))) this.rebuild();
    const selected = new Set(choice.selection);
    const alone = selected.size === 1;
    for (const handle of handles) {
      const isSelected = selected.has(handle.vertex);
      this.rows.get(handle.vertex)!.show(handle, isSelected, isSelected && alone, this.edgeLength);
    }
    if (alone) this.bringIntoSight(choice.selection[0]!);
    this.form.show(handles.filter(({ vertex }) => selected.has(vertex)), choice, this.edgeLength);
  }

  /** When another one is selected, e.g. in the view. Only the list scrolls, not what is around it. */
  private bringIntoSight(vertex: number): void {
    if (vertex === this.inSight) return;
    this.inSight = vertex;
    const { offsetTop, offsetHeight } = this.rows.get(vertex)!.element;
    const top = offsetTop - this.list.offsetTop;
    const { scrollTop, clientHeight } = this.list;
    this.list.scrollTop = Math.max(Math.min(scrollTop, top), top + offsetHeight - clientHeight);
  }

  private add(vertex: number): void {
    this.number.value = '';
    if (this.rows.has(vertex)) this.events.handles.select([vertex]);
    else this.events.handles.add(vertex);
  }

  private rebuild(): void {
    this.rows = new Map(this.handles.map(({ vertex }) => [vertex, this.rows.get(vertex) ?? this.makeRow(vertex)]));
    this.list.replaceChildren(...[...this.rows.values()].map(({ element }) => element));
  }

  private makeRow(vertex: number): HandleRow {
    const { handles } = this.events;
    return new HandleRow(vertex, {
      select: (adds) => this.select(vertex, adds),
      change: (traits) => handles.change([vertex], traits),
      place: (target) => handles.place(vertex, target),
      remove: () => handles.remove([vertex]),
    });
  }

  private select(vertex: number, adds: boolean): void {
    const { selection } = this.choice;
    const only = selection.length === 1 && selection[0] === vertex;
    this.events.handles.select(adds || only ? toggled(selection, vertex) : [vertex]);
  }
}

/** The handles as a list, what can be done with several of them, and one more by its vertex number. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { toggled } from '../handles/selection';
import type { Choice } from '../handles/commands';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSection, setSummary, setText } from '../elements/dom';
import type { OpenedNet } from '../worker/protocol';
import { HandleRow } from './handle_row';
import type { Panel, PanelEvents } from '../panels';
import { SelectionForm } from './selection_form';
import { SymmetryChoice } from './symmetry_choice';
import './handle_list.css';

/** Number of rows made at first, and added with each press of the button below them: thousands of rows would block the page. */
const ROWS_AT_A_TIME = 100;

export class HandleList implements Panel {
  readonly #list = make('ul', { class: 'handles' });
  readonly #more = makeButton('', () => this.#showMore(), { class: 'plain', hidden: true });
  readonly #empty = make('p', { class: 'quiet' }, panelWords.handles.none);
  readonly #several = make('p', { class: 'quiet' }, panelWords.handles.several);
  readonly #number = make('input', {
    type: 'number',
    min: 0,
    step: 1,
    required: true,
    placeholder: panelWords.handles.number,
    'aria-label': panelWords.handles.vertexNumber,
  });
  readonly #form: SelectionForm;
  readonly #symmetry: SymmetryChoice;
  readonly element: HTMLDetailsElement;
  #rows = new Map<number, HandleRow>();
  #handles: readonly HandleData[] = [];
  #mostRows = ROWS_AT_A_TIME;
  #choice: Choice = { selection: [], selecting: false, mode: 'translate', onBoundary: false, lines: 0 };
  #edgeLength = 1;
  /** The handle last scrolled to. */
  #inSight: number | null = null;
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    const add = make('form', { class: 'add-handle' }, this.#number, make('button', {}, panelWords.handles.add));
    add.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#add(this.#number.valueAsNumber);
    });
    this.#form = new SelectionForm(events);
    this.#symmetry = new SymmetryChoice((symmetry) => events.handles.setSymmetry(symmetry));
    this.element = makeSection(
      panelWords.handles.title(0),
      false,
      this.#form.element,
      this.#list,
      this.#more,
      this.#empty,
      this.#several,
      add,
      ...this.#symmetry.rows,
    );
  }

  setNet({ info }: OpenedNet): void {
    this.#number.max = String(info.vertices - 1);
    this.#edgeLength = info.meanLength;
    this.#mostRows = ROWS_AT_A_TIME;
  }

  setDocument({ symmetry }: ChebnetDocument): void {
    this.#symmetry.set(symmetry);
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    setSummary(this.element, panelWords.handles.title(handles.length));
    this.#handles = handles;
    this.#choice = choice;
    this.#empty.hidden = handles.length > 0;
    this.#several.hidden = handles.length < 2 || choice.selection.length > 1;
    const selected = new Set(choice.selection);
    const alone = selected.size === 1;
    const listed = this.#listed(alone ? choice.selection[0] : undefined);
    if (listed.length !== this.#rows.size || listed.some(({ vertex }) => !this.#rows.has(vertex)))
      this.#rebuild(listed);
    this.#more.hidden = listed.length === handles.length;
    setText(
      this.#more,
      panelWords.handles.more(Math.min(ROWS_AT_A_TIME, handles.length - listed.length), handles.length - listed.length),
    );
    for (const handle of listed) {
      const isSelected = selected.has(handle.vertex);
      this.#rows.get(handle.vertex)!.update(handle, isSelected, isSelected && alone, this.#edgeLength);
    }
    if (alone) this.#bringIntoSight(choice.selection[0]!);
    this.#form.update(
      handles.filter(({ vertex }) => selected.has(vertex)),
      choice,
      this.#edgeLength,
    );
  }

  /** The first of them, and the one that is selected. */
  #listed(selected: number | undefined): readonly HandleData[] {
    const first = this.#handles.slice(0, this.#mostRows);
    const beyond = this.#handles.slice(this.#mostRows).filter(({ vertex }) => vertex === selected);
    return [...first, ...beyond];
  }

  /** Moves the focus to the first new row. */
  #showMore(): void {
    const next = this.#handles[this.#mostRows];
    this.#mostRows += ROWS_AT_A_TIME;
    this.setHandles(this.#handles, this.#choice);
    if (next) this.#rows.get(next.vertex)?.focus();
  }

  /** When another one is selected, e.g. in the view. Only the list scrolls, not what is around it. */
  #bringIntoSight(vertex: number): void {
    if (vertex === this.#inSight) return;
    this.#inSight = vertex;
    const { offsetTop, offsetHeight } = this.#rows.get(vertex)!.element;
    const top = offsetTop - this.#list.offsetTop;
    const { scrollTop, clientHeight } = this.#list;
    this.#list.scrollTop = Math.max(Math.min(scrollTop, top), top + offsetHeight - clientHeight);
  }

  #add(vertex: number): void {
    this.#number.value = '';
    if (this.#handles.some((handle) => handle.vertex === vertex)) this.#events.handles.select([vertex]);
    else this.#events.handles.add(vertex);
  }

  #rebuild(listed: readonly HandleData[]): void {
    this.#rows = new Map(listed.map(({ vertex }) => [vertex, this.#rows.get(vertex) ?? this.#makeRow(vertex)]));
    this.#list.replaceChildren(...[...this.#rows.values()].map(({ element }) => element));
  }

  #makeRow(vertex: number): HandleRow {
    const { handles } = this.#events;
    return new HandleRow(vertex, {
      select: (adds) => this.#select(vertex, adds),
      change: (traits) => handles.change([vertex], traits),
      place: (target) => handles.place(vertex, target),
      remove: () => handles.remove([vertex]),
    });
  }

  #select(vertex: number, adds: boolean): void {
    const { selection } = this.#choice;
    const only = selection.length === 1 && selection[0] === vertex;
    this.#events.handles.select(adds || only ? toggled(selection, vertex) : [vertex]);
  }
}

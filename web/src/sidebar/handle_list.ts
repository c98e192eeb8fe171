/** The handles as a list, those of one name as one row; what can be done with several of them, and one more by its vertex
 *  number. */
import type { ChebnetDocument, HandleData } from '../document/document';
import { type Selection, toggled, united } from '../handles/selection';
import type { Choice } from '../handles/commands';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import { make, makeButton, makeSection, setSummary, setText } from '../elements/dom';
import { setChildren } from '../elements/children';
import { NumberField } from '../elements/number_field';
import type { OpenedNet } from '../worker/protocol';
import { HandleGroupRow } from './handle_group_row';
import { HandleRow } from './handle_row';
import type { Panel, PanelEvents } from '../panels';
import { SelectionForm } from './selection_form';
import { type Slipway, slipwayOf } from './sliding';
import { SymmetryChoice } from './symmetry_choice';
import './handle_list.css';

/** Number of rows made at first, and added with each press of the button below them: thousands of rows would block the page. */
const ROWS_AT_A_TIME = 100;

interface Row {
  readonly element: HTMLElement;
  /** `alone`: nothing else is selected. */
  update(handles: readonly HandleData[], selected: boolean, alone: boolean, edgeLength: number, slipway: Slipway): void;
  focus(): void;
}

/** What one row stands for. */
type Group = readonly HandleData[];

export class HandleList implements Panel {
  readonly #list = make('ul', { class: 'handles' });
  readonly #more = makeButton('', () => this.#showMore(), { class: 'plain', hidden: true });
  readonly #empty = make('p', { class: 'quiet' }, panelWords.handles.none);
  readonly #several = make('p', { class: 'quiet' }, panelWords.handles.several);
  readonly #number = new NumberField({
    min: 0,
    step: 1,
    required: true,
    placeholder: panelWords.handles.number,
    'aria-label': panelWords.handles.vertexNumber,
  });
  readonly #form: SelectionForm;
  readonly #symmetry: SymmetryChoice;
  #methods: Tables['methods'] = [];
  #slipway: Slipway = { up: 'z', slides: true };
  readonly element: HTMLDetailsElement;
  /** By the keys of their groups. */
  #rows = new Map<string, Row>();
  #handles: readonly HandleData[] = [];
  #groups: readonly Group[] = [];
  #mostRows = ROWS_AT_A_TIME;
  #choice: Choice = { selection: [], selecting: false, mode: 'translate', onBoundary: false, lines: 0 };
  #edgeLength = 1;
  /** The handle last scrolled to. */
  #inSight: number | null = null;
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    const add = make('form', { class: 'add-handle' }, this.#number.input, make('button', {}, panelWords.handles.add));
    add.addEventListener('submit', (event) => {
      event.preventDefault();
      const vertex = this.#number.input.valueAsNumber;
      // A field that is only emptied counts as one that the visitor has left empty.
      add.reset();
      this.#add(vertex);
    });
    this.#form = new SelectionForm(events);
    this.#symmetry = new SymmetryChoice((symmetry) => events.handles.setSymmetry(symmetry));
    this.element = makeSection(
      panelWords.handles.title(0),
      false,
      this.#list,
      this.#more,
      // Below: a row that has just been pressed stays where it is, for the second click of two.
      this.#form.element,
      this.#empty,
      this.#several,
      add,
      this.#number.note,
      ...this.#symmetry.rows,
    );
  }

  setNet({ info }: OpenedNet): void {
    this.#number.input.max = String(info.vertices - 1);
    this.#edgeLength = info.meanLength;
    this.#mostRows = ROWS_AT_A_TIME;
  }

  setTables({ methods }: Tables): void {
    this.#methods = methods;
  }

  setDocument(document: ChebnetDocument): void {
    this.#symmetry.set(document.symmetry);
    this.#slipway = slipwayOf(document, this.#methods);
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    setSummary(this.element, panelWords.handles.title(handles.length));
    this.#handles = handles;
    this.#choice = choice;
    this.#empty.hidden = handles.length > 0;
    this.#several.hidden = handles.length < 2 || choice.selection.length > 1;
    const selected = new Set(choice.selection);
    const alone = selected.size === 1;
    this.#groups = groupsOf(handles);
    const single = alone ? choice.selection[0] : undefined;
    const shown = this.#shown(single);
    const listed = shown.flatMap((group) => withMember(group, single));
    if (listed.length !== this.#rows.size || listed.some((group) => !this.#rows.has(keyOf(group))))
      this.#rebuild(listed);
    const left = this.#groups.length - shown.length;
    this.#more.hidden = left === 0;
    setText(this.#more, panelWords.handles.more(Math.min(ROWS_AT_A_TIME, left), left));
    for (const group of listed) {
      const isSelected = group.every(({ vertex }) => selected.has(vertex));
      this.#rows.get(keyOf(group))!.update(group, isSelected, isSelected && alone, this.#edgeLength, this.#slipway);
    }
    if (alone) this.#bringIntoSight(choice.selection[0]!);
    this.#form.update(
      handles.filter(({ vertex }) => selected.has(vertex)),
      choice,
      this.#edgeLength,
      this.#slipway,
    );
  }

  /** The first of them, and the one that is selected. */
  #shown(selected: number | undefined): readonly Group[] {
    const first = this.#groups.slice(0, this.#mostRows);
    const beyond = this.#groups.slice(this.#mostRows).filter((group) => has(group, selected));
    return [...first, ...beyond];
  }

  /** Moves the focus to the first new row. */
  #showMore(): void {
    const next = this.#groups[this.#mostRows];
    this.#mostRows += ROWS_AT_A_TIME;
    this.setHandles(this.#handles, this.#choice);
    if (next) this.#rows.get(keyOf(next))?.focus();
  }

  /** When another one is selected, e.g. in the view. Only the list scrolls, not what is around it. */
  #bringIntoSight(vertex: number): void {
    if (vertex === this.#inSight) return;
    this.#inSight = vertex;
    const { offsetTop, offsetHeight } = this.#rows.get(String(vertex))!.element;
    const top = offsetTop - this.#list.offsetTop;
    const { scrollTop, clientHeight } = this.#list;
    this.#list.scrollTop = Math.max(Math.min(scrollTop, top), top + offsetHeight - clientHeight);
  }

  #add(vertex: number): void {
    if (this.#handles.some((handle) => handle.vertex === vertex)) this.#events.handles.select([vertex]);
    else this.#events.handles.add(vertex);
  }

  #rebuild(listed: readonly Group[]): void {
    const before = [...this.#rows.values()];
    const focused = before.findIndex(({ element }) => element.contains(document.activeElement));
    this.#rows = new Map(listed.map((group) => [keyOf(group), this.#rows.get(keyOf(group)) ?? this.#makeRow(group)]));
    const rows = [...this.#rows.values()];
    setChildren(
      this.#list,
      rows.map(({ element }) => element),
    );
    // Of a row that has gone, by its own cross, the next one takes the focus.
    if (focused >= 0 && !rows.includes(before[focused]!)) (rows[focused] ?? rows.at(-1))?.focus();
  }

  #makeRow([first, ...more]: Group): Row {
    return more.length > 0 || first === undefined ? this.#makeGroupRow() : this.#makeHandleRow(first.vertex);
  }

  #makeGroupRow(): Row {
    const { handles } = this.#events;
    return new HandleGroupRow({
      select: (vertices, adds) => this.#selectGroup(vertices, adds),
      change: (vertices, traits) => handles.change(vertices, traits),
      remove: (vertices) => handles.remove(vertices),
    });
  }

  #makeHandleRow(vertex: number): Row {
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

  #selectGroup(vertices: Selection, adds: boolean): void {
    const { selection } = this.#choice;
    const isOnly = vertices.length === selection.length && vertices.every((vertex) => selection.includes(vertex));
    this.#events.handles.select(adds ? united(selection, vertices) : isOnly ? [] : vertices);
  }
}

function groupsOf(handles: readonly HandleData[]): Group[] {
  const named = new Map<string, HandleData[]>();
  const groups: HandleData[][] = [];
  for (const handle of handles) {
    const known = handle.name === undefined ? undefined : named.get(handle.name);
    if (known) {
      known.push(handle);
      continue;
    }
    const group = [handle];
    groups.push(group);
    if (handle.name !== undefined) named.set(handle.name, group);
  }
  return groups;
}

/** A handle that is selected alone has its own row below that of its group. */
function withMember(group: Group, selected: number | undefined): Group[] {
  return group.length > 1 && has(group, selected)
    ? [group, group.filter(({ vertex }) => vertex === selected)]
    : [group];
}

/** A row that stands for one handle has fields for it, so it is not that of a group. */
function keyOf([first, ...more]: Group): string {
  return `${more.length > 0 ? 'all ' : ''}${first?.vertex}`;
}

function has(group: Group, wanted: number | undefined): boolean {
  return group.some(({ vertex }) => vertex === wanted);
}

/** What the menu of exports offers: kinds of files, with their settings. Loaded after the first picture. */
import { kindsFor, TABLES } from '../export/kinds';
import type { FileKind, Purpose, TableName } from '../export/kinds';
import { filmType } from '../export/film_type';
import { lengthDigits } from '../language/numbers';
import { panelWords } from '../language/panels';
import { make } from '../elements/dom';
import type { Menu, MenuItem } from '../elements/menu';
import { NumberField } from '../elements/number_field';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';

const words = panelWords.exports;
const MAGNIFICATIONS = [1, 2, 4];
const EDGE_MM = { usual: 10, smallest: 1, largest: 1000 };
/** An edge as long as this in the unit of its file, which nobody tells, is taken to be in millimetres: a shorter one would hardly be
 *  made, and metres are given as parts of one. */
const SHORTEST_MM = 5;

export class ExportLines implements Panel {
  readonly element: HTMLElement;
  readonly #edge = makeEdgeField();
  readonly #size = makeNamedSelect(words.magnification, MAGNIFICATIONS, (factor) => `${factor}×`);
  readonly #table = makeNamedSelect(words.table, TABLES, (table) => words.tables[table]);
  readonly #menu: Menu;
  readonly #events: PanelEvents;
  #edgeIsChosen = false;
  /** Of the net as it was made. */
  #edgeLength = 1;

  constructor(menu: Menu, events: PanelEvents) {
    this.element = menu.menu;
    this.#menu = menu;
    this.#events = events;
    this.#edge.input.addEventListener('change', () => (this.#edgeIsChosen = true));
  }

  setNet({ info: { edgeLength } }: OpenedNet): void {
    this.#edgeLength = edgeLength;
  }

  setFrame({ lengthScale }: FrameData): void {
    if (!this.#edgeIsChosen) this.#edge.set(usualMm(this.#edgeLength * lengthScale));
  }

  setTables({ formats }: Tables): void {
    const beside: Partial<Record<FileKind, HTMLElement[]>> = {
      svg: [this.#edge.input, make('span', {}, 'mm'), this.#edge.note],
      csv: [this.#table],
      png: [this.#size],
    };
    const items = (purpose: Purpose): MenuItem[] =>
      kindsFor(purpose, formats, words).map(({ kind, title, hint }) => {
        return { title, hint, choose: () => this.#save(kind), beside: beside[kind] };
      });
    this.#menu.setContent([
      { title: words.meshes, items: items('meshes') },
      { title: words.making, items: items('making') },
      { title: words.pictures, items: [...items('pictures'), recordItem(() => this.#events.record())] },
    ]);
  }

  /** A file of another kind has no edges to be drawn. */
  #save(kind: FileKind): void {
    const edgeMm = kind === 'svg' ? this.#edge.value : EDGE_MM.usual;
    if (edgeMm === null) return this.#refuse();
    const [table, magnification] = [this.#table.value as TableName, Number(this.#size.value)];
    this.#events.save({ kind, edgeMm, table, magnification });
  }

  /** The menu, which has closed, comes back: beside the field stands what is allowed. */
  #refuse(): void {
    this.#menu.menu.showPopover();
    this.#edge.input.focus();
    this.#edge.input.checkValidity();
  }
}

/** A pattern is of the net's own size, unless somebody wants another or its unit is no millimetre. */
function usualMm(edgeLength: number): string {
  const isInMm = edgeLength >= SHORTEST_MM && edgeLength <= EDGE_MM.largest;
  return isInMm ? lengthDigits(edgeLength) : String(EDGE_MM.usual);
}

function makeEdgeField(): NumberField {
  const { usual, smallest, largest } = EDGE_MM;
  return new NumberField({
    required: true,
    value: usual,
    min: smallest,
    max: largest,
    step: 'any',
    'aria-label': words.edgeLength,
  });
}

/** Its name is not seen: it stands in a line that says what it is for. */
function makeNamedSelect<Value extends string | number>(
  label: string,
  values: readonly Value[],
  textOf: (value: Value) => string,
): HTMLSelectElement {
  return make('select', { 'aria-label': label }, ...values.map((value) => make('option', { value }, textOf(value))));
}

function recordItem(record: () => void): MenuItem {
  const { title, hint, impossible } = words.video;
  return filmType() === null
    ? { title, hint: impossible, choose: record, disabled: true }
    : { title, hint, choose: record };
}

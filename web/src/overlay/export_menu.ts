/** What the menu of exports offers: kinds of files, with their settings. Loaded after the first picture. */
import { kindsFor } from '../export/kinds';
import type { FileKind, Purpose, SaveRequest } from '../export/kinds';
import { filmType } from '../export/film_type';
import { panelWords } from '../language/panels';
import { make } from '../elements/dom';
import type { Menu, MenuItem } from '../elements/menu';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';

const words = panelWords.exports;
const MAGNIFICATIONS = [1, 2, 4];
const EDGE_MM = { usual: 10, smallest: 1, largest: 1000 };

export class ExportLines implements Panel {
  readonly element: HTMLElement;
  readonly #edge = makeEdgeInput();
  readonly #size = makeSizeSelect();
  readonly #menu: Menu;
  readonly #events: PanelEvents;

  constructor(menu: Menu, events: PanelEvents) {
    this.element = menu.menu;
    this.#menu = menu;
    this.#events = events;
  }

  setTables({ formats }: Tables): void {
    const beside: Partial<Record<FileKind, HTMLElement[]>> = {
      svg: [this.#edge, make('span', {}, 'mm')],
      png: [this.#size],
    };
    const items = (purpose: Purpose): MenuItem[] =>
      kindsFor(purpose, formats, words).map(({ kind, title, hint }) => {
        return { title, hint, choose: () => this.#events.save(this.#request(kind)), beside: beside[kind] };
      });
    this.#menu.setContent([
      { title: words.meshes, items: items('meshes') },
      { title: words.making, items: items('making') },
      { title: words.pictures, items: [...items('pictures'), recordItem(() => this.#events.record())] },
    ]);
  }

  #request(kind: FileKind): SaveRequest {
    const { usual, smallest, largest } = EDGE_MM;
    this.#edge.valueAsNumber = Math.min(largest, Math.max(smallest, this.#edge.valueAsNumber || usual));
    return { kind, edgeMm: this.#edge.valueAsNumber, magnification: Number(this.#size.value) };
  }
}

function makeEdgeInput(): HTMLInputElement {
  const { usual, smallest, largest } = EDGE_MM;
  return make('input', {
    type: 'number',
    value: usual,
    min: smallest,
    max: largest,
    step: 'any',
    'aria-label': words.edgeLength,
  });
}

function makeSizeSelect(): HTMLSelectElement {
  const sizes = MAGNIFICATIONS.map((factor) => make('option', { value: factor }, `${factor}×`));
  return make('select', { 'aria-label': words.magnification }, ...sizes);
}

function recordItem(record: () => void): MenuItem {
  const { title, hint, impossible } = words.video;
  return filmType() === null
    ? { title, hint: impossible, choose: record, disabled: true }
    : { title, hint, choose: record };
}

/** The menu of file kinds to export the net as, with their settings. */
import type { FormatInfo } from '../../../wasm/chebnet';
import { kindsFor } from '../export/kinds';
import type { FileKind, Purpose, SaveRequest } from '../export/kinds';
import { filmType } from '../export/film_type';
import { words } from '../language/language';
import { make } from '../elements/dom';
import { Menu } from '../elements/menu';
import type { MenuItem } from '../elements/menu';
import type { PanelEvents } from '../panels';

const LOOK = {
  id: 'export-menu',
  icon: 'M8 2.5v8M4.8 7.5 8 10.7l3.2-3.2M2.5 13.5h11',
  ...words.toolbar.export,
  title: words.save.as,
};
const MAGNIFICATIONS = [1, 2, 4];
const EDGE_MM = { usual: 10, smallest: 1, largest: 1000 };

export class ExportMenu extends Menu {
  readonly #edge = makeEdgeInput();
  readonly #size = makeSizeSelect();
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    super(LOOK, []);
    this.#events = events;
    this.setFormats([]);
  }

  /** @param formats the core's; until they are known, the menu has the page's own only. */
  setFormats(formats: readonly FormatInfo[]): void {
    const beside: Partial<Record<FileKind, HTMLElement[]>> = {
      svg: [this.#edge, make('span', {}, 'mm')],
      png: [this.#size],
    };
    const items = (purpose: Purpose): MenuItem[] =>
      kindsFor(purpose, formats, words.save.hints).map(({ kind, title, hint }) => {
        return { title, hint, choose: () => this.#events.save(this.#request(kind)), beside: beside[kind] };
      });
    this.setContent([
      { title: words.save.meshes, items: items('meshes') },
      { title: words.save.making, items: items('making') },
      { title: words.save.pictures, items: [...items('pictures'), recordItem(() => this.#events.record())] },
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
    'aria-label': words.save.edgeLength,
  });
}

function makeSizeSelect(): HTMLSelectElement {
  const sizes = MAGNIFICATIONS.map((factor) => make('option', { value: factor }, `${factor}×`));
  return make('select', { 'aria-label': words.save.magnification }, ...sizes);
}

function recordItem(record: () => void): MenuItem {
  const { kind: title, hint, impossible } = words.recording;
  return filmType() === null
    ? { title, hint: impossible, choose: record, disabled: true }
    : { title, hint, choose: record };
}

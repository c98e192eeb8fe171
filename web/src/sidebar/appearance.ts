/** What the colours mean, whether faces are drawn, and from where the net is seen. */
import type { ChebnetDocument, UpAxis } from '../document/document';
import { type ColourMap, FIELD_NAMES, type FieldName, fieldOf } from '../fields/fields';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSection, makeSelect, makeSwitch, setValue } from '../elements/dom';
import type { Panel, PanelEvents } from '../panels';
import type { StandardView } from '../view/camera_fit';
import './appearance.css';

export class Appearance implements Panel {
  readonly element: HTMLElement;
  readonly #field: HTMLSelectElement;
  readonly #map: HTMLSelectElement;
  readonly #mapRow: HTMLElement;
  readonly #faces: HTMLInputElement;
  readonly #up: HTMLSelectElement;
  readonly #parallel: HTMLInputElement;

  constructor(events: PanelEvents) {
    const fields = FIELD_NAMES.map((name) => ({ value: name, text: words.colourFields[name].choice }));
    const maps = [
      { value: 'paper', text: panelWords.appearance.paper },
      { value: 'log', text: panelWords.appearance.log },
    ];
    const axes = [
      { value: 'z', text: 'z' },
      { value: 'y', text: 'y' },
    ];
    const field = makeSelect(panelWords.appearance.colourBy, fields, (value) =>
      events.setView({ field: value as FieldName }),
    );
    const map = makeSelect(panelWords.appearance.colours, maps, (value) =>
      events.setView({ colourMap: value as ColourMap }),
    );
    const faces = makeSwitch(panelWords.appearance.faces, (showFaces) => events.setView({ showFaces }));
    const up = makeSelect(panelWords.appearance.upAxis, axes, (value) => events.setView({ upAxis: value as UpAxis }));
    [this.#field, this.#map, this.#mapRow] = [field.select, map.select, map.row];
    const parallel = makeSwitch(panelWords.appearance.parallel, (on) => events.setView({ parallel: on }));
    [this.#faces, this.#up, this.#parallel] = [faces.box, up.select, parallel.box];
    this.element = makeSection(
      words.sections.appearance,
      false,
      field.row,
      map.row,
      faces.row,
      standardViews((from) => events.frameAll(from)),
      parallel.row,
      up.row,
    );
  }

  setDocument({ view }: ChebnetDocument): void {
    const { field, colourMap, showFaces, upAxis, parallel } = view;
    setValue(this.#field, field);
    setValue(this.#map, colourMap);
    this.#mapRow.hidden = fieldOf(field).maps === undefined;
    this.#faces.checked = showFaces;
    setValue(this.#up, upAxis ?? 'z');
    this.#parallel.checked = parallel ?? false;
  }
}

function standardViews(look: (from: StandardView) => void): HTMLElement {
  const { views, from, keys } = panelWords.appearance;
  const button = (view: StandardView): HTMLElement => makeButton(views[view], () => look(view), { title: keys[view] });
  return make(
    'div',
    { class: 'views', role: 'group', 'aria-label': from },
    ...(['free', 'front', 'side', 'top'] as const).map(button),
  );
}

/** What the colours mean, what of the net is drawn, and from where it is seen. */
import type { ChebnetDocument, Section, UpAxis, ViewState } from '../document/document';
import { type ColourMap, FIELD_NAMES, type FieldName, fieldOf } from '../fields/fields';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSection, makeSelect, makeSwitch, setValue } from '../elements/dom';
import type { Panel, PanelEvents } from '../panels';
import type { StandardView } from '../view/camera_fit';
import { makeSlider } from './slider';
import './appearance.css';

/** Diameters of rods, in percent of an edge's length, and the usual one. */
const [THINNEST, THICKEST, USUAL_ROD] = [2, 40, 12];
/** Steps of the section plane through the net. */
const SECTION_STEPS = 100;

export class Appearance implements Panel {
  readonly element: HTMLElement;
  readonly #field: HTMLSelectElement;
  readonly #map: HTMLSelectElement;
  readonly #mapRow: HTMLElement;
  readonly #faces: HTMLInputElement;
  readonly #up: HTMLSelectElement;
  readonly #parallel: HTMLInputElement;
  readonly #rods: HTMLInputElement;
  readonly #thickness: ReturnType<typeof makeSlider>;
  readonly #section: HTMLSelectElement;
  readonly #place: ReturnType<typeof makeSlider>;
  #view: ViewState | null = null;

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
    const rods = makeSwitch(panelWords.appearance.rods, (on) =>
      events.setView({ rods: on ? USUAL_ROD / 100 : undefined }),
    );
    this.#thickness = makeSlider(panelWords.appearance.thickness, THICKEST, panelWords.appearance.ofEdge, () => {});
    this.#thickness.input.min = String(THINNEST);
    this.#thickness.input.addEventListener('input', () =>
      events.setView({ rods: this.#thickness.input.valueAsNumber / 100 }),
    );
    const planes = (['', 'x', 'y', 'z'] as const).map((value) => ({
      value,
      text: value === '' ? panelWords.appearance.whole : panelWords.appearance.across(value),
    }));
    const section = makeSelect(panelWords.appearance.section, planes, (axis) =>
      events.setView({ section: axis === '' ? undefined : { axis: axis as Section['axis'], at: 0.5 } }),
    );
    this.#place = makeSlider(panelWords.appearance.place, SECTION_STEPS, panelWords.appearance.through, () => {});
    this.#place.input.addEventListener('input', () => {
      const { axis } = this.#view?.section ?? {};
      if (axis) events.setView({ section: { axis, at: this.#place.input.valueAsNumber / SECTION_STEPS } });
    });
    [this.#rods, this.#section] = [rods.box, section.select];
    [this.#faces, this.#up, this.#parallel] = [faces.box, up.select, parallel.box];
    this.element = makeSection(
      words.sections.appearance,
      false,
      field.row,
      map.row,
      faces.row,
      rods.row,
      this.#thickness.row,
      section.row,
      this.#place.row,
      standardViews((from) => events.frameAll(from)),
      parallel.row,
      up.row,
    );
  }

  setDocument({ view }: ChebnetDocument): void {
    this.#view = view;
    const { field, colourMap, showFaces, upAxis, parallel } = view;
    setValue(this.#field, field);
    setValue(this.#map, colourMap);
    this.#mapRow.hidden = fieldOf(field).maps === undefined;
    this.#faces.checked = showFaces;
    setValue(this.#up, upAxis ?? 'z');
    this.#parallel.checked = parallel ?? false;
    this.#setRods(view);
    this.#setSection(view);
  }

  #setRods({ rods }: ViewState): void {
    this.#rods.checked = rods !== undefined;
    this.#thickness.row.hidden = rods === undefined;
    const percent = Math.round(100 * (rods ?? 0));
    this.#thickness.set(percent);
  }

  #setSection({ section }: ViewState): void {
    setValue(this.#section, section?.axis ?? '');
    this.#place.row.hidden = section === undefined;
    const step = Math.round(SECTION_STEPS * (section?.at ?? 0));
    this.#place.set(step);
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

/** Fields for the ends of the colour map, and a button back to the automatic ones: what the legend unfolds. */
import { type ChebnetDocument, lookOf } from '../document/document';
import { make, makeButton, setText, setValue } from '../elements/dom';
import { takeCommas, withPoint } from '../elements/number_input';
import { type Ends, endText } from '../fields/colour_map';
import { areEnds, endsOf, type FieldName, fieldOf, type ShownColouring, scaleOf } from '../fields/fields';
import { lengthError } from '../language/numbers';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import { readTheme } from '../view/theme';
import './map_ends.css';

const TEXT = panelWords.legend;

/** What the ends are measured in; those of other fields are numbers alone. */
const UNITS: Partial<Record<FieldName, (ends: Ends) => string>> = {
  deviation: ([low, high]) => TEXT.inDeviations(lengthError(low), lengthError(high)),
  shear: () => TEXT.inDegrees,
  fold: () => TEXT.inDegrees,
  curvature: () => TEXT.inDegrees,
  angle: () => TEXT.inDegrees,
  height: () => TEXT.inEdges,
};

export class MapEnds implements Panel {
  readonly #unit = make('p', { class: 'unit', id: 'unit-of-ends' });
  readonly #inputs = [TEXT.low, TEXT.high].map((label) => {
    const input = make('input', {
      type: 'text',
      'aria-label': label,
      'aria-describedby': this.#unit.id,
      title: label,
      autocomplete: 'off',
    });
    takeCommas(input);
    input.addEventListener('change', () => this.#read(input));
    return input;
  });
  readonly #automatic = makeButton(TEXT.automatic, () => this.#choose(undefined));
  readonly element = make('div', { class: 'ends' }, this.#unit, ...this.#inputs, this.#automatic);
  #view: ShownColouring = { field: 'deviation', colourMap: 'paper' };
  readonly #setView: PanelEvents['setView'];

  constructor({ setView }: Pick<PanelEvents, 'setView'>) {
    this.#setView = setView;
  }

  setDocument(document: ChebnetDocument): void {
    this.#view = lookOf(document);
    if (fieldOf(this.#view.field).ends === undefined) return;
    const { low, high } = scaleOf(this.#view, readTheme(globalThis.document.documentElement));
    this.#automatic.setAttribute('aria-pressed', String(endsOf(this.#view) === undefined));
    setText(this.#unit, UNITS[this.#view.field]?.([low, high]) ?? '');
    this.#inputs.forEach((input, i) => {
      setValue(input, endText([low, high][i]!));
      input.setCustomValidity('');
    });
  }

  /** Undefined: the automatic ones. */
  #choose(ends: Ends | undefined): void {
    this.#setView({ ends: { ...this.#view.ends, [this.#view.field]: ends } });
  }

  #read(changed: HTMLInputElement): void {
    for (const input of this.#inputs) input.setCustomValidity('');
    const [low = NaN, high = NaN] = this.#inputs.map(({ value }) => numberIn(value.trim()));
    const field = fieldOf(this.#view.field);
    if (areEnds(field, [low, high])) return this.#choose([low, high]);
    changed.setCustomValidity(TEXT.badEnds(field.ends === 'above 0'));
    changed.reportValidity();
  }
}

/** With a comma that did not become a point as it was typed, by an input method. */
function numberIn(text: string): number {
  return text === '' ? NaN : Number(withPoint(text));
}

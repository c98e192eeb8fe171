/** Fields for the ends of the colour map, and a button back to the automatic ones. */
import { type Ends, endText, type Scale } from '../fields/colour_map';
import { areEnds, type ColourField, FIELDS } from '../fields/fields';
import { words } from '../language/language';
import { make, makeButton, setValue } from '../elements/dom';

export class MapEnds {
  readonly element: HTMLElement;
  readonly #inputs = [words.legend.low, words.legend.high].map((label) => {
    const input = make('input', { type: 'text', 'aria-label': label, title: label, autocomplete: 'off' });
    input.addEventListener('change', () => this.#read(input));
    return input;
  });
  readonly #automatic: HTMLButtonElement;
  #field: ColourField = FIELDS.deviation;
  readonly #choose: (ends: Ends | undefined) => void;

  /** @param choose is called with the ends entered; undefined: automatic. */
  constructor(choose: (ends: Ends | undefined) => void) {
    this.#choose = choose;
    this.#automatic = makeButton(words.legend.automatic, () => choose(undefined));
    const row = make('div', { class: 'ends' }, ...this.#inputs, this.#automatic);
    this.element = make('details', {}, make('summary', {}, words.legend.ends), row);
  }

  update(field: ColourField, { low, high }: Scale, byHand: boolean): void {
    this.#field = field;
    this.#automatic.setAttribute('aria-pressed', String(!byHand));
    this.#inputs.forEach((input, i) => {
      setValue(input, endText([low, high][i]!));
      input.setCustomValidity('');
    });
  }

  #read(changed: HTMLInputElement): void {
    for (const input of this.#inputs) input.setCustomValidity('');
    const [low = NaN, high = NaN] = this.#inputs.map(({ value }) => (value.trim() === '' ? NaN : Number(value)));
    if (areEnds(this.#field, [low, high])) return this.#choose([low, high]);
    changed.setCustomValidity(words.legend.badEnds(this.#field.ends === 'above 0'));
    changed.reportValidity();
  }
}

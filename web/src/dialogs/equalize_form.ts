/** Options of equalising: the length of all edges, and whether handles are fixed. */
import type { EqualizeOptions, EqualizeReport } from '../../../wasm/chebnet';
import { dialogWords } from '../language/dialogs';
import { make, makeSwitch, setText } from '../elements/dom';
import { NumberField } from '../elements/number_field';
import { lengthWords } from './file_words';

const TEXT = dialogWords.equalize;
type Choice = 'mean' | 'fitting' | 'given';

export class EqualizeForm {
  readonly element: HTMLFieldSetElement;
  #choice: Choice = 'mean';
  readonly #radios: Record<Choice, HTMLInputElement>;
  readonly #fitting = make('span', {}, TEXT.fitting);
  readonly #number: NumberField;
  readonly #near = makeSwitch(TEXT.near, () => this.#nearChanged());
  readonly #guide = makeSwitch('', () => this.#changed());
  readonly #hold = makeSwitch('', () => this.#holdChanged());
  readonly #changed: () => void;

  /** @param isNear whether the surface counts as long as the user does not say otherwise.
   *  @param guide the name of a surface beside the net; null: there is none.
   *  @param changed is called after every change of the options. */
  constructor(mean: number, handleCount: number, isNear: boolean, guide: string | null, changed: () => void) {
    this.#near.box.checked = isNear || guide !== null;
    this.#guide.box.checked = guide !== null;
    this.#guide.row.hidden = guide === null;
    setText(this.#guide.row.querySelector('span')!, TEXT.guide(guide ?? ''));
    this.#changed = changed;
    this.#number = new NumberField({
      min: 0,
      above: 0,
      step: 'any',
      required: true,
      value: Number(mean.toPrecision(6)),
      'aria-label': TEXT.given,
    });
    this.#number.input.addEventListener('input', () => this.#choose('given'));
    const radio = (value: Choice): HTMLInputElement => {
      const input = make('input', { type: 'radio', name: 'equalize-length', value, checked: value === this.#choice });
      input.addEventListener('change', () => this.#choose(value));
      return input;
    };
    this.#radios = { mean: radio('mean'), fitting: radio('fitting'), given: radio('given') };
    this.#fitting.append(make('small', {}, TEXT.fittingHint));
    setText(this.#hold.row.querySelector('span')!, TEXT.hold(handleCount));
    this.#hold.row.hidden = handleCount === 0;
    this.element = make(
      'fieldset',
      { class: 'lengths' },
      make('legend', {}, TEXT.length),
      make('label', {}, this.#radios.mean, TEXT.mean(lengthWords(mean))),
      make('label', {}, this.#radios.fitting, this.#fitting),
      make(
        'div',
        {},
        make('div', { class: 'given' }, make('label', {}, this.#radios.given, TEXT.given), this.#number.input),
        this.#number.note,
      ),
      this.#near.row,
      this.#guide.row,
      this.#hold.row,
    );
  }

  get method(): 'equilibrium' | 'projection' {
    return this.#near.box.checked ? 'equilibrium' : 'projection';
  }

  get usesGuide(): boolean {
    return this.#near.box.checked && this.#guide.box.checked;
  }

  /** null: the number is not allowed, which stands below it. */
  read(handles: readonly number[]): EqualizeOptions | null {
    const length = this.#choice === 'given' ? this.#number.value : this.#choice;
    if (length !== null) return { length, handles: this.#hold.box.checked ? handles : [], method: this.method };
    this.#number.input.focus();
    return null;
  }

  setBusy(busy: boolean): void {
    this.element.disabled = busy;
  }

  renderFittingLength({ fittingLength }: EqualizeReport): void {
    if (!this.#hold.box.checked) setText(this.#fitting.firstChild!, TEXT.fittingKnown(lengthWords(fittingLength)));
  }

  #choose(choice: Choice): void {
    this.#choice = choice;
    this.#radios[choice].checked = true;
    this.#changed();
  }

  #nearChanged(): void {
    this.#guide.box.disabled = !this.#near.box.checked;
    this.#changed();
  }

  /** Fixed handles determine the size of the net: a length cannot be fitted. */
  #holdChanged(): void {
    this.#radios.fitting.disabled = this.#hold.box.checked;
    this.#choose(this.#hold.box.checked && this.#choice === 'fitting' ? 'mean' : this.#choice);
  }
}

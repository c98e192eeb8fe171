/** Whether handles are soft, and how hard they pull then. */
import type { HandleTraits } from '../handles/commands';
import { panelWords } from '../language/panels';
import { make, makeSwitch, mayBeSet, setText, setValue } from '../elements/dom';
import { small } from '../language/numbers';

/** Weights as powers of ten, and the one a handle begins with. */
const WEIGHTS = { smallest: -2, largest: 2, usual: 1 };

export class Softness {
  readonly rows: HTMLElement[];
  readonly #soft: ReturnType<typeof makeSwitch>;
  readonly #weight = make('input', { type: 'range', min: WEIGHTS.smallest, max: WEIGHTS.largest, step: 0.1 });
  readonly #value = make('output');
  readonly #weightRow = make(
    'label',
    { class: 'slider' },
    make('span', {}, panelWords.handles.weight),
    this.#weight,
    this.#value,
  );

  constructor(change: (traits: HandleTraits) => void) {
    this.#soft = makeSwitch(panelWords.handles.soft, (on) => change({ weight: on ? WEIGHTS.usual : undefined }));
    this.#weight.addEventListener('input', () => setText(this.#value, small(this.#chosen())));
    this.#weight.addEventListener('change', () => change({ weight: this.#chosen() }));
    this.rows = [this.#soft.row, this.#weightRow];
  }

  /** undefined: exact. */
  setWeight(weight: number | undefined): void {
    this.#soft.box.checked = weight !== undefined;
    this.#weightRow.hidden = weight === undefined;
    if (weight === undefined) return;
    setValue(this.#weight, String(Math.log10(weight)));
    if (mayBeSet(this.#weight)) setText(this.#value, small(weight));
  }

  #chosen(): number {
    return Number((10 ** this.#weight.valueAsNumber).toPrecision(2));
  }
}

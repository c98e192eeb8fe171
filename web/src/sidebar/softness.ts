/** Whether handles are soft, and how hard they pull then. */
import type { HandleTraits } from '../handles/commands';
import { panelWords } from '../language/panels';
import { make, makeSwitch, setText } from '../elements/dom';
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
  /** The one that is set. */
  #shown: number | undefined;
  /** The slider has been moved, but not let go. */
  #isMoving = false;

  constructor(change: (traits: HandleTraits) => void) {
    this.#soft = makeSwitch(panelWords.handles.soft, (on) => change({ weight: on ? WEIGHTS.usual : undefined }));
    this.#weight.addEventListener('input', () => {
      this.#isMoving = true;
      setText(this.#value, small(this.#chosen()));
    });
    this.#weight.addEventListener('change', () => {
      this.#isMoving = false;
      change({ weight: this.#chosen() });
    });
    this.#weight.addEventListener('blur', () => {
      this.#isMoving = false;
      this.setWeight(this.#shown);
    });
    this.rows = [this.#soft.row, this.#weightRow];
  }

  /** undefined: exact. */
  setWeight(weight: number | undefined): void {
    this.#shown = weight;
    this.#soft.box.checked = weight !== undefined;
    this.#weightRow.hidden = weight === undefined;
    if (weight === undefined || this.#isMoving) return;
    this.#weight.valueAsNumber = Math.log10(weight);
    setText(this.#value, small(weight));
  }

  #chosen(): number {
    return Number((10 ** this.#weight.valueAsNumber).toPrecision(2));
  }
}

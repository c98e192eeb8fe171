/** A field for a number. What is allowed stands below it in words while it holds something else: browsers only mark it, or
 *  say so for a moment and in their own language. */
import { count } from '../language/numbers';
import { panelWords } from '../language/panels';
import { type Attributes, make, mayBeSet, setApplied, setText } from './dom';
import { makeNumberInput } from './number_input';

const TEXT = panelWords.allowed;

/** For the ids of the notes. */
let made = 0;

export class NumberField {
  readonly input: HTMLInputElement;
  /** To be placed below the field. */
  readonly note = make('p', { class: 'allowed', role: 'status', id: `allowed-${++made}` });
  /** Numbers must be above it. */
  readonly #above: number;
  readonly #reason: string;

  /** @param attributes as of an input, with `above` for a limit that is not allowed itself.
   *  @param reason a sentence on why no other numbers are allowed. */
  constructor({ above = -Infinity, ...attributes }: Attributes & { above?: number }, reason = '') {
    this.#above = above;
    this.#reason = reason;
    this.input = makeNumberInput(attributes);
    this.input.addEventListener('change', () => {
      setApplied(this.input, this.#isAllowed);
      this.#say();
    });
    this.input.addEventListener('input', () => {
      if (this.#isAllowed) this.#say();
    });
    // What a browser would say of it when a form is sent.
    this.input.addEventListener('invalid', (event) => {
      event.preventDefault();
      this.#say();
    });
  }

  /** NaN: the field is empty. Null: what it holds is not allowed. */
  get value(): number | null {
    return this.#isAllowed ? this.input.valueAsNumber : null;
  }

  /** Unless the user may be typing there. */
  set(value: string): void {
    if (mayBeSet(this.input)) this.put(value);
  }

  /** Whether it has the focus or not. */
  put(value: string): void {
    if (this.input.value !== value) this.input.value = value;
    if (this.#isAllowed) this.#say();
  }

  get #isAllowed(): boolean {
    return this.input.validity.valid && !(this.input.valueAsNumber <= this.#above);
  }

  /** What is allowed; nothing, if it is. */
  #say(): void {
    const isAllowed = this.#isAllowed;
    setText(this.note, isAllowed ? '' : this.#allowed);
    for (const [name, value] of [
      ['aria-invalid', 'true'],
      ['aria-describedby', this.note.id],
    ] as const) {
      if (isAllowed) this.input.removeAttribute(name);
      else this.input.setAttribute(name, value);
    }
  }

  get #allowed(): string {
    const { min, max, step } = this.input;
    const above = Number.isFinite(this.#above) ? TEXT.above(spoken(this.#above)) : '';
    const range = above || rangeWords(min && spoken(Number(min)), max && spoken(Number(max)));
    return step === 'any' ? TEXT.number(range, this.#reason) : TEXT.whole(range, this.#reason);
  }
}

/** Each end may be missing. */
function rangeWords(least: string, most: string): string {
  if (least && most) return TEXT.fromTo(least, most);
  return least ? TEXT.atLeast(least) : most && TEXT.atMost(most);
}

/** As large numbers are read, and small ones typed. */
function spoken(value: number): string {
  return Number.isInteger(value) ? count(value) : String(value);
}

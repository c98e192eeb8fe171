/** Sliders for the parameters of the present shape. */
import type { ShapeInfo, ShapeParameter } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { make, setText } from '../elements/dom';
import { formatRecipe, fromSlider, parseRecipe, SLIDER_STEPS, toSlider, type Recipe } from './recipe';
import { count } from '../language/numbers';
import './gallery.css';

interface Slider {
  parameter: ShapeParameter;
  input: HTMLInputElement;
  output: HTMLOutputElement;
}

export class ShapeParameters {
  readonly element = make('div', { class: 'parameters' });
  #shown: string | null = null;
  #shape: ShapeInfo | null = null;
  #sliders: readonly Slider[] = [];
  /** Of the net that is open. */
  #recipe: Recipe | null = null;
  /** What was asked for last; null: that is open. */
  #asked: Recipe | null = null;
  /** In hand: moved, and not yet let go. */
  #held: HTMLInputElement | null = null;
  readonly #open: (recipe: string) => Promise<void>;

  /** @param open resolves once the last recipe that was asked for is open, or refused. */
  constructor(open: (recipe: string) => Promise<void>) {
    this.#open = open;
  }

  /** null: the net is from a file. */
  setRecipe(text: string | null, shapes: readonly ShapeInfo[]): void {
    const recipe = text === null ? null : parseRecipe(text);
    const shape = shapes.find(({ name }) => name === recipe?.name) ?? null;
    const key = shape && text;
    if (key === this.#shown) return;
    this.#shown = key;
    this.#recipe = recipe;
    if (shape !== this.#shape) this.#makeSliders(shape);
    this.#show();
  }

  #makeSliders(shape: ShapeInfo | null): void {
    this.#shape = shape;
    this.#asked = null;
    this.#held = null;
    // Where undo leads to another shape, a parameter that both have keeps the focus.
    const focused = (document.activeElement as HTMLElement | null)?.dataset['parameter'];
    this.#sliders = shape?.parameters.map((parameter) => this.#makeSlider(parameter)) ?? [];
    this.element.replaceChildren(
      ...this.#sliders.map(({ parameter, input, output }) =>
        make('label', { class: 'slider' }, make('span', {}, words.core.parameter(parameter.name)), input, output),
      ),
    );
    this.#sliders.find(({ parameter }) => parameter.name === focused)?.input.focus();
  }

  #makeSlider(parameter: ShapeParameter): Slider {
    const input = make('input', { type: 'range', min: 0, max: SLIDER_STEPS, 'data-parameter': parameter.name });
    const slider = { parameter, input, output: make('output') };
    const value = (): number => fromSlider(parameter, input.valueAsNumber);
    input.addEventListener('input', () => {
      this.#held = input;
      tell(slider, value());
    });
    // Let go where it was taken, it does not change.
    for (const end of ['change', 'pointerup', 'blur']) input.addEventListener(end, () => (this.#held = null));
    input.addEventListener('change', () => void this.#ask({ [parameter.name]: value() }));
    return slider;
  }

  /** The net that is asked for has what has just been asked for of other parameters, too. */
  async #ask(change: Recipe['values']): Promise<void> {
    const before = this.#asked ?? this.#recipe!;
    const asked = { ...before, values: { ...before.values, ...change } };
    this.#asked = asked;
    await this.#open(formatRecipe(asked, this.#shape!));
    if (asked !== this.#asked) return;
    this.#asked = null;
    this.#show();
  }

  #show(): void {
    for (const slider of this.#sliders) {
      const { parameter, input } = slider;
      // One that is in hand, or that keys move, is ahead of the net.
      if (input === this.#held || (this.#asked !== null && input === document.activeElement)) continue;
      const value = this.#recipe?.values[parameter.name] ?? parameter.value;
      input.value = String(toSlider(parameter, value));
      tell(slider, value);
    }
  }
}

function tell({ input, output }: Slider, value: number): void {
  input.setAttribute('aria-valuetext', count(value));
  setText(output, count(value));
}

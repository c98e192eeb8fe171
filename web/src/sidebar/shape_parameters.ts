/** Sliders for the parameters of the present shape. */
import type { ShapeInfo, ShapeParameter } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { make } from '../elements/dom';
import { formatRecipe, fromSlider, parseRecipe, SLIDER_STEPS, toSlider, type Recipe } from './recipe';
import { count } from '../language/numbers';
import './gallery.css';

export class ShapeParameters {
  readonly element = make('div', { class: 'parameters' });
  #shown = '';
  readonly #open: (recipe: string) => void;

  constructor(open: (recipe: string) => void) {
    this.#open = open;
  }

  /** null: the net is from a file. */
  setRecipe(text: string | null, shapes: ShapeInfo[]): void {
    const recipe = text === null ? null : parseRecipe(text);
    const shape = shapes.find(({ name }) => name === recipe?.name);
    const key = shape ? text! : '';
    if (key === this.#shown) return;
    this.#shown = key;
    // Keeps the slider that has the focus: it is being moved by keys.
    const focused = (document.activeElement as HTMLElement | null)?.dataset.parameter;
    this.element.replaceChildren(
      ...(recipe && shape ? shape.parameters.map((parameter) => this.#slider(parameter, recipe, shape)) : []),
    );
    if (focused) this.element.querySelector<HTMLElement>(`[data-parameter="${focused}"]`)?.focus();
  }

  #slider(parameter: ShapeParameter, recipe: Recipe, shape: ShapeInfo): HTMLElement {
    const value = recipe.values[parameter.name] ?? parameter.value;
    const input = make('input', {
      type: 'range',
      min: 0,
      max: SLIDER_STEPS,
      value: toSlider(parameter, value),
      'data-parameter': parameter.name,
      'aria-valuetext': count(value),
    });
    const output = make('output', {}, count(value));
    input.addEventListener('input', () => {
      const text = count(fromSlider(parameter, input.valueAsNumber));
      output.value = text;
      input.setAttribute('aria-valuetext', text);
    });
    input.addEventListener('change', () => {
      const values = { ...recipe.values, [parameter.name]: fromSlider(parameter, input.valueAsNumber) };
      this.#open(formatRecipe({ name: recipe.name, values }, shape));
    });
    return make('label', { class: 'slider' }, make('span', {}, words.core.parameter(parameter.name)), input, output);
  }
}

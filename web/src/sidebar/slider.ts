import { make } from '../elements/dom';

/** A slider of whole steps with its value in words; `chosen` is called when it is released. */
export function makeSlider(label: string, steps: number, chosen: () => void) {
  const input = make('input', { type: 'range', min: 0, max: steps, step: 1, value: 0 });
  const output = make('output');
  input.addEventListener('change', chosen);
  const set = (step: number, text: string): void => {
    if (input.valueAsNumber !== step) input.valueAsNumber = step;
    output.value = text;
    input.setAttribute('aria-valuetext', text);
  };
  return { row: make('label', { class: 'slider' }, make('span', {}, label), input, output), input, set };
}

import { make } from '../elements/dom';

/** A slider of whole steps with its value in words, which follow it; `chosen` is called with the step when it is released. */
export function makeSlider(
  label: string,
  steps: number,
  textOf: (step: number) => string,
  chosen: (step: number) => void,
) {
  const input = make('input', { type: 'range', min: 0, max: steps, step: 1, value: 0 });
  const output = make('output');
  const write = (text: string): void => {
    output.value = text;
    input.setAttribute('aria-valuetext', text);
  };
  input.addEventListener('input', () => write(textOf(input.valueAsNumber)));
  input.addEventListener('change', () => chosen(input.valueAsNumber));
  const set = (step: number, text = textOf(step)): void => {
    if (input.valueAsNumber !== step) input.valueAsNumber = step;
    write(text);
  };
  return { row: make('label', { class: 'slider' }, make('span', {}, label), input, output), input, set };
}

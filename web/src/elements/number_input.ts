/** Input elements for numbers. */
import { type Attributes, make, setApplied } from './dom';

/** A number with a comma for its decimal point, alone. */
const COMMA = /^[+-]?\d*,\d*$/;
/** In thousands, more likely. */
const THOUSANDS = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** Takes a comma for a decimal point, typed or pasted: browsers of other languages drop it, and 0,3 becomes 03. */
export function makeNumberInput(attributes: Attributes): HTMLInputElement {
  const input = make('input', { type: 'number', ...attributes });
  input.addEventListener('beforeinput', (event) => {
    const text = event.data?.trim() ?? '';
    if (!COMMA.test(text) || THOUSANDS.test(text)) return;
    event.preventDefault();
    // The only way in that goes to where the caret is: inputs for numbers do not tell where.
    document.execCommand('insertText', false, text.replace(',', '.'));
  });
  input.addEventListener('input', () => setApplied(input, false));
  input.addEventListener('change', () => setApplied(input, input.validity.valid));
  return input;
}

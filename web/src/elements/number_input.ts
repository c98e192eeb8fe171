/** Input elements for numbers. */
import { type Attributes, make, setApplied } from './dom';

/** A number with a comma for its decimal point, alone. */
const COMMA = /^[+-]?\d*,\d*(e[+-]?\d+)?$/i;
/** In thousands, more likely. */
const THOUSANDS = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** With a point for a decimal comma. */
export function withPoint(text: string): string {
  const isDecimal = COMMA.test(text) && !THOUSANDS.test(text);
  return isDecimal ? text.replace(',', '.') : text;
}

/** Takes a comma for a decimal point, typed or pasted: browsers of other languages drop it, and 0,3 becomes 03. */
export function makeNumberInput(attributes: Attributes): HTMLInputElement {
  const input = make('input', { type: 'number', ...attributes });
  takeCommas(input);
  input.addEventListener('input', () => setApplied(input, false));
  input.addEventListener('change', () => setApplied(input, input.validity.valid));
  return input;
}

/** As what is typed, or pasted, into an input for numbers: a comma typed alone is a point, also before three digits. */
export function takeCommas(input: HTMLInputElement): void {
  input.addEventListener('beforeinput', (event) => {
    const text = event.data?.trim() ?? '';
    const pointed = withPoint(text);
    // What an input method composes goes in whatever is done here.
    if (pointed === text || !event.cancelable) return;
    event.preventDefault();
    // The only way in that goes to where the caret is: inputs for numbers do not tell where.
    document.execCommand('insertText', false, pointed);
  });
}

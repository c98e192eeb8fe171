/** Keys, as tables of them write them. */
import type { Words } from '../language/language';

/** What some keys do, each of them alone. Such tables stand beside the code that handles the keys. */
export interface KeyRow {
  /** Keys held together are joined by `+`. */
  keys: readonly string[];
  does: keyof Words['keys']['does'];
}

/** As the table writes it. Shift counts with letters only: other signs say themselves whether they need it. */
export function chordOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): string {
  const isLetter = /^\p{L}$/u.test(key);
  const name = isLetter ? key.toUpperCase() : key === 'Escape' ? 'Esc' : key;
  const held = [ctrlKey && 'Ctrl+', altKey && 'Alt+', metaKey && '⌘+', shiftKey && isLetter && 'Shift+'];
  return [...held, name].filter(Boolean).join('');
}

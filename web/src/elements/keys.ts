/** Tables of keyboard shortcuts. */
import type { panelWords } from '../language/panels';

/** A command and the keys that each trigger it. Such tables stand beside the code that handles the keys. */
export interface KeyRow {
  /** Keys held together are joined by `+`. */
  keys: readonly string[];
  does: keyof (typeof panelWords)['keys']['does'];
}

/** The key of an event as the tables write it. Shift is named with letters only: other characters imply it. */
export function chordOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): string {
  const isLetter = /^\p{L}$/u.test(key);
  const name = isLetter ? key.toUpperCase() : key === 'Escape' ? 'Esc' : key;
  const held = [ctrlKey && 'Ctrl+', altKey && 'Alt+', metaKey && '⌘+', shiftKey && isLetter && 'Shift+'];
  return [...held, name].filter(Boolean).join('');
}

/** Tables of keyboard shortcuts. */
import type { panelWords } from '../language/panels';

/** A command and the keys that each trigger it. Such tables stand beside the code that handles the keys. */
export interface KeyRow {
  /** Keys held together are joined by `+`. */
  keys: readonly string[];
  does: keyof (typeof panelWords)['keys']['does'];
}

/** Where arrow keys lead on the screen: right and down. */
export const ARROW_KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What Cyrillic, Greek and other keyboards write that have no letters of the tables. */
const OTHER_SCRIPT = /^(?!\p{Script=Latin})[\p{L}\p{M}]$/u;

/** The key of an event as the tables write it. Shift is named with letters only: other characters imply it. */
export function chordOf({ key, code, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): string {
  const latin = OTHER_SCRIPT.test(key) ? code.replace(/^Key/, '') : key;
  const isLetter = /^\p{L}$/u.test(latin);
  const name = isLetter ? latin.toUpperCase() : latin === 'Escape' ? 'Esc' : latin;
  const held = [ctrlKey && 'Ctrl+', altKey && 'Alt+', metaKey && '⌘+', shiftKey && isLetter && 'Shift+'];
  return [...held, name].filter(Boolean).join('');
}

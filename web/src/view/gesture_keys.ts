/** Tables of what keys, Escape and the pointer with Shift do in gestures.ts, for the sheet of keys. */
import type { KeyRow } from '../elements/keys';
import { words } from '../language/language';

export const VIEW_KEYS: readonly KeyRow[] = [
  { keys: ['← → ↑ ↓'], does: 'turn' },
  { keys: ['Shift+← → ↑ ↓'], does: 'pan' },
  { keys: ['+', '−'], does: 'zoom' },
  { keys: ['Home'], does: 'frame' },
];
export const SELECTION_KEYS: readonly KeyRow[] = [
  { keys: ['← → ↑ ↓'], does: 'nudge' },
  { keys: ['Shift+← → ↑ ↓'], does: 'bigNudge' },
  { keys: [`Shift+${words.keys.click}`], does: 'toggle' },
  { keys: [`Shift+${words.keys.drag}`], does: 'box' },
  { keys: ['Esc'], does: 'cancel' },
];

/** Tables of what keys, Escape and the pointer with Shift do in gestures.ts and pen.ts, for the sheet of keys. */
import type { KeyRow } from '../elements/keys';
import { panelWords } from '../language/panels';

const { click, dragging, space } = panelWords.keys;

export const VIEW_KEYS: readonly KeyRow[] = [
  { keys: ['← → ↑ ↓'], does: 'turn' },
  { keys: ['Shift+← → ↑ ↓'], does: 'pan' },
  { keys: ['+', '−'], does: 'zoom' },
  { keys: ['Home'], does: 'frame' },
];
export const SELECTION_KEYS: readonly KeyRow[] = [
  { keys: ['← → ↑ ↓'], does: 'nudge' },
  { keys: ['Shift+← → ↑ ↓'], does: 'bigNudge' },
  { keys: [`Shift+${click}`], does: 'toggle' },
  { keys: [`Shift+${dragging}`], does: 'box' },
  { keys: ['Esc'], does: 'cancel' },
];
export const PEN_KEYS: readonly KeyRow[] = [
  { keys: ['← → ↑ ↓'], does: 'movePen' },
  { keys: ['Shift+← → ↑ ↓'], does: 'movePenFar' },
  { keys: [space, 'Enter'], does: 'setPenDown' },
  { keys: ['Esc'], does: 'putPenAway' },
];

/** Whether keys of a single letter, number or sign do something wherever the focus is. Who speaks to the computer, or strikes
 *  keys by mistake, switches them off (WCAG 2.1.4). */
const KEY = 'chebnet.singleKeys';

/** Of this visit, where storage is switched off. */
let isOn = true;

export function areSingleKeysOn(): boolean {
  try {
    return localStorage.getItem(KEY) !== 'off';
  } catch {
    return isOn;
  }
}

export function setSingleKeys(on: boolean): void {
  isOn = on;
  try {
    if (on) localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, 'off');
  } catch {
    // As above.
  }
}

/** Whether a key, as tables write it, is one of those. */
export function isSingleKey(chord: string): boolean {
  return [...chord].length === 1;
}

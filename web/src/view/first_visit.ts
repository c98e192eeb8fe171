/** Whether this visitor has ever dragged a handle here; until then one handle beckons. */
const KEY = 'chebnet.dragged';

export function isFirstVisit(): boolean {
  try {
    return localStorage.getItem(KEY) === null;
  } catch {
    return true; // Storage is switched off.
  }
}

export function endFirstVisit(): void {
  try {
    localStorage.setItem(KEY, '1');
  } catch {
    // Storage is switched off: it will beckon again, which does no harm.
  }
}

/** Whether this visitor has ever dragged a handle here; until then one handle is pointed out. */
const KEY = 'chebnet.dragged';

export function isFirstVisit(): boolean {
  try {
    return localStorage.getItem(KEY) === null;
  } catch {
    return true; // Storage is disabled.
  }
}

export function endFirstVisit(): void {
  try {
    localStorage.setItem(KEY, '1');
  } catch {
    // Storage is disabled: it is pointed out again on the next visit, which does no harm.
  }
}

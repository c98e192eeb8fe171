/** Says what is being opened by itself, a link or a kept project, until it has settled. A mark that is still there when
 *  the page starts means that the page died of it. */
const KEY = 'chebnet.opening';

export function setMark(what: string): void {
  try {
    localStorage.setItem(KEY, what);
  } catch {
    // Storage is switched off: then nothing is kept that could open by itself.
  }
}

export function clearMark(): void {
  try {
    localStorage.removeItem(KEY);
  } catch {
    // As above.
  }
}

export function isMarked(what: string): boolean {
  try {
    return localStorage.getItem(KEY) === what;
  } catch {
    return false;
  }
}

/** Says what is being opened by itself, a link or a kept project, until it has settled. A flag that is still there when
 *  the page starts means that the page died of it. */
const KEY = 'chebnet.opening';

export function setCrashFlag(what: string): void {
  try {
    localStorage.setItem(KEY, what);
  } catch {
    // Storage is switched off: then nothing is kept that could open by itself.
  }
}

export function clearCrashFlag(): void {
  try {
    localStorage.removeItem(KEY);
  } catch {
    // As above.
  }
}

export function hasCrashFlag(what: string): boolean {
  try {
    return localStorage.getItem(KEY) === what;
  } catch {
    return false;
  }
}

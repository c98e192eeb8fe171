/** Names what is being opened without a question, a link or a kept project, until it has settled. A flag that is still set
 *  when the page starts means that opening it crashed the page. */
const KEY = 'chebnet.opening';

export function setCrashFlag(what: string): void {
  try {
    localStorage.setItem(KEY, what);
  } catch {
    // Storage is disabled: then nothing is kept that could open by itself.
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

/** Which language the visitor reads. */
export type Language = 'en' | 'zh';
const CHOICE = 'chebnet.language';

/** As chosen on an earlier visit, or else as the browser wants it. */
export function preferredLanguage(): Language {
  const wanted = earlierChoice() ?? globalThis.navigator?.language ?? 'en';
  return wanted.toLowerCase().startsWith('zh') ? 'zh' : 'en';
}

function earlierChoice(): string | null {
  try {
    return globalThis.localStorage?.getItem(CHOICE) ?? null;
  } catch {
    return new URLSearchParams(location.search).get(CHOICE); // Storage is switched off.
  }
}

/** Counts from the next load of the page. */
export function chooseLanguage(language: Language): void {
  try {
    localStorage.setItem(CHOICE, language);
  } catch {
    // Storage is switched off: the address keeps it.
    const address = new URL(location.href);
    address.searchParams.set(CHOICE, language);
    history.replaceState(null, '', address);
  }
}

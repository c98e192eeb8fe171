/** Which language the visitor reads. */
export type Language = 'en' | 'zh';
const CHOICE = 'chebnet.language';

/** As chosen on an earlier visit, or else as the browser wants it. */
export function preferredLanguage(): Language {
  const wanted = earlierChoice() ?? globalThis.navigator?.language ?? 'en';
  return wanted.toLowerCase().startsWith('zh') ? 'zh' : 'en';
}

/** The address says it where the browser could not store it, though it may read what it stored before. */
function earlierChoice(): string | null {
  try {
    return (
      new URLSearchParams(globalThis.location?.search).get(CHOICE) ?? globalThis.localStorage?.getItem(CHOICE) ?? null
    );
  } catch {
    return null; // Storage is switched off.
  }
}

/** Counts from the next load of the page. */
export function chooseLanguage(language: Language): void {
  const address = addressForOthers();
  try {
    localStorage.setItem(CHOICE, language);
  } catch {
    // Storage is switched off or full: the address keeps it.
    address.searchParams.set(CHOICE, language);
  }
  history.replaceState(null, '', address);
}

/** That of the page without the choice: whoever follows a link has one of their own. */
export function addressForOthers(): URL {
  const address = new URL(location.href);
  // Deleting what is not there would write the others anew.
  if (address.searchParams.has(CHOICE)) address.searchParams.delete(CHOICE);
  return address;
}

/** Every sentence the page says, in the visitor's language. Workers say theirs in English, with a code: see `words.core`. */
import { en } from './en';

/** What every language must have: the same names, texts where English has texts, functions where it has functions. */
export type Words = Widened<typeof en>;
type Widened<T> = T extends (...given: infer Given) => infer Result
  ? (...given: Given) => Result extends string ? string : Result
  : T extends string
    ? string
    : { [K in keyof T]: Widened<T[K]> };

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
    return null; // Storage is switched off.
  }
}

/** Counts from the next load of the page. */
export function chooseLanguage(language: Language): void {
  try {
    localStorage.setItem(CHOICE, language);
  } catch {
    // Storage is switched off: the browser's language stays.
  }
}

export const language = preferredLanguage();
export const words: Words = language === 'zh' ? (await import('./zh')).zh : en;

/** Puts what stands in the document itself in that language. */
export function translateDocument(document: Document): void {
  document.documentElement.lang = words.locale;
  document.title = words.page.title;
  document.querySelector('meta[name=description]')?.setAttribute('content', words.page.description);
  if (language !== 'en') document.querySelector('link[rel=manifest]')?.setAttribute('href', `./manifest.${language}.webmanifest`);
  document.querySelector('#beside')?.setAttribute('aria-label', words.comparison.net);
}

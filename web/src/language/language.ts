/** Every sentence the page says, in the visitor's language. */
import { en } from './en';
import { zh } from './zh';

/** What every language must have: the same names, texts where English has texts, functions where it has functions. */
export type Words = Widened<typeof en>;
type Widened<T> = { [K in keyof T]: T[K] extends string ? string : T[K] extends (...given: infer G) => string ? (...given: G) => string : Widened<T[K]> };

export type Language = 'en' | 'zh';
const LANGUAGES: Record<Language, Words> = { en, zh };
const CHOICE = 'chebnet.language';

/** As chosen on an earlier visit, or else as the browser wants it. */
export function preferredLanguage(): Language {
  const chosen = globalThis.localStorage?.getItem(CHOICE) ?? globalThis.navigator?.language ?? 'en';
  return chosen.toLowerCase().startsWith('zh') ? 'zh' : 'en';
}

/** Counts from the next load of the page. */
export function chooseLanguage(language: Language): void {
  localStorage.setItem(CHOICE, language);
}

export const language = preferredLanguage();
export const words: Words = LANGUAGES[language];

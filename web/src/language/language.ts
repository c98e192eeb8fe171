/** Every sentence the page says, in the visitor's language. Workers say theirs in English, with a code: see `words.core`. */
import { preferredLanguage } from './choice';
import type { Words } from './words';

export type { Words } from './words';

export const language = preferredLanguage();
export const words: Words = language === 'zh' ? (await import('./zh')).zh : (await import('./en')).en;

/** Puts what stands in the document itself in that language. */
export function translateDocument(document: Document): void {
  document.documentElement.lang = words.locale;
  document.title = words.page.title;
  document.querySelector('meta[name=description]')?.setAttribute('content', words.page.description);
  if (language !== 'en')
    document.querySelector('link[rel=manifest]')?.setAttribute('href', `./manifest.${language}.webmanifest`);
}

/** The languages, each by its own name; another one counts when the page has loaded again, which it does at once. */
import { chooseLanguage, language, words } from '../language/language';
import type { Language } from '../language/language';
import { make, makeButton } from './dom';

const NAMES: readonly [Language, string][] = [
  ['en', 'English'],
  ['zh', '中文'],
];

export function makeLanguageChoice(): HTMLElement {
  const buttons = NAMES.map(([each, name]) =>
    makeButton(name, () => choose(each), { class: 'plain', lang: each, 'aria-pressed': String(each === language) }),
  );
  return make('footer', { class: 'languages', role: 'group', 'aria-label': words.page.language }, ...buttons);
}

function choose(wanted: Language): void {
  if (wanted === language) return;
  chooseLanguage(wanted);
  location.reload();
}

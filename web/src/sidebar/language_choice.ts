/** The languages, each by its own name. */
import type { Language } from '../language/choice';
import { language, words } from '../language/language';
import { make, makeButton } from '../elements/dom';

const NAMES: readonly [Language, string][] = [
  ['en', 'English'],
  ['zh', '中文'],
];

/** `choose` is called with another language than the present one. */
export function makeLanguageChoice(choose: (language: Language) => void): HTMLElement {
  const buttons = NAMES.map(([each, name]) =>
    makeButton(name, () => each !== language && choose(each), {
      class: 'plain',
      lang: each,
      'aria-pressed': String(each === language),
    }),
  );
  return make('footer', { class: 'languages', role: 'group', 'aria-label': words.page.language }, ...buttons);
}

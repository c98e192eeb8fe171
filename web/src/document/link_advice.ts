/** What is to be said of a link that was made. */
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { HUGE_LINK, LONG_LINK, type Shared } from './share';

/** What to tell a user about the link just made, or null if there is nothing to tell. */
export function linkAdvice(shared: Shared): string | null {
  if (shared.hash === null) return panelWords.link.tooLarge;
  const advice = sizeAdvice(shared);
  if (shared.surface !== false) return advice;
  return advice === null
    ? panelWords.link.withoutSurface
    : words.core.sentences([panelWords.link.withoutSurface, advice]);
}

function sizeAdvice(shared: Extract<Shared, { hash: string }>): string | null {
  const size = shared.hash.length.toLocaleString(words.locale);
  if (!shared.positions) return panelWords.link.withoutShape(size);
  if (shared.hash.length > HUGE_LINK) return panelWords.link.huge(size);
  if (shared.hash.length > LONG_LINK) return panelWords.link.long(size);
  return null;
}

import { setText } from '../elements/dom';

/** What a button that was just pressed asks for, below it, may lie beyond the end of what scrolls. */
export function sayInSight(words: HTMLElement, sentence: string): void {
  setText(words, sentence);
  if (sentence !== '') words.scrollIntoView({ block: 'nearest' });
}

/** What the core knows by its name: a method, say, or a recipe with all its parameters. */
import type { Untrusted } from './untrusted';

const LONGEST = 1000;

export function readCoreName(text: Untrusted): string {
  return text.text(LONGEST);
}

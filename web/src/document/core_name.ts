/** What the core knows by its name: a method, say, or a recipe with all its parameters. */
import { words } from '../language/language';
import type { Untrusted } from './untrusted';

const LONGEST = 1000;

export function readCoreName(text: Untrusted): string {
  return text.text(LONGEST);
}

/** As people type it: its shape may be called as its button says, too. */
export function readRecipe(text: Untrusted): string {
  const [shape = '', ...parameters] = readCoreName(text).split(':');
  const called = shape.trim().toLowerCase();
  const [name = called] = Object.entries(words.core.shapes()).find(([, title]) => title === called) ?? [];
  return [name, ...parameters].join(':');
}

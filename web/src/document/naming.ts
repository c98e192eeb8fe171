/** What the history calls a change, so that it can be said in any language: a sentence of `panelWords.changes`, and what it
 *  speaks of. In projects of older versions it is the words themselves. Loaded after the first picture. */
import { words } from '../language/language';
import { lengthText, limitText } from '../language/numbers';
import { panelWords } from '../language/panels';
import type { Untrusted } from './untrusted';

export type ChangeName = string | readonly [Sentence, ...Term[]];
type Sentence = Exclude<keyof typeof panelWords.changes, 'one' | 'several'>;
/** A text as it stands, or one of these kinds of things. */
export type Term = string | { readonly [Kind in keyof typeof KINDS]?: string };

/** Settings that a panel has in words of its own: how it calls them, and their values, among them the usual one, where that is
 *  the same for all methods. */
const SETTINGS = new Map<string, { label: string; usual?: string; textOf(value: string): string | undefined }>([
  ['length_scale', { label: words.behaviour.length, usual: '1', textOf: (scale) => lengthText(Number(scale)) }],
  ['shear_limit', { label: words.behaviour.limit, textOf: (degrees) => limitText(Number(degrees)) }],
  [
    'guide_mode',
    {
      label: panelWords.guide.mode,
      usual: '1',
      textOf: (mode): string | undefined => panelWords.guide.modes[Number(mode)],
    },
  ],
  [
    'square_corners',
    {
      label: panelWords.material.quads,
      usual: 'false',
      textOf: (isOn) => panelWords.material.choices[isOn === 'true' ? 'square' : 'atRest'],
    },
  ],
]);

const KINDS = {
  shape: (name: string) => words.core.shapes()[name] ?? name,
  /** One of the core's own. */
  surface: (name: string) => panelWords.guide.own[name as keyof typeof panelWords.guide.own] ?? name,
  method: words.core.method,
  option: (name: string) => SETTINGS.get(name)?.label ?? panelWords.solver.optionName(name),
  behaviour: (name: string) => words.behaviour.choices[name as keyof typeof words.behaviour.choices] ?? name,
  /** By its name, or its vertex. */
  handle: panelWords.changes.one,
  handles: (count: string) => panelWords.changes.several(Number(count)),
  number: (value: string) => Number(value).toLocaleString(words.locale),
};
/** Characters of the words, and of what they speak of. */
const LONGEST = 500;

/** In the present language. */
export function sentenceOf(name: ChangeName): string {
  if (typeof name === 'string') return name;
  const [key, ...terms] = name;
  const usual = key === 'optionBack' ? settingOf(terms[0]!)?.usual : undefined;
  if (usual !== undefined) return sentenceOf(['option', terms[0]!, usual]);
  const sentence = panelWords.changes[key];
  if (typeof sentence === 'string') return sentence;
  const said = terms.map(textOf);
  if (key === 'option') said[1] = settingOf(terms[0]!)?.textOf(said[1]!) ?? said[1]!;
  return (sentence as (...said: string[]) => string)(...said);
}

function settingOf(term: Term) {
  return typeof term === 'string' ? undefined : SETTINGS.get(term.option ?? '');
}

/** In the present language. What every object inherits is in all tables, and names nothing of ours. */
export function textOf(term: Term): string {
  if (typeof term === 'string') return term;
  return Object.entries(term)
    .map(([kind, value]) => (value in Object.prototype ? value : KINDS[kind as keyof typeof KINDS](value)))
    .join('');
}

/** As fields of an entry. Versions that know no more than the words find them. */
export function writeName(name: ChangeName): object {
  return typeof name === 'string' ? { name } : { name: sentenceOf(name), change: name };
}

/** The words, if there is no more or if it comes from a newer version. Throws a Failure that says what is wrong, and where. */
export function readName(entry: Untrusted): ChangeName {
  const name = entry.at('name').name(LONGEST);
  const { value } = entry.at('change');
  return isKnown(value) ? value : name;
}

function isKnown(change: unknown): change is ChangeName {
  if (!Array.isArray(change) || !Object.hasOwn(panelWords.changes, String(change[0]))) return false;
  const sentence: unknown = panelWords.changes[change[0] as Sentence];
  const wanted = typeof sentence === 'function' ? sentence.length : 0;
  return change.length === 1 + wanted && change.slice(1).every(isTerm);
}

function isTerm(term: unknown): boolean {
  if (typeof term === 'string') return term.length <= LONGEST;
  if (typeof term !== 'object' || term === null) return false;
  return Object.entries(term).every(
    ([kind, value]) => Object.hasOwn(KINDS, kind) && typeof value === 'string' && value.length <= LONGEST,
  );
}

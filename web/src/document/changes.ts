/** Changes of a document, as the history names them. */
import { words } from '../language/language';
import type { HandleData, NetSource, SolverSettings } from './document';

/** A file by its name, a recipe by that of its shape. */
export function netTitle(net: NetSource): string {
  return 'recipe' in net ? words.core.shape(net.recipe.split(':')[0] ?? '') : net.name;
}

/** One of the handles by its name or vertex, several by their number. */
export function handlesTitle(handles: readonly HandleData[], of: readonly { vertex: number }[]): string {
  const [first, ...more] = of;
  if (first === undefined || more.length > 0) return words.history.several(of.length);
  return words.history.one(handles.find(({ vertex }) => vertex === first.vertex)?.name ?? String(first.vertex));
}

export function traitsChange(traits: { [Trait in keyof HandleData]?: HandleData[Trait] | undefined }, who: string): string {
  const { history } = words;
  if ('anchor' in traits) return (traits.anchor ? history.lock : history.unlock)(who);
  if ('hidden' in traits) return (traits.hidden ? history.hide : history.show)(who);
  if ('weight' in traits) return (traits.weight === undefined ? history.harden : history.soften)(who);
  return history.rename(who);
}

export interface NamedChange {
  name: string;
  /** Changes of one key are one entry of the history; null: an entry of its own. */
  key: string | null;
}

/** Another net; or the same shape with other parameters, as a slider gives one after another. */
export function netChange(before: NetSource, after: NetSource): NamedChange {
  const name = netTitle(after);
  const same = 'recipe' in before && 'recipe' in after && netTitle(before) === name;
  return same ? { name: words.history.shape(name), key: `shape ${name}` } : { name: words.history.open(name), key: null };
}

/** How settings differ; null: not at all. */
export function settingsChange(before: SolverSettings, after: SolverSettings): NamedChange | null {
  if (after.method !== before.method) return { name: words.history.method(words.core.method(after.method)), key: null };
  if (after.initialisation !== before.initialisation) {
    return { name: words.history.initialisation(words.core.method(after.initialisation.split(':')[0] ?? '')), key: 'initialisation' };
  }
  const names = Object.keys({ ...before.options, ...after.options });
  const [first, ...more] = names.filter((name) => before.options[name] !== after.options[name]);
  if (first === undefined) return null;
  if (more.length > 0) return { name: words.history.options, key: null };
  const value = after.options[first];
  const name = value === undefined ? words.history.optionBack(words.core.name(first)) : words.history.option(words.core.name(first), String(value));
  return { name, key: `option ${first}` };
}

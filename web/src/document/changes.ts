/** Changes of a document, as the history names them. */
import type { GuideSource, HandleData, NetSource, SolverSettings } from './document';
import type { ChangeName, Term } from './naming';

/** A file by its name, a recipe by that of its shape. */
export function netTitle(net: NetSource): Term {
  return 'recipe' in net ? { shape: net.recipe.split(':')[0] ?? '' } : net.name;
}

/** One of the handles by its name or vertex, several by their number. */
export function handlesTitle(handles: readonly HandleData[], of: readonly { vertex: number }[]): Term {
  const [first, ...more] = of;
  if (first === undefined || more.length > 0) return { handles: String(of.length) };
  return { handle: handles.find(({ vertex }) => vertex === first.vertex)?.name ?? String(first.vertex) };
}

export function traitsChange(
  traits: { [Trait in keyof HandleData]?: HandleData[Trait] | undefined },
  who: Term,
): ChangeName {
  if ('anchor' in traits) return [traits.anchor ? 'lock' : 'unlock', who];
  if ('hidden' in traits) return [traits.hidden ? 'hide' : 'show', who];
  if (traits.slides !== undefined) return ['slide', who];
  if ('slides' in traits) return ['hold', who];
  if ('weight' in traits) return [traits.weight === undefined ? 'harden' : 'soften', who];
  return ['rename', who];
}

export interface NamedChange {
  name: ChangeName;
  /** Changes of one key are one entry of the history; null: an entry of its own. */
  key: string | null;
}

/** Of a surface beside the net: a file by its name. */
export function guideTitle(guide: GuideSource): Term {
  return 'own' in guide ? { surface: guide.own } : guide.name;
}

/** Another net; or the same shape with other parameters, as a slider gives one after another. */
export function netChange(before: NetSource, after: NetSource): NamedChange {
  const [was, is] = [netTitle(before), netTitle(after)];
  const same = typeof was !== 'string' && typeof is !== 'string' && was.shape === is.shape;
  return same ? { name: ['shape', is], key: `shape ${is.shape}` } : { name: ['open', is], key: null };
}

/** How settings differ; null: not at all. */
export function settingsChange(before: SolverSettings, after: SolverSettings): NamedChange | null {
  if (after.method !== before.method) return { name: ['method', { method: after.method }], key: null };
  if (after.initialisation !== before.initialisation) {
    return { name: ['initialisation', { method: after.initialisation.split(':')[0] ?? '' }], key: 'initialisation' };
  }
  const names = Object.keys({ ...before.options, ...after.options });
  const [first, ...more] = names.filter((name) => before.options[name] !== after.options[name]);
  if (first === undefined) return null;
  if (more.length > 0) return { name: ['options'], key: null };
  const value = after.options[first];
  const name: ChangeName =
    value === undefined ? ['optionBack', { option: first }] : ['option', { option: first }, String(value)];
  return { name, key: `option ${first}` };
}

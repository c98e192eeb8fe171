/** The selected handles, by vertex, in the order of selection: the last one leads. */
import type { HandleData } from '../document/document';

export type Selection = readonly number[];

/** Adds a vertex, or removes it. */
export function toggled(selection: Selection, vertex: number): Selection {
  return selection.includes(vertex) ? selection.filter((each) => each !== vertex) : [...selection, vertex];
}

export function united(selection: Selection, more: readonly number[]): Selection {
  return [...new Set([...selection, ...more])];
}

/** The selection without vertices that are no handles any more. */
export function within(selection: Selection, handles: readonly HandleData[]): Selection {
  const present = new Set(handles.map(({ vertex }) => vertex));
  return selection.every((vertex) => present.has(vertex))
    ? selection
    : selection.filter((vertex) => present.has(vertex));
}

/** The selected handles, in the order of selection. */
export function chosen(selection: Selection, handles: readonly HandleData[]): HandleData[] {
  const byVertex = new Map(handles.map((handle) => [handle.vertex, handle]));
  return selection.flatMap((vertex) => byVertex.get(vertex) ?? []);
}

/** Those that may be moved or removed, the leading one first. */
export function unlocked(selection: Selection, handles: readonly HandleData[]): HandleData[] {
  return chosen([...selection].reverse(), handles).filter(({ anchor }) => !anchor);
}

/** All visible handles. */
export function all(handles: readonly HandleData[]): Selection {
  return handles.filter(({ hidden }) => !hidden).map(({ vertex }) => vertex);
}

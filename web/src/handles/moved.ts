/** Which handle has been moved. */
import type { HandleData } from '../document/document';
import { AXES } from './transform';

/** A handle that can be taken and has another target than before, e.g. after undo; where it slides, it only went with the net. */
export function movedBetween(before: readonly HandleData[], after: readonly HandleData[]): number | undefined {
  const targets = new Map(before.map(({ vertex, target }) => [vertex, target]));
  const isMoved = ({ vertex, target, anchor, hidden, slides }: HandleData): boolean => {
    const stood = targets.get(vertex) ?? target;
    return !anchor && !hidden && AXES.some((axis, i) => stood[i] !== target[i] && !slides?.includes(axis));
  };
  return after.find(isMoved)?.vertex;
}

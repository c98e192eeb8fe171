/** The real module, loaded in Node. */
import { readFileSync } from 'node:fs';
import type { Chebnet, ChebnetError, Editor, Editors, Handle } from '../../wasm/chebnet';
import { loadChebnet } from '../../wasm/chebnet';
import { loadEditors } from '../../wasm/editors';

export const ROOT = new URL('../../', import.meta.url);

export function load(): Promise<Chebnet> {
  return loadChebnet({ wasmBinary: readFileSync(new URL('build/wasm/chebnet_core.wasm', ROOT)) });
}

/** What the page loads first. */
export function loadFirst(): Promise<Editors> {
  return loadEditors({ wasmBinary: readFileSync(new URL('build/wasm/chebnet_editor.wasm', ROOT)) });
}

/** The error that `action` throws. */
export function failure(action: () => unknown): ChebnetError {
  try {
    action();
  } catch (error) {
    return error as ChebnetError;
  }
  throw new Error('nothing was thrown');
}

/** Handles at the suggested vertices, the last of them pulled 15 % of the way towards the middle of the others. */
export function firstEdit(editor: Editor): Handle[] {
  const place = (vertex: number) => Array.from(editor.restPositions.subarray(3 * vertex, 3 * vertex + 3));
  const handles = Array.from(editor.suggestedHandles, (vertex) => ({ vertex, target: place(vertex) }));
  const dragged = handles.at(-1);
  const anchors = handles.slice(0, -1);
  if (!dragged || anchors.length === 0) throw new Error('a shape must suggest an anchor and a vertex to drag');
  dragged.target = dragged.target.map((from, k) => {
    const middle = anchors.reduce((sum, { target }) => sum + (target[k] ?? NaN), 0) / anchors.length;
    return from + 0.15 * (middle - from);
  });
  return handles.map(({ vertex, target: [x = NaN, y = NaN, z = NaN] }) => ({ vertex, target: [x, y, z] }));
}

/** Largest distance between the places of a vertex in `a` and in `b`. */
export function largestDistance(a: Float64Array, b: Float64Array): number {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  for (let i = 0; i < a.length; i += 3) {
    const distance = Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!);
    if (!(distance <= largest)) largest = distance; // NaN must not pass
  }
  return largest;
}

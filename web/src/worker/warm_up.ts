/** Engines compile WebAssembly function by function, and better once a function has run for a while: the first solve of
 *  a page takes many times as long as the next. */
import type { Editors } from '../../../wasm/chebnet';

const MILLISECONDS = 120;

/** Solves small edits of a small net for a short while, so that the user's first one finds the solver compiled. */
export function warmUp(core: Editors): void {
  const [shape] = core.shapes();
  if (shape === undefined) return;
  const editor = core.openRecipe(`${shape.name}:vertices=300`);
  const handles = Array.from(editor.suggestedHandles, (vertex) => {
    const [x = 0, y = 0, z = 0] = editor.restPositions.subarray(3 * vertex, 3 * vertex + 3);
    return { vertex, target: [x, y, z] as [number, number, number] };
  });
  editor.setHandles(handles);
  const start = performance.now();
  for (let depth = 0.1; performance.now() - start < MILLISECONDS; depth += 0.1) {
    for (const { vertex, target } of handles.slice(-1))
      editor.moveHandle(vertex, [target[0], target[1], target[2] - depth]);
    editor.solve({ milliseconds: MILLISECONDS });
    editor.reset();
  }
  editor.dispose();
}

/** Engines compile WebAssembly function by function, and better once a function has run for a while: the first solve of
 *  a page takes many times as long as the next. */
import type { Editors, Handle } from '../../../wasm/chebnet';
import { pointOf } from '../document/point_of';

/** A slice; between two of them requests are answered. */
const MILLISECONDS = 12;
/** After these, all that a hand calls for has been compiled well; on a phone they take a second. */
const EDITS = 8;

/** Drags a small net about, so that the user's first drag finds the solver compiled.
 *  @param pause resolves when nobody waits for the worker. */
export async function warmUp(core: Editors, pause: () => Promise<void>): Promise<void> {
  const [shape] = core.shapes();
  if (shape === undefined) return;
  const editor = core.openRecipe(`${shape.name}:vertices=300`);
  const { restPositions, suggestedHandles } = editor;
  const handles = Array.from(
    suggestedHandles,
    (vertex): Handle => ({ vertex, target: pointOf(restPositions, vertex) }),
  );
  editor.setHandles(handles);
  const { vertex, target } = handles.at(-1)!;
  for (let edit = 1; edit <= EDITS; edit++) {
    editor.reach(vertex);
    editor.dragHandle(vertex, [target[0], target[1], target[2] - 0.1 * edit]);
    // Also before edits that one slice is enough for: a hand that comes now is not to wait for several of them.
    do await pause();
    while (editor.solve({ milliseconds: MILLISECONDS }).status === 'running');
    editor.releaseHandles();
    editor.reset();
  }
  editor.dispose();
}

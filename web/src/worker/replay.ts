/** Drags of a link, made again: by them a net that has several shapes at rest comes to the same one. */
import type { Editor, Handle } from '../../../wasm/chebnet';
import type { Replay, Vec3 } from '../document/document';
import { pointOf } from '../document/point_of';

/** Drags the handles of a net at rest from where they rest to their targets, all at once, and lets go. By numbers of iterations,
 *  not by time: on any machine the net goes the same way. */
export function replay(editor: Editor, [steps, iterations]: Replay): void {
  const handles = editor.handles();
  const restOf = ({ vertex }: Handle): Vec3 => pointOf(editor.restPositions, vertex);
  const dragged = handles.filter((handle) => isExact(handle) && handle.target.some((x, i) => x !== restOf(handle)[i]));
  editor.setHandles(
    handles.map((handle) => (dragged.includes(handle) ? { ...handle, target: restOf(handle) } : handle)),
  );
  for (let step = 1; step <= steps; step++) {
    for (const handle of dragged)
      editor.dragHandle(handle.vertex, between(restOf(handle), handle.target, step / steps));
    editor.solve({ iterations });
  }
  editor.releaseHandles();
}

/** The others come to rest by themselves. */
function isExact({ weight, slides }: Handle): boolean {
  return weight === undefined && slides === undefined;
}

function between(from: Vec3, to: Handle['target'], part: number): Vec3 {
  return from.map((x, i) => x + part * (to[i]! - x)) as Vec3;
}

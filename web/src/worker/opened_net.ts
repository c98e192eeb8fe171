/** An editor's net as plain data for the page. */
import type { Editor } from '../../../wasm/chebnet';
import { numberingOf } from '../document/numbering';
import type { OpenedNet } from './protocol';
import { fanTriangles, stripTriangles } from './triangles';

export function describe(editor: Editor): OpenedNet {
  const [lines, loops] = [editor.netLines(), editor.boundaryLoops()];
  const { info, edges, faceStart, faceVertices, restPositions, restLengths, suggestedHandles } = editor;
  return {
    info,
    numbering: numberingOf(editor),
    // Copies, since these arrays are transferred to the page: cloning them from the message would block it.
    edges: edges.slice(),
    faceStart: faceStart.slice(),
    faceVertices: faceVertices.slice(),
    restPositions: restPositions.slice(),
    restLengths: restLengths.slice(),
    suggestedHandles: suggestedHandles.slice(),
    lineStart: lines.start,
    lineVertices: lines.vertices,
    loopStart: loops.start,
    loopVertices: loops.vertices,
    triangles: fanTriangles(faceStart, faceVertices),
    strips: stripTriangles(edges.length / 2),
    handles: editor.handles(),
  };
}

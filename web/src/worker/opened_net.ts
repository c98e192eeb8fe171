/** A net as the page wants to have it. */
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
    // Copies, made here: what the page gets is moved there, for to read it out of the message would hold the page up.
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

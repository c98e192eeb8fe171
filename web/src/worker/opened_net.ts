/** Nets and surfaces as workers open them, and a net as plain data for the page. */
import type { Editor, Editors, Mesh, Surface } from '../../../wasm/chebnet';
import type { NetSource } from '../document/document';
import { numberingOf } from '../document/numbering';
import type { OpenedNet } from './protocol';
import { fanTriangles, stripTriangles } from './triangles';

/** Only traps of the module have no code; see wasm/chebnet.d.ts. */
export function openNet(core: Editors, net: NetSource): Editor {
  if ('recipe' in net) return core.openRecipe(net.recipe);
  if ('obj' in net) return core.openObj(net.obj, net.name, net.restLengths);
  return core.openMesh(net.mesh, net.restLengths);
}

/** One of our own by its name, or what a user brings. */
export function openSurface(core: Editors, source: { own: string } | { mesh: Mesh }): Surface {
  return 'own' in source ? core.ownSurface(source.own) : core.openSurface(source.mesh);
}

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

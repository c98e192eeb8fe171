/** A net as a 3DM file: a mesh on one layer, the net lines on another. Loaded when it is asked for. */
import rhino3dm from 'rhino3dm';
import type { Mesh, ObjectAttributes, RhinoModule } from 'rhino3dm';
import type { VertexLists } from '../../../wasm/chebnet';
import { listsOf } from '../handles/lines';
import type { OpenedNet } from '../worker/protocol';

export interface RhinoNet {
  mesh: Pick<OpenedNet, 'faceStart' | 'faceVertices'>;
  positions: Float64Array;
  /** Net lines. */
  lines: VertexLists;
  name: string;
  /** What the layers are called. */
  layers: { mesh: string; lines: string };
}

/** @param wasmUrl of the library's module; without it, it is looked for beside the library. */
export async function rhinoFileOf(
  { mesh, positions, lines, name, layers }: RhinoNet,
  wasmUrl?: string,
): Promise<Uint8Array<ArrayBuffer>> {
  const rhino = await rhino3dm(wasmUrl === undefined ? {} : { locateFile: () => wasmUrl });
  const file = new rhino.File3dm();
  const on = (layer: string): ObjectAttributes => {
    const attributes = new rhino.ObjectAttributes();
    attributes.layerIndex = file.layers().addLayer(layer, { r: 0, g: 0, b: 0, a: 255 });
    attributes.name = name;
    return attributes;
  };
  file.objects().addMesh(meshOf(rhino, mesh, positions), on(layers.mesh));
  const lineLayer = on(layers.lines);
  for (const line of listsOf(lines)) {
    file.objects().addPolyline(
      Array.from(line, (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]),
      lineLayer,
    );
  }
  return Uint8Array.from(file.toByteArray());
}

/** Quads stay quads; faces of more corners become fans of triangles. */
function meshOf(rhino: RhinoModule, { faceStart, faceVertices }: RhinoNet['mesh'], positions: Float64Array): Mesh {
  const mesh = new rhino.Mesh();
  const vertices = mesh.vertices();
  for (let i = 0; i < positions.length; i += 3)
    vertices.addPoint3d(positions[i]!, positions[i + 1]!, positions[i + 2]!);
  const faces = mesh.faces();
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const [first = 0, ...others] = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    const [b, c, d] = others as [number, number, number];
    if (others.length === 3) faces.addQuadFace(first, b, c, d);
    else for (let k = 1; k < others.length; k++) faces.addTriFace(first, others[k - 1]!, others[k]!);
  }
  return mesh;
}

/** A net as a 3DM file: a mesh, or one for each of its pieces, on one layer, its rods on another. Loaded when it is asked for. */
import rhino3dm from 'rhino3dm';
import type { Mesh, ObjectAttributes, RhinoModule } from 'rhino3dm';
import type { VertexLists } from '../../../wasm/chebnet';
import { listsOf } from '../handles/lines';
import { facesOfPieces } from '../net/pieces';
import type { OpenedNet } from '../worker/protocol';

export interface RhinoNet {
  mesh: Pick<OpenedNet, 'faceStart' | 'faceVertices'>;
  positions: Float64Array;
  /** The lines they are laid along, as lists of rods have them. */
  rods: VertexLists;
  name: string;
  /** What the layers are called. */
  layers: { mesh: string; rods: string };
}

/** @param wasmUrl of the library's module; without it, it is looked for beside the library. */
export async function rhinoFileOf(
  { mesh, positions, rods, name, layers }: RhinoNet,
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
  const meshLayer = on(layers.mesh);
  const pieces = facesOfPieces(mesh);
  for (const [i, piece] of pieces.entries()) {
    meshLayer.name = pieces.length > 1 ? `${name} ${i + 1}` : name;
    file.objects().addMesh(meshOf(rhino, mesh, positions, piece), meshLayer);
  }
  const rodLayer = on(layers.rods);
  for (const rod of listsOf(rods)) {
    file.objects().addPolyline(
      Array.from(rod, (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]),
      rodLayer,
    );
  }
  return Uint8Array.from(file.toByteArray());
}

/** These faces, with the vertices that they use, in their order. Quads stay quads; faces of more corners become fans of
 *  triangles. */
function meshOf(
  rhino: RhinoModule,
  { faceStart, faceVertices }: RhinoNet['mesh'],
  positions: Float64Array,
  piece: readonly number[],
): Mesh {
  const cornersOf = (face: number): Int32Array => faceVertices.subarray(faceStart[face], faceStart[face + 1]);
  const used = [...new Set(piece.flatMap((face) => [...cornersOf(face)]))].sort((a, b) => a - b);
  const placeOf = new Map(used.map((vertex, place) => [vertex, place]));
  const mesh = new rhino.Mesh();
  const vertices = mesh.vertices();
  for (const vertex of used)
    vertices.addPoint3d(positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!);
  const faces = mesh.faces();
  for (const face of piece) {
    const [first = 0, ...others] = Array.from(cornersOf(face), (vertex) => placeOf.get(vertex)!);
    const [b, c, d] = others as [number, number, number];
    if (others.length === 3) faces.addQuadFace(first, b, c, d);
    else for (let k = 1; k < others.length; k++) faces.addTriFace(first, others[k - 1]!, others[k]!);
  }
  return mesh;
}

/** The meshes of a 3DM file, as one. Quads stay quads. */
import rhino3dm from 'rhino3dm';
import type { Mesh as RhinoMesh } from 'rhino3dm';
import type { Mesh } from '../../../wasm/chebnet';
import { Failure } from '../failure';

/** That the core takes, of vertices and of faces. */
const MOST = 2_000_000;

export async function rhinoMesh(bytes: Uint8Array, name: string, wasmUrl?: string): Promise<Mesh> {
  const rhino = await rhino3dm(wasmUrl === undefined ? {} : { locateFile: () => wasmUrl });
  const file = rhino.File3dm.fromByteArray(bytes) as ReturnType<typeof rhino.File3dm.fromByteArray> | null;
  if (file === null) throw new Failure('bad_model', `${name}: the 3DM file is damaged`);
  const objects = file.objects();
  const meshes: RhinoMesh[] = [];
  for (let i = 0; i < objects.count; ++i) {
    const geometry = objects.get(i).geometry();
    if (geometry instanceof rhino.Mesh) meshes.push(geometry);
  }
  if (meshes.length === 0)
    throw new Failure('no_mesh', `${name} holds no mesh; Rhino makes one of a surface with the command Mesh`);
  return joined(meshes, name);
}

function joined(meshes: RhinoMesh[], name: string): Mesh {
  const [vertices, faces] = [total(meshes, 'vertices'), total(meshes, 'faces')];
  if (vertices > MOST || faces > MOST)
    throw new Failure('too_large', `${name}: ${vertices} vertices and ${faces} faces are more than ${MOST}`);
  const positions = new Float64Array(3 * vertices);
  const [faceStart, faceVertices] = [[0], [] as number[]];
  let first = 0;
  for (const mesh of meshes) {
    mesh
      .vertices()
      .toPoint3dArray()
      .forEach((point, i) => positions.set(point, 3 * (first + i)));
    for (let face = 0; face < mesh.faces().count; ++face) {
      // Of a triangle the last two are the same.
      const corners = mesh.faces().get(face);
      for (const vertex of corners[2] === corners[3] ? corners.slice(0, 3) : corners) faceVertices.push(first + vertex);
      faceStart.push(faceVertices.length);
    }
    first += mesh.vertices().count;
  }
  return { positions, faceStart: Int32Array.from(faceStart), faceVertices: Int32Array.from(faceVertices) };
}

function total(meshes: RhinoMesh[], part: 'vertices' | 'faces'): number {
  return meshes.reduce((sum, mesh) => sum + mesh[part]().count, 0);
}

/** Meshes in files that a library reads rather than the core. */
import type { Mesh } from '../../../wasm/chebnet';
import type { UpAxis } from '../document/document';
import { Failure } from '../failure';

interface Model {
  mesh: Mesh;
  /** Where the format says which axis points up. */
  up?: UpAxis;
}

/** The mesh of a glTF or 3DM file; null: it is none of these. A library comes only with a file that needs it.
 *  @param rhinoUrl of the module that reads 3DM; without it, it is looked for beside the library.
 *  Throws Failure `bad_model`, `compressed_model`, `model_in_parts`, `no_mesh` or `too_large`. */
export async function readModel(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  rhinoUrl?: string,
): Promise<Model | null> {
  if (beginsWith(bytes, 'glTF') || /\.gltf$/i.test(name)) {
    const { gltfMesh } = await import('./gltf_mesh');
    return { mesh: await gltfMesh(bytes, name), up: 'y' };
  }
  if (beginsWith(bytes, '3D Geometry File Format ')) {
    const { rhinoMesh } = await import('./rhino_mesh');
    return { mesh: await rhinoMesh(bytes, name, rhinoUrl) };
  }
  const [, extension] = /\.(glb|3dm)$/i.exec(name) ?? [];
  if (extension !== undefined)
    throw new Failure('bad_model', `${name}: this is no ${extension.toUpperCase()} file, or it is damaged`);
  return null;
}

function beginsWith(bytes: Uint8Array, signature: string): boolean {
  return Array.from(signature).every((character, i) => bytes[i] === character.charCodeAt(0));
}

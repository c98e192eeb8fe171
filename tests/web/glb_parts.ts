/** What a binary glTF of a net holds, taken apart by its specification. */

interface Primitive {
  attributes: Record<string, number>;
  indices: number;
  mode?: number;
}

interface Gltf {
  scene: number;
  scenes: { nodes: number[] }[];
  nodes: { name?: string; children?: number[]; mesh?: number; rotation?: number[]; translation?: number[] }[];
  meshes: { primitives: Primitive[] }[];
  accessors: {
    bufferView: number;
    byteOffset?: number;
    componentType: number;
    count: number;
    type: 'SCALAR' | 'VEC3';
  }[];
  bufferViews: { byteOffset?: number; byteLength: number }[];
}

const FLOAT = 5126;
const UNSIGNED_INT = 5125;
export const LINES = 1;

export function glbParts(bytes: Uint8Array) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67) throw new Error('no binary glTF');
  const jsonLength = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + jsonLength))) as Gltf;
  const data = bytes.slice(28 + jsonLength).buffer;

  const read = (index: number): Float32Array | Uint32Array => {
    const { bufferView, byteOffset = 0, componentType, count, type } = gltf.accessors[index]!;
    const start = (gltf.bufferViews[bufferView]!.byteOffset ?? 0) + byteOffset;
    const length = count * (type === 'VEC3' ? 3 : 1);
    if (componentType === FLOAT) return new Float32Array(data, start, length);
    if (componentType === UNSIGNED_INT) return new Uint32Array(data, start, length);
    throw new Error(`component type ${componentType}`);
  };
  const primitives = gltf.meshes.flatMap((mesh) => mesh.primitives);
  const part = ({ attributes, indices }: Primitive) => ({
    positions: read(attributes.POSITION!),
    colours: attributes.COLOR_0 === undefined ? null : read(attributes.COLOR_0),
    indices: read(indices),
  });
  return {
    faces: part(primitives.find(({ mode }) => mode !== LINES)!),
    lines: part(primitives.find(({ mode }) => mode === LINES)!),
    nodes: gltf.nodes,
    root: gltf.nodes[gltf.scenes[gltf.scene]!.nodes[0]!]!,
  };
}

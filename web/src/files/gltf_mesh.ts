/** The triangles of a glTF file, text or binary, as one mesh where its nodes stand. Colours, bones and movements are left
 *  out before they are read, and nothing is fetched: all must be in the file. */
import { type Matrix4, type Object3D, Mesh as Part, Vector3 } from 'three';
import { GLTFLoader, type GLTFLoaderPlugin, type GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import type { Mesh } from '../../../wasm/chebnet';
import { fromBase64 } from '../document/base64';
import { Failure, messageOf } from '../failure';

/** Of corners of all triangles, and of vertices that they name: three for each face that the core takes. */
const MOST = 6_000_000;
/** Of all that is taken out of the file; views of the same bytes count each. */
const MOST_BYTES = 1e9;
const COMPRESSIONS = ['KHR_draco_mesh_compression', 'EXT_meshopt_compression', 'KHR_meshopt_compression'];
const COPIES = 'EXT_mesh_gpu_instancing';

/** @param name what messages call the file. */
export async function gltfMesh(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Mesh> {
  const loader = new GLTFLoader().register((parser) => new ShapeAlone(parser, name));
  let scene: Object3D | undefined;
  try {
    ({ scene } = await loader.parseAsync(bytes.buffer, ''));
  } catch (error) {
    if (error instanceof Failure) throw error;
    // What the engine says of bytes that are not there is of no use to anybody.
    const why = error instanceof RangeError ? 'it ends too early' : messageOf(error);
    throw new Failure('bad_model', `${name}: the glTF file is damaged: ${why}`);
  }
  const parts = scene === undefined ? [] : partsOf(scene);
  if (parts.length === 0) throw new Failure('no_mesh', `${name} holds no triangles`);
  return welded(parts);
}

/** The parts of a glTF file that shapes are made of (glTF 2.0 specification, section 5). */
interface Gltf {
  scene?: number;
  scenes?: { nodes?: number[] }[];
  nodes?: { children?: number[]; mesh?: number }[];
  meshes?: { primitives: Primitive[] }[];
  accessors?: { count: number }[];
  bufferViews?: { buffer: number; byteOffset?: number; byteLength: number }[];
  buffers?: { uri?: string }[];
  extensionsUsed?: string[];
  extensionsRequired?: string[];
  [part: string]: unknown;
}

interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
}

/** Refuses what cannot be read, or would take all memory, and leaves the loader nothing but shapes. */
class ShapeAlone implements GLTFLoaderPlugin {
  readonly name = 'SHAPE_ALONE';
  readonly #gltf: Gltf;
  readonly #parser: GLTFParser;
  readonly #file: string;
  readonly #buffers = new Map<number, ArrayBuffer>();
  #taken = 0;

  constructor(parser: GLTFParser, file: string) {
    this.#gltf = parser.json as Gltf;
    this.#parser = parser;
    this.#file = file;
    this.#checkExtensions();
    this.#leaveShapes();
    this.#checkTree();
    this.#checkSize();
  }

  /** Instead of the loader's own, which would fetch. */
  async loadBufferView(index: number): Promise<ArrayBuffer> {
    const { buffer, byteOffset = 0, byteLength } = this.#gltf.bufferViews![index]!;
    if (!this.#buffers.has(buffer)) this.#buffers.set(buffer, await this.#buffer(buffer));
    const view = this.#buffers.get(buffer)!.slice(byteOffset, byteOffset + byteLength);
    this.#taken += view.byteLength;
    if (this.#taken > MOST_BYTES) throw new Failure('too_large', `${this.#file}: more than a gigabyte of vertices`);
    return view;
  }

  async #buffer(index: number): Promise<ArrayBuffer> {
    const { uri } = this.#gltf.buffers![index]!;
    if (uri === undefined) return this.#parser.loadBuffer(index);
    const data = /^data:[^,]*;base64,/.exec(uri);
    if (data === null)
      throw new Failure(
        'model_in_parts',
        `${this.#file} keeps its mesh in another file, ${uri.slice(0, 80)}; save it as GLB, which has all in one`,
      );
    return fromBase64(uri.slice(data[0].length)).buffer;
  }

  #checkExtensions(): void {
    const { extensionsUsed = [], extensionsRequired = [] } = this.#gltf;
    const kept = COMPRESSIONS.find((each) => extensionsRequired.includes(each));
    const unread = kept ?? extensionsUsed.find((each) => each === COPIES);
    if (unread !== undefined)
      throw new Failure(
        'compressed_model',
        `${this.#file} packs its mesh by ${unread}, which is not read here; save it without compression`,
      );
  }

  #leaveShapes(): void {
    const gltf = this.#gltf;
    const { scene = 0, scenes = [], nodes = [], meshes = [] } = gltf;
    for (const part of ['materials', 'textures', 'images', 'samplers', 'animations', 'skins', 'cameras'])
      delete gltf[part];
    gltf.extensionsUsed = gltf.extensionsUsed?.filter((each) => each === 'KHR_mesh_quantization') ?? [];
    gltf.scene = 0;
    gltf.scenes = scenes.slice(scene, scene + 1).map(({ nodes: roots = [] }) => ({ nodes: roots }));
    gltf.nodes = nodes.map((node) => without(node, 'skin', 'camera', 'weights', 'extensions'));
    gltf.meshes = meshes.map(({ primitives }) => ({ primitives: primitives.filter(hasTriangles).map(shapeOf) }));
  }

  /** The loader would wait for ever for a node below itself. */
  #checkTree(): void {
    const { scenes = [], nodes = [] } = this.#gltf;
    const named = [...scenes, ...nodes.map(({ children }) => ({ nodes: children }))].flatMap(
      (each) => each.nodes ?? [],
    );
    if (new Set(named).size < named.length)
      throw new Failure('bad_model', `${this.#file}: the glTF file is damaged: its nodes are no tree`);
  }

  #checkSize(): void {
    const { nodes = [], meshes = [], accessors = [] } = this.#gltf;
    const sizes = meshes.map(({ primitives }) =>
      primitives
        .flatMap(({ attributes, indices }) => [attributes['POSITION'], indices])
        .reduce<number>((sum, accessor) => sum + (accessor === undefined ? 0 : accessors[accessor]!.count), 0),
    );
    const size = nodes.reduce((sum, { mesh }) => sum + (mesh === undefined ? 0 : (sizes[mesh] ?? 0)), 0);
    if (!(size <= 2 * MOST)) throw new Failure('too_large', `${this.#file}: more than ${MOST / 3} triangles`);
  }
}

/** Triangles, strips and fans. */
function hasTriangles({ attributes, mode = 4 }: Primitive): boolean {
  return mode >= 4 && attributes['POSITION'] !== undefined;
}

function shapeOf({ attributes, indices, mode }: Primitive): Primitive {
  return {
    attributes: { POSITION: attributes['POSITION']! },
    ...(indices !== undefined && { indices }),
    ...(mode !== undefined && { mode }),
  };
}

function without<T extends object>(object: T, ...parts: string[]): T {
  return Object.fromEntries(Object.entries(object).filter(([part]) => !parts.includes(part))) as T;
}

function partsOf(scene: Object3D): Part[] {
  scene.updateMatrixWorld(true);
  const parts: Part[] = [];
  scene.traverse((object) => {
    if (object instanceof Part) parts.push(object);
  });
  return parts;
}

/** Vertices at the very same place are one: in glTF, faces that differ in their normals or colours share none. */
function welded(parts: Part[]): Mesh {
  const vertexAt = new Map<string, number>();
  const [positions, faceVertices] = [[] as number[], [] as number[]];
  for (const part of parts) {
    const numbers = Int32Array.from(placesOf(part), (place) => {
      const key = place.join();
      if (!vertexAt.has(key)) {
        vertexAt.set(key, vertexAt.size);
        positions.push(...place);
      }
      return vertexAt.get(key)!;
    });
    // A corner that names no vertex is left for the core to refuse.
    for (const corner of cornersOf(part)) faceVertices.push(numbers[corner] ?? -1);
  }
  return {
    positions: Float64Array.from(positions),
    faceStart: Int32Array.from({ length: faceVertices.length / 3 + 1 }, (_, face) => 3 * face),
    faceVertices: Int32Array.from(faceVertices),
  };
}

function* placesOf({ geometry, matrixWorld }: Part): Generator<[number, number, number]> {
  const position = geometry.getAttribute('position');
  const point = new Vector3();
  for (let i = 0; i < position.count; ++i)
    yield point.fromBufferAttribute(position, i).applyMatrix4(matrixWorld).toArray();
}

/** Of its triangles, one after the other, counterclockwise from outside: a mirrored part turns them round. */
function cornersOf({ geometry, matrixWorld }: Part): Int32Array {
  const { index } = geometry;
  const count = (index ?? geometry.getAttribute('position')).count;
  const whole = count - (count % 3);
  const turn = isMirrored(matrixWorld) ? [0, 2, 1] : [0, 1, 2];
  return Int32Array.from({ length: whole }, (_, i) => {
    const corner = i - (i % 3) + turn[i % 3]!;
    return index === null ? corner : index.getX(corner);
  });
}

function isMirrored(matrix: Matrix4): boolean {
  return matrix.determinant() < 0;
}

/** Meshes in glTF and 3DM files, as other programs write them and as nobody should. */
import rhino3dm from 'rhino3dm';
import {
  BoxGeometry,
  BufferGeometry,
  Group,
  Mesh as Drawn,
  Line,
  MeshStandardMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { GLTFExporter } from 'three/examples/jsm/exporters/GLTFExporter.js';
import { describe, expect, test, vi } from 'vitest';
import type { Mesh } from '../../wasm/chebnet';
import { toBase64 } from '../../web/src/document/base64';
import { codeOf } from '../../web/src/failure';
import { readModel } from '../../web/src/files/model';
import { load } from '../wasm/load';

const core = await load();

vi.stubGlobal(
  'FileReader',
  class {
    result: ArrayBuffer | string | null = null;
    onloadend: () => void = () => {};
    async readAsArrayBuffer(blob: Blob): Promise<void> {
      this.result = await blob.arrayBuffer();
      this.onloadend();
    }
    async readAsDataURL(blob: Blob): Promise<void> {
      this.result = `data:application/octet-stream;base64,${toBase64(new Uint8Array(await blob.arrayBuffer()))}`;
      this.onloadend();
    }
  },
);

const textBytes = (text: string) => Uint8Array.from(new TextEncoder().encode(text));

async function exported(object: Group | Drawn, binary: boolean): Promise<Uint8Array<ArrayBuffer>> {
  const result = await new GLTFExporter().parseAsync(object, { binary });
  return binary ? new Uint8Array(result as ArrayBuffer) : textBytes(JSON.stringify(result));
}

async function meshOf(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Mesh> {
  return (await readModel(bytes, name))!.mesh;
}

/** The enclosed volume, negative inside out. */
function volume({ positions, faceStart, faceVertices }: Mesh): number {
  const point = (corner: number) => new Vector3().fromArray(positions, 3 * faceVertices[corner]!);
  let sum = 0;
  for (let face = 0; face + 1 < faceStart.length; ++face)
    for (let k = faceStart[face]! + 1; k + 1 < faceStart[face + 1]!; ++k)
      sum += point(faceStart[face]!).dot(point(k).cross(point(k + 1))) / 6;
  return sum;
}

/** Of a triangle; what is given takes the place of that. */
function gltf(changes: Record<string, unknown>): Uint8Array<ArrayBuffer> {
  const numbers = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const uri = `data:application/octet-stream;base64,${toBase64(new Uint8Array(numbers.buffer))}`;
  return textBytes(
    JSON.stringify({
      asset: { version: '2.0' },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
      bufferViews: [{ buffer: 0, byteLength: 36 }],
      buffers: [{ uri, byteLength: 36 }],
      ...changes,
    }),
  );
}

async function codeAndMessage(bytes: Uint8Array<ArrayBuffer>, name = 'a.gltf'): Promise<[string, string]> {
  try {
    await readModel(bytes, name);
    return ['none', ''];
  } catch (error) {
    return [codeOf(error), (error as Error).message];
  }
}

describe('glTF', () => {
  const box = () => new Drawn(new BoxGeometry(1, 2, 3), new MeshStandardMaterial());

  test.each([
    ['binary', true],
    ['text', false],
  ])('as another program writes it, %s, is a closed mesh again', async (_, binary) => {
    const model = await readModel(await exported(box(), binary), binary ? 'box.glb' : 'box.gltf');
    expect(model?.up).toBe('y');
    const { positions, faceStart } = model!.mesh;
    // Its faces share no vertices in the file, since they have normals of their own.
    expect([positions.length / 3, faceStart.length - 1]).toEqual([8, 12]);
    expect(volume(model!.mesh)).toBeCloseTo(6, 6);
    expect(core.openSurface(model!.mesh).describe()).toMatchObject({ boundaryLoops: 0, genus: 0 });
  });

  test('stands where its nodes put it, right side out, and lines are left out', async () => {
    const group = new Group();
    const [first, second] = [box(), new Drawn(new SphereGeometry(1, 12, 8), new MeshStandardMaterial())];
    first.position.set(10, 0, 0);
    first.scale.set(-2, 1, 1);
    const outer = new Group();
    outer.add(second);
    outer.position.set(-10, 0, 0);
    group.add(first, outer, new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(1, 1, 1)])));
    const mesh = await meshOf(await exported(group, true), 'two.glb');
    const x = Array.from(mesh.positions).filter((_, i) => i % 3 === 0);
    expect([Math.min(...x), Math.max(...x)]).toEqual([expect.closeTo(-11, 6), expect.closeTo(11, 6)]);
    expect(volume(mesh)).toBeGreaterThan(12 + 3);
  });

  test('has strips, whole numbers and vertices that are all zero but for some', async () => {
    const numbers = Int16Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0);
    const uri = `data:;base64,${toBase64(new Uint8Array(numbers.buffer))}`;
    const strip = gltf({
      extensionsUsed: ['KHR_mesh_quantization'],
      extensionsRequired: ['KHR_mesh_quantization'],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 5 }] }],
      accessors: [{ bufferView: 0, componentType: 5122, count: 4, type: 'VEC3' }],
      bufferViews: [{ buffer: 0, byteLength: 24 }],
      buffers: [{ uri, byteLength: 24 }],
    });
    const mesh = await meshOf(strip, 'strip.gltf');
    expect(Array.from(mesh.positions)).toEqual([0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0]);
    expect(Array.from(mesh.faceVertices)).toEqual([0, 1, 2, 3, 2, 1]);
  });

  test.each<[string, Record<string, unknown>, string, RegExp]>([
    ['another file', { buffers: [{ uri: 'parts.bin', byteLength: 36 }] }, 'model_in_parts', /parts\.bin.*GLB/],
    ['another site', { buffers: [{ uri: 'https://a.example/b.bin', byteLength: 36 }] }, 'model_in_parts', /a\.example/],
    [
      'Draco',
      { extensionsUsed: ['KHR_draco_mesh_compression'], extensionsRequired: ['KHR_draco_mesh_compression'] },
      'compressed_model',
      /KHR_draco_mesh_compression/,
    ],
    [
      'meshopt',
      { extensionsUsed: ['EXT_meshopt_compression'], extensionsRequired: ['EXT_meshopt_compression'] },
      'compressed_model',
      /without compression/,
    ],
    ['copies', { extensionsUsed: ['EXT_mesh_gpu_instancing'] }, 'compressed_model', /EXT_mesh_gpu_instancing/],
    ['no scene', { scenes: [] }, 'no_mesh', /no triangles/],
    ['lines alone', { meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 1 }] }] }, 'no_mesh', /a\.gltf/],
    ['a node below itself', { nodes: [{ mesh: 0, children: [0] }] }, 'bad_model', /no tree/],
    ['a circle of nodes', { nodes: [{ children: [1] }, { children: [2] }, { children: [1] }] }, 'bad_model', /no tree/],
    [
      'a million copies of a node',
      {
        scenes: [{ nodes: Array.from({ length: 1000 }, (_, i) => i) }],
        nodes: Array(1000).fill({ mesh: 0 }),
        accessors: [{ componentType: 5126, count: 1e5, type: 'VEC3' }],
      },
      'too_large',
      /triangles/,
    ],
    ['too many zeros', { accessors: [{ componentType: 5126, count: 1e12, type: 'VEC3' }] }, 'too_large', /triangles/],
    [
      'an end before its end',
      { accessors: [{ bufferView: 0, componentType: 5126, count: 99, type: 'VEC3' }] },
      'bad_model',
      /damaged/,
    ],
    ['a view of nothing', { bufferViews: [] }, 'bad_model', /damaged/],
    ['no numbers', { nodes: [{ mesh: 'x' }] }, 'bad_model', /damaged/],
    ['an older version', { asset: { version: '1.0' } }, 'bad_model', /2\.0/],
  ])('with %s is refused with its reason', async (_, changes, code, message) => {
    expect(await codeAndMessage(gltf(changes))).toEqual([code, expect.stringMatching(message)]);
  });

  test('that is cut off, or no JSON, is damaged', async () => {
    const whole = await exported(box(), true);
    for (const bytes of [whole.slice(0, 100), whole.slice(0, 10), textBytes('{')])
      expect((await codeAndMessage(bytes))[0]).toBe('bad_model');
  });

  test('whose triangles name vertices that are none is refused by the core', async () => {
    const indices = `data:;base64,${toBase64(Uint8Array.of(0, 1, 200))}`;
    const parts = JSON.parse(new TextDecoder().decode(gltf({}))) as { buffers: unknown[] };
    const mesh = await meshOf(
      gltf({
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
        accessors: [
          { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' },
          { bufferView: 1, componentType: 5121, count: 3, type: 'SCALAR' },
        ],
        bufferViews: [
          { buffer: 0, byteLength: 36 },
          { buffer: 1, byteLength: 3 },
        ],
        buffers: [parts.buffers[0], { uri: indices, byteLength: 3 }],
      }),
      'a.gltf',
    );
    expect(() => core.repairMesh(mesh)).toThrow(/-1|out of range/);
  });
});

describe('3DM', async () => {
  const rhino = await rhino3dm();

  function file(add: (objects: ReturnType<InstanceType<typeof rhino.File3dm>['objects']>) => void) {
    const model = new rhino.File3dm();
    add(model.objects());
    return Uint8Array.from(model.toByteArray());
  }

  function square(x: number) {
    const mesh = new rhino.Mesh();
    for (const [u, v] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ] as const)
      mesh.vertices().addPoint3d(x + u, v, 0.1);
    return mesh;
  }

  test('quads stay quads, to the last digit, and meshes become one', async () => {
    const [quad, triangles] = [square(0), square(5)];
    quad.faces().addQuadFace(0, 1, 2, 3);
    triangles.faces().addTriFace(0, 1, 2);
    triangles.faces().addTriFace(0, 2, 3);
    const bytes = file((objects) => {
      objects.addPoint([9, 9, 9]);
      objects.addMesh(quad, new rhino.ObjectAttributes());
      objects.addMesh(triangles, new rhino.ObjectAttributes());
    });
    const model = await readModel(bytes, 'squares.3dm');
    expect(model?.up).toBeUndefined();
    const { positions, faceStart, faceVertices } = model!.mesh;
    expect(Array.from(faceStart)).toEqual([0, 4, 7, 10]);
    expect(Array.from(faceVertices)).toEqual([0, 1, 2, 3, 4, 5, 6, 4, 6, 7]);
    expect(Array.from(positions.subarray(12, 18))).toEqual([5, 0, 0.1, 6, 0, 0.1]);
  });

  test('without a mesh, or damaged, is refused with its reason', async () => {
    const points = file((objects) => void objects.addPoint([1, 2, 3]));
    expect(await codeAndMessage(points, 'a.3dm')).toEqual(['no_mesh', expect.stringMatching(/command Mesh/)]);
    expect((await codeAndMessage(points.slice(0, 60), 'a.3dm'))[0]).toBe('bad_model');
  });
});

test('other files are left to the core', async () => {
  expect(await readModel(textBytes('v 0 0 0\n'), 'a.obj')).toBeNull();
  expect(await readModel(textBytes('{}'), 'a.json')).toBeNull();
});

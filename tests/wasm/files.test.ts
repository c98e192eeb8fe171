/** Files and raw meshes across the border: bytes in, bytes out, findings. */
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import type { Defect, Editor, Mesh } from '../../wasm/chebnet';
import { ROOT, failure, load } from './load';

const chebnet = await load();

const encode = (text: string) => new TextEncoder().encode(text);
const read = (text: string, name = 'net.obj') => chebnet.readMesh(encode(text), name);
const sample = (path: string) => chebnet.readMesh(readFileSync(new URL(`tests/data/${path}`, ROOT)), path);

/** A quad, a triangle and a pentagon in a row. */
const MIXED = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 .5 0\nv 1.5 2 0.1\nv .3 2 0\nf 1 2 3 4\nf 2 5 3\nf 4 3 5 6 7\n';
/** The same square twice, a vertex double, one too many, and a third face at an edge. */
const BROKEN =
  'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 9 9 9\nv 2 0 0\nv 2 1 0\nv 0 0 1\nv 1 0 1\nv 0 0 -1\nv 1 0 -1\n' +
  'f 1 2 3 4\nf 4 3 2 1\nf 5 7 8 3\nf 1 2 10 9\nf 1 2 12 11\n';

function meshOf({ restPositions, faceStart, faceVertices }: Editor): Mesh {
  return { positions: restPositions, faceStart, faceVertices };
}

describe('reading', () => {
  test('keeps faces of every arity and their order', () => {
    const mesh = read(MIXED);
    expect(mesh.positions).toBeInstanceOf(Float64Array);
    expect(mesh.positions.subarray(15, 18)).toEqual(Float64Array.of(1.5, 2, 0.1));
    expect(mesh.faceStart).toEqual(Int32Array.of(0, 4, 7, 12));
    expect(mesh.faceVertices).toEqual(Int32Array.of(0, 1, 2, 3, 1, 4, 2, 3, 2, 4, 5, 6));
  });

  test.each([
    ['ply/blender.ply', 5, 2],
    ['ply/meshlab.ply', 4, 1],
    ['off/geomview.off', 8, 6],
  ])('takes %s as another program wrote it', (path, vertices, faces) => {
    const mesh = sample(path);
    expect(mesh.positions).toHaveLength(3 * vertices);
    expect(mesh.faceStart).toHaveLength(faces + 1);
  });

  test('looks at the bytes before the name, and at no more than it is given', () => {
    const off = encode('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n!');
    expect(chebnet.readMesh(off.subarray(0, -1), 'called.obj').faceVertices).toEqual(Int32Array.of(0, 1, 2));
  });

  const faults: [string, string, RegExp, () => unknown][] = [
    ['a bad line', 'bad_syntax', /^net\.obj:2: .*zero/, () => read('v 0 0 0\nv 1 zero 0\n')],
    ['a face too far', 'index_out_of_range', /^net\.obj:4: /, () => read('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n')],
    ['a PLY cut short', 'bad_syntax', /^cut\.ply/, () => chebnet.readMesh(cut('ply/meshlab.ply'), 'cut.ply')],
    ['an OFF cut short', 'bad_syntax', /^cut\.off:/, () => chebnet.readMesh(cut('off/geomview.off'), 'cut.off')],
    ['an STL with a word of its own', 'bad_syntax', /^part\.stl:2: /, () => read('solid\nfact\n', 'part.stl')],
    ['a picture', 'bad_syntax', /OBJ, PLY, OFF/, () => chebnet.readMesh(Uint8Array.of(137, 80, 78, 71), 'a.png')],
    ['text instead of bytes', 'bad_syntax', /Uint8Array/, () => chebnet.readMesh('v 0 0 0' as never, 'net.obj')],
    ['a name that is none', 'bad_syntax', /name/, () => chebnet.readMesh(new Uint8Array(), 7 as never)],
  ];
  test.each(faults)('refuses %s', (_, code, message, action) => {
    expect(failure(action)).toMatchObject({ code, message: expect.stringMatching(message) });
  });

  function cut(path: string): Uint8Array {
    const bytes = readFileSync(new URL(`tests/data/${path}`, ROOT));
    return bytes.subarray(0, bytes.length - 20);
  }
});

describe('repair', () => {
  test('finds nothing in a sound mesh and changes nothing', () => {
    const mesh = read(MIXED);
    expect(chebnet.repairMesh(mesh)).toEqual({ mesh, newVertex: Int32Array.of(0, 1, 2, 3, 4, 5, 6), findings: [] });
  });

  test('says what it found and gives a mesh that opens', () => {
    const given = read(BROKEN);
    const { mesh, newVertex, findings } = chebnet.repairMesh(given);
    expect(findings.map(({ defect, count, examples }) => [defect, count, examples])).toEqual([
      ['duplicate_vertices', 1, [4]],
      ['duplicate_faces', 1, [1]],
      ['non_manifold_edges', 1, [4]],
      ['inconsistent_winding', 1, [3]],
      ['unused_vertices', 3, [5, 10, 11]],
    ]);
    expect(findings.every(({ repaired }) => repaired)).toBe(true);
    expect(findings[0]?.sentence).toBe('1 vertex at the place of an earlier one, merged: 4');
    expect(newVertex).toEqual(Int32Array.of(0, 1, 2, 3, 1, -1, 4, 5, 6, 7, -1, -1));
    const editor = chebnet.openMesh(mesh);
    expect(editor.info).toMatchObject({ vertices: 8, faces: 3 });
    editor.dispose();
    expect(given).toEqual(read(BROKEN));
  });

  test('does only what is chosen', () => {
    const { mesh, findings } = chebnet.repairMesh(read(BROKEN), ['unused_vertices']);
    expect(findings.filter(({ repaired }) => repaired).map(({ defect }) => defect)).toEqual(['unused_vertices']);
    expect(mesh.faceStart).toHaveLength(6);
    expect(failure(() => chebnet.openMesh(mesh)).code).toBe('non_manifold_edge');
  });

  test('merges as far as it is told', () => {
    const near = read('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1.01 1 0\nv 2 0 0\nf 1 2 3\nf 2 5 4\n');
    expect(chebnet.repairMesh(near).findings).toEqual([]);
    expect(chebnet.repairMesh(near, chebnet.defects(), 0.1).findings).toMatchObject([
      { defect: 'duplicate_vertices', count: 1 },
    ]);
  });

  test('names all that it looks for', () => {
    const names: Record<Defect, true> = {
      duplicate_vertices: true,
      degenerate_faces: true,
      duplicate_faces: true,
      non_manifold_edges: true,
      inconsistent_winding: true,
      unused_vertices: true,
    };
    expect(chebnet.defects()).toEqual(Object.keys(names));
  });

  const mesh = read(MIXED);
  const wrong: [string, string, () => unknown][] = [
    ['an unknown defect', 'bad_option', () => chebnet.repairMesh(mesh, ['ugliness' as never])],
    ['defects that are none', 'bad_option', () => chebnet.repairMesh(mesh, 'all' as never)],
    ['a tolerance of 0', 'bad_option', () => chebnet.repairMesh(mesh, [], 0)],
    ['a tolerance that is text', 'bad_option', () => chebnet.repairMesh(mesh, [], '1' as never)],
    ['no mesh', 'bad_syntax', () => chebnet.repairMesh(null as never)],
    ['half a vertex', 'bad_syntax', () => chebnet.repairMesh({ ...mesh, positions: new Float64Array(4) })],
    [
      'positions of floats',
      'bad_syntax',
      () => chebnet.openMesh({ ...mesh, positions: new Float32Array(21) as never }),
    ],
    ['faces that begin late', 'bad_syntax', () => chebnet.openMesh({ ...mesh, faceStart: Int32Array.of(1, 4, 7, 12) })],
    ['faces that go back', 'bad_syntax', () => chebnet.openMesh({ ...mesh, faceStart: Int32Array.of(0, 99, 7, 12) })],
    ['faces that end early', 'bad_syntax', () => chebnet.openMesh({ ...mesh, faceStart: Int32Array.of(0, 4) })],
    [
      'no faces',
      'no_faces',
      () => chebnet.openMesh({ ...mesh, faceStart: Int32Array.of(0), faceVertices: new Int32Array() }),
    ],
    [
      'a face too far',
      'index_out_of_range',
      () => chebnet.repairMesh({ ...mesh, faceVertices: mesh.faceVertices.map((v) => v + 1) }),
    ],
    [
      'a vertex at infinity',
      'non_finite',
      () => chebnet.repairMesh({ ...mesh, positions: mesh.positions.map(() => Infinity) }),
    ],
  ];
  test.each(wrong)('refuses %s', (_, code, action) => {
    expect(failure(action).code).toBe(code);
  });
});

describe('rest lengths', () => {
  const mesh = read(MIXED);

  test('are those that are asked for', () => {
    for (const [choice, isChebyshev] of [
      ['automatic', false],
      ['own', false],
      ['equal', true],
    ] as const) {
      const editor = chebnet.openMesh(mesh, choice);
      expect(editor.info.isChebyshev).toBe(isChebyshev);
      expect(editor.restLengths).toHaveLength(editor.info.edges);
      expect(new Set(editor.restLengths).size === 1).toBe(isChebyshev);
      editor.dispose();
    }
    const editor = chebnet.openObj(MIXED, 'net.obj', 'equal');
    expect(editor.restLengths.every((length) => length === editor.info.meanLength)).toBe(true);
    editor.dispose();
  });

  test('of an unknown kind are refused', () => {
    expect(failure(() => chebnet.openMesh(mesh, 'longest' as never)).code).toBe('bad_option');
    expect(failure(() => chebnet.openMesh(mesh, 5 as never)).code).toBe('bad_option');
  });
});

describe('writing', () => {
  const editor = chebnet.openRecipe('vault:vertices=300');
  editor.setPositions(editor.restPositions.map((x, i) => x + Math.sin(i) / 7));

  test('the edges with their lengths', () => {
    const [header, ...lines] = editor.edgeTable().trimEnd().split('\n');
    expect(header).toBe('edge,vertex_a,vertex_b,length,rest_length,deviation');
    const rows = lines.map((line) => line.split(',').map(Number));
    expect(rows.flatMap(([, a, b]) => [a, b])).toEqual([...editor.edges]);
    expect(rows.map(([, , , , rest]) => rest)).toEqual([...editor.restLengths]);
    expect(rows.map(([, , , , , deviation]) => Math.fround(deviation!))).toEqual([...editor.fields().deviation]);
  });

  test('the rods with their lengths', () => {
    const [header, ...lines] = editor.rodTable().trimEnd().split('\n');
    expect(header).toBe('rod,edges,length,closed,vertices,marks');
    const rows = lines.map((line) => line.split(','));
    expect(rows.reduce((sum, [, edges]) => sum + Number(edges), 0)).toBe(editor.edges.length / 2);
    const lengths = editor
      .edgeTable()
      .trimEnd()
      .split('\n')
      .slice(1)
      .map((line) => Number(line.split(',')[3]));
    const sum = (numbers: readonly number[]) => numbers.reduce((all, each) => all + each, 0);
    expect(sum(rows.map(([, , length]) => Number(length)))).toBeCloseTo(sum(lengths), 8);
  });

  test.each<[string, string]>([
    ['obj', 'a.obj'],
    ['ply', 'a.ply'],
    ['ply_text', 'a.ply'],
    ['off', 'a.off'],
  ])('as %s keeps faces, order and every bit of the present positions', (format, name) => {
    const bytes = editor.toFile(format);
    expect(bytes).toBeInstanceOf(Uint8Array);
    expect(chebnet.readMesh(bytes, name)).toEqual({ ...meshOf(editor), positions: editor.positions() });
  });

  test('in each format of the table is read back', () => {
    for (const { name } of chebnet.formats()) {
      const { faceVertices } = chebnet.readMesh(editor.toFile(name), `a.${name}`);
      const corners = name === 'stl' ? 3 * 2 * editor.info.faces : editor.faceVertices.length;
      expect(faceVertices).toHaveLength(corners);
    }
  });

  test('as STL gives two triangles for a quad', () => {
    const triangles = 2 * editor.info.faces; // a vault has quads only
    const bytes = editor.toFile('stl');
    expect(bytes).toHaveLength(84 + 50 * triangles);
    expect(new DataView(bytes.buffer).getUint32(80, true)).toBe(triangles);
  });

  test('in an unknown format is refused', () => {
    expect(failure(() => editor.toFile('dxf'))).toMatchObject({
      code: 'bad_option',
      message: expect.stringMatching(/dxf/),
    });
    expect(failure(() => editor.toFile(1 as never)).code).toBe('bad_option');
  });
});

/** What leaves the page beside the core's own formats: flat patterns, 3DM, glTF, QR codes. */
import rhino3dm from 'rhino3dm';
import { describe, expect, test, vi } from 'vitest';
import type { CoreFields, Editor, FlatPattern } from '../../wasm/chebnet';
import { glbOf } from '../../web/src/export/glb';
import { vertexColours } from '../../web/src/export/paint';
import { type Drawing, patternSvg } from '../../web/src/export/pattern_svg';
import { seamsOf } from '../../web/src/export/seams';
import { QR_CAPACITY, qrCode } from '../../web/src/export/qr_code';
import { Recording } from '../../web/src/export/recording';
import { rhinoFileOf } from '../../web/src/export/rhino_file';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { facesOfPieces } from '../../web/src/net/pieces';
import { listsOf } from '../../web/src/handles/lines';
import { type FieldName, fieldOf, scaleOf } from '../../web/src/fields/fields';
import { fanTriangles } from '../../web/src/worker/triangles';
import { load } from '../wasm/load';
import { largestDistance } from '../wasm/load';
import { glbParts } from './glb_parts';
import { grid } from './nets';

const chebnet = await load();
const vault = chebnet.openRecipe('vault:vertices=300');

/** Without handles, an edge a centimetre long. */
function drawingOf(editor: Editor): Drawing {
  const { faceStart: start, faceVertices: vertices, restPositions, info } = editor;
  return {
    pattern: editor.flatPattern() as FlatPattern,
    lines: editor.netLines(),
    loops: editor.boundaryLoops(),
    faces: { start, vertices },
    restPositions,
    meanLength: info.meanLength,
    handles: [],
    name: '',
    edgeMm: 10,
  };
}

test('a pattern is drawn to scale, with its boundary and handles', () => {
  const net = grid(4, 3);
  const handles = [
    { vertex: 0, target: [0, 0, 0] as [number, number, number], anchor: true },
    { vertex: 11, target: [3, 2, 0] as [number, number, number], anchor: true },
    { vertex: 5, target: [1, 1, 0] as [number, number, number], anchor: false, name: 'a<b>&\u0000\uFFFE\uD800' },
  ];
  const editor = chebnet.openMesh({ ...net, positions: net.restPositions });
  const svg = patternSvg({ ...drawingOf(editor), handles, name: 'grid', edgeMm: 12.5 });
  expect(svg).toContain('width="62.5mm" height="62.5mm" viewBox="0 0 62.5 62.5"');
  const strokes = (id: string): string[] => new RegExp(`id="${id}"[^>]* d="([^"]*)"`).exec(svg)![1]!.split(/(?=M)/);
  expect(strokes('net')).toHaveLength(3);
  expect(strokes('net')).toContainEqual(expect.stringMatching(/^M(12.5 25L50 25|50 25L12.5 25)$/));
  expect(strokes('boundary')).toHaveLength(4);
  expect(svg.match(/<circle/g)).toHaveLength(3);
  expect(svg).toContain('cx="12.5" cy="37.5"');
  expect(svg).toMatch(/text-anchor="start"[^>]*>0<\/text>/);
  expect(svg).toMatch(/text-anchor="end"[^>]*>11<\/text>/);
  expect(svg).toContain('>a&lt;b&gt;&amp;   </text>');
});

test('names of handles on a pattern stand each in a cell of its own, clear of lines', () => {
  const net = grid(4, 3);
  const editor = chebnet.openMesh({ ...net, positions: net.restPositions });
  const handles = [0, 1, 3, 5, 10, 11].map((vertex) => ({
    vertex,
    target: [0, 0, 0] as [number, number, number],
    anchor: true,
    name: String(1000 + vertex),
  }));
  const svg = patternSvg({ ...drawingOf(editor), handles });
  const texts = svg.matchAll(/<text x="(.*?)" y="(.*?)" text-anchor="(.*?)" dy="0.35em" font-size="(.*?)">1\d{3}</g);
  const cells = [...texts].map(([, x, y, anchor, size]) => {
    const width = 4 * 0.62 * Number(size) * (anchor === 'end' ? -1 : 1);
    const [from, to] = [Number(x), Number(x) + width].sort((a, b) => a - b) as [number, number];
    const [top, bottom] = [Number(y) - Number(size) / 2, Number(y) + Number(size) / 2];
    // Lines are a centimetre apart, the net between 1 cm and 4 or 3 cm.
    expect(Math.floor(from / 10)).toBe(Math.floor(to / 10));
    expect(Math.floor(top / 10)).toBe(Math.floor(bottom / 10));
    expect([from, top, 40 - to, 30 - bottom].every((room) => room > 0)).toBe(true);
    return `${Math.floor(from / 10)} ${Math.floor(top / 10)}`;
  });
  expect(new Set(cells).size).toBe(handles.length);
});

test('the pieces of a net are drawn beside each other, with numbers, and are meshes of their own in a 3DM', async () => {
  const corners = [0, 1, 2, 3, 4].flatMap((i) => [`v ${3 * i} 0 0`, `v ${3 * i + 1} 0 0`, `v ${3 * i + 1} 1 0`]);
  const ends = [0, 1, 2, 3, 4].map((i) => `v ${3 * i} 1 0`);
  const quads = [0, 1, 2, 3, 4].map((i) => `f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3} ${16 + i}`);
  const editor = chebnet.openObj([...corners, ...ends, ...quads, ''].join('\n'));
  const drawing = { ...drawingOf(editor), name: 'squares' };
  const svg = patternSvg(drawing);
  const labels = [...svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)" [^>]*>(\d)<\/text>/g)].map(([, ...each]) =>
    each.map(Number),
  );
  // Three and two, as words are set in lines.
  expect(labels).toEqual([
    [10, 10, 1],
    [40, 10, 2],
    [10, 40, 3],
    [40, 40, 4],
    [10, 70, 5],
  ]);

  const mesh = { faceStart: editor.faceStart, faceVertices: editor.faceVertices };
  expect(facesOfPieces(mesh)).toEqual([[0], [1], [2], [3], [4]]);
  const { restPositions: positions } = editor;
  const bytes = await rhinoFileOf({ mesh, positions, rods: editor.rods(), name: 'squares', layers: LAYERS });
  const rhino = await rhino3dm();
  const objects = rhino.File3dm.fromByteArray(bytes).objects();
  for (let i = 0; i < 5; i++) {
    expect(objects.get(i).attributes().name).toBe(`squares ${i + 1}`);
    const piece = objects.get(i).geometry() as InstanceType<typeof rhino.Mesh>;
    expect(piece.vertices().count).toBe(4);
    expect(
      piece
        .faces()
        .get(0)
        .map((place) => piece.vertices().point3dAt(place)[0]),
    ).toEqual([0, 1, 1, 0].map((x) => 3 * i + x));
  }
});

test('rods that end on the border of a surface are drawn as long as they are', () => {
  const shell = chebnet.ownSurface('shell');
  const { mesh, cutEnds } = shell.drape({ ...shell.suggest(300), border: 'cut' });
  shell.dispose();
  const editor = chebnet.openMesh(mesh);
  const pattern = editor.flatPattern() as FlatPattern;
  const isCut = (vertex: number) => [0, 1].some((axis) => !Number.isInteger(pattern.places[2 * vertex + axis]));
  expect(Array.from({ length: editor.info.vertices }, (_, v) => v).filter(isCut)).toHaveLength(cutEnds);
  const svg = patternSvg({ ...drawingOf(editor), name: 'shell' });
  expect(svg).toMatch(/^[^N]*$/);
  // A rod is one straight stroke: upright or level.
  const strokes = /id="net"[^>]* d="M([^"]*)"/.exec(svg)![1]!.split('M');
  expect(strokes.length).toBeGreaterThan(30);
  for (const stroke of strokes) {
    const ends = stroke.split('L').map((place) => place.split(' ').map(Number));
    expect(ends).toHaveLength(2);
    expect(ends[0]![0] === ends[1]![0] || ends[0]![1] === ends[1]![1]).toBe(true);
  }
});

test('both sides of a seam have its letter, and all sides of a net that was closed have one or lie closed', () => {
  const { faceStart, faceVertices, restPositions: positions } = chebnet.openRecipe('jack:vertices=400');
  const { mesh } = chebnet.change({ positions, faceStart, faceVertices }, 'cut_flat');
  const editor = chebnet.openMesh(mesh);
  const drawing = drawingOf(editor);
  const seams = seamsOf(drawing.loops, drawing.restPositions, drawing.meanLength);
  const sides = seams.reduce((sum, [one]) => sum + one.length - 1, 0);
  expect(2 * sides).toBe(drawing.loops.vertices.length);
  for (const [one, other] of seams) {
    expect(other.length).toBe(one.length);
    for (const [i, vertex] of one.entries())
      for (const axis of [0, 1, 2])
        expect(drawing.restPositions[3 * other[i]! + axis]).toBe(drawing.restPositions[3 * vertex + axis]);
  }

  const letters = [...patternSvg(drawing).matchAll(/>([A-Z]+)<\/text>/g)].map(([, letter]) => letter);
  expect(letters.length).toBeGreaterThan(4);
  expect(letters).toEqual([...new Set(letters)].flatMap((letter) => [letter, letter]));
  expect(patternSvg(drawingOf(vault))).not.toContain('id="seams"');
});

const LAYERS = { mesh: 'Mesh', rods: 'Rods' };

test('a 3DM holds the quads and the rods, to the last digit', async () => {
  const { faceVertices, restPositions } = vault;
  const rods = vault.rods();
  const bytes = await rhinoFileOf({ mesh: vault, positions: restPositions, rods, name: 'vault', layers: LAYERS });
  const rhino = await rhino3dm();
  const file = rhino.File3dm.fromByteArray(bytes);
  expect([0, 1].map((layer) => file.layers().get(layer).name)).toEqual(['Mesh', 'Rods']);

  const mesh = file.objects().get(0).geometry() as InstanceType<typeof rhino.Mesh>;
  expect(file.objects().get(0).attributes().layerIndex).toBe(0);
  expect(mesh.faces().quadCount).toBe(vault.info.faces);
  expect(Array.from({ length: vault.info.faces }, (_, f) => mesh.faces().get(f)).flat()).toEqual([...faceVertices]);
  expect(Array.from({ length: vault.info.vertices }, (_, v) => mesh.vertices().point3dAt(v)).flat()).toEqual([
    ...restPositions,
  ]);

  expect(file.objects().count).toBe(1 + rods.start.length - 1);
  listsOf(rods).forEach((vertices, i) => {
    const object = file.objects().get(1 + i);
    const line = object.geometry() as InstanceType<typeof rhino.PolylineCurve>;
    expect(object.attributes().layerIndex).toBe(1);
    expect(Array.from({ length: line.pointCount }, (_, k) => line.point(k)).flat()).toEqual(
      [...vertices].flatMap((v) => [...restPositions.subarray(3 * v, 3 * v + 3)]),
    );
  });
});

test('faces of other sizes become triangles in a 3DM', async () => {
  const pentagon = chebnet.openObj('v 0 0 0\nv 1 0 0\nv 1.5 1 0\nv 0.5 2 0\nv -0.5 1 0\nf 1 2 3 4 5\n');
  const bytes = await rhinoFileOf({
    mesh: pentagon,
    positions: pentagon.restPositions,
    rods: pentagon.rods(),
    name: 'pentagon',
    layers: LAYERS,
  });
  const rhino = await rhino3dm();
  const mesh = rhino.File3dm.fromByteArray(bytes).objects().get(0).geometry() as InstanceType<typeof rhino.Mesh>;
  expect([0, 1, 2].map((f) => mesh.faces().get(f).slice(0, 3))).toEqual([
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
  ]);
});

describe('glTF', () => {
  // All of it that the exporter uses, which Node has not.
  vi.stubGlobal(
    'FileReader',
    class {
      result: ArrayBuffer | null = null;
      onloadend: () => void = () => {};
      async readAsArrayBuffer(blob: Blob): Promise<void> {
        this.result = await blob.arrayBuffer();
        this.onloadend();
      }
    },
  );
  const { faceStart, faceVertices, edges, restPositions: positions } = vault;
  const painted = {
    positions,
    triangles: fanTriangles(faceStart, faceVertices),
    edges,
    colours: Uint8Array.from({ length: positions.length }, (_, i) => [255, 128, 0][i % 3]!),
    ink: [0, 0, 0] as const,
    up: 'z' as const,
    name: 'vault',
  };

  test('holds positions, linear colours, triangles and edges', async () => {
    const { faces, lines, root } = glbParts(await glbOf(painted));
    expect(faces.positions).toEqual(Float32Array.from(positions));
    expect(lines.positions).toEqual(faces.positions);
    expect([...faces.indices]).toEqual([...painted.triangles]);
    expect([...lines.indices]).toEqual([...edges]);
    expect(faces.colours!.length).toBe(positions.length);
    // 128 of 255 is a fifth of the light.
    expect([...faces.colours!.subarray(0, 3)]).toEqual([1, expect.closeTo(0.216, 3), 0]);
    const lengths = edgeLengths(Float64Array.from(faces.positions), edges);
    expect(Math.max(...lengths) / Math.min(...lengths)).toBeCloseTo(1, 4);
    expect(root.rotation).toEqual([expect.closeTo(-Math.SQRT1_2), 0, 0, expect.closeTo(Math.SQRT1_2)]);
  });

  test('far from the origin holds a net as exactly, in a node that is there', async () => {
    const far = positions.map((x, i) => x + [5.4e6, 6e5, 400][i % 3]!);
    const { faces, lines, nodes } = glbParts(await glbOf({ ...painted, positions: far }));
    const places = nodes.filter(({ mesh }) => mesh !== undefined).map(({ translation }) => translation!);
    expect(places).toHaveLength(2);
    expect(places[0]).toEqual(places[1]);
    expect(lines.positions).toEqual(faces.positions);
    expect(
      largestDistance(
        Float64Array.from(faces.positions, (x, i) => x + places[0]![i % 3]!),
        far,
      ),
    ).toBeLessThan(1e-5);
  });

  test('stands as it is where y is up', async () => {
    const { root } = glbParts(await glbOf({ ...painted, up: 'y' }));
    expect(root.rotation).toBeUndefined();
  });
});

test('a vertex takes the colour of its worst edge, of its angle, or of most of its edges', () => {
  const colours = {
    good: [0, 0, 1],
    bad: [1, 0, 0],
    narrow: [0, 1, 0],
    right: [0, 0, 0],
    wide: [1, 1, 0],
    warn: [1, 1, 0],
    longer: [1, 0, 1],
    dark: false,
  } as const;
  const frame = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 3, 0, 0),
    lengthScale: 1,
    fields: {
      deviation: Float32Array.of(1e-9, 1),
      angle: Float32Array.of(Math.PI / 4, Math.PI / 2, Math.PI),
    } as CoreFields,
  };
  const faces = { faceStart: Int32Array.of(0), faceVertices: Int32Array.of() };
  const net = { edges: Int32Array.of(0, 1, 1, 2), restLengths: Float64Array.of(1, 1), ...faces };
  const coloursBy = (name: FieldName) => {
    const scale = scaleOf({ field: name, colourMap: 'paper' }, colours);
    return [...vertexColours(scale, fieldOf(name), frame, net)];
  };
  expect(coloursBy('deviation')).toEqual([0, 0, 255, 255, 0, 0, 255, 0, 0]);
  const [, green, , ...others] = coloursBy('angle');
  expect(green).toBe(255);
  expect(Math.max(...others.slice(0, 3))).toBeLessThan(3);
  expect(others.slice(3)).toEqual([255, 255, 0]);
  const longer = coloursBy('longer');
  frame.lengthScale = 2;
  expect(coloursBy('longer').slice(6)).toEqual(longer.slice(0, 3));
  expect([longer.slice(0, 3), longer.slice(6)]).toEqual([
    [0, 0, 0],
    [255, 0, 255],
  ]);
});

test('a QR code has room for links of its capacity and no more', () => {
  const { size, path } = qrCode('https://example.org/#v1=abc');
  expect(path.startsWith('M4 4h1v1h-1z')).toBe(true);
  expect(size).toBeGreaterThan(28);
  expect(qrCode('x'.repeat(QR_CAPACITY)).size).toBe(177 + 8);
  expect(() => qrCode('x'.repeat(QR_CAPACITY + 1))).toThrow();
});

test('a film that a browser does not record after all is ended', () => {
  vi.stubGlobal(
    'MediaRecorder',
    class {
      constructor() {
        throw new Error('no such codec');
      }
    },
  );
  const film = { stream: {} as MediaStream, end: vi.fn() };
  const record = () => new Recording(film, 'video/webm', () => {});
  expect(record).toThrow(expect.objectContaining({ code: 'no_film' }));
  expect(film.end).toHaveBeenCalledOnce();
  vi.unstubAllGlobals();
});

/** The mesh of a file comes back from few bytes, nearly; what else bytes may be is refused. */
import { deflateSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/chebnet';
import { objText } from '../../web/src/document/obj_text';
import { packMesh, unpackMesh } from '../../web/src/document/packed_mesh';
import { largestDistance, load } from '../wasm/load';
import { grid } from './nets';
import { printedSeed, random } from './random';

const core = await load();

/** Unit squares, some of them cut into triangles, each vertex moved a little. */
function rough(columns: number, rows: number, seed: string): Mesh {
  const next = random(printedSeed(seed));
  const { restPositions, faceStart, faceVertices } = grid(columns, rows, () => next() < 0.2);
  return { positions: restPositions.map((x) => x + 0.2 * next()), faceStart, faceVertices };
}

function bentSheet(vertices: number): Mesh {
  const editor = core.openRecipe(`sheet:vertices=${vertices}`);
  const { faceStart, faceVertices } = editor;
  const positions = editor.restPositions.slice();
  for (let i = 0; i < positions.length; i += 3) positions[i + 2] = Math.cos(positions[i]! / 9) * positions[i + 1]!;
  return { positions, faceStart: faceStart.slice(), faceVertices: faceVertices.slice() };
}

test.each([1e-7, 1e-4])('within %d of half an edge, and all numbers of vertices and faces', (precision) => {
  const mesh = rough(12, 9, 'packed meshes');
  const again = unpackMesh(packMesh(mesh, precision)!);
  expect(again.faceStart).toEqual(mesh.faceStart);
  expect(again.faceVertices).toEqual(mesh.faceVertices);
  // Edges have about 1, and each of three coordinates is within half a step.
  expect(largestDistance(again.positions, mesh.positions)).toBeLessThan(precision);
  // What has come back once comes back again.
  expect(packMesh(again, precision)).toHaveLength(packMesh(mesh, precision)!.length);
});

test('a smooth net in less than a fifth of its text', () => {
  const mesh = bentSheet(4000);
  const [packed, text] = [packMesh(mesh, 1e-4)!, objText(mesh)].map(
    (each) => deflateSync(typeof each === 'string' ? Buffer.from(each) : each, { level: 9 }).length,
  );
  expect(packed!).toBeLessThan(text! / 5);
});

test('a net far away from the origin', () => {
  const mesh = rough(5, 5, 'packed meshes far away');
  for (let i = 0; i < mesh.positions.length; ++i) mesh.positions[i]! += 1e6;
  expect(largestDistance(unpackMesh(packMesh(mesh, 1e-6)!).positions, mesh.positions)).toBeLessThan(1e-6);
});

test('a vertex of many edges', () => {
  const around = Array.from({ length: 3000 }, (_, k) => (2 * Math.PI * k) / 3000);
  const mesh: Mesh = {
    positions: Float64Array.from([0, 0, 0, ...around.flatMap((angle) => [Math.cos(angle), Math.sin(angle), 0])]),
    faceStart: Int32Array.from({ length: 3001 }, (_, f) => 3 * f),
    faceVertices: Int32Array.from(around.flatMap((_, k) => [0, 1 + k, 1 + ((k + 1) % 3000)])),
  };
  expect(unpackMesh(packMesh(mesh, 1e-6)!).faceVertices).toEqual(mesh.faceVertices);
});

describe('not packed is', () => {
  const faces = { faceStart: Int32Array.of(0, 3), faceVertices: Int32Array.of(0, 1, 2) };
  test.each([
    ['an edge too short for the precision', { positions: Float64Array.of(0, 0, 0, 1e-9, 0, 0, 1, 1, 0), ...faces }],
    ['an edge without a length', { positions: new Float64Array(9), ...faces }],
    ['a coordinate that is no number', { positions: Float64Array.of(0, 0, NaN, 1, 0, 0, 1, 1, 0), ...faces }],
    ['a net too far away', { positions: Float64Array.of(1e30, 0, 0, 1e30, 1, 0, 1e30, 0, 1), ...faces }],
    ['nothing', { positions: new Float64Array(), faceStart: Int32Array.of(0), faceVertices: new Int32Array() }],
  ])('%s', (_, mesh) => expect(packMesh(mesh, 1e-7)).toBeNull());

  test('a mesh of too many vertices to be opened from a link', () => {
    const { restPositions: positions, faceStart, faceVertices } = grid(400, 400);
    expect(
      packMesh({ positions: positions.map((x) => x + Math.sin(x * x)), faceStart, faceVertices }, 1e-7),
    ).toBeNull();
  });
});

describe('refused is', () => {
  const packed = packMesh(rough(4, 4, 'refused meshes'), 1e-4)!;

  test('what is cut off anywhere', () => {
    for (let length = 0; length < packed.length; ++length)
      expect(() => unpackMesh(packed.subarray(0, length))).toThrow(expect.objectContaining({ code: 'bad_link' }));
  });

  test.each([
    ['what goes on behind its end', Uint8Array.of(...packed, 0)],
    ['more vertices than bytes', Uint8Array.of(254, 255, 255, 255, 15, 2, 0)],
    ['a face of a vertex that is not there', Uint8Array.of(6, 2, 1, 0, 2, 6, ...new Uint8Array(17))],
    ['more than a megabyte', new Uint8Array(1_000_001)],
  ])('%s', (_, bytes) => {
    expect(() => unpackMesh(bytes)).toThrow(expect.objectContaining({ code: 'bad_link' }));
  });
});

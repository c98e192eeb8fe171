/**
 * Meshes of files in few bytes, for links: a tenth of their text. Vertices and faces keep their numbers.
 *
 * Layout, in integers but for the step: how many vertices and faces there are; for each face how many more corners it has
 * than four, and by how much each is more than that of the face before it; the step as a 64-bit float, little end first; then
 * for each axis the coordinates in steps, as prediction.ts predicts them.
 */
import type { Mesh } from '../../../wasm/chebnet';
import { edgeLengths } from '../net/edge_lengths';
import { damaged, NumberReader, LARGEST_INTEGER, writeFloat64, writeInteger } from './numbers';
import { type Connectivity, forEachPrediction } from './prediction';

/** Corners of most faces. */
const QUAD = 4;
/** The largest step, in lengths of the shortest edge. */
const FINENESS = 0.01;
/** Bytes of one, at most: what is made of it takes much more. */
const LARGEST_MESH = 1e6;

/** @param precision each coordinate comes back within half of it, in lengths of the mean edge; null: that is too coarse for
 *  the shortest one, or the mesh is too large. */
export function packMesh(mesh: Mesh, precision: number): Uint8Array | null {
  const net = connectivityOf(mesh);
  const lengths = edgeLengths(mesh.positions, net.edges);
  const step = (precision * lengths.reduce((sum, length) => sum + length, 0)) / lengths.length;
  const shortest = lengths.reduce((least, length) => Math.min(least, length), Infinity);
  if (!(step > 0 && step <= FINENESS * shortest)) return null;
  const steps = mesh.positions.map((x) => Math.round(x / step));
  if (!steps.every((x) => Math.abs(x) <= LARGEST_INTEGER)) return null;
  const bytes: number[] = [];
  writeInteger(bytes, net.vertices);
  writeInteger(bytes, mesh.faceStart.length - 1);
  writeFaces(bytes, mesh);
  writeFloat64(bytes, step);
  forEachPrediction(net, (i, prediction) => {
    const value = steps[i] ?? 0;
    writeInteger(bytes, value - prediction);
    return value;
  });
  return bytes.length <= LARGEST_MESH ? Uint8Array.from(bytes) : null;
}

/** The mesh that `packMesh` packed, whether or not it is a net. Throws a Failure, "bad_link", if it is damaged. */
export function unpackMesh(packed: Uint8Array): Mesh {
  if (packed.length > LARGEST_MESH) throw damaged();
  const reader = new NumberReader(packed);
  const vertices = readCount(reader, 3);
  const faces = readFaces(reader, vertices);
  const step = reader.float64();
  if (!(step > 0 && step < Infinity)) throw damaged();
  const positions = new Float64Array(3 * vertices);
  forEachPrediction(connectivityOf({ positions, ...faces }), (i, prediction) => {
    const value = prediction + reader.integer();
    if (!(Math.abs(value) <= LARGEST_INTEGER)) throw damaged();
    positions[i] = value * step;
    if (!Number.isFinite(positions[i])) throw damaged();
    return value;
  });
  reader.end();
  return { positions, ...faces };
}

function writeFaces(bytes: number[], { faceStart, faceVertices }: Mesh): void {
  for (let f = 0; f + 1 < faceStart.length; ++f) {
    const [before, start, end] = [faceStart[f - 1] ?? 0, faceStart[f]!, faceStart[f + 1]!];
    writeInteger(bytes, end - start - QUAD);
    for (let k = 0; start + k < end; ++k)
      writeInteger(bytes, faceVertices[start + k]! - (before + k < start ? faceVertices[before + k]! : 0));
  }
}

/** Of something each of which takes `least` bytes: no more than there are bytes for. */
function readCount(reader: NumberReader, least: number): number {
  const count = reader.integer();
  if (!(count >= 0 && count * least <= reader.left)) throw damaged();
  return count;
}

function readFaces(reader: NumberReader, vertices: number): Pick<Mesh, 'faceStart' | 'faceVertices'> {
  const starts = [0];
  const corners: number[] = [];
  let before: number[] = [];
  for (let left = readCount(reader, QUAD); left > 0; --left) {
    const face: number[] = [];
    for (let more = QUAD + reader.integer(); more > 0; --more) {
      const vertex = (before[face.length] ?? 0) + reader.integer();
      if (!(vertex >= 0 && vertex < vertices)) throw damaged();
      face.push(vertex);
    }
    for (const vertex of face) corners.push(vertex);
    starts.push(corners.length);
    before = face;
  }
  return { faceStart: Int32Array.from(starts), faceVertices: Int32Array.from(corners) };
}

/** Edges in the order of their vertices, as the core has them. */
function connectivityOf({ positions, faceStart, faceVertices }: Mesh): Connectivity {
  const vertices = positions.length / 3;
  const sides: number[] = [];
  for (let f = 0; f + 1 < faceStart.length; ++f) {
    const face = faceVertices.subarray(faceStart[f], faceStart[f + 1]);
    face.forEach((a, k) => {
      const b = face[(k + 1) % face.length]!;
      sides.push(Math.min(a, b) * vertices + Math.max(a, b));
    });
  }
  const sorted = Float64Array.from(sides).sort();
  const edges = sorted.filter((side, i) => side !== sorted[i - 1]);
  return {
    vertices,
    edges: Int32Array.from([...edges].flatMap((side) => [Math.floor(side / vertices), side % vertices])),
    faceStart,
    faceVertices,
  };
}

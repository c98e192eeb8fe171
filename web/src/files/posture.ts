/** Which axis of a mesh points up. Files do not say: some programs have z up, others y, and a net then lies on its back. */
import type { Mesh } from '../../../wasm/chebnet';
import type { UpAxis } from '../document/document';

export interface Posture {
  up: UpAxis;
  /** Whether the mesh shows it clearly. */
  isClear: boolean;
  /** Some of its edges, for a picture. */
  sketch: { edges: Int32Array; positions: Float32Array };
}

/** A vertex so near the lowest or the highest, as a part of the height, is at the bottom or at the top. */
const NEAR = 0.03;
/** The mean of |n · axis| of a body round about is half; from here on most of a mesh looks up or down. */
const LEVEL = 0.65;
/** By so much one axis has to be more likely than the other. */
const CLEARLY = 0.01;
const MOST_FACES = 3_000;

export function postureOf(mesh: Mesh): Posture {
  const isBorder = bordersOf(mesh);
  const [y, z] = [likelihood(mesh, isBorder, 1), likelihood(mesh, isBorder, 2)];
  return { up: y > z ? 'y' : 'z', isClear: Math.abs(y - z) > CLEARLY, sketch: sketchOf(mesh) };
}

/** How much speaks for an axis: that the mesh stands on more vertices than it has at the top, that it lies level, and that
 *  it arches over its border, or hangs within it. */
function likelihood(mesh: Mesh, isBorder: readonly boolean[], axis: 1 | 2): number {
  return standing(mesh, axis) + Math.max(0, meanSlope(mesh, axis) - LEVEL) + arching(mesh, isBorder, axis);
}

/** The part of the vertices at the bottom, less that at the top; 0 of a mesh that is flat across the axis. */
function standing({ positions }: Mesh, axis: 1 | 2): number {
  let [low, high] = [Infinity, -Infinity];
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]!);
    high = Math.max(high, positions[i]!);
  }
  const near = NEAR * (high - low);
  let difference = 0;
  for (let i = axis; i < positions.length; i += 3) {
    if (positions[i]! <= low + near) difference += 1;
    if (positions[i]! >= high - near) difference -= 1;
  }
  return difference / (positions.length / 3);
}

/** How far the mean vertex is from the mean one of the border, as a part of the height. */
function arching({ positions }: Mesh, isBorder: readonly boolean[], axis: 1 | 2): number {
  const [all, border] = [new Heights(), new Heights()];
  isBorder.forEach((is, vertex) => {
    const height = positions[3 * vertex + axis]!;
    all.add(height);
    if (is) border.add(height);
  });
  return border.count > 0 && all.range > 0 ? Math.abs(all.mean - border.mean) / all.range : 0;
}

class Heights {
  count = 0;
  #sum = 0;
  #low = Infinity;
  #high = -Infinity;

  add(height: number): void {
    this.count += 1;
    this.#sum += height;
    this.#low = Math.min(this.#low, height);
    this.#high = Math.max(this.#high, height);
  }

  get mean(): number {
    return this.#sum / this.count;
  }

  get range(): number {
    return this.#high - this.#low;
  }
}

/** V: whether it is on a border, which is where what comes after it in its faces is not what comes before it. */
function bordersOf({ positions, faceStart, faceVertices }: Mesh): boolean[] {
  const balance = new Float64Array(positions.length / 3);
  for (let face = 0; face + 1 < faceStart.length; face += 1) {
    const [begin, end] = [faceStart[face]!, faceStart[face + 1]!];
    for (let k = begin; k < end; k += 1) {
      const [a, b] = [faceVertices[k]!, faceVertices[k + 1 < end ? k + 1 : begin]!];
      balance[a]! += b;
      balance[b]! -= a;
    }
  }
  return Array.from(balance, (each) => each !== 0);
}

/** The mean of |n · axis| over the area. */
function meanSlope({ positions, faceStart, faceVertices }: Mesh, axis: 1 | 2): number {
  let [along, whole] = [0, 0];
  for (let face = 0; face + 1 < faceStart.length; face += 1) {
    const normal = [0, 0, 0];
    // Newell's sum: twice the area, along the normal.
    for (let k = faceStart[face]!; k < faceStart[face + 1]!; k += 1) {
      const a = 3 * faceVertices[k]!;
      const b = 3 * faceVertices[k + 1 < faceStart[face + 1]! ? k + 1 : faceStart[face]!]!;
      for (let i = 0; i < 3; i += 1) {
        const [j, l] = [(i + 1) % 3, (i + 2) % 3];
        normal[i]! += (positions[a + j]! - positions[b + j]!) * (positions[a + l]! + positions[b + l]!);
      }
    }
    along += Math.abs(normal[axis]!);
    whole += Math.hypot(...normal);
  }
  return whole > 0 ? along / whole : 0;
}

function sketchOf({ positions, faceStart, faceVertices }: Mesh): Posture['sketch'] {
  const places = new Map<number, number>();
  const place = (vertex: number): number => {
    const known = places.get(vertex) ?? places.size;
    places.set(vertex, known);
    return known;
  };
  const step = Math.ceil((faceStart.length - 1) / MOST_FACES) || 1;
  const edges: number[] = [];
  for (let face = 0; face + 1 < faceStart.length; face += step) {
    const corners = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    corners.forEach((vertex, k) => edges.push(place(vertex), place(corners[(k + 1) % corners.length]!)));
  }
  const drawn = [...places.keys()].flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]);
  return { edges: Int32Array.from(edges), positions: Float32Array.from(drawn) };
}

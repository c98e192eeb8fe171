/** Lengths computed by the tests themselves, a mesh that nobody would make, and a hand on the pointer. */
import type { Script } from './page';

export function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}

/** The vertex of a net that rests nearest to a point, given in parts of the net's extent in x and y. */
export function vertexAt(restPositions: Float64Array, u: number, v: number): number {
  const [xs, ys] = [0, 1].map((axis) => restPositions.filter((_, i) => i % 3 === axis));
  const between = (values: Float64Array, part: number) => Math.min(...values) * (1 - part) + Math.max(...values) * part;
  const [x, y] = [between(xs!, u), between(ys!, v)];
  const far = Array.from(xs!, (each, vertex) => Math.hypot(each - x, ys![vertex]! - y));
  return far.indexOf(Math.min(...far));
}

/** dL of the worst edge against `length`. */
export function largestDeviation(positions: Float64Array, edges: Int32Array, length: number): number {
  let largest = 0;
  for (let e = 0; e < edges.length; e += 2) {
    const [a, b] = [3 * edges[e]!, 3 * edges[e + 1]!];
    const ratio = distance(positions.subarray(a, a + 3), positions.subarray(b, b + 3)) / length;
    const deviation = ratio + 1 / ratio - 2;
    if (!(deviation <= largest)) largest = deviation; // NaN must not pass
  }
  return largest;
}

/** Largest difference of a coordinate. */
export function largestError(a: Float64Array, b: Float64Array): number {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  a.forEach((value, i) => {
    const difference = Math.abs(value - b[i]!);
    if (!(difference <= largest)) largest = difference;
  });
  return largest;
}

/** As an OBJ: a rim of unit radius around vertex 0. */
export function fan(count: number): string {
  const angles = Array.from({ length: count }, (_, i) => (2 * Math.PI * i) / count);
  const rim = angles.map((angle, i) => `v ${Math.cos(angle)} ${Math.sin(angle)} ${0.01 * (i % 3)}`);
  const faces = angles.map((_, i) => `f 1 ${i + 2} ${((i + 1) % count) + 2}`);
  return ['v 0 0 0', ...rim, ...faces, ''].join('\n');
}

/** As an OBJ: quads around vertex 0, wavy, so that edges differ in length. */
export function fanOfQuads(count: number): string {
  const place = (radius: number, steps: number, z: number) => {
    const angle = (2 * Math.PI * steps) / count;
    return `v ${radius * Math.cos(angle)} ${radius * Math.sin(angle)} ${z}`;
  };
  const all = Array.from({ length: count }, (_, i) => i);
  const spokes = all.map((i) => place(1, i, 0.3 * (i % 2)));
  const outer = all.map((i) => place(2, i + 0.5, 0.1));
  const faces = all.map((i) => `f 1 ${i + 2} ${i + 2 + count} ${((i + 1) % count) + 2}`);
  return ['v 0 0 0', ...spokes, ...outer, ...faces, ''].join('\n');
}

interface Watching {
  /** Moves of the pointer. */
  steps?: number;
  /** After each move of the pointer. */
  during?(): Promise<void>;
  /** Before the button is let go. */
  atEnd?(): Promise<void>;
}

/** Drags the handle at a vertex across the screen with the mouse. */
export async function dragBy(script: Script, vertex: number, [dx, dy]: [number, number], watching: Watching = {}) {
  const { mouse } = script.page;
  const { x, y } = await script.screenPosition(vertex);
  const { steps = 10 } = watching;
  await mouse.move(x, y);
  await mouse.down();
  for (let i = 1; i <= steps; ++i) {
    await mouse.move(x + (dx * i) / steps, y + (dy * i) / steps);
    await script.page.waitForTimeout(30);
    await watching.during?.();
  }
  await watching.atEnd?.();
  await mouse.up();
}

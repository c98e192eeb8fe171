/** The nearest point of a surface, many times a second, with no word to a worker: triangles in a tree of boxes. */
import type { Vec3 } from '../document/document';

export interface Triangles {
  /** 3 numbers a vertex. */
  readonly positions: Float64Array;
  /** 3 vertices each. */
  readonly triangles: Int32Array;
}

/** A part of the triangles: two halves, or few enough to look at each. */
interface Box {
  low: Vec3;
  high: Vec3;
  /** In the order of the tree. */
  first: number;
  end: number;
  halves: readonly [Box, Box] | null;
}

const FEW = 8;

export class SurfacePoints {
  readonly #surface: Triangles;
  readonly #order: Int32Array;
  readonly #root: Box;

  constructor(surface: Triangles) {
    this.#surface = surface;
    this.#order = Int32Array.from({ length: surface.triangles.length / 3 }, (_, triangle) => triangle);
    this.#root = this.#boxOf(0, this.#order.length);
  }

  nearest(point: Vec3): Vec3 {
    return this.#search(this.#root, point, { square: Infinity, at: point }).at;
  }

  #search(box: Box, point: Vec3, best: { square: number; at: Vec3 }): { square: number; at: Vec3 } {
    if (squareTo(box, point) >= best.square) return best;
    if (box.halves) {
      const [a, b] = box.halves;
      const [near, far] = squareTo(a, point) < squareTo(b, point) ? [a, b] : [b, a];
      return this.#search(far, point, this.#search(near, point, best));
    }
    for (let i = box.first; i < box.end; i++) {
      const at = nearestOf(this.#corners(this.#order[i]!), point);
      const square = squareBetween(at, point);
      if (square < best.square) best = { square, at };
    }
    return best;
  }

  /** Cut across where it is longest, into halves of as many triangles. */
  #boxOf(first: number, end: number): Box {
    const low: Vec3 = [Infinity, Infinity, Infinity];
    const high: Vec3 = [-Infinity, -Infinity, -Infinity];
    for (let i = first; i < end; i++)
      for (const corner of this.#corners(this.#order[i]!))
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis]!, corner[axis]!);
          high[axis] = Math.max(high[axis]!, corner[axis]!);
        }
    if (end - first <= FEW) return { low, high, first, end, halves: null };
    const sizes = high.map((x, axis) => x - low[axis]!);
    const axis = sizes.indexOf(Math.max(...sizes));
    const middle = (triangle: number): number => {
      const [a, b, c] = this.#corners(triangle);
      return a[axis]! + b[axis]! + c[axis]!;
    };
    this.#order.subarray(first, end).sort((a, b) => middle(a) - middle(b));
    const half = (first + end) >> 1;
    return { low, high, first, end, halves: [this.#boxOf(first, half), this.#boxOf(half, end)] };
  }

  #corners(triangle: number): readonly [Vec3, Vec3, Vec3] {
    const { positions, triangles } = this.#surface;
    const corner = (k: number): Vec3 => {
      const at = 3 * triangles[3 * triangle + k]!;
      return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
    };
    return [corner(0), corner(1), corner(2)];
  }
}

function squareTo({ low, high }: Box, point: Vec3): number {
  return squareBetween(point.map((x, axis) => Math.min(Math.max(x, low[axis]!), high[axis]!)) as Vec3, point);
}

export function squareBetween(a: Vec3, b: Vec3): number {
  return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
}

/** Of a triangle: within it, or else on the nearest of its sides. */
function nearestOf([a, b, c]: readonly [Vec3, Vec3, Vec3], point: Vec3): Vec3 {
  const [u, v, w] = [minus(b, a), minus(c, a), minus(point, a)];
  const [uu, uv, vv, wu, wv] = [dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)];
  const area = uu * vv - uv * uv;
  const [s, t] = [(wu * vv - wv * uv) / area, (wv * uu - wu * uv) / area];
  if (area > 0 && s >= 0 && t >= 0 && s + t <= 1) return plus(plus(a, u, s), v, t);
  const onSides = [nearestOnSide(a, b, point), nearestOnSide(b, c, point), nearestOnSide(c, a, point)];
  return onSides.reduce((best, each) => (squareBetween(each, point) < squareBetween(best, point) ? each : best));
}

export function nearestOnSide(from: Vec3, to: Vec3, point: Vec3): Vec3 {
  const along = minus(to, from);
  const square = dot(along, along);
  return plus(from, along, square > 0 ? Math.min(Math.max(dot(minus(point, from), along) / square, 0), 1) : 0);
}

function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function plus(a: Vec3, b: Vec3, factor: number): Vec3 {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}

function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

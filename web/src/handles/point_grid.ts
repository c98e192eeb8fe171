/** Points by the cubes of a grid, so that what is near a place is found without looking at all of them. */
import type { Vec3 } from '../document/document';

export class PointGrid {
  readonly #points: Float64Array;
  readonly #reach: number;
  readonly #cubes = new Map<number, number[]>();

  /** @param reach how far from a place points are looked for. */
  constructor(points: Float64Array, reach: number) {
    this.#points = points;
    this.#reach = reach;
    for (let i = 0; i < points.length; i += 3) {
      const cube = keyOf(this.#cubeOf(points[i]!), this.#cubeOf(points[i + 1]!), this.#cubeOf(points[i + 2]!));
      const inside = this.#cubes.get(cube);
      if (inside) inside.push(i / 3);
      else this.#cubes.set(cube, [i / 3]);
    }
  }

  /** The nearest point within reach, of several the last; null: there is none. */
  nearest(place: Vec3): number | null {
    let nearest: number | null = null;
    let smallest = this.#reach ** 2;
    for (const point of this.#around(place)) {
      const distance = this.#squareTo(place, point);
      if (distance > smallest || (distance === smallest && nearest !== null && point < nearest)) continue;
      smallest = distance;
      nearest = point;
    }
    return nearest;
  }

  /** All within reach, and some beyond. */
  *#around(place: Vec3): Generator<number> {
    const [is, js, ks] = place.map((x) => this.#cubesAround(x));
    const keys = new Set<number>();
    for (const i of is!) for (const j of js!) for (const k of ks!) keys.add(keyOf(i, j, k));
    for (const key of keys) yield* this.#cubes.get(key) ?? [];
  }

  /** The numbers along an axis; counted from 0, as 1 more makes no difference to those from 2^53 on. */
  #cubesAround(x: number): number[] {
    const low = this.#cubeOf(x - this.#reach);
    const high = this.#cubeOf(x + this.#reach);
    const cubes: number[] = [];
    for (let step = 0; step <= high - low; ++step) cubes.push(low + step);
    return cubes;
  }

  #squareTo([x, y, z]: Vec3, point: number): number {
    const [dx, dy, dz] = [
      this.#points[3 * point]! - x,
      this.#points[3 * point + 1]! - y,
      this.#points[3 * point + 2]! - z,
    ];
    return dx * dx + dy * dy + dz * dz;
  }

  #cubeOf(x: number): number {
    return Math.floor(x / (2 * this.#reach));
  }
}

/** Cubes far from each other may share one. */
function keyOf(i: number, j: number, k: number): number {
  return Math.imul(i, 73856093) ^ Math.imul(j, 19349663) ^ Math.imul(k, 83492791);
}

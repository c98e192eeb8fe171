/** Curves in space to which drags keep: borders, or through handles. Loaded with the controls that choose one. */
import type { HandleData, Vec3 } from '../document/document';
import { pointOf } from '../document/point_of';
import type { OpenedNet } from '../worker/protocol';
import { nearestOnSide, squareBetween, type Triangles } from './surface_points';

/** Of the way to a place that is out of reach. */
const HALVINGS = 30;

/** From point to point; where it is closed the first comes again at the end. */
export type Polyline = readonly Vec3[];

export class Curve {
  /** At least one, of at least two points each. */
  readonly lines: readonly Polyline[];

  constructor(lines: readonly Polyline[]) {
    this.lines = lines;
  }

  nearest(point: Vec3): Vec3 {
    let best = { square: Infinity, at: point };
    for (const line of this.lines)
      for (let i = 1; i < line.length; i++) {
        const at = nearestOnSide(line[i - 1]!, line[i]!, point);
        const square = squareBetween(at, point);
        if (square < best.square) best = { square, at };
      }
    return best.at;
  }

  /** How far a drag goes along it: the last translation that is allowed, on the way from one that is. `base`: from where. */
  farthest(base: Vec3, from: Vec3, to: Vec3, isAllowed: (translation: Vec3) => boolean): Vec3 {
    let [best, low, high] = [from, 0, 1];
    for (let round = 0; round < HALVINGS; round++) {
      const share = (low + high) / 2;
      const place = this.nearest(base.map((x, i) => x + from[i]! + share * (to[i]! - from[i]!)) as Vec3);
      const translation = place.map((x, i) => x - base[i]!) as Vec3;
      if (isAllowed(translation)) [best, low] = [translation, share];
      else high = share;
    }
    return best;
  }
}

/** The border of a net, as it lies at these positions; null: it has none. */
export function borderOfNet({ loopStart, loopVertices }: OpenedNet, positions: Float64Array): Curve | null {
  const loops = Array.from({ length: loopStart.length - 1 }, (_, k) =>
    Array.from(loopVertices.subarray(loopStart[k], loopStart[k + 1]), (vertex) => pointOf(positions, vertex)),
  );
  return curveOf(loops.map((loop) => [...loop, loop[0]!]));
}

/** The border of a surface: sides of one triangle alone, one after another; null: it has none. */
export function borderOfSurface({ positions, triangles }: Triangles): Curve | null {
  const next = new Map<number, number[]>();
  const key = (from: number, to: number) => from * (positions.length / 3) + to;
  const sides = new Set<number>();
  const eachSide = (look: (from: number, to: number) => void): void => {
    for (let i = 0; i < triangles.length; i += 3)
      for (let k = 0; k < 3; k++) look(triangles[i + k]!, triangles[i + ((k + 1) % 3)]!);
  };
  eachSide((from, to) => sides.add(key(from, to)));
  eachSide((from, to) => {
    if (!sides.has(key(to, from))) next.set(from, [...(next.get(from) ?? []), to]);
  });
  const lines: Vec3[][] = [];
  // Where borders touch, more than one goes on from a vertex.
  for (const start of next.keys())
    while (next.get(start)!.length > 0) {
      const line = [pointOf(positions, start)];
      for (let to = next.get(start)!.pop(); to !== undefined; to = next.get(to)?.pop())
        line.push(pointOf(positions, to));
      lines.push(line);
    }
  return curveOf(lines);
}

/** From handle to handle in their order; null: of fewer than two. */
export function throughHandles(handles: readonly Pick<HandleData, 'target'>[]): Curve | null {
  return curveOf([handles.map(({ target }) => target)]);
}

function curveOf(lines: readonly Polyline[]): Curve | null {
  const whole = lines.filter((line) => line.length > 1);
  return whole.length > 0 ? new Curve(whole) : null;
}

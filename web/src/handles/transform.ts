/** Rigid motions and scalings of handles about a common centre, by numbers. */
import type { Vec3 } from '../document/document';

export type Axis = 'x' | 'y' | 'z';
export const AXES: readonly Axis[] = ['x', 'y', 'z'];

export type Motion =
  | { kind: 'move'; by: Vec3 }
  /** About the axis through the centre, counterclockwise seen against the axis. */
  | { kind: 'rotate'; axis: Axis; degrees: number }
  | { kind: 'scale'; factor: number };

export function centreOf(points: readonly Vec3[]): Vec3 {
  const sum = (axis: 0 | 1 | 2): number => points.reduce((total, point) => total + point[axis], 0) / points.length;
  return [sum(0), sum(1), sum(2)];
}

/** The transformed points. */
export function transformed(points: readonly Vec3[], motion: Motion): Vec3[] {
  const centre = centreOf(points);
  return points.map((point) => moved(point, centre, motion));
}

function moved(point: Vec3, centre: Vec3, motion: Motion): Vec3 {
  switch (motion.kind) {
    case 'move':
      return plus(point, motion.by);
    case 'rotate':
      return plus(centre, turned(minus(point, centre), motion.axis, motion.degrees));
    case 'scale':
      return plus(centre, minus(point, centre).map((x) => motion.factor * x) as Vec3);
  }
}

function turned(arm: Vec3, axis: Axis, degrees: number): Vec3 {
  const along = AXES.indexOf(axis);
  const [u, v] = [(along + 1) % 3, (along + 2) % 3];
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const result: Vec3 = [...arm];
  result[u] = cos * arm[u]! - sin * arm[v]!;
  result[v] = sin * arm[u]! + cos * arm[v]!;
  return result;
}

function plus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

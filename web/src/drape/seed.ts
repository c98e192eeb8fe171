/** Directions at the seed of a net: vectors of length 1 in the plane that touches the surface there. */
import type { Point } from '../../../wasm/chebnet';

/** A direction nearer than that to the normal, as a cosine, says nothing. */
const UPRIGHT = 0.999;

/** The direction as it lies in the plane; if it stands upright on it, some other one. */
export function laidInto(direction: Readonly<Point>, normal: Readonly<Point>): Point {
  const along = dot(direction, normal);
  const isUpright = Math.abs(along) > UPRIGHT * Math.hypot(...direction);
  if (isUpright) return reference(normal);
  return unit(combined(1, direction, -along, normal));
}

/** From which turns are counted: the x axis, or the y axis where that is nearly upright. */
export function reference(normal: Readonly<Point>): Point {
  const axis: Point = Math.abs(normal[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  return unit(combined(1, axis, -dot(axis, normal), normal));
}

/** So many radians counterclockwise from the reference. */
export function turned(angle: number, normal: Readonly<Point>): Point {
  const from = reference(normal);
  return combined(Math.cos(angle), from, Math.sin(angle), cross(normal, from));
}

/** Where a direction points: 0 … π, since a net line runs both ways. */
export function turnOf(direction: Readonly<Point>, normal: Readonly<Point>): number {
  const from = reference(normal);
  const angle = Math.atan2(dot(direction, cross(normal, from)), dot(direction, from));
  return angle < 0 ? angle + Math.PI : angle;
}

export function combined(a: number, x: Readonly<Point>, b: number, y: Readonly<Point>): Point {
  return [a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]];
}

export function cross(a: Readonly<Point>, b: Readonly<Point>): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function dot(a: Readonly<Point>, b: Readonly<Point>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function unit(vector: Point): Point {
  const length = Math.hypot(...vector);
  return combined(1 / length, vector, 0, vector);
}

/** Where a handle may be moved: the points in all balls round the others, each as wide as the net between them is long. */
import type { Ball } from '../../../wasm/chebnet';
import type { Vec3 } from '../document/document';

const MOST_ROUNDS = 1000;
/** A round that moves the point by less than this part of a radius is the last. */
const TOLERANCE = 1e-9;
/** Of a radius: closer to a border than this is near it. */
const NEAR = 0.05;

/** The point nearest to `wish` that lies in all balls, by Dykstra's algorithm of alternating projections (Boyle & Dykstra
 *  1986). Here rather than in the core: the pointer's next place cannot wait for the worker. Where the balls meet in hardly a
 *  point or not at all, it comes as close as many rounds bring it. */
export function nearestInAll(balls: readonly Ball[], wish: Vec3): Vec3 {
  let point = wish;
  const corrections = balls.map((): Vec3 => [0, 0, 0]);
  for (let round = 0; round < MOST_ROUNDS; round++) {
    let moved = 0;
    balls.forEach((ball, i) => {
      const corrected = plus(point, corrections[i]!, 1);
      const next = nearestIn(ball, corrected);
      corrections[i] = plus(corrected, next, -1);
      moved = Math.max(moved, distance(next, point) / ball.radius);
      point = next;
    });
    if (moved < TOLERANCE) break;
  }
  return point;
}

export function isNearBorder(balls: readonly Ball[], point: Vec3): boolean {
  return balls.some(({ centre, radius }) => distance(point, centre) > (1 - NEAR) * radius);
}

function nearestIn({ centre, radius }: Ball, point: Vec3): Vec3 {
  const away = distance(point, centre);
  return away > radius ? plus(centre, plus(point, centre, -1), radius / away) : point;
}

function distance(a: Vec3, b: Vec3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function plus(a: Vec3, b: Vec3, times: number): Vec3 {
  return [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]];
}

/** From where a place on a surface is seen: parts of the surface itself may stand between, as the walls of a channel do. */
import { Vector3 } from 'three';

/** Away from the normal, radians: nearer to the plane of the surface, little is seen of what lies on it. */
const TILTS = [0.6, 1.15];
const AROUND = 8;
/** Scene lengths from the place: what is nearer is the surface there. */
const CLOSE = 2e-3;
/** Likewise: as much around the place is to be seen as well. Seen from the side, what is around it stands so many times as far
 *  before or behind it. */
const [MARGIN, BEFORE] = [0.05, 4];
/** A line along the side of a triangle meets it. */
const SLACK = 1e-6;

/** In the order in which they are tried: the one that is wanted, others in front of the surface, those nearest to it first, and last
 *  from behind. */
export function directionsTowards(normal: Vector3, wanted: Vector3): Vector3[] {
  const along = new Vector3(1, 0, 0).cross(normal);
  if (along.lengthSq() < 0.1) along.set(0, 1, 0).cross(normal);
  along.normalize();
  const across = new Vector3().crossVectors(normal, along);
  const rings = TILTS.map((tilt) =>
    Array.from({ length: AROUND }, (_, i) => {
      const angle = (2 * Math.PI * i) / AROUND;
      return new Vector3()
        .addScaledVector(normal, Math.cos(tilt))
        .addScaledVector(along, Math.sin(tilt) * Math.cos(angle))
        .addScaledVector(across, Math.sin(tilt) * Math.sin(angle));
    }),
  );
  const front = rings.flat().sort((a, b) => b.dot(wanted) - a.dot(wanted));
  const behind = rings[0]!.map((direction) => direction.clone().negate());
  return [wanted, ...front, ...behind];
}

/** Whether what is around a place is seen, too, not only through a gap or past an edge. */
export function isClear(place: Vector3, eye: Vector3, corners: Float32Array, triangles: ArrayLike<number>): boolean {
  if (isHidden(place, eye, corners, triangles)) return false;
  const way = eye.clone().sub(place).normalize();
  const right = new Vector3(-way.y, way.x, 0);
  if (right.lengthSq() < CLOSE) right.set(1, 0, 0);
  right.setLength(MARGIN);
  const up = new Vector3().crossVectors(way, right);
  return [right, up, right.clone().negate(), up.clone().negate()].every(
    (aside) => !isHidden(place.clone().add(aside), eye.clone().add(aside), corners, triangles, BEFORE * MARGIN),
  );
}

/** Whether a triangle stands between a place on the surface and the eye. By Möller and Trumbore (1997).
 *  @param corners of the triangles, 3 numbers each. @param triangles 3 corners each. @param close what is nearer to the place than that, counts
 *  as the surface there. */
export function isHidden(
  place: Vector3,
  eye: Vector3,
  corners: Float32Array,
  triangles: ArrayLike<number>,
  close = CLOSE,
): boolean {
  const [px, py, pz] = [place.x, place.y, place.z];
  const way = eye.clone().sub(place);
  const far = way.length();
  const { x: dx, y: dy, z: dz } = way.divideScalar(far);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    const [ax, ay, az] = [corners[a]!, corners[a + 1]!, corners[a + 2]!];
    const [ux, uy, uz] = [corners[b]! - ax, corners[b + 1]! - ay, corners[b + 2]! - az];
    const [vx, vy, vz] = [corners[c]! - ax, corners[c + 1]! - ay, corners[c + 2]! - az];
    const [hx, hy, hz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const volume = ux * hx + uy * hy + uz * hz;
    if (volume === 0) continue;
    const [sx, sy, sz] = [px - ax, py - ay, pz - az];
    const first = (sx * hx + sy * hy + sz * hz) / volume;
    if (first < -SLACK || first > 1 + SLACK) continue;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const second = (dx * qx + dy * qy + dz * qz) / volume;
    if (second < -SLACK || first + second > 1 + SLACK) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / volume;
    if (distance > close && distance < far) return true;
  }
  return false;
}

/** Finds what lies under the pointer. Plain loops over flat numbers: no scene graph, no allocation, quick enough to run at
 *  every pointer move on 100,000 vertices. */
import { Matrix4 } from 'three';
import type { Eye } from './camera_rig';

/** From the scene to the canvas. */
export interface Projection {
  /** Column-major 4×4, projection · view. */
  matrix: ArrayLike<number>;
  /** Of x, y, z, 1: the depth. */
  depth: ArrayLike<number>;
  /** The canvas in CSS pixels. */
  width: number;
  height: number;
}

export interface ScreenPoint {
  x: number;
  y: number;
  /** Beyond the near plane, along the line of sight; not positive: not to be seen. */
  depth: number;
}

/** What this camera sees on a canvas of so many CSS pixels. */
export function projectionOf(camera: Eye, width: number, height: number): Projection {
  camera.updateMatrixWorld();
  const view = camera.matrixWorldInverse.elements;
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  return { matrix, depth: [-view[2]!, -view[6]!, -view[10]!, -view[14]! - camera.near], width, height };
}

const NO_PLANE: Plane = { x: 0, y: 0, z: 0, w: 0 };

export function project(
  { matrix: m, depth: d, width, height }: Projection,
  x: number,
  y: number,
  z: number,
): ScreenPoint {
  const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
  const u = (m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w;
  const v = (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w;
  return { x: (0.5 + 0.5 * u) * width, y: (0.5 - 0.5 * v) * height, depth: d[0]! * x + d[1]! * y + d[2]! * z + d[3]! };
}

/** A plane, by its normal and how far it is from the origin along that. */
export type Plane = Readonly<Record<'x' | 'y' | 'z' | 'w', number>>;

/** The vertex nearest to (x, y) on the screen among those within `radius` pixels that belong to the frontmost layer:
 *  not farther behind the nearest of them than `layer` (scene units), and neither hidden nor beyond the section plane.
 *  `points` holds 4 numbers a vertex; see NetData. null: none. */
export function nearestVertex(
  points: Float32Array,
  count: number,
  { matrix: m, depth: d, width, height }: Projection,
  x: number,
  y: number,
  radius: number,
  layer: number,
  section: Plane = NO_PLANE,
): number | null {
  const [m0, m1, m3, m4, m5, m7] = [m[0]!, m[1]!, m[3]!, m[4]!, m[5]!, m[7]!];
  const [m8, m9, m11, m12, m13, m15] = [m[8]!, m[9]!, m[11]!, m[12]!, m[13]!, m[15]!];
  const [d0, d1, d2, d3] = [d[0]!, d[1]!, d[2]!, d[3]!];
  const hits: number[] = [];
  let front = Infinity;
  for (let i = 0, at = 0; i < count; i++, at += 4) {
    const px = points[at]!;
    const py = points[at + 1]!;
    const pz = points[at + 2]!;
    const w = m3 * px + m7 * py + m11 * pz + m15;
    const depth = d0 * px + d1 * py + d2 * pz + d3;
    if (depth <= 0 || points[at + 3]! > 0 || section.x * px + section.y * py + section.z * pz > section.w) continue;
    const dx = (0.5 + (0.5 * (m0 * px + m4 * py + m8 * pz + m12)) / w) * width - x;
    if (dx > radius || dx < -radius) continue;
    const dy = (0.5 - (0.5 * (m1 * px + m5 * py + m9 * pz + m13)) / w) * height - y;
    const distance = dx * dx + dy * dy;
    if (distance > radius * radius) continue;
    hits.push(i, depth, distance);
    if (depth < front) front = depth;
  }
  let nearest: number | null = null;
  let smallest = Infinity;
  for (let h = 0; h < hits.length; h += 3) {
    if (hits[h + 1]! > front + layer || hits[h + 2]! >= smallest) continue;
    smallest = hits[h + 2]!;
    nearest = hits[h]!;
  }
  return nearest;
}

/** Of some markers, the nearest to (x, y) within its own radius plus `slack` pixels; of two such the one in front. */
export function nearestMarker(
  markers: readonly (ScreenPoint & { radius: number })[],
  x: number,
  y: number,
  slack: number,
): number | null {
  let best: number | null = null;
  markers.forEach((marker, i) => {
    const inside = marker.depth > 0 && Math.hypot(marker.x - x, marker.y - y) <= marker.radius + slack;
    if (inside && (best === null || marker.depth < markers[best]!.depth)) best = i;
  });
  return best;
}

/** Whether a point lies within a closed outline, or within a loop of one that crosses itself: it winds around the point. */
export function isInside(outline: readonly { x: number; y: number }[], x: number, y: number): boolean {
  let winding = 0;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length]!;
    const downwards = a.y <= y;
    if (downwards === b.y <= y) return;
    const onLeft = (b.x - a.x) * (y - a.y) > (x - a.x) * (b.y - a.y);
    if (onLeft === downwards) winding += downwards ? 1 : -1;
  });
  return winding !== 0;
}

/** So far from a handle it is still hit, pixels: a fingertip hides its target. */
export const HANDLE_SLACK = { mouse: 4, touch: 16 };
/** A pointer that moves no farther between down and up has clicked, pixels. */
export const STILL = { mouse: 3, touch: 8 };

/** Fingers are less sure than a mouse or a pen. */
export function pointerKind({ pointerType }: PointerEvent): 'mouse' | 'touch' {
  return pointerType === 'touch' ? 'touch' : 'mouse';
}

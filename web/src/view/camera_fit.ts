/** Where to place the camera to see the whole net. */
import { Matrix4, type PerspectiveCamera, Vector3 } from 'three';

/** From the front, a little to the right and from above. */
const FRONT = new Vector3(0.55, -1, 0.62).normalize();
const BACK = new Vector3(-FRONT.x, -FRONT.y, FRONT.z);
const UP = new Vector3(0, 0, 1);

/** Those that are drawn from far above or aside. From the top a little to the front, for which way is up in the picture. */
const STANDARD = {
  front: new Vector3(0, -1, 0),
  side: new Vector3(1, 0, 0),
  top: new Vector3(0, -1e-4, 1).normalize(),
};

/** The part of a picture's width that is clearly within it. */
const INSIDE = 0.94;

/** How far behind the middle of the scene is clearly behind. */
const CLEARLY = 0.1;

export interface Stand {
  position: Vector3;
  target: Vector3;
}

/** `free`: from the front and from above. */
export type StandardView = 'free' | keyof typeof STANDARD;

/** `here`: from where the camera is. */
export type Side = StandardView | 'here';

/** From where to see the whole net.
 *  @param behind whether freely is from behind. */
export function directionFor(from: StandardView = 'free', behind = false): Vector3 {
  if (from !== 'free') return STANDARD[from];
  return behind ? BACK : FRONT;
}

/** Whether from the front a point would be at the back. */
export function isBehind({ x, y }: Vector3): boolean {
  return x * FRONT.x + y * FRONT.y < -CLEARLY;
}

/** Margins at each side of the view, as a fraction of its height or width. */
export interface Margins {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** The nearest stand from which all points (4 numbers each, see NetData) that are not hidden are in the picture, within the margins.
 *  @param isParallel they are seen in parallel, as large as at the target. */
export function fitCamera(
  points: Float32Array,
  count: number,
  camera: PerspectiveCamera,
  margins: Margins,
  direction = FRONT,
  isParallel = false,
): Stand {
  const basis = new Matrix4().lookAt(direction, new Vector3(), UP);
  const right = new Vector3();
  const up = new Vector3();
  basis.extractBasis(right, up, new Vector3());
  const slope = Math.tan((camera.fov * Math.PI) / 360);
  const across = new Span(slope * camera.aspect, margins.left, margins.right);
  const upright = new Span(slope, margins.bottom, margins.top);
  const p = new Vector3();
  for (let i = 0; i < count; i++) {
    if (points[4 * i + 3]! > 0) continue;
    p.fromArray(points, 4 * i);
    const towards = isParallel ? 0 : p.dot(direction);
    across.include(p.dot(right), towards);
    upright.include(p.dot(up), towards);
  }
  const distance = Math.max(across.distance, upright.distance);
  const target = new Vector3()
    .addScaledVector(right, across.centre(distance))
    .addScaledVector(up, upright.centre(distance));
  return { position: target.clone().addScaledVector(direction, distance), target };
}

/** From a stand that was kept for a picture of another aspect, so far back that all that is within that is within this one.
 *  @param camera stands there. */
export function standBack(
  points: Float32Array,
  count: number,
  camera: PerspectiveCamera,
  { position, target }: Stand,
  aspect: number,
  isParallel = false,
): Stand {
  const slope = Math.tan((camera.fov * Math.PI) / 360);
  const away = position.clone().sub(target);
  const distance = away.length();
  const p = new Vector3();
  let back = 0;
  camera.updateMatrixWorld();
  for (let i = 0; i < count; i++) {
    if (points[4 * i + 3]! > 0) continue;
    p.fromArray(points, 4 * i).applyMatrix4(camera.matrixWorldInverse);
    const depth = isParallel ? distance : -p.z;
    const [across, upright] = [Math.abs(p.x) / slope, Math.abs(p.y) / slope];
    if (upright < depth && across < aspect * depth) back = Math.max(back, across / (INSIDE * camera.aspect) - depth);
  }
  return { position: position.clone().addScaledVector(away, back / distance), target };
}

/** One direction of the picture. From a distance d before centre c, a point (x, towards) is within both sides if
 *  x − c ≤ high · (d − towards) and c − x ≤ low · (d − towards): of all points, one bounds each side. */
class Span {
  readonly #low: number;
  readonly #high: number;
  #below = -Infinity;
  #above = -Infinity;

  constructor(slope: number, lowMargin: number, highMargin: number) {
    this.#low = slope * (1 - 2 * lowMargin);
    this.#high = slope * (1 - 2 * highMargin);
  }

  include(x: number, towards: number): void {
    this.#below = Math.max(this.#below, -x + this.#low * towards);
    this.#above = Math.max(this.#above, x + this.#high * towards);
  }

  get distance(): number {
    return (this.#below + this.#above) / (this.#low + this.#high);
  }

  /** At a greater distance than needed, in the middle of the free range. */
  centre(distance: number): number {
    return (this.#above - this.#high * distance + this.#low * distance - this.#below) / 2;
  }
}

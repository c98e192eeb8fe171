/** Keys that keep a drag to an axis of the net through where it began, or to the plane across it: where the pointer then takes a
 *  handle, and the lines that show it. Loaded when a handle is first taken hold of. */
// Its types only: loaded by itself, a part of three.js would make the first visit larger.
import type { Camera, Vector3 } from 'three';
import type { Axes } from '../../../wasm/chebnet';
import type { KeyRow } from '../elements/keys';
import { Along } from '../handles/along';
import { AXES } from '../handles/transform';
import type { NetData } from './net_data';
import type { Place } from './overlay';
import './axis_drag.css';

/** What each key keeps a drag to. */
const KEYS: Readonly<Record<string, Axes>> = {
  X: 'x',
  Y: 'y',
  Z: 'z',
  'Shift+X': 'yz',
  'Shift+Y': 'xz',
  'Shift+Z': 'xy',
};

const keysTo = (count: number): string[] => Object.keys(KEYS).filter((key) => KEYS[key]!.length === count);

export const AXIS_KEYS: readonly KeyRow[] = [
  { keys: keysTo(1), does: 'alongAxis' },
  { keys: keysTo(2), does: 'acrossAxis' },
];

/** A move along an axis or in a plane that is seen so steeply is at most so many times the one seen. */
const STEEPEST = 8;
/** How far a line goes to either side, in distances of the camera: beyond what is seen. */
const FAR = 3;

/** What of the picture it needs. */
interface Picture {
  /** Of the net that is open. */
  data(): Pick<NetData, 'space' | 'edgeLength'>;
  /** A point of the scene on the canvas. */
  place(point: Vector3): Place;
}

export class AxisDrag {
  /** What the drag is kept to; null: nothing. */
  along: Along | null = null;
  /** Along the axes of the net. */
  readonly #lines: readonly SVGLineElement[];
  readonly #picture: Picture;

  /** @param overlay over the picture: there the lines are drawn. */
  constructor(overlay: Element, picture: Picture) {
    this.#picture = picture;
    this.#lines = AXES.map((axis) => {
      const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
      line.classList.add('axis', axis);
      return line;
    });
    overlay.prepend(...this.#lines);
    this.free();
  }

  /** A key is pressed during a drag: the same again frees it. */
  press(key: string): void {
    const axes = KEYS[key]!;
    if (this.along?.axes === axes) return this.free();
    const { space, edgeLength } = this.#picture.data();
    this.along = new Along(axes, edgeLength / space.scale);
  }

  /** Keeps the drag to nothing. */
  free(): void {
    this.along = null;
    for (const line of this.#lines) line.toggleAttribute('hidden', true);
  }

  /** Where a handle goes that would go to `aim`, which faces the camera beside `from`, where the drag began. */
  carry(camera: Camera, from: Vector3, aim: Vector3): Vector3 {
    if (!this.along) return aim;
    const { axes } = this.along;
    const isLine = axes.length === 1;
    const way = this.#way(
      AXES.findIndex((axis) => axes.includes(axis) === isLine),
      from.clone(),
    );
    return isLine ? onAxis(camera, from, aim, way) : inPlane(camera, from, aim, way);
  }

  /** Draws the lines through the handle that leads. @param distance of the camera. */
  draw(point: Vector3 | undefined, camera: Camera, distance: number): void {
    const { along } = this;
    if (!point || !along) return;
    const sight = camera.getWorldDirection(point.clone());
    const depth = isParallel(camera) ? Infinity : point.clone().sub(camera.position).dot(sight);
    this.#lines.forEach((line, i) => {
      line.toggleAttribute('hidden', !along.axes.includes(AXES[i]!));
      const away = this.#way(i, point.clone());
      const slope = away.dot(sight);
      if (slope < 0) away.negate();
      // Not to behind the eye.
      const nearer = Math.min(FAR * distance, (0.95 * depth) / Math.abs(slope));
      const [from, to] = [-nearer, FAR * distance].map((by) =>
        this.#picture.place(point.clone().addScaledVector(away, by)),
      );
      const ends = { x1: from!.x, y1: from!.y, x2: to!.x, y2: to!.y };
      for (const [name, value] of Object.entries(ends)) line.setAttribute(name, value.toFixed(1));
    });
  }

  /** Makes a vector the direction of an axis of the net in the scene. */
  #way(axis: number, way: Vector3): Vector3 {
    const { axes } = this.#picture.data().space;
    return way.setScalar(0).setComponent(axes.indexOf(AXES[axis]!), 1);
  }
}

/** The point of the axis through `from` that is nearest to the line of sight through `aim`. An axis that points at the eye has
 *  none: along it moves are up and down the screen. */
export function onAxis(camera: Camera, from: Vector3, aim: Vector3, axis: Vector3): Vector3 {
  const move = aim.clone().sub(from);
  return from.clone().addScaledVector(axis, lengthAlong(camera, from, aim, move, axis));
}

function lengthAlong(camera: Camera, from: Vector3, aim: Vector3, move: Vector3, axis: Vector3): number {
  const sight = sightTo(camera, from);
  if (across(axis, sight).length() < 1 / STEEPEST) {
    const up = from.clone().setFromMatrixColumn(camera.matrixWorld, 1);
    // The scene's z goes up; of the others what is farther away.
    return move.dot(up) * (axis.z !== 0 ? 1 : Math.sign(axis.dot(sight)));
  }
  const ray = sightTo(camera, aim);
  const seen = across(axis, ray);
  const by = move.dot(seen) / Math.max(seen.lengthSq(), Number.EPSILON);
  const most = STEEPEST * move.length();
  // Beyond the point where the axis vanishes, the nearest one is behind the eye.
  const isBehind = !isParallel(camera) && from.clone().addScaledVector(axis, by).sub(camera.position).dot(ray) <= 0;
  return isBehind ? most * Math.sign(axis.dot(ray)) : Math.max(-most, Math.min(by, most));
}

/** Where the line of sight through `aim` meets the plane through `from`. In a plane seen from its edge moves are along that. */
export function inPlane(camera: Camera, from: Vector3, aim: Vector3, normal: Vector3): Vector3 {
  const move = aim.clone().sub(from);
  const most = STEEPEST * move.length();
  const steepness = normal.dot(sightTo(camera, from));
  if (Math.abs(steepness) < 1 / STEEPEST) return move.addScaledVector(normal, -move.dot(normal)).add(from);
  const ray = sightTo(camera, aim);
  const down = normal.dot(ray);
  // Above the horizon of the plane it goes towards that.
  if (down * steepness <= 0) return ray.addScaledVector(normal, -down).setLength(most).add(from);
  return move
    .addScaledVector(ray, -move.dot(normal) / down)
    .clampLength(0, most)
    .add(from);
}

function isParallel(camera: Camera): boolean {
  return 'isOrthographicCamera' in camera;
}

/** The direction in which a point is seen. */
function sightTo(camera: Camera, point: Vector3): Vector3 {
  return isParallel(camera) ? camera.getWorldDirection(point.clone()) : point.clone().sub(camera.position).normalize();
}

/** The part of a direction across another of length 1. */
function across(way: Vector3, sight: Vector3): Vector3 {
  return way.clone().addScaledVector(sight, -way.dot(sight));
}

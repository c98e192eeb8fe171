/** What a drag snaps to: a grid through the origin, along the axes, the coordinates of other handles, and a surface or a curve. Loaded
 *  with the controls that set it. */
import type { HandleData, Vec3 } from '../document/document';
import { coordinate } from '../language/numbers';
import { panelWords } from '../language/panels';
import { Curve } from './curve';
import { type InHand, translated } from './reach';
import { AXES } from './transform';

/** What is said in the middle of a drag is to be read at a glance: to a thousandth of an edge, where coordinate() gives ten thousandths. */
const READ_TO = 10;
/** A coordinate of another handle attracts from so far, in edge lengths. */
const ATTRACTS = 0.3;
/** Along an axis where a drag goes less far than this, in edge lengths, it does not go at all. */
const STILL = 1e-6;

/** A surface or a curve. */
interface SnapPlace {
  nearest(point: Vec3): Vec3;
}

export class Snapping {
  /** Spacing of the grid, in the net's unit; null: there is none. */
  readonly step: number | null;
  readonly #toHandles: boolean;
  readonly #edgeLength: number;
  readonly #onto: SnapPlace | null;

  /** @param edgeLength in the net's unit. */
  constructor(step: number | null, toHandles: boolean, edgeLength: number, onto: SnapPlace | null = null) {
    this.step = step;
    this.#toHandles = toHandles;
    this.#edgeLength = edgeLength;
    this.#onto = onto;
  }

  /** To which drags keep, if it is a curve. */
  get curve(): Curve | null {
    return this.#onto instanceof Curve ? this.#onto : null;
  }

  /** The translation near `asked` that takes a handle to where it snaps: onto the surface or curve, unless it keeps to an axis or a plane;
   *  otherwise each coordinate by itself, to that of another handle which is near, or else to the grid. One along which the drag
   *  does not go stays: an arrow along an axis keeps to it. */
  translation(asked: Vec3, leading: InHand, others: readonly HandleData[]): Vec3 {
    const place = translated(leading, asked);
    if (this.#onto && leading.follows.every((follows) => follows !== 0)) {
      const at = this.#onto.nearest(place);
      return leading.follows.map((follows, axis) => follows * (at[axis]! - leading.base[axis]!)) as Vec3;
    }
    return asked.map((by, axis) => {
      const follows = leading.follows[axis]!;
      if (follows === 0 || Math.abs(by) < STILL * this.#edgeLength) return by;
      return follows * (this.#coordinate(place[axis]!, axis, others) - leading.base[axis]!);
    }) as Vec3;
  }

  /** Where a handle is, and which others it is level with. */
  describe(place: Vec3, others: readonly HandleData[]): string {
    const coordinates = AXES.map((name, axis) => {
      const level = this.#toHandles ? others.find(({ target }) => this.#isAt(target[axis]!, place[axis]!)) : undefined;
      const text = `${name} ${coordinate(place[axis]!, READ_TO * this.#edgeLength)}`;
      return level ? panelWords.drag.level(text, level.name ?? panelWords.handles.vertex(level.vertex)) : text;
    });
    return coordinates.join(' · ');
  }

  #coordinate(x: number, axis: number, others: readonly HandleData[]): number {
    const near = this.#toHandles
      ? nearest(
          x,
          others.map(({ target }) => target[axis]!),
        )
      : Infinity;
    if (Math.abs(near - x) < ATTRACTS * this.#edgeLength) return near;
    return this.step === null ? x : Math.round(x / this.step) * this.step;
  }

  #isAt(a: number, b: number): boolean {
    return Math.abs(a - b) < STILL * this.#edgeLength;
  }
}

/** Infinity if there are none. */
function nearest(x: number, values: readonly number[]): number {
  return values.reduce((best, value) => (Math.abs(value - x) < Math.abs(best - x) ? value : best), Infinity);
}

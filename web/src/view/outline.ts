/** The outline drawn around handles: a box from corner to corner, or with the lasso the path of the pointer. */
import type { Place } from './overlay';

/** Shortest segment of a lasso, in pixels. */
const FINEST = 3;

export class Outline {
  /** The corners of the closed outline. */
  corners: readonly Place[];
  readonly #kind: 'box' | 'lasso';
  readonly #start: Place;

  constructor(kind: 'box' | 'lasso', start: Place) {
    this.#kind = kind;
    this.#start = start;
    this.corners = [start];
  }

  /** Extends it to the pointer. */
  extend(to: Place): void {
    const start = this.#start;
    const last = this.corners.at(-1)!;
    if (this.#kind === 'box') this.corners = [start, { x: to.x, y: start.y }, to, { x: start.x, y: to.y }];
    else if (Math.hypot(to.x - last.x, to.y - last.y) >= FINEST) this.corners = [...this.corners, to];
  }
}

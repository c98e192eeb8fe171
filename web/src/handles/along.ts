/** What keys keep a drag to: an axis, or the plane across one. Loaded with the first drag. */
import type { Axes } from '../../../wasm/chebnet';
import type { HandleData, Vec3 } from '../document/document';
import { panelWords } from '../language/panels';
import { Snapping } from './snapping';

export class Along {
  /** Of the net: those along which it goes. */
  readonly axes: Axes;
  readonly #edgeLength: number;

  /** @param edgeLength in the net's unit. */
  constructor(axes: Axes, edgeLength: number) {
    this.axes = axes;
    this.#edgeLength = edgeLength;
  }

  /** What it is kept to, and where a handle is. */
  describe(place: Vec3, others: readonly HandleData[], snapping: Snapping | null): string {
    const coordinates = (snapping ?? new Snapping(null, false, this.#edgeLength)).describe(place, others);
    return `${panelWords.drag.along(this.axes)} · ${coordinates}`;
  }
}

/** The handles being dragged: which ones move together, and where to. */
import { type Matrix4, Vector3 } from 'three';
import type { Along } from '../handles/along';
import type { Selection } from '../handles/selection';
import type { DragReport } from './drag';
import type { HandleMarkers } from './handles';
import type { Space } from './space';

export class Hand {
  /** Positions of the dragged handles at the start. */
  #taken: { vertex: number; from: Vector3 }[] = [];
  readonly #markers: HandleMarkers;
  readonly #report: DragReport;
  readonly #selection: () => Selection;

  /** @param selection the last one leads. */
  constructor(markers: HandleMarkers, report: DragReport, selection: () => Selection) {
    this.#markers = markers;
    this.#report = report;
    this.#selection = selection;
  }

  /** Those of the selection that are not locked, the leading one first; a handle that is not selected moves alone. */
  moving(handle?: number): readonly number[] {
    const selection = this.#selection();
    if (handle !== undefined && !selection.includes(handle)) return [handle];
    const free = [...selection].reverse().filter((vertex) => !this.#markers.isLocked(vertex));
    return handle === undefined ? free : [handle, ...free.filter((vertex) => vertex !== handle)];
  }

  /** The centre of the handles that would move; null: there are none. */
  centre(): Vector3 | null {
    const points = this.moving().flatMap((vertex) => this.#markers.point(vertex) ?? []);
    if (points.length === 0) return null;
    return points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length);
  }

  grab(vertices: readonly number[]): void {
    this.#taken = vertices.flatMap((vertex) => {
      const from = this.#markers.point(vertex)?.clone();
      return from ? [{ vertex, from }] : [];
    });
    this.#report.begin(vertices);
  }

  /** They are drawn at the pointer, ahead of document and net. */
  carry(motion: Matrix4, space: Space, along: Along | null): void {
    const targets = this.#taken.map(({ vertex, from }) => {
      const point = this.#markers.carry(vertex, from.clone().applyMatrix4(motion));
      return { vertex, target: space.toNet(point) };
    });
    this.#report.move(targets, along);
  }
}

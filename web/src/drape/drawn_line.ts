/** A line that is being drawn on a surface, point by point; how it runs between them is asked for. */
import type { Point } from '../../../wasm/chebnet';
import type { Cut, Ray } from './drape_protocol';

interface LineEvents {
  /** How a line through some points runs. */
  traceWanted(points: (Point | Ray)[], revision: number): void;
  /** More of it is known, or less. */
  changed(): void;
  /** It has at least two points, and no others will come. */
  ended(line: Cut): void;
}

/** Counts how often points of any line have become others. */
let revisions = 0;

export class DrawnLine {
  readonly #events: LineEvents;
  /** Those not yet found on the surface are rays. */
  #points: (Point | Ray)[] = [];
  #revision = ++revisions;
  /** As far as it is known. */
  #known: Cut | null = null;
  /** It ends once all of its points are known. */
  #isEnding = false;
  /** The last point has been moved, and may have come beside the surface. */
  #isMoving = false;

  constructor(events: LineEvents) {
    this.#events = events;
  }

  /** As far as it is known; null: not even a point. */
  get known(): Cut | null {
    return this.#known;
  }

  get revision(): number {
    return this.#revision;
  }

  add(point: Point | Ray): void {
    this.#setPoints([...this.#points, point]);
  }

  /** To where a ray meets the surface, if it does. */
  moveLast(to: Ray): void {
    this.#setPoints([...this.#points.slice(0, -1), to]);
    this.#isMoving = true;
  }

  /** Leads it back to its first point, and ends it. */
  close(): void {
    const first = this.#points[0];
    if (first === undefined) return;
    this.add(first);
    this.end();
  }

  /** Takes back the last point; false if there is none. */
  takeBack(): boolean {
    if (this.#points.length === 0) return false;
    this.#setPoints(this.#points.slice(0, -1));
    return true;
  }

  /** @param revision of the points through which it runs; others may have come, or been given up. */
  setTraced(line: Cut, revision: number): void {
    if (revision !== this.#revision) return;
    if (this.#isMoving && line.points.length < this.#points.length) return this.giveUp();
    this.#points = line.points;
    this.#known = line.points.length > 0 ? line : null;
    if (this.#isEnding) this.end();
    else this.#events.changed();
  }

  /** Of a line with one point nothing is left. */
  end(): void {
    const line = this.#known;
    this.#isEnding = !this.#areKnown;
    if (this.#isEnding || line === null) return;
    this.clear();
    if (line.points.length < 2) this.#events.changed();
    else this.#events.ended(line);
  }

  clear(): void {
    this.#points = [];
    this.#revision = ++revisions;
    this.#known = null;
    this.#isEnding = false;
  }

  /** The core has refused something. */
  giveUp(): void {
    this.#isEnding = false;
    this.#points = this.#known?.points ?? [];
  }

  get #areKnown(): boolean {
    return (
      this.#points.every((point) => !('origin' in point)) && this.#points.length === (this.#known?.points.length ?? 0)
    );
  }

  #setPoints(points: (Point | Ray)[]): void {
    this.#points = points;
    this.#isMoving = false;
    this.#revision = ++revisions;
    this.#events.traceWanted(points, this.#revision);
  }
}

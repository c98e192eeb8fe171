/** What holds a drag: how far from the handles in hand the net moves with them, and where the other handles let them go. */
import type { Ball, Handle } from '../../../wasm/chebnet';
import type { Client } from '../worker/client';
import { isNearBorder, nearestInAll } from './reach';

/** Where it is shown. */
export interface GuideMarks {
  /** How freely each vertex moves, 0 … 1; null: all do. */
  setRegion(mobility: Float32Array | null): void;
  /** Where the handle in hand may go; null: that is not shown. */
  setReach(balls: readonly Ball[] | null): void;
}

/** A locality as the net measures it. */
export interface Locality {
  /** In edge lengths. */
  radius: number;
  edgeLength: number;
}

export class DragGuide {
  /** Whether a drag is held to where the net can follow. */
  keepsWithin = true;
  /** Whether the reach is shown all the time, or only near its border. */
  alwaysShowsReach = false;
  readonly #client: Client;
  readonly #marks: GuideMarks;
  #balls: readonly Ball[] = [];
  /** The solver holds a part of the net. */
  #local = false;
  /** Answers to earlier questions are too late. */
  #drags = 0;
  #regions = 0;

  constructor(client: Client, marks: GuideMarks) {
    this.#client = client;
    this.#marks = marks;
  }

  /** Before handles are moved. */
  async limit(vertices: readonly number[], locality: Locality | null): Promise<void> {
    if (locality === null && !this.#local) return;
    this.#local = locality !== null;
    await this.#client.setLocality(locality?.radius ?? null, vertices);
  }

  /** As a hand begins to drag handles. The limits come a moment later. */
  async begin(vertices: readonly number[], locality: Locality | null): Promise<void> {
    this.#balls = [];
    await Promise.all([this.limit(vertices, locality), this.#findReach(vertices), this.showRegion(vertices, locality)]);
  }

  /** Where the drag may go. */
  within(targets: readonly Handle[]): readonly Handle[] {
    if (this.#balls.length === 0) return targets;
    const held = targets.map(({ vertex, target }) => ({ vertex, target: nearestInAll(this.#balls, target) }));
    const shown = this.alwaysShowsReach || held.some(({ target }) => isNearBorder(this.#balls, target));
    this.#marks.setReach(shown ? this.#balls : null);
    return this.keepsWithin ? held : targets;
  }

  end(): void {
    this.#drags += 1;
    this.#balls = [];
    this.#marks.setReach(null);
    this.hideRegion();
  }

  /** Shades what would stay. */
  async showRegion(origins: readonly number[], locality: Locality | null): Promise<void> {
    if (locality === null || origins.length === 0) return this.hideRegion();
    const question = ++this.#regions;
    const distances = await this.#client.distances(origins);
    if (question === this.#regions) this.#marks.setRegion(mobilityOf(distances, locality));
  }

  hideRegion(): void {
    this.#regions += 1;
    this.#marks.setRegion(null);
  }

  /** Of one handle; several limit each other anew with every move. */
  async #findReach(vertices: readonly number[]): Promise<void> {
    const [vertex, ...more] = vertices;
    if (vertex === undefined || more.length > 0) return;
    const drag = ++this.#drags;
    const balls = await this.#client.reach(vertex);
    if (drag === this.#drags) this.#balls = balls;
  }
}

/** As in core/edit/locality.h the outer half of the region moves less and less. */
export function mobilityOf(distances: Float64Array, { radius, edgeLength }: Locality): Float32Array {
  return Float32Array.from(distances, (distance) => {
    const s = Math.min(Math.max(2 * (1 - distance / edgeLength / radius), 0), 1);
    return s * s * (3 - 2 * s);
  });
}

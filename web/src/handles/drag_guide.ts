/** What holds a drag: how far from the handles in hand the net moves with them, and where the other handles let them go. */
import type { Handle } from '../../../wasm/chebnet';
import type { Client } from '../worker/client';
import { type InHand, isNearBorder, type Limit, limitsOf, nearestInAll, translated, translationTo } from './reach';

/** Where it is shown. */
export interface GuideView {
  /** How freely each vertex moves, 0 … 1; null: all do. */
  setRegion(mobility: Float32Array | null): void;
  /** Where the handle that leads the drag may go; null: that is not shown. */
  setReach(limits: readonly Limit[] | null): void;
}

/** More handles in hand than this are not held: by what limits each of them the page would be held up itself. */
const MOST_HELD = 500;

export class DragGuide {
  /** Whether a drag is held to where the net can follow. */
  keepsWithin = true;
  /** Whether the reach is shown all the time, or only near its border. */
  alwaysShowsReach = false;
  readonly #client: Client;
  readonly #view: GuideView;
  #inHand: readonly InHand[] = [];
  /** Of the translation of what is in hand. */
  #limits: readonly Limit[] = [];
  /** The solver holds a part of the net. */
  #local = false;
  /** Answers to earlier questions are too late. */
  #drags = 0;
  #regions = 0;

  constructor(client: Client, view: GuideView) {
    this.#client = client;
    this.#view = view;
  }

  /** Before handles are moved. `locality`: a radius in edge lengths; null: none. */
  async limit(vertices: readonly number[], locality: number | null): Promise<void> {
    if (locality === null && !this.#local) return;
    this.#local = locality !== null;
    await this.#client.setLocality(locality, vertices);
  }

  /** As a hand begins to drag handles, the leading one first. The limits come a moment later. */
  async begin(inHand: readonly InHand[], locality: number | null): Promise<void> {
    this.#inHand = inHand;
    this.#limits = [];
    const vertices = inHand.map(({ vertex }) => vertex);
    await Promise.all([this.limit(vertices, locality), this.#findReach(vertices), this.showRegion(vertices, locality)]);
  }

  /** Where the drag may go. Handles that are turned or scaled limit each other anew with every move: they are not held. */
  within(targets: readonly Handle[]): readonly Handle[] {
    if (this.#limits.length === 0) return targets;
    const wish = translationTo(targets, this.#inHand);
    const held = wish && nearestInAll(this.#limits, wish);
    this.#showReach(held !== null && (this.alwaysShowsReach || isNearBorder(this.#limits, held)));
    if (held === null || held === wish || !this.keepsWithin) return targets;
    return this.#inHand.map((each) => ({ vertex: each.vertex, target: translated(each, held) }));
  }

  end(): void {
    this.#drags += 1;
    this.#limits = [];
    this.#view.setReach(null);
    this.hideRegion();
  }

  /** Shades what would stay. */
  async showRegion(origins: readonly number[], locality: number | null): Promise<void> {
    if (locality === null || origins.length === 0) return this.hideRegion();
    const question = ++this.#regions;
    const mobility = await this.#client.mobility(locality, origins);
    if (question === this.#regions) this.#view.setRegion(mobility);
  }

  hideRegion(): void {
    this.#regions += 1;
    this.#view.setRegion(null);
  }

  async #findReach(vertices: readonly number[]): Promise<void> {
    const drag = ++this.#drags;
    if (vertices.length > MOST_HELD) return;
    const reaches = await this.#client.reach(vertices);
    if (drag === this.#drags) this.#limits = limitsOf(this.#inHand, reaches);
  }

  /** From where the leading handle stood. */
  #showReach(shown: boolean): void {
    const [x, y, z] = this.#inHand[0]!.base;
    const place = ({ centre, ...limit }: Limit): Limit => ({
      ...limit,
      centre: [centre[0] + x, centre[1] + y, centre[2] + z],
    });
    this.#view.setReach(shown ? this.#limits.map(place) : null);
  }
}

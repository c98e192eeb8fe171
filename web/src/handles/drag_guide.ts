/** What guides a drag: to which axes it keeps, to what it snaps, how far from the dragged handles the net moves with them, and
 *  where the other handles let them go. */
import type { Axes, Ball, Handle } from '../../../wasm/chebnet';
import type { HandleData, Vec3 } from '../document/document';
import type { Client } from '../worker/client';
import type { Along } from './along';
import {
  type InHand,
  isNearBorder,
  keptTo,
  type Limit,
  limitsOf,
  nearestInAll,
  translated,
  translationTo,
} from './reach';
import type { Snapping } from './snapping';

/** The part of the view that shows how a drag is guided. */
interface GuideView {
  /** How freely each vertex moves, 0 … 1; null: all move freely. */
  setRegion(mobility: Float32Array | null): void;
  /** What share of the move each handle makes; null: all that move make all of it. */
  setShares(shares: ReadonlyMap<number, number> | null): void;
  /** Where the leading handle may go; null: not shown. */
  setReach(limits: readonly Limit[] | null): void;
  /** What is said beside the leading handle. */
  setReadout(text: string): void;
}

/** A drag of more handles than this is not limited: the limits of all of them would take too long. */
const MOST_LIMITED = 500;

export class DragGuide {
  /** Whether a drag is kept to where the net can follow. */
  keepsWithin = true;
  /** Whether the reach is shown all the time, or only near its border. */
  alwaysShowsReach = false;
  /** What drags snap to; null: nothing. */
  snapping: Snapping | null = null;
  readonly #client: Client;
  readonly #view: GuideView;
  /** What the drag is kept to; null: nothing. */
  #along: Along | null = null;
  /** The dragged handles as they move freely, and as they are kept to axes. */
  #free: readonly InHand[] = [];
  #inHand: readonly InHand[] = [];
  /** Of the dragged handles. */
  #reaches: readonly (readonly Ball[])[] = [];
  /** Limits of the translation of the dragged handles, and those of a free one, to be shown. */
  #limits: readonly Limit[] = [];
  #freeLimits: readonly Limit[] = [];
  /** The latest translation within the limits. */
  #reached: Vec3 = [0, 0, 0];
  /** Whether the solver was told a locality. */
  #local = false;
  /** Numbers of the latest requests: answers to earlier ones are ignored. */
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

  /** At the start of a drag. The leading handle comes first; the limits arrive a moment later. */
  async begin(inHand: readonly InHand[], locality: number | null): Promise<void> {
    this.#free = inHand;
    this.#reached = [0, 0, 0];
    this.#reaches = [];
    this.#restrict();
    const vertices = inHand.map(({ vertex }) => vertex);
    await Promise.all([this.limit(vertices, locality), this.#findReach(), this.showRegion(vertices, locality)]);
  }

  /** To which the drag is kept; undefined: to none. */
  get axes(): Axes | undefined {
    return this.#along?.axes;
  }

  /** Keeps the drag to axes; null: to none any more. */
  keepTo(along: Along | null): void {
    if (along === this.#along) return;
    this.#along = along;
    this.#restrict();
  }

  /** These targets on the axes kept to, and where they snap, as one: the leading handle does, among `others`. What turns or scales
   *  does not snap. */
  snapped(targets: readonly Handle[], others: readonly HandleData[]): readonly Handle[] {
    const asked = (this.snapping || this.#along) && translationTo(targets, this.#inHand);
    if (!asked) return targets;
    return this.#moved(targets, this.snapping?.translation(asked, this.#inHand[0]!, others) ?? asked);
  }

  /** Says where the leading handle is. */
  describe([leading]: readonly Handle[], others: readonly HandleData[]): void {
    const said = this.#along ?? this.snapping;
    this.#view.setReadout((leading && said?.describe(leading.target, others, this.snapping)) ?? '');
  }

  /** The targets nearest to these within the limits. Rotations and scalings are not limited: their limits would change with
   *  every move. */
  within(targets: readonly Handle[]): readonly Handle[] {
    if (this.#limits.length === 0) return targets;
    const asked = translationTo(targets, this.#inHand);
    const nearest = asked && nearestInAll(this.#limits, asked);
    this.#showReach(nearest !== null && (this.alwaysShowsReach || isNearBorder(this.#limits, nearest)));
    if (nearest === null || !this.keepsWithin) return targets;
    if (nearest === asked) {
      this.#reached = asked;
      return targets;
    }
    const isWithin = (place: Vec3): boolean => nearestInAll(this.#limits, place) === place;
    const stop = this.snapping?.curve?.farthest(this.#inHand[0]!.base, this.#reached, asked!, isWithin) ?? nearest;
    return this.#moved(targets, (this.#reached = stop));
  }

  end(): void {
    this.#drags += 1;
    this.#along = null;
    this.#limits = [];
    this.#view.setReach(null);
    this.#view.setShares(null);
    this.#view.setReadout('');
    this.hideRegion();
  }

  /** Shows what follows, and by how much; null: nothing does. */
  showShares(shares: ReadonlyMap<number, number> | null): void {
    this.#view.setShares(shares);
  }

  /** Shades vertices by a number from 1 to 0; null: not. */
  shade(shares: Float32Array | null): void {
    this.#regions += 1;
    this.#view.setRegion(shares);
  }

  /** Shades the vertices that the locality would fix. */
  async showRegion(origins: readonly number[], locality: number | null): Promise<void> {
    if (locality === null || origins.length === 0) return this.hideRegion();
    const question = ++this.#regions;
    const mobility = await this.#client.mobility(locality, origins);
    if (question === this.#regions) this.#view.setRegion(mobility);
  }

  hideRegion(): void {
    this.shade(null);
  }

  /** Only these: of what was in hand at the start some may have gone. */
  #moved(targets: readonly Handle[], translation: Vec3): Handle[] {
    const present = new Set(targets.map(({ vertex }) => vertex));
    return this.#inHand
      .filter(({ vertex }) => present.has(vertex))
      .map((each) => ({ vertex: each.vertex, target: translated(each, translation) }));
  }

  async #findReach(): Promise<void> {
    const drag = ++this.#drags;
    const vertices = this.#free.filter(({ isLed }) => !isLed).map(({ vertex }) => vertex);
    if (vertices.length > MOST_LIMITED) return;
    // The solver is to be at the first move before it is asked for this.
    await new Promise((resume) => setTimeout(resume));
    if (drag !== this.#drags) return;
    const reaches = await this.#client.reach(vertices);
    if (drag !== this.#drags) return;
    const led = new Set(this.#free.filter(({ isLed }) => isLed).map(({ vertex }) => vertex));
    this.#reaches = reaches.map((balls) => balls.filter(({ vertex }) => !led.has(vertex)));
    this.#restrict();
  }

  /** To what the drag is kept to. */
  #restrict(): void {
    const { axes } = this.#along ?? {};
    const limits = (all: readonly InHand[]): Limit[] =>
      limitsOf(
        all.filter(({ isLed }) => !isLed),
        this.#reaches,
      );
    this.#freeLimits = limits(this.#free);
    this.#inHand = axes ? this.#free.map((each) => keptTo(axes, each)) : this.#free;
    this.#limits = axes ? limits(this.#inHand) : this.#freeLimits;
  }

  /** Limits are of translations; they are drawn about the start of the leading handle. */
  #showReach(shown: boolean): void {
    const [x, y, z] = this.#inHand[0]!.base;
    const place = ({ centre, ...limit }: Limit): Limit => ({
      ...limit,
      centre: [centre[0] + x, centre[1] + y, centre[2] + z],
    });
    this.#view.setReach(shown ? this.#freeLimits.map(place) : null);
  }
}

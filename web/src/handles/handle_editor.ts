/** The one place that changes handles: keeps document, history, solver and the mirror image in step. */
import type { Handle } from '../../../wasm/chebnet';
import { handlesTitle, traitsChange } from '../document/changes';
import { targetsOf } from '../document/document';
import type { ChebnetDocument, HandleData, Symmetry, Vec3 } from '../document/document';
import type { ChangeName, Term } from '../document/naming';
import { pointOf } from '../document/point_of';
import type { Snapshot, UndoHistory } from '../document/undo';
import { words } from '../language/language';
import { lazy } from '../lazy';
import type { Client } from '../worker/client';
import type { Opening } from '../worker/opening';
import type { DrawnSurface, OpenedNet } from '../worker/protocol';
import type { Along } from './along';
import type { DragGuide } from './drag_guide';
import type { Follower } from './influence';
import { listsThrough } from './lines';
import type { Part } from './part';
import type { InHand } from './reach';
import { all, type Selection, unlocked, within } from './selection';
import type { Snapping } from './snapping';
import type { Surroundings, SurroundingsHost } from './surroundings';
import { Mirror } from './symmetry';
import { AXES, type Motion, transformed } from './transform';
import type { Choice, GizmoMode, HandleTraits, HandleCommands, LineName } from './commands';

/** The part of the app that it uses. */
interface HandleHost {
  opening(): Opening | null;
  /** The state before a change. Fails where no net is open, or another one is about to be. */
  before(): Snapshot;
  /** Null then. */
  beforeIfAny(): Snapshot | null;
  change(change: Partial<ChebnetDocument>): void;
  /** Likewise, in the middle of a drag; shown at once. */
  drag(handles: HandleData[]): void;
  restore(state: Snapshot): void;
  /** The selection changed, or its mode. */
  choiceChanged(): void;
  say(message: string): void;
  /** For what the user does: a failure is shown, not thrown. */
  attempt(doing: Promise<unknown>): void;
}

type Influence = typeof import('./influence');

/** Of one vertex. */
interface LinesThrough {
  net: OpenedNet;
  vertex: number;
  loops: number[][];
  netLines: number[][];
}

export class HandleEditor implements HandleCommands {
  readonly #host: HandleHost;
  readonly #client: Client;
  readonly #history: UndoHistory;
  readonly #guide: DragGuide;
  #selection: Selection = [];
  #selecting = false;
  #mode: GizmoMode = 'translate';
  /** The part of the net that is shown alone. */
  #part: Part | undefined;
  /** The history's name for the drag under way; null until it moves something. */
  #dragName: ChangeName | null = null;
  /** What follows what is in hand, and where all stood at the start of the drag. */
  #followers: readonly Follower[] = [];
  #stood: ReadonlyMap<number, Vec3> = new Map();
  /** null: it has not been wanted yet. */
  #influence: Influence | null = null;
  /** Targets of the drag under way, to be sent again if a new solver replaces a lost one; null: none, or sent again already. */
  #pendingTargets: readonly Handle[] | null = null;
  #lines: LinesThrough | null = null;
  #mirror: { net: OpenedNet; symmetry: Symmetry; mirror: Mirror } | null = null;
  readonly #loadInfluence = lazy(async () => (this.#influence = await import('./influence')));
  readonly #surroundings = lazy(async () => new (await import('./surroundings')).Surroundings(this.#forSurroundings));

  constructor(host: HandleHost, client: Client, history: UndoHistory, guide: DragGuide) {
    this.#host = host;
    this.#client = client;
    this.#history = history;
    this.#guide = guide;
  }

  // --------------------------------------------------------------------------------------------------------- choosing

  /** The selection, and what can be done with it. */
  get choice(): Choice {
    this.#selection = within(this.#selection, this.#handles);
    const lines = this.#linesThroughLeading();
    return {
      selection: this.#selection,
      selecting: this.#selecting,
      mode: unlocked(this.#selection, this.#handles).length > 1 ? this.#mode : 'translate',
      onBoundary: lines !== null && lines.loops.length > 0,
      lines: lines?.netLines.length ?? 0,
      part: this.#part,
      snapping: this.#guide.snapping,
    };
  }

  select(selection: Selection): void {
    this.#selection = selection;
    this.#host.choiceChanged();
  }

  selectAll(): void {
    this.select(all(this.#handles).filter((vertex) => !this.#part?.hidden[vertex]));
  }

  toggleSelecting(): void {
    this.#selecting = !this.#selecting;
    this.#host.choiceChanged();
  }

  /** Ends selecting several; without that, clears the selection. */
  escape(): void {
    if (this.#selecting) this.toggleSelecting();
    else this.select([]);
  }

  /** Ends selecting several, during which there are no arrows to use. */
  setMode(mode: GizmoMode): void {
    this.#mode = mode;
    this.#selecting = false;
    this.#host.choiceChanged();
  }

  /** Another net is open. */
  netChanged(): void {
    this.#selection = [];
    this.#selecting = false;
    this.#mode = 'translate';
    this.#part = undefined;
    this.#pendingTargets = null;
    this.#prepareInfluence();
  }

  // --------------------------------------------------------------------------------------------------------- which ones

  /** Replaces the handles.
   *  @param name what the history calls it.
   *  @param selection of these. */
  async set(
    handles: readonly HandleData[],
    name: ChangeName = ['handles'],
    selection = this.#selection,
  ): Promise<void> {
    const before = this.#host.before();
    const after = [...handles];
    this.#history.record(before, name);
    this.#host.change({ handles: after });
    // At once: others may be selected before the solver has taken them.
    this.select(selection);
    await this.#taken(this.#client.setHandles(targetsOf(handles)), before, after);
  }

  add(vertex: number, also: Selection = []): void {
    this.#host.attempt(this.#take([vertex], [...also, vertex]));
  }

  propose(): void {
    this.#host.attempt(this.#propose());
  }

  async #propose(): Promise<void> {
    const { proposedHandles } = await import('./proposal');
    const net = this.#host.opening()?.net;
    if (!net || this.#handles.length > 0) return;
    const handles = proposedHandles(net).map((seed) => ({ ...seed, target: this.positionOf(seed.vertex) }));
    await this.set(handles, ['propose']);
  }

  takeLine(name: LineName, title: string): void {
    this.#takeNamed(this.line(name), title);
  }

  around(doing: (surroundings: Surroundings) => void): void {
    this.#host.attempt(this.#surroundings().then(doing));
  }

  line(name: LineName): readonly number[] {
    const lines = this.#linesThroughLeading();
    return (name === 'boundary' ? lines?.loops[0] : lines?.netLines[name]) ?? [];
  }

  remove(vertices: Selection): void {
    const chosen = new Set(this.bothSides(vertices));
    const leaves = ({ vertex, anchor }: HandleData): boolean => chosen.has(vertex) && !anchor;
    const leaving = this.#handles.filter(leaves);
    if (unlocked(vertices, this.#handles).length < vertices.length) this.sayLocked();
    if (leaving.length === 0) return;
    const staying = this.#handles.filter((handle) => !leaves(handle));
    this.#host.attempt(this.set(staying, ['remove', this.#titleOf(leaving)]));
  }

  sayLocked(): void {
    this.#host.say(words.handles.lockedStay);
  }

  removeSelected(): void {
    if (this.#selection.length > 0) this.remove(this.#selection);
  }

  /** These vertices and their mirror images. */
  bothSides(vertices: readonly number[]): readonly number[] {
    return this.#mirrorOf()?.both(vertices) ?? vertices;
  }

  /** Makes vertices around the leading handle handles of one name. */
  #takeNamed(vertices: readonly number[], title: string): void {
    const vertex = this.#selection.at(-1);
    if (vertex === undefined) return;
    const selection = [...vertices.filter((each) => each !== vertex), vertex];
    this.#host.attempt(this.#take(vertices, selection, `${title} · ${vertex}`));
  }

  /** Makes vertices handles, with their mirror images, where they stand.
   *  @param name of those that are new, or have none and are not locked. */
  async #take(vertices: readonly number[], selection: Selection, name?: string): Promise<void> {
    const wanted = new Set(this.bothSides(vertices));
    const present = new Set(this.#handles.map(({ vertex }) => vertex));
    const fresh = [...wanted].filter((vertex) => !present.has(vertex));
    const joins = (each: HandleData): boolean =>
      name !== undefined && each.name === undefined && !each.anchor && wanted.has(each.vertex);
    const before = this.#handles.map((each) => (joins(each) ? { ...each, name: name! } : each));
    const added = fresh.map(
      (vertex): HandleData => ({
        vertex,
        target: this.positionOf(vertex),
        anchor: false,
        ...(name !== undefined && { name }),
      }),
    );
    if (added.length === 0) return this.select(selection);
    await this.set([...before, ...added], ['add', this.#titleOf(added)], selection);
  }

  // --------------------------------------------------------------------------------------------------------- what they are

  /** Name, lock and the like of some handles. */
  change(vertices: Selection, traits: HandleTraits): void {
    const chosen = new Set(vertices);
    // Only exact handles slide.
    const others: HandleTraits =
      traits.weight !== undefined ? { slides: undefined } : traits.slides !== undefined ? { weight: undefined } : {};
    const changed = (handle: HandleData): HandleData => ({ ...handle, ...others, ...traits });
    const handles = this.#handles.map((handle) => (chosen.has(handle.vertex) ? changed(handle) : handle));
    // The solver does not know names, locks and visibility.
    const name = traitsChange(traits, this.#titleOf(this.#handles.filter(({ vertex }) => chosen.has(vertex))));
    if ('weight' in traits || 'slides' in traits) return this.#host.attempt(this.set(handles, name));
    this.#changeDocument({ handles }, name);
  }

  setSymmetry(symmetry: Symmetry | undefined): void {
    this.#changeDocument({ symmetry }, [symmetry ? 'symmetry' : 'noSymmetry']);
  }

  // --------------------------------------------------------------------------------------------------- what limits drags

  setLocality(locality: number | undefined): void {
    const name: ChangeName = locality === undefined ? ['noLocality'] : ['locality', { number: String(locality) }];
    this.#changeDocument({ locality }, name, 'locality');
    // The next drag brings another locality to the solver; that there is none counts at once, also for a net that is stuck.
    if (locality === undefined) this.#host.attempt(this.#guide.limit([], null));
  }

  /** Previews the locality around the selection, or around the handle likely to be dragged. */
  previewLocality(locality: number | undefined): void {
    this.#host.attempt(this.#guide.showRegion(this.bothSides(this.#likely), locality ?? null));
  }

  /** What is likely to be dragged next. */
  get #likely(): readonly number[] {
    const draggable = this.#handles.filter(({ anchor }) => !anchor).map(({ vertex }) => vertex);
    return this.#selection.length > 0 ? this.#selection : draggable.slice(-1);
  }

  setInfluence(influence: number | undefined): void {
    const name: ChangeName = influence === undefined ? ['noInfluence'] : ['influence', { number: String(influence) }];
    this.#changeDocument({ influence }, name, 'influence');
    this.#prepareInfluence();
  }

  /** So that it is there when a drag begins. */
  #prepareInfluence(): void {
    if (this.#radius !== null) this.#host.attempt(this.#loadInfluence());
  }

  /** Shows what would follow the selection, or the handle likely to be dragged. */
  previewInfluence(influence: number | undefined): void {
    this.#host.attempt(this.#loadInfluence().then((module) => this.#showInfluence(module, influence)));
  }

  #showInfluence({ sharesAround }: Influence, radius: number | undefined): void {
    const net = this.#host.opening()?.net;
    const inHand = this.bothSides(this.#likely);
    const isShown = net && radius !== undefined && inHand.length > 0;
    this.#guide.shade(isShown ? sharesAround(net, inHand, radius) : null);
    this.#guide.showShares(isShown ? this.#sharesOf(inHand, this.#followersOf(inHand, radius)) : null);
  }

  setKeepWithin(on: boolean): void {
    this.#guide.keepsWithin = on;
  }

  guide(): Promise<DrawnSurface | null> {
    return this.#client.guide();
  }

  setSnapping(snapping: Snapping | null): void {
    this.#guide.snapping = snapping;
    this.#host.choiceChanged();
    if (this.#dragName !== null && this.#pendingTargets) this.#carry(this.#pendingTargets);
  }

  setShowReach(on: boolean): void {
    this.#guide.alwaysShowsReach = on;
  }

  get #locality(): number | null {
    return this.#host.opening()?.document.locality ?? null;
  }

  get #radius(): number | null {
    return this.#host.opening()?.document.influence ?? null;
  }

  /** Changes one after another with the same `key` are undone together. */
  #changeDocument(change: Partial<ChebnetDocument>, name: ChangeName, key: string | null = null): void {
    const before = this.#host.beforeIfAny();
    // Controls show again what is.
    if (before === null || isPartOf(before, change)) return this.#host.choiceChanged();
    this.#history.record(before, name, key);
    this.#host.change(change);
  }

  // ---------------------------------------------------------------------------------------------------- where they are

  place(vertex: number, target: Vec3): void {
    this.#host.attempt(this.moveByHand([{ vertex, target }]));
  }

  /** Moves, turns or scales the selection about its centre. */
  transform(motion: Motion): void {
    const moving = unlocked(this.#selection, this.#handles);
    const targets = transformed(
      moving.map(({ target }) => target),
      motion,
    );
    if (moving.length > 0)
      this.#host.attempt(this.moveByHand(moving.map(({ vertex }, i) => ({ vertex, target: targets[i]! }))));
  }

  /** Moves handles, and their mirror images. Moves one after another with the same `key` are undone together. */
  async move(targets: readonly Handle[], key: string | null = null, inHand = false): Promise<void> {
    const before = this.#host.before();
    const both = this.#onBothSides(targets);
    this.#history.record(before, ['move', this.#titleOf(targets)], key);
    // The requests are sent now, in this order, so that a caller's next request comes after them.
    const limited = this.#guide.limit(verticesOf(both), this.#locality);
    const asked = Promise.all([limited, this.#client.drag(both, inHand), ...(inHand ? [this.#client.release()] : [])]);
    const after = this.#withTargets(both);
    this.#host.change({ handles: after });
    await this.#taken(asked, before, after);
  }

  /** Handles that stand in the document are taken back if the solver refuses them. */
  async #taken(asked: Promise<unknown>, before: Snapshot, after: readonly HandleData[]): Promise<void> {
    try {
      await asked;
    } catch (error) {
      // A solver that replaces a lost one takes them from the document.
      if (this.#client.returning) return;
      this.#takeBack(before, after);
      throw error;
    }
  }

  /** A change of handles, from those of `before`, was refused. What has been done since stays. */
  #takeBack(before: Snapshot, after: readonly HandleData[]): void {
    const wasLast = this.#history.takeBack(before);
    if (wasLast || this.#handles === after) this.#host.change({ handles: [...before.handles] });
  }

  /** Likewise, as far as the net goes if drags are kept within reach. */
  moveByHand(targets: readonly Handle[]): Promise<void> {
    return this.move(targets, null, this.#guide.keepsWithin);
  }

  /** Returns whether it can begin. */
  beginDrag(): boolean {
    const before = this.#host.beforeIfAny();
    if (before === null) return false;
    this.#dragName = null;
    this.#prepareInfluence();
    this.#history.beginGesture(before);
    return true;
  }

  /** `along`: what the drag is kept to, from now on. Handles that have gone since the view took hold of them are left out. */
  drag(targets: readonly Handle[], along: Along | null = null): void {
    const present = new Set(verticesOf(this.#handles));
    const held = targets.filter(({ vertex }) => present.has(vertex));
    if (!this.#history.inGesture || held.length === 0 || this.#host.beforeIfAny() === null) return;
    this.#followers = this.#followers.filter(({ vertex, leader }) => present.has(vertex) && present.has(leader));
    this.#pendingTargets = held;
    this.#guide.keepTo(along);
    this.#carry(held);
  }

  /** A new solver has replaced a lost one, at its last positions. It is sent the targets of the drag once only: they may be
   *  what broke the other. */
  resumeDrag(): void {
    const targets = this.#pendingTargets;
    if (targets === null) return;
    this.#pendingTargets = null;
    this.#host.attempt(this.#guide.limit(verticesOf(this.#withFollowers(targets)), this.#locality));
    this.#carry(targets);
    if (!this.#history.inGesture) this.#host.attempt(this.#client.release());
  }

  #carry(targets: readonly Handle[]): void {
    if (this.#dragName === null) this.#begin(targets);
    const mirrored = this.#withFollowers(targets);
    const inHand = new Set(verticesOf(mirrored));
    const others = this.#handles.filter(({ vertex }) => !inHand.has(vertex));
    const asked = this.#guide.snapped(mirrored, others);
    const both = this.#guide.within(asked);
    const hand = this.#handSays(targets, asked, both !== asked);
    // First, so that the solver is at work while they are shown.
    this.#host.attempt(this.#client.drag(both, this.#guide.keepsWithin, hand));
    this.#guide.describe(both, others);
    this.#host.drag(this.#withTargets(both));
  }

  /** What follows the hand asks for nothing: it goes as far as the net lets it. Where it gets into its way the hand falls short
   *  for its sake, and not for that of the lengths, unless it is beyond reach by itself. */
  #handSays(hand: readonly Handle[], asked: readonly Handle[], isBeyond: boolean): Parameters<Client['drag']>[2] {
    const own = new Set(this.#followers.length > 0 && !isBeyond ? [] : verticesOf(this.#onBothSides(hand)));
    return { asked: asked.filter(({ vertex }) => own.has(vertex)), along: this.#guide.axes };
  }

  #begin(targets: readonly Handle[]): void {
    this.#dragName = ['move', this.#titleOf(targets)];
    this.#stood = new Map(this.#handles.map(({ vertex, target }) => [vertex, target]));
    const hand = verticesOf(this.#onBothSides(targets));
    this.#followers = this.#radius === null ? [] : this.#followersOf(hand, this.#radius);
    if (this.#radius !== null) this.#guide.showShares(this.#sharesOf(hand, this.#followers));
    this.#host.attempt(this.#guide.begin(this.#inHand(targets), this.#locality));
  }

  endDrag(cancelled: boolean): void {
    // A new solver on its way does not know yet where the handles were released.
    if (cancelled || !this.#client.returning) this.#pendingTargets = null;
    const hasChanged = this.#dragName !== null || this.#history.gestureHasChanges;
    const before = cancelled ? this.#history.cancelGesture() : null;
    if (before && hasChanged) this.#host.restore(before);
    else if (this.#dragName !== null && this.#history.inGesture && !this.#client.returning)
      this.#host.attempt(this.#client.release());
    this.#history.endGesture(this.#dragName);
    this.#followers = [];
    this.#guide.end();
  }

  /** Where a vertex stands. */
  positionOf(vertex: number): Vec3 {
    const positions = this.#host.opening()?.frame.positions;
    return positions ? pointOf(positions, vertex) : [0, 0, 0];
  }

  // ------------------------------------------------------------------------------------------------------------ the net

  get #handles(): readonly HandleData[] {
    return this.#host.opening()?.document.handles ?? [];
  }

  #titleOf(of: readonly { vertex: number }[]): Term {
    return handlesTitle(this.#handles, of);
  }

  #withTargets(targets: readonly Handle[]): HandleData[] {
    const moved = new Map(targets.map(({ vertex, target }) => [vertex, target]));
    return this.#handles.map((handle) => {
      const target = moved.get(handle.vertex);
      return target ? { ...handle, target: slid(target, handle) } : handle;
    });
  }

  get #forSurroundings(): SurroundingsHost {
    return {
      net: () => this.#host.opening()?.net ?? null,
      selection: () => this.choice.selection,
      take: (vertices, title) => this.#takeNamed(vertices, title),
      part: () => this.#part,
      show: (part) => {
        this.#part = part;
        this.#host.choiceChanged();
      },
    };
  }

  #onBothSides(targets: readonly Handle[]): readonly Handle[] {
    return this.#mirrorOf()?.mirrored(targets, this.#handles) ?? targets;
  }

  /** Where these, what follows them, and the mirror images go. */
  #withFollowers(targets: readonly Handle[]): readonly Handle[] {
    const hand = this.#onBothSides(targets);
    if (this.#followers.length === 0 || this.#influence === null) return hand;
    const followers = this.#influence.following(this.#followers, hand, (vertex) => this.#stood.get(vertex)!);
    return this.#onBothSides([...hand, ...followers]);
  }

  #followersOf(hand: readonly number[], radius: number): readonly Follower[] {
    const net = this.#host.opening()?.net;
    return (net && this.#influence?.followersOf(net, this.#handles, hand, radius)) ?? [];
  }

  #sharesOf(hand: readonly number[], followers: readonly Follower[]): Map<number, number> {
    const whole = hand.map((vertex): [number, number] => [vertex, 1]);
    return new Map([...followers.map(({ vertex, share }): [number, number] => [vertex, share]), ...whole]);
  }

  /** What a translation of these handles, from where they stood, does to them, what follows them, and the mirror images. */
  #inHand(of: readonly Handle[]): InHand[] {
    const movedBy = (step: number): readonly Handle[] =>
      this.#withFollowers(
        verticesOf(of).map((vertex) => ({ vertex, target: this.#stood.get(vertex)!.map((x) => x + step) as Vec3 })),
      );
    const stepped = movedBy(1);
    const slides = new Map(this.#handles.map((handle) => [handle.vertex, handle.slides]));
    const led = new Set(verticesOf(this.#followers));
    return movedBy(0).map(({ vertex, target: base }, i) => {
      const moves = base.map((x, axis) => withoutRounding(stepped[i]!.target[axis]! - x));
      // Where it slides it goes with the net.
      const follows = moves.map((each, axis) => (slides.get(vertex)?.includes(AXES[axis]!) ? 0 : each)) as Vec3;
      return { vertex, base, follows, isLed: led.has(vertex) };
    });
  }

  #linesThroughLeading(): LinesThrough | null {
    const vertex = this.#selection.at(-1);
    const net = this.#host.opening()?.net;
    if (vertex === undefined || net === undefined) return null;
    if (this.#lines?.net !== net || this.#lines.vertex !== vertex) {
      const loops = listsThrough(vertex, { start: net.loopStart, vertices: net.loopVertices });
      const netLines = listsThrough(vertex, { start: net.lineStart, vertices: net.lineVertices });
      this.#lines = { net, vertex, loops, netLines };
    }
    return this.#lines;
  }

  #mirrorOf(): Mirror | null {
    const opening = this.#host.opening();
    const symmetry = opening?.document.symmetry;
    if (!opening || !symmetry) return null;
    const { net } = opening;
    if (this.#mirror?.net !== net || this.#mirror.symmetry !== symmetry) {
      this.#mirror = { net, symmetry, mirror: new Mirror(symmetry, net.restPositions, net.info.meanLength) };
    }
    return this.#mirror.mirror;
  }
}

function isPartOf(document: Snapshot, change: Partial<Snapshot>): boolean {
  return Object.entries(change).every(([name, value]) => document[name as keyof Snapshot] === value);
}

/** A whole number where it is one but for rounding. */
function withoutRounding(x: number): number {
  const whole = Math.round(x);
  return Math.abs(x - whole) < 1e-6 ? whole : x;
}

/** A target, but where the handle slides along axes. */
function slid(target: Vec3, { slides, target: at }: HandleData): Vec3 {
  return target.map((x, axis) => (slides?.includes(AXES[axis]!) ? at[axis]! : x)) as Vec3;
}

function verticesOf(targets: readonly { vertex: number }[]): number[] {
  return targets.map(({ vertex }) => vertex);
}

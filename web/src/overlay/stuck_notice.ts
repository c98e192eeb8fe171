/** Where the net does not do what was asked of it: a solve ended without a shape in which all edges have their length, or a
 *  hand was held back, or a net that is too large to be at rest while it is edited is creased, or it has come to a shape that
 *  is crumpled. Why, and the ways out; it stays for as long as that is so, or until it is dismissed. Also what came of one of
 *  these ways: edges that have grown, for as long as they are so. */
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument, HandleData } from '../document/document';
import { isTooLargeToRest } from '../document/too_large_to_rest';
import type { HistoryView } from '../document/undo';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden, showLine } from '../elements/leave';
import type { Choice } from '../handles/commands';
import { unlocked } from '../handles/selection';
import { apart, count } from '../language/numbers';
import { panelWords } from '../language/panels';
import { type BadCells, badCells, creasedCells, crumpledCells, NONE_BAD } from './bad_cells';
import { placeClear } from './clear_place';
import { CornerLimit } from './corner_limit';
import { GoodPlaces } from './good_places';
import { makeDismiss } from './messages';
import { KEPT_DEVIATION } from '../net/edge_lengths';
import { sharpQuads } from '../net/sharp_quads';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet, SearchProgress } from '../worker/protocol';
import './stuck_notice.css';

/** The least weight that can be chosen: the net finds its shape, and the weight can be raised from there. */
const SOFT = 0.01;
const SCALE = 'length_scale';
/** What is no farther from the limit of corners is held by it, in degrees. */
const AT_LIMIT = 0.1;
/** More than this could not be told apart, and would be slow to draw. */
const MOST_MARKS = 500;
/** Of the net, for how much of it the notice would cover. */
const MOST_POINTS = 300;

/** Of the history, before that has been told. */
const BEGINNING = { names: [''], present: 0, forgotten: 0, inGesture: false };

type Unreachable = FrameData['unreachable'][number];

type Standing = 'good' | 'stuck' | 'creased' | 'crumpled' | 'short' | 'grown' | 'growing' | 'relaxing';

export class StuckNotice implements Panel {
  // In the page from the start: screen readers announce changes of what is there.
  readonly element = make('div', { class: 'stuck-notice', role: 'status' });
  readonly #events: PanelEvents;
  readonly #failed: (error: unknown) => void;
  readonly #words = make('span');
  readonly #back: HTMLButtonElement;
  readonly #soften: HTMLButtonElement;
  readonly #grow: HTMLButtonElement;
  readonly #widen: HTMLButtonElement;
  readonly #rest: HTMLButtonElement;
  readonly #relax: HTMLButtonElement;
  readonly #stop: HTMLButtonElement;
  readonly #lengthsBack: HTMLButtonElement;
  readonly #dismiss: HTMLButtonElement;
  readonly #line: HTMLElement;
  #document: ChebnetDocument | null = null;
  #handles: readonly HandleData[] = [];
  #choice: Choice | null = null;
  #frame: FrameData | null = null;
  #net: OpenedNet | null = null;
  readonly #cornerLimit = new CornerLimit();
  /** What is wrong with the net as it stands. */
  #bad: BadCells = NONE_BAD;
  /** A way out that takes its time. */
  #underWay: 'growing' | 'relaxing' | null = null;
  #history: HistoryView | null = null;
  readonly #places = new GoodPlaces();
  /** The revision of the history for which a way out that took its time has led nowhere. */
  #hopeless: number | null = null;
  /** What was said when it was put away. */
  #dismissed: string | null = null;
  /** The scale of lengths that was found here, as a way out, and that of before. */
  #grown: { to: number; from: number } | null = null;

  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.#failed = failed;
    const { back, soften, grow, widen, rest, stop, lengthsBack } = panelWords.stuck;
    const { relax } = panelWords;
    this.#back = makeButton(back, () => events.goTo(this.#lastGood!));
    this.#soften = makeButton(soften, () => events.handles.change(this.#candidates, { weight: SOFT }));
    this.#grow = makeButton(grow, () => this.#growEdges().catch(this.#failed));
    this.#widen = makeButton(widen, () => events.moveWhole());
    this.#rest = makeButton(rest, () => this.#bringToRest());
    this.#relax = makeButton(relax.label, () => this.#relaxFurther().catch(this.#failed), { title: relax.hint });
    this.#stop = makeButton(stop, () => events.cancel());
    this.#lengthsBack = makeButton(lengthsBack, () => this.#takeLengthsBack());
    this.#dismiss = makeDismiss(() => this.#putAway());
    const ways = make(
      'div',
      { class: 'buttons' },
      ...[this.#back, this.#soften, this.#grow, this.#widen, this.#rest, this.#relax, this.#stop, this.#lengthsBack],
    );
    this.#line = make('div', { class: 'message' }, make('div', {}, this.#words, ways), this.#dismiss);
  }

  setTables(tables: Tables): void {
    this.#cornerLimit.setTables(tables);
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    this.#show();
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    const isOther = choice.selection !== this.#choice?.selection;
    this.#handles = handles;
    this.#choice = choice;
    this.#show();
    // What can be done with what is selected makes room, or takes it.
    if (isOther) this.#place();
  }

  setHistory(history: HistoryView): void {
    this.#history = history;
    this.#show();
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#grown = null;
    this.#places.clear();
    this.#frame = null;
    this.#mark();
    this.#show();
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) {
      if (this.#standing === 'short') this.#dismissed = null;
      return;
    }
    this.#frame = frame;
    this.#mark();
    const wasShown = this.#isShown;
    const isGood = frame.maxDeviation <= KEPT_DEVIATION && this.#badCells.length === 0;
    this.#places.note(this.#history ?? BEGINNING, isGood);
    this.#show();
    // Under a moving hand it stays where it was put.
    if (!wasShown || !this.#isHeld) this.#place();
  }

  #place(): void {
    if (!this.#isShown) return;
    const vertices = thinnedOut([...Array(this.#net?.info.vertices ?? 0).keys()], MOST_POINTS);
    placeClear(this.element, this.#handles, this.#choice?.selection ?? [], vertices, this.#events);
  }

  /** The cells to blame, if the net did not come to a good shape. */
  #mark(): void {
    const [net, frame, before] = [this.#net, this.#frame, this.#bad];
    this.#bad = net && frame ? this.#badOf(net, frame) : NONE_BAD;
    const cells = thinnedOut(this.#badCells, MOST_MARKS);
    if (net && (cells.length > 0 || before !== NONE_BAD))
      this.#events.mark(
        cells.map((face) => [...net.faceVertices.subarray(net.faceStart[face], net.faceStart[face + 1])]),
      );
  }

  #badOf(net: OpenedNet, frame: FrameData): BadCells {
    const isLost = hasLostLengths(frame, net);
    // What a hand holds may yet unfold.
    if (!isLost && this.#isTooLargeToRest)
      return this.#isHeld ? NONE_BAD : creasedCells(net, frame, this.#cornerLimit.asked(this.#document!));
    const bad = isLost || mayBeSharp(frame) ? badCells(net, frame, this.#limit) : NONE_BAD;
    const mayBeCrumpled = frame.maxDeviation <= KEPT_DEVIATION && !frame.fellShort && !this.#isHeld;
    return mayBeCrumpled && bad.sharp.size === 0 ? crumpledCells(net, frame) : bad;
  }

  get #isHeld(): boolean {
    return this.#history?.inGesture === true;
  }

  get #badCells(): number[] {
    const { off, sharp, folded } = this.#bad;
    return [...new Set([...off, ...sharp, ...folded])];
  }

  /** Whether it is for its size that the method keeps lengths alone. */
  get #isTooLargeToRest(): boolean {
    return this.#document !== null && isTooLargeToRest(this.#document);
  }

  /** Of corners, in degrees, for the method that heeds one. */
  get #limit(): number {
    return this.#document === null ? 0 : this.#cornerLimit.of(this.#document);
  }

  /** Whether corners keep the net from going farther. */
  get #isAtLimit(): boolean {
    const [net, frame] = [this.#net, this.#frame];
    return net !== null && frame !== null && sharpQuads(net, frame.positions, this.#limit + AT_LIMIT).size > 0;
  }

  #show(): void {
    const standing = this.#standing;
    const isAsked = standing === 'stuck' || standing === 'short';
    const isBad = standing === 'stuck' || standing === 'creased' || standing === 'crumpled';
    const isUnderWay = this.#underWay !== null;
    setHidden(this.#back, !isBad || !this.#history?.canUndo || this.#lastGood === undefined);
    setHidden(this.#rest, standing !== 'creased' && (standing !== 'crumpled' || this.#isAtRest));
    setHidden(this.#relax, standing !== 'crumpled' || !this.#isAtRest || this.#isHopeless);
    setHidden(this.#soften, standing !== 'stuck' || this.#candidates.length === 0);
    setHidden(this.#grow, !isAsked || this.#isLocal || (standing === 'stuck' && !isTooFar(this.#worst)));
    setHidden(this.#widen, !isAsked || !this.#isLocal);
    setHidden(this.#stop, !isUnderWay);
    setHidden(this.#lengthsBack, standing !== 'grown');
    setHidden(this.#dismiss, isUnderWay);
    if (standing !== 'good' && !isUnderWay) setText(this.#words, this.#reason(standing));
    if (standing === 'good') this.#dismissed = null;
    const isShown = standing !== 'good' && this.#words.textContent !== this.#dismissed;
    showLine(this.element, this.#line, isShown);
  }

  get #isShown(): boolean {
    return this.element.hasChildNodes();
  }

  get #standing(): Standing {
    if (this.#underWay !== null) return this.#underWay;
    if (this.#frame === null || this.#net === null) return 'good';
    if (hasLostLengths(this.#frame, this.#net)) return 'stuck';
    if (this.#bad.sharp.size > 0) return this.#isTooLargeToRest ? 'creased' : 'stuck';
    if (this.#frame.fellShort) return 'short';
    if (this.#bad.folded.size > 0) return 'crumpled';
    return this.#scale === this.#grown?.to ? 'grown' : 'good';
  }

  /** What may not move keeps its edges as they are. */
  get #isLocal(): boolean {
    return this.#document?.locality !== undefined;
  }

  get #isAtRest(): boolean {
    return this.#document?.method === METHOD_AT_REST;
  }

  get #isHopeless(): boolean {
    return this.#hopeless === this.#history?.revision;
  }

  get #scale(): number {
    return Number(this.#document?.options[SCALE] ?? 1);
  }

  get #worst(): Unreachable | undefined {
    return this.#frame?.unreachable[0];
  }

  get #lastGood(): number | undefined {
    return this.#places.lastBefore(this.#history ?? BEGINNING);
  }

  /** The handles that could give way: those out of reach, or else those selected. */
  get #candidates(): number[] {
    const wanted = this.#worst ? [this.#worst.vertexA, this.#worst.vertexB] : (this.#choice?.selection ?? []);
    const exact = unlocked(wanted, this.#handles).filter(({ weight }) => weight === undefined);
    return exact.map(({ vertex }) => vertex);
  }

  async #growEdges(): Promise<void> {
    const { growing } = panelWords.stuck;
    const from = this.#scale;
    const tell = (scale: number): void => setText(this.#words, growing(percentOf(scale)));
    tell(from);
    await this.#goWay('growing', async () =>
      this.#take(await this.#events.adaptLengths(({ reached }) => tell(reached)), from),
    );
  }

  async #relaxFurther(): Promise<void> {
    const tell = ({ reached, iterations }: SearchProgress): void =>
      setText(this.#words, panelWords.relax.looking(reached, count(iterations)));
    tell({ reached: 0, iterations: 0 });
    await this.#goWay('relaxing', async () => {
      if ((await this.#events.searchRest(tell)) === null) this.#hopeless = this.#history?.revision ?? null;
    });
  }

  async #goWay(way: 'growing' | 'relaxing', go: () => Promise<void>): Promise<void> {
    this.#underWay = way;
    this.#show();
    try {
      await go();
    } finally {
      this.#underWay = null;
      this.#show();
    }
  }

  #take(scale: number | null, from: number): void {
    this.#dismissed = null;
    if (scale === null) {
      this.#hopeless = this.#history?.revision ?? null;
      return;
    }
    this.#grown = scale === from ? null : { to: scale, from };
    // What fell short was the net of before; the next frame at rest may be seconds away.
    if (this.#frame) this.#frame = { ...this.#frame, fellShort: false };
  }

  #bringToRest(): void {
    const { initialisation, options } = this.#document!;
    this.#events.setBehaviour({ method: METHOD_AT_REST, initialisation, options });
  }

  #putAway(): void {
    this.#dismissed = this.#words.textContent;
    this.#show();
  }

  #takeLengthsBack(): void {
    if (this.#document === null || this.#grown === null) return;
    const { method, initialisation, options } = this.#document;
    this.#events.setBehaviour({ method, initialisation, options: { ...options, [SCALE]: this.#grown.from } });
  }

  #reason(standing: Standing): string {
    const { creased, crumpled, noSmoother, fellShort, localFellShort } = panelWords.stuck;
    const { grown, shrunk, leftSo, noLength, noShape, tooSharp } = panelWords.stuck;
    if (standing === 'creased') return creased(count(this.#bad.sharp.size), this.#cornerLimit.asked(this.#document!));
    if (standing === 'crumpled') return this.#isHopeless ? noSmoother : crumpled;
    if (standing !== 'grown' && this.#isHopeless) return noLength;
    if (standing === 'short' && this.#isLocal) return localFellShort;
    if (standing === 'short') return fellShort(this.#isAtLimit ? this.#limit : null);
    if (standing === 'grown') return (this.#scale > 1 ? grown : shrunk)(percentOf(this.#scale));
    if (this.#worst === undefined) {
      if (!hasLostLengths(this.#frame!, this.#net!)) return tooSharp;
      return this.#frame!.status === 'running' ? leftSo : noShape;
    }
    return this.#reasonOf(this.#worst);
  }

  #reasonOf(pair: Unreachable): string {
    const { unreachable, tooNear, tooLocal } = panelWords.stuck;
    const { vertexA, vertexB, distance, reach } = pair;
    if (this.#handles.every(({ vertex }) => vertex !== vertexB)) return tooLocal;
    return (isTooFar(pair) ? unreachable : tooNear)(vertexA, vertexB, ...apart(distance, reach));
  }
}

/** Not so two handles that an edge joins and that are nearer than it is long. */
function isTooFar(pair: Unreachable | undefined): boolean {
  return pair !== undefined && pair.distance > pair.reach;
}

/** A solve has ended without them; or the net comes so, from a link or the history, and was moved before. */
function hasLostLengths(frame: FrameData, { restPositions }: OpenedNet): boolean {
  if (frame.maxDeviation <= KEPT_DEVIATION) return false;
  return frame.status !== 'running' || (frame.iterations === 0 && hasMoved(frame, restPositions));
}

/** No solve has ended with corners within their limit. */
function mayBeSharp({ status, iterations }: FrameData): boolean {
  return status !== 'running' && !(status === 'converged' && iterations > 0);
}

/** Elsewhere than at handles, which an experiment moves before it is solved. */
function hasMoved({ positions, handles }: FrameData, rest: Float64Array): boolean {
  const held = new Set(handles.map(({ vertex }) => vertex));
  return positions.some((x, i) => x !== rest[i] && !held.has(Math.floor(i / 3)));
}

/** So many at most, from all over. */
function thinnedOut(all: readonly number[], most: number): readonly number[] {
  if (all.length <= most) return all;
  return Array.from({ length: most }, (_, i) => all[Math.floor((i * all.length) / most)]!);
}

/** By how much lengths differ from those of before. */
function percentOf(scale: number): string {
  return (100 * Math.abs(scale - 1)).toFixed(1);
}

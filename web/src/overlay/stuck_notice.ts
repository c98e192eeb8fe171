/** Where the net does not do what was asked of it: a solve ended without a shape in which all edges have their length, or a
 *  hand was held back. Why, and the ways out; it stays for as long as that is so. Also what came of one of these ways: edges
 *  that have grown, for as long as they are so. */
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument, HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import { make, makeButton, setText } from '../elements/dom';
import type { Choice } from '../handles/commands';
import { unlocked } from '../handles/selection';
import { panelWords } from '../language/panels';
import { type BadCells, badCells } from './bad_cells';
import { KEPT_DEVIATION } from '../net/edge_lengths';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import './messages.css';

/** The least weight that can be chosen: the net finds its shape, and the weight can be raised from there. */
const SOFT = 0.01;
const SCALE = 'length_scale';
const LIMIT = 'shear_limit';
/** More than this could not be told apart, and would be slow to draw. */
const MOST_MARKS = 500;

const NONE_BAD: BadCells = { off: new Set(), sharp: new Set() };

type Standing = 'good' | 'stuck' | 'short' | 'grown' | 'growing';

export class StuckNotice implements Panel {
  // In the page from the start: screen readers announce changes of what is there.
  readonly element = make('div', { class: 'stuck-notice', role: 'status' });
  readonly #events: PanelEvents;
  readonly #words = make('span');
  readonly #back: HTMLButtonElement;
  readonly #soften: HTMLButtonElement;
  readonly #grow: HTMLButtonElement;
  readonly #widen: HTMLButtonElement;
  readonly #stop: HTMLButtonElement;
  readonly #lengthsBack: HTMLButtonElement;
  readonly #line: HTMLElement;
  #document: ChebnetDocument | null = null;
  #handles: readonly HandleData[] = [];
  #choice: Choice | null = null;
  #frame: FrameData | null = null;
  #net: OpenedNet | null = null;
  #usualLimit = 0;
  /** What is wrong with the net as it stands. */
  #bad: BadCells = NONE_BAD;
  #isGrowing = false;
  #history: HistoryView | null = null;
  /** The place in the history of the last shape that was right. */
  #good = 0;

  constructor(events: PanelEvents) {
    this.#events = events;
    const { back, soften, grow, widen, stop, lengthsBack } = panelWords.stuck;
    this.#back = makeButton(back, () => events.goTo(Math.min(this.#good, this.#present - 1)));
    this.#soften = makeButton(soften, () => events.handles.change(this.#candidates, { weight: SOFT }));
    this.#grow = makeButton(grow, () => void this.#growEdges());
    this.#widen = makeButton(widen, () => {
      events.handles.setLocality(undefined);
      events.solve();
    });
    this.#stop = makeButton(stop, () => events.cancel());
    this.#lengthsBack = makeButton(lengthsBack, () => this.#takeLengthsBack());
    const ways = make(
      'div',
      { class: 'buttons' },
      ...[this.#back, this.#soften, this.#grow, this.#widen, this.#stop, this.#lengthsBack],
    );
    this.#line = make('div', { class: 'message' }, make('div', {}, this.#words, ways));
  }

  setTables({ options }: Tables): void {
    this.#usualLimit = options.find(({ name }) => name === LIMIT)?.value ?? 0;
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    this.#show();
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    this.#handles = handles;
    this.#choice = choice;
    this.#show();
  }

  setHistory(history: HistoryView): void {
    this.#history = history;
    this.#show();
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#frame = null;
    this.#mark();
    this.#show();
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) return;
    this.#frame = frame;
    this.#mark();
    if (frame.maxDeviation <= KEPT_DEVIATION && this.#bad.sharp.size === 0) this.#good = this.#present;
    this.#show();
  }

  /** The cells to blame, if the net did not come to a good shape. */
  #mark(): void {
    const [net, frame, before] = [this.#net, this.#frame, this.#bad];
    const isLost = net && frame && (hasLostLengths(frame) || frame.status === 'stalled');
    this.#bad = isLost ? badCells(net, frame, this.#limit) : NONE_BAD;
    const cells = [...new Set([...this.#bad.off, ...this.#bad.sharp])].slice(0, MOST_MARKS);
    if (net && (cells.length > 0 || before !== NONE_BAD))
      this.#events.mark(
        cells.map((face) => [...net.faceVertices.subarray(net.faceStart[face], net.faceStart[face + 1])]),
      );
  }

  /** Of corners, in degrees, for the method that heeds one. */
  get #limit(): number {
    const { method, options } = this.#document ?? {};
    return method === METHOD_AT_REST ? Number(options?.[LIMIT] ?? this.#usualLimit) : 0;
  }

  #show(): void {
    const standing = this.#standing;
    const isAsked = standing === 'stuck' || standing === 'short';
    this.#back.hidden = standing !== 'stuck' || !this.#history?.canUndo;
    this.#soften.hidden = standing !== 'stuck' || this.#candidates.length === 0;
    this.#grow.hidden = !isAsked || (standing === 'stuck' && this.#worst === undefined);
    this.#widen.hidden = standing !== 'stuck' || this.#document?.locality === undefined;
    this.#stop.hidden = standing !== 'growing';
    this.#lengthsBack.hidden = standing !== 'grown';
    if (standing !== 'good' && standing !== 'growing') setText(this.#words, this.#reason(standing));
    const isShown = standing !== 'good';
    if (isShown !== this.element.hasChildNodes()) this.element.replaceChildren(...(isShown ? [this.#line] : []));
  }

  get #standing(): Standing {
    if (this.#isGrowing) return 'growing';
    if (this.#frame === null) return 'good';
    if (hasLostLengths(this.#frame) || this.#bad.sharp.size > 0) return 'stuck';
    if (this.#frame.fellShort) return 'short';
    return this.#scale === 1 ? 'good' : 'grown';
  }

  get #scale(): number {
    return Number(this.#document?.options[SCALE] ?? 1);
  }

  get #worst(): FrameData['unreachable'][number] | undefined {
    return this.#frame?.unreachable[0];
  }

  get #present(): number {
    return this.#history?.present ?? 0;
  }

  /** The handles that could give way: those out of reach, or else those selected. */
  get #candidates(): number[] {
    const wanted = this.#worst ? [this.#worst.vertexA, this.#worst.vertexB] : (this.#choice?.selection ?? []);
    const exact = unlocked(wanted, this.#handles).filter(({ weight }) => weight === undefined);
    return exact.map(({ vertex }) => vertex);
  }

  async #growEdges(): Promise<void> {
    const { growing, noLength } = panelWords.stuck;
    this.#isGrowing = true;
    const tell = (scale: number): void => setText(this.#words, growing(percentOf(scale)));
    tell(this.#scale);
    this.#show();
    // It is cancelled, without a message, if the net is edited meanwhile.
    const scale = await this.#events.adaptLengths(tell).catch(() => undefined);
    this.#isGrowing = false;
    this.#show();
    if (scale === null) setText(this.#words, noLength);
  }

  #takeLengthsBack(): void {
    if (this.#document === null) return;
    const { method, initialisation, options } = this.#document;
    this.#events.setBehaviour({ method, initialisation, options: { ...options, [SCALE]: 1 } });
  }

  #reason(standing: Standing): string {
    const { fellShort, grown, shrunk, noShape, tooSharp, unreachable, tooLocal } = panelWords.stuck;
    if (standing === 'short') return fellShort;
    if (standing === 'grown') return (this.#scale > 1 ? grown : shrunk)(percentOf(this.#scale));
    if (this.#worst === undefined) return hasLostLengths(this.#frame!) ? noShape : tooSharp;
    const { vertexA, vertexB, distance, reach } = this.#worst;
    const isHandle = this.#handles.some(({ vertex }) => vertex === vertexB);
    return isHandle ? unreachable(vertexA, vertexB, distance.toPrecision(3), reach.toPrecision(3)) : tooLocal;
  }
}

/** A solve has ended without them. */
function hasLostLengths({ status, maxDeviation }: FrameData): boolean {
  return status !== 'running' && !(maxDeviation <= KEPT_DEVIATION);
}

/** By how much lengths differ from those of before. */
function percentOf(scale: number): string {
  return (100 * Math.abs(scale - 1)).toFixed(1);
}

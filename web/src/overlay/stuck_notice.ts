/** Where the net does not do what was asked of it: a solve ended without a shape in which all edges have their length, or a
 *  hand was held back. Why, and the ways out; it stays for as long as that is so. Also what came of one of these ways: edges
 *  that have grown, for as long as they are so. */
import type { ChebnetDocument, HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import { make, makeButton, setText } from '../elements/dom';
import type { Choice } from '../handles/commands';
import { unlocked } from '../handles/selection';
import { panelWords } from '../language/panels';
import { KEPT_DEVIATION } from '../net/edge_lengths';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import './messages.css';

/** The least weight that can be chosen: the net finds its shape, and the weight can be raised from there. */
const SOFT = 0.01;
const SCALE = 'length_scale';

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

  setNet(_net: OpenedNet): void {
    this.#frame = null;
    this.#show();
  }

  setFrame(frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) return;
    this.#frame = frame;
    if (frame.maxDeviation <= KEPT_DEVIATION) this.#good = this.#present;
    this.#show();
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
    const { status, maxDeviation, fellShort } = this.#frame;
    if (status !== 'running' && !(maxDeviation <= KEPT_DEVIATION)) return 'stuck';
    if (fellShort) return 'short';
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
    const { fellShort, grown, shrunk, noShape, unreachable, tooLocal } = panelWords.stuck;
    if (standing === 'short') return fellShort;
    if (standing === 'grown') return (this.#scale > 1 ? grown : shrunk)(percentOf(this.#scale));
    if (this.#worst === undefined) return noShape;
    const { vertexA, vertexB, distance, reach } = this.#worst;
    const isHandle = this.#handles.some(({ vertex }) => vertex === vertexB);
    return isHandle ? unreachable(vertexA, vertexB, distance.toPrecision(3), reach.toPrecision(3)) : tooLocal;
  }
}

/** By how much lengths differ from those of before. */
function percentOf(scale: number): string {
  return (100 * Math.abs(scale - 1)).toFixed(1);
}

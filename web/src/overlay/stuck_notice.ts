/** Where a solve ended without a shape in which all edges have their length: why, and the ways out. It stays for as long as
 *  that is so. */
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

export class StuckNotice implements Panel {
  // In the page from the start: screen readers announce changes of what is there.
  readonly element = make('div', { class: 'stuck-notice', role: 'status' });
  readonly #words = make('span');
  readonly #back: HTMLButtonElement;
  readonly #soften: HTMLButtonElement;
  readonly #widen: HTMLButtonElement;
  readonly #line: HTMLElement;
  #handles: readonly HandleData[] = [];
  #choice: Choice | null = null;
  #worst: FrameData['unreachable'][number] | undefined;
  #history: HistoryView | null = null;
  /** The place in the history of the last shape that was right. */
  #good = 0;

  constructor(events: PanelEvents) {
    const { back, soften, widen } = panelWords.stuck;
    this.#back = makeButton(back, () => events.goTo(Math.min(this.#good, this.#present - 1)));
    this.#soften = makeButton(soften, () => events.handles.change(this.#candidates, { weight: SOFT }));
    this.#widen = makeButton(widen, () => {
      events.handles.setLocality(undefined);
      events.solve();
    });
    const ways = make('div', { class: 'buttons' }, this.#back, this.#soften, this.#widen);
    this.#line = make('div', { class: 'message' }, make('div', {}, this.#words, ways));
  }

  setDocument({ locality }: ChebnetDocument): void {
    this.#widen.hidden = locality === undefined;
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    this.#handles = handles;
    this.#choice = choice;
    this.#soften.hidden = this.#candidates.length === 0;
  }

  setHistory(history: HistoryView): void {
    this.#history = history;
    this.#back.hidden = !history.canUndo;
  }

  setNet(_net: OpenedNet): void {
    this.element.replaceChildren();
  }

  setFrame({ status, unreachable, maxDeviation }: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (solving) return;
    const isStuck = status !== 'running' && !(maxDeviation <= KEPT_DEVIATION);
    if (maxDeviation <= KEPT_DEVIATION) this.#good = this.#present;
    this.#worst = unreachable[0];
    this.#soften.hidden = this.#candidates.length === 0;
    if (isStuck) setText(this.#words, this.#reason());
    if (isStuck !== this.element.hasChildNodes()) this.element.replaceChildren(...(isStuck ? [this.#line] : []));
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

  #reason(): string {
    if (this.#worst === undefined) return panelWords.stuck.noShape;
    const { vertexA, vertexB, distance, reach } = this.#worst;
    const isHandle = this.#handles.some(({ vertex }) => vertex === vertexB);
    return isHandle
      ? panelWords.stuck.unreachable(vertexA, vertexB, distance.toPrecision(3), reach.toPrecision(3))
      : panelWords.stuck.tooLocal;
  }
}

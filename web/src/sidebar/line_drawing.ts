/** A line that the user draws on the net, and what it does to the net. */
import { type DrawnLine, extended, waysAlong } from '../change/drawn_line';
import { edgesAlong } from '../change/place';
import { sidesOf } from '../change/sides';
import { make, makeButton, setText } from '../elements/dom';
import { panelWords } from '../language/panels';
import { words } from '../language/language';
import type { PanelEvents } from '../panels';
import type { Pen } from '../view/view';
import type { FrameData, OpenedNet } from '../worker/protocol';

const TEXT = panelWords.change.drawing;

export class LineDrawing {
  readonly element: HTMLElement;
  /** Along edges of the net, each by its vertices; none: there is no line. */
  ways: readonly number[][] = [];
  readonly #draw = makeButton(TEXT.draw, () => this.#turn(), { title: TEXT.hint, 'aria-pressed': 'false' });
  readonly #remove = makeButton(TEXT.remove, () => this.#clear(), { title: TEXT.removeHint, hidden: true });
  // In the page from the start: screen readers announce changes of what is there.
  readonly #words = make('p', { class: 'quiet', role: 'status' });
  readonly #events: Pick<PanelEvents, 'takePen'>;
  readonly #changed: () => void;
  readonly #failed: (error: unknown) => void;
  #pen: Pen | null = null;
  #line: DrawnLine = [];
  /** Faces, on each side of it. */
  #sides: readonly (readonly number[])[] = [];
  #net: OpenedNet | null = null;
  #frame: FrameData | null = null;

  /** @param changed the line is another, or there is none any more. */
  constructor(events: Pick<PanelEvents, 'takePen'>, changed: () => void, failed: (error: unknown) => void) {
    this.#events = events;
    this.#changed = changed;
    this.#failed = failed;
    this.element = make('div', {}, make('div', { class: 'buttons' }, this.#draw, this.#remove), this.#words);
  }

  /** Whether it parts the net. */
  get parts(): boolean {
    return this.#sides.length > 1;
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#frame = null;
    this.putAway();
    if (this.ways.length > 0) this.#clear();
  }

  setFrame(frame: FrameData): void {
    this.#frame = frame;
  }

  putAway(): void {
    this.#pen?.putAway();
  }

  #turn(): void {
    if (this.#pen !== null) return this.putAway();
    this.#events
      .takePen({ label: TEXT.keys, drawn: (stroke) => this.#add(stroke), putAway: () => this.#setPen(null) })
      .then((pen) => this.#take(pen))
      .catch(this.#failed);
  }

  /** Another may have come while this one was loaded. */
  #take(pen: Pen): void {
    this.putAway();
    this.#setPen(pen);
    pen.focus();
  }

  #setPen(pen: Pen | null): void {
    this.#pen = pen;
    this.#draw.setAttribute('aria-pressed', String(pen !== null));
    // What has the focus is gone with the pen.
    if (pen === null && document.activeElement === document.body) this.#draw.focus();
    if (this.ways.length === 0) this.#say(pen === null ? '' : TEXT.howTo);
  }

  /** A stroke that comes to nothing leaves the line as it is. */
  #add(stroke: DrawnLine): void {
    const [net, frame] = [this.#net, this.#frame];
    if (net === null || frame === null) return;
    const edgeLength = net.info.meanLength * frame.lengthScale;
    const line = extended(this.#line, stroke, edgeLength);
    const ways = waysAlong(net, frame.positions, line, edgeLength);
    if (ways.length === 0) return this.#say(stroke.length === 0 ? TEXT.missed : TEXT.short);
    this.#set(line, ways);
    this.#say(effectOf(net, this.#sides));
  }

  #clear(): void {
    this.#set([], []);
    this.#say(this.#pen === null ? '' : TEXT.howTo);
  }

  #set(line: DrawnLine, ways: readonly number[][]): void {
    this.#line = line;
    this.ways = ways;
    this.#sides = this.#net && ways.length > 0 ? sidesOf(this.#net, edgesAlong(this.#net, ...ways)) : [];
    this.#remove.hidden = ways.length === 0;
    this.#changed();
  }

  #say(text: string): void {
    setText(this.#words, text);
  }
}

/** What a line with these sides does to the net. */
function effectOf(net: OpenedNet, [, ...others]: readonly (readonly number[])[]): string {
  if (others.length === 0) return TEXT.open;
  const [smaller, all] = [others.flat().length, net.info.faces];
  return TEXT.parts(smaller.toLocaleString(words.locale), all.toLocaleString(words.locale));
}

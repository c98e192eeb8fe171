/** Curves that net lines over a whole surface are to follow, drawn point by point. What is changed holds for the next net. */
import type { Point, RemeshOptions } from '../../../wasm/chebnet';
import type { Cut, Ray, RemeshedNet } from '../drape/drape_protocol';
import { DrawnLine } from '../drape/drawn_line';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import { dialogWords } from '../language/dialogs';
import { small } from '../language/numbers';
import { sayInSight } from './say_in_sight';

const TEXT = dialogWords.drape.markedCreases;
/** Points of a closed curve. */
const LEAST_CLOSED = 3;

interface CreaseEvents {
  /** Whether points are being set in the picture. */
  drawingChanged(drawing: boolean): void;
  /** What is to be drawn: all creases, and the points of the one that is not ended. */
  shown(creases: readonly Cut[], points: readonly Point[]): void;
  /** How a crease through some points runs. */
  traceWanted(points: (Point | Ray)[], revision: number): void;
}

export class DrapeCreases {
  readonly #events: CreaseEvents;
  readonly #draw = makeButton(TEXT.draw, () => this.setDrawing(!this.#isDrawing), { 'aria-pressed': 'false' });
  readonly #end = makeButton(TEXT.end, () => this.end(), { hidden: true });
  readonly #close = makeButton(TEXT.close, () => this.#line.close(), { hidden: true });
  readonly #undo = makeButton(TEXT.undo, () => this.undo(), { hidden: true });
  readonly #clear = makeButton(TEXT.clear, () => this.#put([]), { hidden: true });
  // In the page from the start: screen readers announce changes of what is there.
  readonly #words = make('p', { class: 'quiet', role: 'status' });
  readonly element = make(
    'div',
    { class: 'cuts wishes', role: 'group', 'aria-label': TEXT.title, hidden: true },
    make('h3', {}, TEXT.title),
    this.#draw,
    this.#end,
    this.#close,
    this.#undo,
    this.#clear,
    this.#words,
  );
  /** The crease that is being drawn. */
  readonly #line: DrawnLine;
  #creases: readonly Cut[] = [];
  #isDrawing = false;

  constructor(events: CreaseEvents) {
    this.#events = events;
    this.#line = new DrawnLine({
      traceWanted: (points, revision) => events.traceWanted(points, revision),
      changed: () => this.#show(),
      ended: (crease) => this.#put([...this.#creases, crease]),
    });
  }

  get isDrawing(): boolean {
    return this.#isDrawing;
  }

  /** For the next net: the creases that have been ended. */
  read(): Required<Pick<RemeshOptions, 'markedCreases'>> {
    return { markedCreases: this.#creases.map(({ points }) => points) };
  }

  show(shown: boolean): void {
    this.element.hidden = !shown;
    if (!shown) this.setDrawing(false);
    this.#show();
  }

  /** A net is being made: what it is to follow stays. */
  setBusy(busy: boolean): void {
    if (busy) this.setDrawing(false);
    this.element.toggleAttribute('inert', busy);
  }

  setNet({ kept }: RemeshedNet): void {
    const distances = kept.markedCreases.filter(({ followed }) => !followed).map(({ distance }) => distance);
    if (kept.markedCreases.length > 0) this.#say(TEXT.kept(distances.length, small(Math.max(...distances))));
  }

  add(point: Point | Ray): void {
    this.#line.add(point);
  }

  /** The last point is wanted elsewhere. */
  move(to: Ray): void {
    this.#line.moveLast(to);
  }

  setTraced(crease: Cut, revision: number): void {
    this.#line.setTraced(crease, revision);
  }

  end(): void {
    this.#line.end();
  }

  /** Ends the drawing without the crease whose points are being set; false: nothing is drawn. */
  abandon(): boolean {
    if (!this.#isDrawing) return false;
    this.#line.clear();
    this.setDrawing(false);
    this.#show();
    return true;
  }

  /** Takes back the last point, or the last crease. */
  undo(): void {
    if (!this.#line.takeBack() && this.#creases.length > 0) this.#put(this.#creases.slice(0, -1));
  }

  /** The core has refused something. */
  giveUp(): void {
    this.#line.giveUp();
  }

  /** Of another surface. */
  reset(): void {
    this.#line.clear();
    this.setDrawing(false);
    this.#put([]);
  }

  setDrawing(drawing: boolean): void {
    if (this.#isDrawing === drawing) return;
    if (!drawing) this.end();
    this.#isDrawing = drawing;
    this.#draw.setAttribute('aria-pressed', String(drawing));
    this.#events.drawingChanged(drawing);
    if (drawing) sayInSight(this.#words, TEXT.howTo);
    else this.#say(this.#creases.length > 0 ? TEXT.next : '');
  }

  #put(creases: readonly Cut[]): void {
    this.#creases = creases;
    this.#line.clear();
    if (!this.#isDrawing) this.#say(creases.length > 0 ? TEXT.next : '');
    this.#show();
  }

  #show(): void {
    const open = this.#line.known;
    const points = open?.points ?? [];
    setHidden(this.#end, points.length < 2, this.#draw);
    setHidden(this.#close, points.length < LEAST_CLOSED, this.#draw);
    setHidden(this.#undo, open === null && this.#creases.length === 0, this.#draw);
    setHidden(this.#clear, this.#creases.length === 0, this.#draw);
    if (this.element.hidden) this.#events.shown([], []);
    else this.#events.shown([...this.#creases, ...(open === null ? [] : [open])], points);
  }

  #say(sentence: string): void {
    setText(this.#words, sentence);
  }
}

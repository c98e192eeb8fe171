/** How the net lines through the seed run, and the curve that the first family's may follow, drawn point by point. */
import type { DrapeArms as Arms, DrapeOptions, Point } from '../../../wasm/chebnet';
import type { Cut, Ray } from '../drape/drape_protocol';
import { DrawnLine } from '../drape/drawn_line';
import { make, makeButton, makeSelect, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import { dialogWords } from '../language/dialogs';
import { sayInSight } from './say_in_sight';

const TEXT = dialogWords.drape.arms;
/** The usual one first. */
const ARMS = ['geodesic', 'least_shear', 'curve'] as const;

interface ArmsEvents {
  /** Whether points are being set in the picture. */
  drawingChanged(drawing: boolean): void;
  /** What is to be drawn: the curve as far as it is known, and its points until it is ended. */
  shown(curve: Cut | null, points: readonly Point[]): void;
  /** How a curve through some points runs. */
  traceWanted(points: (Point | Ray)[], revision: number): void;
  /** They are to run otherwise. */
  changed(): void;
}

export class DrapeArms {
  readonly #events: ArmsEvents;
  readonly #arms = makeSelect(
    TEXT.title,
    ARMS.map((value) => ({ value, text: TEXT.ways[value] })),
    () => this.#choose(),
  );
  readonly #draw = makeButton(TEXT.draw, () => this.#drawAnew(), { hidden: true, 'aria-pressed': 'false' });
  readonly #end = makeButton(TEXT.end, () => this.end(), { hidden: true });
  readonly #undo = makeButton(TEXT.undo, () => this.undo(), { hidden: true });
  // In the page from the start: screen readers announce changes of what is there.
  readonly #words = make('p', { class: 'quiet', role: 'status' });
  readonly element = make(
    'div',
    { class: 'arms' },
    this.#arms.row,
    make('div', { class: 'cuts', role: 'group', 'aria-label': TEXT.curve }, this.#draw, this.#end, this.#undo),
    this.#words,
  );
  readonly #line: DrawnLine;
  #curve: Cut | null = null;
  #isDrawing = false;
  /** Those of the net that is shown. */
  #shown: Arms = 'geodesic';

  constructor(events: ArmsEvents) {
    this.#events = events;
    this.#line = new DrawnLine({
      traceWanted: (points, revision) => events.traceWanted(points, revision),
      changed: () => this.#show(),
      ended: (curve) => this.#setCurve(curve),
    });
  }

  get isDrawing(): boolean {
    return this.#isDrawing;
  }

  /** Without a curve along which they could run they are geodesic. */
  read(): Pick<DrapeOptions, 'arms' | 'along'> {
    if (this.#wanted !== 'curve') return { arms: this.#wanted };
    return this.#curve === null ? { arms: 'geodesic' } : { arms: 'curve', along: this.#curve.points };
  }

  add(point: Point | Ray): void {
    this.#line.add(point);
  }

  setTraced(curve: Cut, revision: number): void {
    this.#line.setTraced(curve, revision);
  }

  end(): void {
    this.#line.end();
  }

  /** Takes back the last point. */
  undo(): void {
    this.#line.takeBack();
  }

  /** What is not ended is no curve. */
  stopDrawing(): void {
    if (!this.#isDrawing) return;
    this.#line.clear();
    this.#setDrawing(false);
  }

  /** Ends the drawing without the curve; false: nothing is drawn. */
  abandon(): boolean {
    const wasDrawing = this.#isDrawing;
    this.stopDrawing();
    return wasDrawing;
  }

  /** Of the net that is shown. */
  setShown(arms: Arms): void {
    this.#shown = arms;
    this.#show();
  }

  /** The core has refused something. */
  giveUp(): void {
    this.#line.giveUp();
  }

  /** Of another surface. */
  reset(): void {
    this.stopDrawing();
    this.#curve = null;
    if (this.#wanted === 'curve') this.#arms.select.value = ARMS[0];
    this.setShown('geodesic');
  }

  get #wanted(): Arms {
    return this.#arms.select.value as Arms;
  }

  #choose(): void {
    if (this.#wanted !== 'curve') this.stopDrawing();
    else if (this.#curve === null) this.#setDrawing(true);
    this.#events.changed();
    this.#show();
  }

  #drawAnew(): void {
    if (this.#isDrawing) return this.stopDrawing();
    this.#curve = null;
    this.#setDrawing(true);
    this.#events.changed();
  }

  #setCurve(curve: Cut): void {
    this.#curve = curve;
    this.#setDrawing(false);
    this.#events.changed();
  }

  #setDrawing(drawing: boolean): void {
    this.#isDrawing = drawing;
    this.#draw.setAttribute('aria-pressed', String(drawing));
    this.#events.drawingChanged(drawing);
    this.#show();
    if (drawing) sayInSight(this.#words, this.#hint());
  }

  #show(): void {
    const { known } = this.#line;
    this.#draw.hidden = this.#wanted !== 'curve';
    setHidden(this.#end, known === null || known.points.length < 2, this.#draw);
    setHidden(this.#undo, known === null, this.#draw);
    setText(this.#words, this.#hint());
    const curve = this.#wanted === 'curve' ? this.#curve : null;
    this.#events.shown(known ?? curve, known?.points ?? []);
  }

  #hint(): string {
    if (this.#isDrawing) return TEXT.howTo;
    if (this.#wanted === 'curve') return this.#curve === null ? TEXT.noCurve : TEXT.along;
    return this.#wanted === 'least_shear' && this.#shown === 'geodesic' ? TEXT.noBetter : '';
  }
}

/** Cuts along which the surface is opened before nets are laid on its pieces: drawn point by point, or proposed. */
import type { Point } from '../../../wasm/chebnet';
import type { Cut, Ray } from '../drape/drape_protocol';
import { DrawnLine } from '../drape/drawn_line';
import { make, makeButton, setText } from '../elements/dom';
import { setDisabled, setHidden } from '../elements/leave';
import { dialogWords } from '../language/dialogs';
import { percentWords } from './file_words';
import { sayInSight } from './say_in_sight';

const TEXT = dialogWords.drape.cuts;

export interface CutEvents {
  /** Whether points are being set in the picture. */
  cuttingChanged(cutting: boolean): void;
  /** What is to be drawn: all cuts, and the points of the one that is not ended. */
  shown(cuts: readonly Cut[], points: readonly Point[]): void;
  /** How a cut through some points runs. */
  traceWanted(points: (Point | Ray)[], revision: number): void;
  /** The shortest cut to the border, or with null between two borders, beside other cuts. */
  shortestWanted(from: Point | null, cuts: Point[][], revision: number): void;
  /** Where a net begins. */
  seed(): Point;
  /** Other cuts are to be made. */
  changed(): void;
  proposalsWanted(): void;
}

export class DrapeCuts {
  readonly #events: CutEvents;
  readonly #draw = makeButton(TEXT.draw, () => this.setCutting(!this.#isCutting), { 'aria-pressed': 'false' });
  readonly #end = makeButton(TEXT.end, () => this.end(), { hidden: true });
  readonly #toBorder = makeButton(TEXT.toBorder, () => this.#wantShortest(this.#lastPoint ?? this.#events.seed()));
  readonly #between = makeButton(TEXT.between, () => this.#wantShortest(null));
  readonly #undo = makeButton(TEXT.undo, () => this.undo(), { hidden: true });
  readonly #clear = makeButton(TEXT.clear, () => this.#change([]), { hidden: true });
  readonly #propose = makeButton(TEXT.propose, () => this.#wantProposals());
  // In the page from the start: screen readers announce changes of what is there.
  readonly #words = make('p', { class: 'quiet', role: 'status' });
  readonly element = make(
    'div',
    { class: 'cuts', role: 'group', 'aria-label': TEXT.title },
    this.#draw,
    this.#end,
    this.#toBorder,
    this.#between,
    this.#undo,
    this.#clear,
    this.#propose,
    this.#words,
  );
  /** The cut that is being drawn. */
  readonly #line: DrawnLine;
  #cuts: readonly Cut[] = [];
  #isCutting = false;
  /** To which helpful ones are looked for; null: they are not, or not any more. */
  #proposed: readonly Cut[] | null = null;
  /** Of the surface, uncut. */
  #borders = 0;

  constructor(events: CutEvents) {
    this.#events = events;
    this.#line = new DrawnLine({
      traceWanted: (points, revision) => events.traceWanted(points, revision),
      changed: () => this.#show(),
      ended: (cut) => this.#change([...this.#cuts, cut]),
    });
  }

  /** For the nets: the cuts that have been ended. */
  read(): Point[][] {
    return this.#cuts.map(({ points }) => points);
  }

  add(point: Point | Ray): void {
    this.#line.add(point);
  }

  setTraced(cut: Cut, revision: number): void {
    this.#line.setTraced(cut, revision);
  }

  /** Ends the cut that is being drawn, if that is where it begins.
   *  @param revision likewise. */
  setFound(cut: Cut, revision: number): void {
    if (revision !== this.#line.revision) return;
    const open = this.#line.known;
    this.#change([...this.#cuts, open === null ? cut : joined(open, cut)]);
  }

  setProposed(cuts: readonly Cut[], coverage: readonly number[]): void {
    const isWanted = this.#proposed === this.#cuts;
    this.#endProposing();
    if (!isWanted) return setText(this.#words, this.#isCutting ? TEXT.howTo : '');
    const [before, after] = [coverage[0]!, coverage.at(-1)!];
    if (cuts.length > 0) this.#change(cuts);
    setText(this.#words, cuts.length > 0 ? TEXT.helped(percentWords(before), percentWords(after)) : TEXT.noneHelps);
  }

  /** The core has refused something. */
  giveUp(): void {
    this.#endProposing();
    this.#line.giveUp();
    setText(this.#words, this.#isCutting ? TEXT.howTo : '');
  }

  /** Of another surface, which has so many borders. */
  reset(borders: number): void {
    this.#borders = borders;
    this.#cuts = [];
    this.#line.clear();
    this.giveUp();
    this.setCutting(false);
  }

  /** A net over the whole surface is wanted, which no cut is for. */
  rest(): void {
    this.#proposed = null;
    this.setCutting(false);
  }

  end(): void {
    this.#line.end();
  }

  /** Ends the drawing without the cut whose points are being set; false: nothing is drawn. */
  abandon(): boolean {
    if (!this.#isCutting) return false;
    this.#line.clear();
    this.setCutting(false);
    return true;
  }

  /** Takes back the last point, or the last cut. */
  undo(): void {
    if (!this.#line.takeBack() && this.#cuts.length > 0) this.#change(this.#cuts.slice(0, -1));
  }

  setCutting(cutting: boolean): void {
    if (!cutting) this.end();
    this.#isCutting = cutting;
    this.#draw.setAttribute('aria-pressed', String(cutting));
    this.#events.cuttingChanged(cutting);
    this.#show();
    sayInSight(this.#words, cutting ? TEXT.howTo : '');
  }

  get #lastPoint(): Point | undefined {
    return this.#line.known?.points.at(-1);
  }

  #change(cuts: readonly Cut[]): void {
    this.#cuts = cuts;
    this.#line.clear();
    this.#show();
    this.#events.changed();
  }

  #wantShortest(from: Point | null): void {
    this.#events.shortestWanted(from, this.read(), this.#line.revision);
  }

  #wantProposals(): void {
    setDisabled(this.#propose, true, this.#draw);
    this.#proposed = this.#cuts;
    sayInSight(this.#words, TEXT.proposing);
    this.#events.proposalsWanted();
  }

  #endProposing(): void {
    this.#propose.disabled = false;
    this.#proposed = null;
  }

  #show(): void {
    const open = this.#line.known;
    setHidden(this.#end, open === null, this.#draw);
    setHidden(this.#toBorder, this.#borders + this.#cuts.length === 0, this.#draw);
    setHidden(this.#between, this.#borders < 2 || open !== null, this.#draw);
    setHidden(this.#undo, open === null && this.#cuts.length === 0, this.#draw);
    setHidden(this.#clear, this.#cuts.length === 0, this.#draw);
    this.#events.shown([...this.#cuts, ...(open === null ? [] : [open])], open?.points ?? []);
  }
}

/** A cut that goes on along another one. */
function joined(cut: Cut, next: Cut): Cut {
  return { points: [...cut.points, ...next.points.slice(1)], path: Float64Array.of(...cut.path, ...next.path) };
}

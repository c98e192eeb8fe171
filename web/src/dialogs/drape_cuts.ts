/** Cuts along which the surface is opened before nets are laid on its pieces: drawn point by point, or proposed. */
import type { Point } from '../../../wasm/chebnet';
import type { Cut, Ray } from '../drape/drape_protocol';
import { make, makeButton, setText } from '../elements/dom';
import { dialogWords } from '../language/dialogs';
import { percentWords } from './file_words';

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
  readonly #draw = makeButton(TEXT.draw, () => this.#setCutting(!this.#isCutting), { 'aria-pressed': 'false' });
  readonly #end = makeButton(TEXT.end, () => this.end(), { hidden: true });
  readonly #toBorder = makeButton(TEXT.toBorder, () => this.#wantShortest(this.#last ?? this.#events.seed()));
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
  #cuts: readonly Cut[] = [];
  /** Points of the cut that is being drawn; those not yet found on the surface are rays. */
  #points: (Point | Ray)[] = [];
  /** Counts how often they have become others. */
  #revision = 0;
  /** That cut, as far as it is known. */
  #open: Cut | null = null;
  #isCutting = false;
  /** Of the surface, uncut. */
  #borders = 0;
  /** The cut ends once all of its points are known. */
  #isEnding = false;

  constructor(events: CutEvents) {
    this.#events = events;
  }

  /** For the nets: the cuts that have been ended. */
  read(): Point[][] {
    return this.#cuts.map(({ points }) => points);
  }

  add(point: Point | Ray): void {
    this.#setPoints([...this.#points, point]);
  }

  /** @param revision of the points through which it runs; others may have come, or been given up. */
  setTraced(cut: Cut, revision: number): void {
    if (revision !== this.#revision) return;
    this.#points = cut.points;
    this.#open = cut.points.length > 0 ? cut : null;
    if (this.#isEnding) this.end();
    else this.#show();
  }

  /** Ends the cut that is being drawn, if that is where it begins.
   *  @param revision likewise. */
  setFound(cut: Cut, revision: number): void {
    if (revision !== this.#revision) return;
    this.#change([...this.#cuts, this.#open === null ? cut : joined(this.#open, cut)]);
  }

  setProposed(cuts: readonly Cut[], coverage: readonly number[]): void {
    this.#propose.disabled = false;
    const [before, after] = [coverage[0]!, coverage.at(-1)!];
    if (cuts.length > 0) this.#change(cuts);
    setText(this.#words, cuts.length > 0 ? TEXT.helped(percentWords(before), percentWords(after)) : TEXT.noneHelps);
  }

  /** The core has refused something. */
  giveUp(): void {
    this.#propose.disabled = false;
    this.#isEnding = false;
    this.#points = this.#open?.points ?? [];
    setText(this.#words, this.#isCutting ? TEXT.howTo : '');
  }

  /** Of another surface, which has so many borders. */
  reset(borders: number): void {
    this.#borders = borders;
    this.#cuts = [];
    this.#open = null;
    this.giveUp();
    this.#setCutting(false);
  }

  /** Of a cut with one point nothing is left. */
  end(): void {
    this.#isEnding = !this.#isKnown;
    if (this.#isEnding || this.#open === null) return;
    this.#change(this.#open.points.length < 2 ? this.#cuts : [...this.#cuts, this.#open]);
  }

  /** Takes back the last point, or the last cut. */
  undo(): void {
    if (this.#points.length > 0) this.#setPoints(this.#points.slice(0, -1));
    else if (this.#cuts.length > 0) this.#change(this.#cuts.slice(0, -1));
  }

  /** Point of the cut that is being drawn. */
  get #last(): Point | undefined {
    return this.#open?.points.at(-1);
  }

  get #isKnown(): boolean {
    return (
      this.#points.every((point) => !('origin' in point)) && this.#points.length === (this.#open?.points.length ?? 0)
    );
  }

  #setPoints(points: (Point | Ray)[]): void {
    this.#points = points;
    this.#revision++;
    this.#events.traceWanted(points, this.#revision);
  }

  #change(cuts: readonly Cut[]): void {
    this.#cuts = cuts;
    this.#points = [];
    this.#revision++;
    this.#open = null;
    this.#isEnding = false;
    this.#show();
    this.#events.changed();
  }

  #wantShortest(from: Point | null): void {
    this.#events.shortestWanted(from, this.read(), this.#revision);
  }

  #wantProposals(): void {
    this.#propose.disabled = true;
    setText(this.#words, TEXT.proposing);
    this.#events.proposalsWanted();
  }

  #setCutting(cutting: boolean): void {
    if (!cutting) this.end();
    this.#isCutting = cutting;
    this.#draw.setAttribute('aria-pressed', String(cutting));
    setText(this.#words, cutting ? TEXT.howTo : '');
    this.#events.cuttingChanged(cutting);
    this.#show();
  }

  #show(): void {
    this.#end.hidden = this.#open === null;
    this.#toBorder.hidden = this.#borders + this.#cuts.length === 0;
    this.#between.hidden = this.#borders < 2 || this.#open !== null;
    this.#undo.hidden = this.#open === null && this.#cuts.length === 0;
    this.#clear.hidden = this.#cuts.length === 0;
    this.#events.shown([...this.#cuts, ...(this.#open === null ? [] : [this.#open])], this.#open?.points ?? []);
  }
}

/** A cut that goes on along another one. */
function joined(cut: Cut, next: Cut): Cut {
  return { points: [...cut.points, ...next.points.slice(1)], path: Float64Array.of(...cut.path, ...next.path) };
}

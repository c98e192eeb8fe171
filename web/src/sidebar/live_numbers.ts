/** The table of current numbers of net and solver. */
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { make, setText } from '../elements/dom';
import { count, duration, lengthError, NOTHING, ROUNDING, small } from '../language/numbers';

const LABELS = panelWords.numbers;

type Cells = Record<keyof typeof LABELS, HTMLElement>;

export class LiveNumbers {
  readonly element = make('dl', { class: 'numbers' });
  readonly #cells: Cells;

  constructor() {
    const cell = (label: string) => {
      const value = make('dd', {}, NOTHING);
      this.element.append(make('div', {}, make('dt', {}, label), value));
      return value;
    };
    this.#cells = Object.fromEntries(Object.entries(LABELS).map(([key, label]) => [key, cell(label)])) as Cells;
  }

  setNet({ info }: OpenedNet): void {
    setText(this.#cells.vertices, count(info.vertices));
    setText(this.#cells.edges, count(info.edges));
  }

  setHandles(handles: number): void {
    setText(this.#cells.handles, count(handles));
  }

  /** @param stage what it is called.
   *  @param solving at rest no frames are counted. */
  setFrame(frame: FrameData, stage: string, framesPerSecond: number, solving: boolean): void {
    setText(
      this.#cells.largestError,
      frame.maxDeviation < ROUNDING ? words.legend.exact : lengthError(frame.maxDeviation),
    );
    setText(this.#cells.maxDeviation, small(frame.maxDeviation));
    const solved = frame.iterations > 0;
    setText(this.#cells.stage, solved ? stage : NOTHING);
    setText(this.#cells.iterations, solved ? count(frame.iterations) : NOTHING);
    setText(this.#cells.milliseconds, solved ? duration(frame.milliseconds) : NOTHING);
    this.#setToRest(frame);
    setText(this.#cells.framesPerSecond, solving && framesPerSecond > 0 ? count(framesPerSecond) : NOTHING);
  }

  #setToRest({ toRest }: FrameData): void {
    const edges = (length: number) => (Number.isFinite(length) ? `${small(length)} L` : NOTHING);
    setText(this.#cells.forceLeft, toRest ? small(toRest.gradientNorm) : NOTHING);
    setText(this.#cells.motionLeft, toRest ? edges(toRest.motion) : NOTHING);
    setText(this.#cells.cornerLack, toRest ? edges(toRest.cornerLack) : NOTHING);
  }
}

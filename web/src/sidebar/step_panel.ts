/** One iteration at a time: what it did, and its direction as arrows in the picture. */
import type { TraceRow } from '../../../wasm/chebnet';
import { longestMove } from '../document/longest_move';
import { words } from '../language/language';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { make, makeButton, makeSwitch, setText } from '../elements/dom';
import type { PanelEvents } from '../panels';
import { count, NOTHING, small } from '../language/numbers';
import { stageWords } from './status';

const LABELS = words.step.numbers;

export class StepPanel {
  readonly content: HTMLElement[];
  private readonly stage = make('p', { class: 'quiet' });
  private readonly cells: Record<keyof typeof LABELS, HTMLElement>;
  private row: TraceRow | null = null;
  /** Of the last step, in edges; null if it was no single one. */
  private move: number | null = null;
  private edgeLength = 1;

  constructor(events: PanelEvents) {
    const { row } = makeSwitch(words.step.arrows, (on) => events.setStepArrows(on));
    row.title = words.step.arrowsHint;
    const numbers = make('dl', { class: 'numbers' });
    const cell = (label: string) => {
      const value = make('dd', {}, NOTHING);
      numbers.append(make('div', {}, make('dt', {}, label), value));
      return value;
    };
    this.cells = Object.fromEntries(
      Object.entries(LABELS).map(([key, label]) => [key, cell(label)]),
    ) as typeof this.cells;
    const step = makeButton(words.step.step, () => events.step(), { title: words.step.stepHint });
    this.content = [make('div', { class: 'buttons' }, step), row, this.stage, numbers];
  }

  showNet({ info }: OpenedNet): void {
    this.edgeLength = info.meanLength;
    this.row = null;
    this.move = null;
    this.refresh();
  }

  /** Takes what a frame tells; what a visitor who steps should be told of a new stage, if one began. */
  take({ trace, stepFrom, positions }: FrameData): string | null {
    const row = trace.at(-1);
    if (row === undefined) return null;
    const isNew = row.iteration === 1 || row.stage !== this.row?.stage;
    this.row = row;
    this.move = stepFrom && longestMove(stepFrom, positions) / this.edgeLength;
    return stepFrom && isNew ? stageWords(row) : null;
  }

  refresh(): void {
    const { row, move, cells } = this;
    setText(this.stage, row ? stageWords(row) : words.step.idle);
    setText(cells.iteration, row ? count(row.iteration) : NOTHING);
    setText(cells.energy, row ? small(row.energy) : NOTHING);
    setText(cells.step, row ? small(row.step) : NOTHING);
    setText(cells.move, move === null ? NOTHING : small(move));
  }
}

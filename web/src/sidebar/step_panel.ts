/** One iteration at a time: what it did, and its direction as arrows in the picture. */
import type { TraceRow } from '../../../wasm/chebnet';
import { longestMove } from '../document/longest_move';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { make, makeButton, makeSection, makeSwitch, setText } from '../elements/dom';
import type { Panel, PanelEvents } from '../panels';
import { count, NOTHING, small } from '../language/numbers';
import { StageNames } from './stage_names';

const LABELS = panelWords.step.numbers;

type Cells = Record<keyof typeof LABELS, HTMLElement>;

export class StepPanel implements Panel {
  readonly element: HTMLElement;
  readonly #stage = make('p', { class: 'quiet' });
  readonly #cells: Cells;
  #row: TraceRow | null = null;
  #method = '';
  /** Of the last step, in edges; null if it was no single one. */
  #move: number | null = null;
  #edgeLength = 1;
  readonly #say: (stage: string) => void;
  readonly #stages = new StageNames();

  /** @param say tells a visitor who steps that another stage began. */
  constructor(events: PanelEvents, say: (stage: string) => void) {
    this.#say = say;
    const { row } = makeSwitch(panelWords.step.arrows, (on) => events.setStepArrows(on));
    row.title = panelWords.step.arrowsHint;
    const numbers = make('dl', { class: 'numbers' });
    const cell = (label: string) => {
      const value = make('dd', {}, NOTHING);
      numbers.append(make('div', {}, make('dt', {}, label), value));
      return value;
    };
    this.#cells = Object.fromEntries(Object.entries(LABELS).map(([key, label]) => [key, cell(label)])) as Cells;
    const step = makeButton(panelWords.step.step, () => events.step(), { title: panelWords.step.stepHint });
    const buttons = make('div', { class: 'buttons' }, step);
    this.element = makeSection(words.sections.step, false, buttons, row, this.#stage, numbers);
  }

  setTables(tables: Tables): void {
    this.#stages.setTables(tables);
  }

  setNet({ info }: OpenedNet): void {
    this.#edgeLength = info.edgeLength;
    this.#row = null;
    this.#move = null;
    this.setFrame();
  }

  onFrame({ trace, stepFrom, positions, lengthScale, method }: FrameData): void {
    const row = trace.at(-1);
    if (row === undefined) return;
    const isNew = row.iteration === 1 || row.stage !== this.#row?.stage;
    this.#row = row;
    this.#method = method;
    this.#move = stepFrom && longestMove(stepFrom, positions) / (this.#edgeLength * lengthScale);
    if (stepFrom && isNew) this.#say(this.#words(row));
  }

  setFrame(): void {
    const [row, move, cells] = [this.#row, this.#move, this.#cells];
    setText(this.#stage, row ? this.#words(row) : panelWords.step.idle);
    setText(cells.iteration, row ? count(row.iteration) : NOTHING);
    setText(cells.energy, row ? small(row.energy) : NOTHING);
    setText(cells.step, row ? small(row.step) : NOTHING);
    setText(cells.move, move === null ? NOTHING : small(move));
  }

  /** Which stage an iteration belongs to and what is done there. */
  #words({ stage, p, freeVertices }: TraceRow): string {
    return panelWords.step.stage(this.#stages.of(this.#method, stage), p > 0 ? p : null, count(freeVertices));
  }
}

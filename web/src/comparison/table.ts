/** The numbers of a comparison, one line a run. A click on a line shows its net. */
import { canShow, isOf, type NetOrigin, type Run } from '../compare/run';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { CurveStyle } from './plot';
import { make, makeButton, setText } from '../elements/dom';
import { count, milliseconds, NOTHING, small } from '../language/numbers';

const DEGREES = 180 / Math.PI;

const { columns } = panelWords.comparison;
const COLUMNS: { title: string; hint: string; text(run: Run): string | undefined }[] = [
  { ...columns.iterations, text: ({ frame }) => (frame ? count(frame.iterations) : undefined) },
  { ...columns.milliseconds, text: ({ frame }) => (frame ? milliseconds(frame.milliseconds) : undefined) },
  { ...columns.maxDeviation, text: ({ frame }) => (frame ? small(frame.maxDeviation) : undefined) },
  { ...columns.bend, text: ({ measures }) => (measures ? small(measures.bend) : undefined) },
  {
    ...columns.smallestAngle,
    text: ({ measures }) => (measures ? `${(measures.smallestAngle * DEGREES).toFixed(1)}°` : undefined),
  },
  { ...columns.distance, text: ({ distance }) => (distance === null ? undefined : small(distance)) },
  { ...columns.handleError, text: ({ measures }) => (measures ? small(measures.handleError) : undefined) },
  { ...columns.status, text: runWords },
];

interface TableEvents {
  show(run: Run): void;
  /** Toggles. */
  showBeside(run: Run): void;
}

interface Row {
  run: Run;
  button: HTMLButtonElement;
  beside: HTMLButtonElement;
  cells: HTMLElement[];
}

export class ComparisonTable {
  readonly element = make('div', {
    class: 'table',
    tabindex: 0,
    role: 'region',
    'aria-label': panelWords.comparison.results,
  });
  #rows: Row[] = [];
  readonly #styleOf: (run: Run) => CurveStyle;
  readonly #events: TableEvents;

  constructor(styleOf: (run: Run) => CurveStyle, events: TableEvents) {
    this.#styleOf = styleOf;
    this.#events = events;
  }

  setRuns(runs: readonly Run[]): void {
    const heads = COLUMNS.map(({ title, hint }) => make('th', { scope: 'col', title: hint }, title));
    this.#rows = runs.map((run) => this.#makeRow(run));
    const body = make('tbody', {}, ...this.#rows.map((row) => this.#makeLine(row)));
    this.element.replaceChildren(
      make(
        'table',
        {},
        make(
          'thead',
          {},
          make('tr', {}, make('th', { scope: 'col' }, panelWords.comparison.run), ...heads, make('td')),
        ),
        body,
      ),
    );
  }

  /** @param current the run whose net is in the view. @param open the user's. */
  refresh(current: Run | null, beside: readonly Run[], open: NetOrigin | null): void {
    for (const row of this.#rows) {
      const { run, cells } = row;
      row.button.setAttribute('aria-pressed', String(run === current));
      row.beside.setAttribute('aria-pressed', String(beside.includes(run)));
      row.button.title = panelWords.comparison[isOf(run, open) ? 'show' : 'otherNet'];
      row.button.disabled = row.beside.disabled = !canShow(run, open);
      COLUMNS.forEach(({ text }, i) => setText(cells[i]!, text(run) ?? NOTHING));
    }
  }

  #makeRow(run: Run): Row {
    const { colour, line } = this.#styleOf(run);
    const swatch = make('i', { class: `swatch ${line}` });
    swatch.style.setProperty('color', `var(${colour})`);
    const button = makeButton(swatch, () => {}, { class: 'plain' });
    button.append(run.label);
    const beside = makeButton(panelWords.comparison.beside, () => this.#events.showBeside(run), {
      class: 'plain link',
      title: panelWords.comparison.besideHint,
      'aria-label': panelWords.comparison.besideOther(run.label),
    });
    return { run, button, beside, cells: COLUMNS.map(() => make('td')) };
  }

  #makeLine({ run, button, beside, cells }: Row): HTMLElement {
    const line = make('tr', {}, make('th', { scope: 'row' }, button), ...cells, make('td', {}, beside));
    line.addEventListener('click', ({ target }) => {
      if (!button.disabled && target !== beside) this.#events.show(run);
    });
    return line;
  }
}

/** The status of a run, short enough for a table. */
function runWords({ state, frame, fault }: Run): string {
  if (state === 'ended') return frame ? panelWords.comparison.status[frame.status] : '';
  return fault === null ? panelWords.comparison.state[state] : words.core.sentence(fault);
}

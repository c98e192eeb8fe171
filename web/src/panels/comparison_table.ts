/** The numbers of a comparison, one row a method. A click on a row asks for its net. */
import type { Run } from '../compare/run';
import type { CurveStyle } from './comparison_plot';
import { make, makeButton, setText } from './dom';
import { count, methodTitle, milliseconds, runWords, small } from './words';

const DEGREES = 180 / Math.PI;
const NOTHING = '–';

const COLUMNS: { title: string; hint: string; text(run: Run): string | undefined }[] = [
  { title: 'Iterations', hint: 'Iterations made', text: ({ frame }) => frame ? count(frame.iterations) : undefined },
  { title: 'ms', hint: 'Time spent in the solver', text: ({ frame }) => frame ? milliseconds(frame.milliseconds) : undefined },
  { title: 'Max dL', hint: 'Largest deviation of an edge from its length', text: ({ frame }) => frame ? small(frame.maxDeviation) : undefined },
  { title: 'Bend', hint: 'Fairness: root mean square change of the bend of net lines from rest; less is smoother', text: ({ measures }) => measures ? small(measures.bend) : undefined },
  { title: 'Smallest angle', hint: 'Smallest angle at a corner of a face', text: ({ measures }) => measures ? `${(measures.smallestAngle * DEGREES).toFixed(1)}°` : undefined },
  { title: 'Handle error', hint: 'Largest distance of a handle from its target', text: ({ measures }) => measures ? small(measures.handleError) : undefined },
  { title: 'Status', hint: 'How the run ended', text: runWords },
];

interface TableEvents {
  show(run: Run): void;
  showBeside(run: Run): void;
}

interface Row {
  run: Run;
  button: HTMLButtonElement;
  beside: HTMLButtonElement;
  cells: HTMLElement[];
}

export class ComparisonTable {
  readonly element = make('div', { class: 'table', tabindex: 0, role: 'region', 'aria-label': 'Results' });
  private rows: Row[] = [];

  constructor(
    private readonly styleOf: (method: string) => CurveStyle,
    private readonly events: TableEvents,
  ) {}

  showRuns(runs: readonly Run[]): void {
    const heads = COLUMNS.map(({ title, hint }) => make('th', { scope: 'col', title: hint }, title));
    this.rows = runs.map((run) => this.makeRow(run));
    const body = make('tbody', {}, ...this.rows.map((row) => this.makeLine(row)));
    this.element.replaceChildren(
      make('table', {}, make('thead', {}, make('tr', {}, make('th', { scope: 'col' }, 'Method'), ...heads, make('td'))), body),
    );
  }

  /** @param current the run whose net is in the view. @param open whether nets of this comparison can be shown. */
  refresh(current: Run | null, beside: Run | null, open: boolean): void {
    for (const row of this.rows) {
      const { run, cells } = row;
      row.button.setAttribute('aria-pressed', String(run === current));
      row.beside.setAttribute('aria-pressed', String(run === beside));
      row.button.disabled = row.beside.disabled = !open || run.frame === null;
      COLUMNS.forEach(({ text }, i) => setText(cells[i]!, text(run) ?? NOTHING));
    }
  }

  private makeRow(run: Run): Row {
    const { colour, dashed } = this.styleOf(run.method);
    const swatch = make('i', { class: dashed ? 'swatch dashed' : 'swatch' });
    swatch.style.setProperty('color', `var(${colour})`);
    const button = makeButton(swatch, () => {}, { class: 'plain', title: 'Show this net' });
    button.append(methodTitle(run.method));
    const beside = makeButton('Beside', () => this.events.showBeside(run), {
      class: 'plain link',
      title: 'Show this net beside the other',
      'aria-label': `${methodTitle(run.method)} beside the other net`,
    });
    return { run, button, beside, cells: COLUMNS.map(() => make('td')) };
  }

  private makeLine({ run, button, beside, cells }: Row): HTMLElement {
    const line = make('tr', {}, make('th', { scope: 'row' }, button), ...cells, make('td', {}, beside));
    line.addEventListener('click', ({ target }) => {
      if (!button.disabled && target !== beside) this.events.show(run);
    });
    return line;
  }
}

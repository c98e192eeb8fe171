/** The results of a comparison, below the picture: curves that grow, a table, and files of both. */
import type { MethodInfo } from '../../../wasm/chebnet';
import { tableCsv, tracesCsv } from '../compare/csv';
import type { Comparison, Run } from '../compare/run';
import { download } from '../files/download';
import { words } from '../language/language';
import { savePicture } from './comparison_picture';
import { ComparisonPlot, type CurveStyle } from './comparison_plot';
import { ComparisonTable } from './comparison_table';
import { make, makeButton, setText } from './dom';
import type { PanelEvents } from './panels';

/** Numbers that change more often cannot be read. */
const REFRESH_MS = 120;
/** Colours for curves in the style sheet; the later half of the methods is dashed besides. */
const CURVE_COLOURS = 10;
const FIRST_DASHED = 5;

export class ComparisonResults {
  readonly element: HTMLElement;
  private readonly words = make('p', { role: 'status' });
  private readonly stop: HTMLButtonElement;
  private readonly plots: ComparisonPlot[];
  private readonly table: ComparisonTable;
  private methods: string[] = [];
  private comparison: Comparison | null = null;
  private current: Run | null = null;
  private beside: Run | null = null;
  private netIsOpen = true;
  private timer = 0;

  constructor(private readonly events: PanelEvents) {
    const styleOf = (method: string) => this.styleOf(method);
    this.plots = [new ComparisonPlot('iterations', styleOf), new ComparisonPlot('milliseconds', styleOf)];
    this.table = new ComparisonTable(styleOf, {
      show: (run) => events.showRun(run === this.current ? null : run),
      showBeside: (run) => events.showBeside(run === this.beside ? null : run),
    });
    this.stop = makeButton(words.comparison.cancel, () => events.cancelComparison());
    this.element = make(
      'section',
      { class: 'comparison', 'aria-label': words.comparison.label, hidden: true },
      make(
        'header',
        {},
        make('h2', {}, words.comparison.heading),
        this.words,
        this.actions(),
        makeButton('×', () => this.close(), { 'aria-label': words.comparison.close }),
      ),
      make('div', { class: 'plots' }, ...this.plots.map(({ element }) => element)),
      this.table.element,
    );
  }

  showTable(table: MethodInfo[]): void {
    this.methods = table.map(({ name }) => name);
  }

  /** May be called often. */
  show(comparison: Comparison): void {
    if (comparison !== this.comparison) this.begin(comparison);
    if (this.timer === 0) this.timer = window.setTimeout(() => this.refresh(), comparison.running ? REFRESH_MS : 0);
  }

  /** The run whose net is in the view (null: the user's own is), and the one beside it. */
  showCurrent(run: Run | null, beside: Run | null): void {
    [this.current, this.beside] = [run, beside];
    this.refreshTable();
  }

  /** Another net is open: those of the comparison cannot be shown in its place. */
  netChanged(): void {
    this.netIsOpen = false;
    this.refreshTable();
  }

  private begin(comparison: Comparison): void {
    this.comparison = comparison;
    this.netIsOpen = true;
    this.element.hidden = false;
    this.table.showRuns(comparison.runs);
  }

  private refresh(): void {
    this.timer = 0;
    const comparison = this.comparison!;
    for (const plot of this.plots) plot.show(comparison);
    this.refreshTable();
    setText(this.words, progress(comparison));
    this.stop.disabled = !comparison.running;
  }

  private refreshTable(): void {
    this.table.refresh(this.current, this.beside, this.netIsOpen);
  }

  private actions(): HTMLElement {
    const save = (name: string, csv: (comparison: Comparison) => string) => () => {
      if (this.comparison) download(name, csv(this.comparison), 'text/csv');
    };
    return make(
      'div',
      { class: 'actions' },
      this.stop,
      makeButton(words.comparison.tableCsv, save('comparison.csv', tableCsv)),
      makeButton(words.comparison.tracesCsv, save('comparison-traces.csv', tracesCsv)),
      makeButton(words.comparison.plotsPng, () => this.savePlots()),
    );
  }

  private savePlots(): void {
    const methods = this.comparison?.runs.map(({ method }) => ({ title: words.core.method(method), ...this.styleOf(method) })) ?? [];
    void savePicture(this.element, this.plots, methods);
  }

  private close(): void {
    this.events.cancelComparison();
    this.events.showRun(null);
    this.events.showBeside(null);
    this.element.hidden = true;
  }

  /** The same for a method in every comparison. */
  private styleOf(method: string): CurveStyle {
    const index = Math.max(0, this.methods.indexOf(method)) % CURVE_COLOURS;
    return { colour: `--curve-${index + 1}`, dashed: index >= FIRST_DASHED };
  }
}

function progress({ runs, running }: Comparison): string {
  const done = runs.filter(({ state }) => state === 'ended' || state === 'failed').length;
  const current = runs.find(({ state }) => state === 'running');
  if (running && current) return words.comparison.running(words.core.method(current.method), done + 1, runs.length);
  if (done < runs.length) return words.comparison.cancelled(done, runs.length);
  const idle = runs.every(({ frame }) => frame?.iterations === 0);
  return idle ? words.comparison.idle : words.comparison.done(done);
}

/** The results of a comparison, below the picture: curves that grow, a table, and files of both. */
import { tableCsv, tracesCsv } from '../compare/csv';
import { canShow, type Comparison, type NetOrigin, type Run } from '../compare/run';
import { download } from '../files/download';
import { panelWords } from '../language/panels';
import { savePicture } from './picture';
import { ComparisonPlot, type CurveStyle, type LineStyle } from './plot';
import { ComparisonTable } from './table';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import type { PanelEvents } from '../panels';
import './results.css';

/** Interval between updates, in milliseconds: faster numbers cannot be read. */
const REFRESH_MS = 120;
/** Colours for curves in the style sheet; every five styles the line is another. */
const CURVE_COLOURS = 10;
const CURVES_OF_A_LINE = 5;
const LINES: readonly LineStyle[] = ['solid', 'dashed', 'dotted'];
/** Nets side by side; a phone has room for two. */
const ABREAST = { desktop: 3, phone: 2 };

export class ComparisonResults {
  readonly element: HTMLElement;
  readonly #words = make('p', { role: 'status' });
  readonly #stop: HTMLButtonElement;
  /** What saves what came of it, once it has ended. */
  #saves: readonly HTMLButtonElement[] = [];
  readonly #plots: ComparisonPlot[];
  readonly #table: ComparisonTable;
  /** What a comparison in which there was nothing to solve has no use for. */
  readonly #parts: readonly HTMLElement[];
  readonly #again = makeButton(panelWords.comparison.again, () => this.#compareAgain());
  readonly #abreast = makeButton(panelWords.comparison.abreast, () => this.#toggleAbreast(), {
    title: panelWords.comparison.abreastHint,
  });
  #comparison: Comparison | null = null;
  #current: Run | null = null;
  #beside: readonly Run[] = [];
  /** The one that is open. */
  #net: NetOrigin | null = null;
  #timer = 0;
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    this.#plots = [new ComparisonPlot('iterations', styleOf), new ComparisonPlot('milliseconds', styleOf)];
    this.#table = new ComparisonTable(styleOf, {
      show: (run) => events.showRun(run === this.#current ? null : run),
      showBeside: (run) => this.#toggleBeside(run),
    });
    // Where its nets are shown, beside the user's: what the document calls that is English.
    document.querySelector('#beside')?.setAttribute('aria-label', panelWords.comparison.nets);
    this.#stop = makeButton(panelWords.comparison.cancel, () => events.cancelComparison());
    const actions = this.#actions();
    const plots = make('div', { class: 'plots' }, ...this.#plots.map(({ element }) => element));
    this.#parts = [actions, plots, this.#table.element];
    this.element = make(
      'section',
      { class: 'comparison', 'aria-label': panelWords.comparison.heading, hidden: true },
      make(
        'header',
        {},
        make('h2', {}, panelWords.comparison.heading),
        this.#words,
        this.#again,
        actions,
        makeButton('×', () => this.#close(), { 'aria-label': panelWords.comparison.close }),
      ),
      plots,
      this.#table.element,
    );
  }

  /** May be called often. */
  setComparison(comparison: Comparison): void {
    if (comparison !== this.#comparison) this.#begin(comparison);
    else if (this.#timer === 0)
      this.#timer = window.setTimeout(() => this.#refresh(), comparison.running ? REFRESH_MS : 0);
  }

  /** The run whose net is in the view (null: the user's own is), and those beside it. */
  setShown(run: Run | null, beside: readonly Run[]): void {
    [this.#current, this.#beside] = [run, beside];
    this.#refreshTable();
  }

  /** Of another net, those of the comparison cannot be shown in its place. */
  setNet(net: NetOrigin): void {
    this.#net = net;
    this.#refreshTable();
  }

  #begin(comparison: Comparison): void {
    this.#comparison = comparison;
    this.element.hidden = false;
    this.#table.setRuns(comparison.runs);
    // What is there to be read and clicked is of the one before.
    this.#refresh();
  }

  #refresh(): void {
    this.#timer = 0;
    const comparison = this.#comparison!;
    for (const plot of this.#plots) plot.setComparison(comparison);
    this.#refreshTable();
    setText(this.#words, progress(comparison));
    for (const button of this.#saves) button.disabled = comparison.running;
    setHidden(this.#stop, !comparison.running, this.#saves[0]);
    const idle = isIdle(comparison);
    this.#again.hidden = !idle;
    for (const part of this.#parts) setHidden(part, idle, this.#again);
  }

  #refreshTable(): void {
    this.#table.refresh(this.#current, this.#beside, this.#net);
    this.#abreast.disabled = this.#toShowAbreast().length < 2;
    this.#abreast.setAttribute('aria-pressed', String(this.#current !== null && this.#beside.length > 0));
  }

  /** The first runs with a net to show. */
  #toShowAbreast(): Run[] {
    return this.#comparison?.runs.filter((run) => canShow(run, this.#net)).slice(0, mostAbreast()) ?? [];
  }

  #toggleAbreast(): void {
    const [first = null, ...others] =
      this.#abreast.getAttribute('aria-pressed') === 'true' ? [] : this.#toShowAbreast();
    this.#events.showRun(first);
    this.#events.showBeside(others);
  }

  #toggleBeside(run: Run): void {
    const others = this.#beside.filter((each) => each !== run);
    const isThere = others.length < this.#beside.length;
    this.#events.showBeside(isThere ? others : [...others, run].slice(1 - mostAbreast()));
  }

  #actions(): HTMLElement {
    const save = (name: string, csv: (comparison: Comparison) => string) => () => {
      if (this.#comparison) download(name, csv(this.#comparison), 'text/csv');
    };
    this.#saves = [
      makeButton(panelWords.comparison.tableCsv, save('comparison.csv', tableCsv)),
      makeButton(panelWords.comparison.tracesCsv, save('comparison-traces.csv', tracesCsv)),
      makeButton(panelWords.comparison.plotsPng, () => this.#savePlots()),
    ];
    return make('div', { class: 'actions' }, this.#stop, this.#abreast, ...this.#saves);
  }

  #savePlots(): void {
    const curves = this.#comparison?.runs.map((run) => ({ title: run.label, ...styleOf(run) })) ?? [];
    void savePicture(this.element, this.#plots, curves);
  }

  /** From where there is something to solve, once a handle has been moved. */
  #compareAgain(): void {
    this.#events.compare({ methods: this.#comparison!.runs.map(({ scene }) => scene.method), start: 'rest' });
  }

  #close(): void {
    this.#events.cancelComparison();
    this.#events.showRun(null);
    this.#events.showBeside([]);
    setHidden(this.element, true);
  }
}

export function styleOf({ style }: Pick<Run, 'style'>): CurveStyle {
  const round = Math.floor(style / CURVES_OF_A_LINE) % LINES.length;
  return { colour: `--curve-${(style % CURVE_COLOURS) + 1}`, line: LINES[round]! };
}

function mostAbreast(): number {
  return matchMedia('(max-width: 720px)').matches ? ABREAST.phone : ABREAST.desktop;
}

function progress(comparison: Comparison): string {
  const { runs, running } = comparison;
  const done = runs.filter(({ state }) => state === 'ended' || state === 'failed').length;
  const current = runs.find(({ state }) => state === 'running');
  if (running && current) return panelWords.comparison.running(current.label, done + 1, runs.length);
  if (done < runs.length) return panelWords.comparison.cancelled(done, runs.length);
  return isIdle(comparison) ? panelWords.comparison.idle : panelWords.comparison.done(done);
}

/** Whether every run began at a solution. */
function isIdle({ runs, running }: Comparison): boolean {
  return !running && runs.every(({ frame }) => frame?.iterations === 0);
}

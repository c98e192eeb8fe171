/** Curves of several runs in one picture: log₁₀ max dL against iterations or milliseconds, from the beginning of the
 *  initialisation; where one ends and the method begins stands a circle. */
import type uPlot from 'uplot';
import { type Comparison, type Run, startLength } from '../compare/run';
import { panelWords } from '../language/panels';
import { decade } from '../net/convergence';
import { make } from '../elements/dom';
import { decadeRange, drawThreshold, loadPlots, plotAxes, plotColour, roomyRange } from '../elements/plot_parts';

const HEIGHT = 172;
/** Radius of a circle, in pixels. */
const RADIUS = 4;

/** Dash patterns in pixels: drawn, left out. */
export const DASHES = { solid: [], dashed: [6, 3], dotted: [2, 3] } as const;
export type LineStyle = keyof typeof DASHES;

/** Style of a run's curve. Dashes help where colours are hard to tell apart. */
export interface CurveStyle {
  /** Name of the colour in the style sheet. */
  colour: string;
  line: LineStyle;
}

export class ComparisonPlot {
  readonly element = make('figure', { class: 'curves' });
  readonly #host = make('div', { role: 'img' });
  #library: typeof uPlot | null = null;
  #plot: uPlot | null = null;
  #comparison: Comparison | null = null;
  readonly #axis: 'iterations' | 'milliseconds';
  readonly #styleOf: (run: Run) => CurveStyle;

  constructor(axis: 'iterations' | 'milliseconds', styleOf: (run: Run) => CurveStyle) {
    this.#axis = axis;
    this.#styleOf = styleOf;
    const caption = panelWords.comparison.plots[axis];
    this.#host.setAttribute('aria-label', panelWords.comparison.plotLabel(caption));
    this.element.append(make('figcaption', {}, caption), this.#host);
    new ResizeObserver(() => this.#fit()).observe(this.#host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#plot?.redraw());
  }

  /** The canvas of the plot; null before it is drawn. */
  get canvas(): HTMLCanvasElement | null {
    return this.#plot?.ctx.canvas ?? null;
  }

  setComparison(comparison: Comparison): void {
    const isOther = this.#comparison?.runs !== comparison.runs;
    this.#comparison = comparison;
    if (isOther) void this.#remake();
    else if (this.#library) this.#plot?.setData(this.#data(this.#library, comparison));
  }

  async #remake(): Promise<void> {
    this.#plot?.destroy();
    this.#plot = null;
    this.#library = await loadPlots(this.#host);
    this.#fit();
  }

  #fit(): void {
    const width = this.#host.clientWidth;
    if (width === 0 || this.#comparison === null || this.#library === null) return;
    if (this.#plot) {
      this.#plot.setSize({ width, height: HEIGHT });
      return;
    }
    this.#host.replaceChildren();
    this.#plot = new this.#library(
      this.#options(this.#comparison, width),
      this.#data(this.#library, this.#comparison),
      this.#host,
    );
  }

  #data({ join }: typeof uPlot, { runs }: Comparison): uPlot.AlignedData {
    return join(runs.map((run) => this.#curve(run)));
  }

  #curve({ startDeviation, trace }: Run): uPlot.AlignedData {
    if (startDeviation === null) return [[], []];
    const x = trace.map(({ totalMs }, i) => (this.#axis === 'iterations' ? i + 1 : totalMs));
    return [
      [0, ...x],
      [decade(startDeviation), ...trace.map(({ maxDeviation }) => decade(maxDeviation))],
    ];
  }

  #options({ runs }: Comparison, width: number): uPlot.Options {
    const thresholds = [...new Set(runs.map(({ threshold }) => threshold))];
    return {
      width,
      height: HEIGHT,
      padding: [8, 16, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: (_, low, high) => roomyRange(low, high) },
        y: { range: (_, low, high) => decadeRange(low, high, Math.min(...thresholds)) },
      },
      series: [{}, ...runs.map((run) => this.#series(run))],
      axes: plotAxes(this.element),
      hooks: {
        drawClear: [(plot) => thresholds.forEach((each) => drawThreshold(plot, each, this.element))],
        draw: [(plot) => runs.forEach((run) => this.#drawBeginning(plot, run))],
      },
    };
  }

  /** A circle where the method begins, after an initialisation. */
  #drawBeginning({ ctx, valToPos }: uPlot, run: Run): void {
    const [x, y] = this.#curve(run).map((values) => values[startLength(run)]);
    if (startLength(run) === 0 || x == null || y == null) return;
    ctx.save();
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.strokeStyle = plotColour(this.element, this.#styleOf(run).colour);
    ctx.fillStyle = plotColour(this.element, '--panel');
    ctx.beginPath();
    ctx.arc(valToPos(x, 'x', true), valToPos(y, 'y', true), RADIUS * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
    ctx.restore();
  }

  #series(run: Run): uPlot.Series {
    const { colour, line } = this.#styleOf(run);
    const stroke = () => plotColour(this.element, colour);
    return { stroke, width: 1.75, points: { show: false }, dash: [...DASHES[line]] };
  }
}

/** The record of convergence as a plot: log₁₀ max dL against iterations or time, the threshold, and where stages begin. */
import type uPlot from 'uplot';
import type { TraceRow } from '../../../wasm/chebnet';
import { panelWords } from '../language/panels';
import { Convergence, type Curve } from '../net/convergence';
import { make, makeSelect } from '../elements/dom';
import {
  decadeRange,
  drawThreshold,
  loadPlots,
  plotAxes,
  plotColour,
  roomyRange,
  strokeLine,
} from '../elements/plot_parts';

const HEIGHT = 168;
/** Labels of stages closer than this, in pixels, would run into each other. */
const LABEL_ROOM = 6;
/** Milliseconds after the last iteration when the record is complete. */
const REST_MS = 1000;

export class ConvergencePlot {
  readonly element = make('div', { class: 'plot' });
  readonly #record = new Convergence();
  readonly #host = make('div', { role: 'img', 'aria-label': panelWords.plot.label });
  #plot: uPlot | null = null;
  /** There has been something to plot. */
  #wanted = false;
  #curve: Curve = { x: [], y: [], stageStarts: [] };
  #byTime = false;
  #threshold = 1e-6;
  #stale = false;
  #isSeen = false;
  #resting = 0;

  constructor() {
    const choices = [
      { value: 'iterations', text: panelWords.plot.iterations },
      { value: 'milliseconds', text: panelWords.plot.milliseconds },
    ];
    const { row } = makeSelect(panelWords.plot.against, choices, (value) => {
      this.#byTime = value === 'milliseconds';
      this.#draw();
    });
    this.element.append(row, this.#host);
    new ResizeObserver(() => this.#fit()).observe(this.#host);
    // Asked at each iteration, the page would lay itself out in the middle of a drag.
    new IntersectionObserver((entries) => this.#see(entries.at(-1)!.isIntersecting)).observe(this.#host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#plot?.redraw());
  }

  add(rows: readonly TraceRow[], stageName: (stage: number) => string): void {
    if (rows.length === 0) return;
    this.#record.add(rows, stageName);
    this.#stale = true;
    clearTimeout(this.#resting);
    this.#resting = window.setTimeout(() => this.#rest(), REST_MS);
  }

  setThreshold(threshold: number): void {
    if (threshold === this.#threshold) return;
    this.#threshold = threshold;
    this.#plot?.redraw();
  }

  /** Axes without a curve would say nothing. */
  clear(): void {
    this.#record.clear();
    this.#plot?.destroy();
    this.#plot = null;
    this.#wanted = false;
    this.#host.replaceChildren(make('p', { class: 'unplotted' }, panelWords.plot.empty));
    this.#draw();
  }

  /** Draws what has been added since, if the plot is visible. */
  refresh(): void {
    if (this.#stale && this.#isSeen) this.#draw();
  }

  #see(isSeen: boolean): void {
    this.#isSeen = isSeen;
    this.#fit();
    this.refresh();
  }

  #rest(): void {
    this.#record.rest();
    this.#draw();
  }

  #draw(): void {
    this.#stale = false;
    this.#curve = this.#record.curve(this.#byTime);
    this.#wanted ||= this.#curve.x.length > 0;
    if (this.#plot) this.#plot.setData([this.#curve.x, this.#curve.y]);
    else this.#fit();
  }

  #fit(): void {
    if (!this.#wanted || !this.#isSeen) return;
    if (this.#plot) this.#plot.setSize({ width: this.#host.clientWidth, height: HEIGHT });
    else void this.#begin();
  }

  async #begin(): Promise<void> {
    const Plot = await loadPlots(this.#host);
    if (Plot === null || !this.#isSeen || this.#plot) return;
    this.#host.replaceChildren();
    this.#plot = new Plot(this.#options(this.#host.clientWidth), [this.#curve.x, this.#curve.y], this.#host);
  }

  #options(width: number): uPlot.Options {
    const colour = () => plotColour(this.element, '--link');
    return {
      width,
      height: HEIGHT,
      padding: [18, 8, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: (_, low, high) => roomyRange(low, high) },
        y: { range: (_, low, high) => decadeRange(low, high, this.#threshold) },
      },
      series: [{}, { stroke: colour, width: 1.5, points: { show: true, size: 4, fill: colour } }],
      axes: plotAxes(this.element),
      hooks: { drawClear: [(plot) => this.#drawStageStarts(plot)] },
    };
  }

  #drawStageStarts(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.lineWidth = ratio;
    ctx.font = `${11 * ratio}px ${getComputedStyle(this.element).fontFamily}`;
    ctx.textAlign = 'left';
    drawThreshold(plot, this.#threshold, this.element);
    let free = -Infinity;
    for (const start of this.#curve.stageStarts) {
      const x = plot.valToPos(start.x, 'x', true);
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      // Fainter if there are many, as during a drag.
      ctx.strokeStyle = plotColour(this.element, this.#curve.stageStarts.length < 8 ? '--line-strong' : '--line');
      ctx.setLineDash([]);
      strokeLine(ctx, x, bbox.top - 4 * ratio, x, bbox.top + bbox.height);
      const { width } = ctx.measureText(start.stage);
      const left = Math.min(x, bbox.left + bbox.width - width);
      if (left < free) continue;
      ctx.fillStyle = plotColour(this.element, '--muted');
      ctx.fillText(start.stage, left, bbox.top - 7 * ratio);
      free = left + width + LABEL_ROOM * ratio;
    }
    ctx.restore();
  }
}

/** The record of convergence as a plot: log₁₀ max dL against iterations or time, the threshold, and where stages begin. */
import uPlot from 'uplot';
import type { TraceRow } from '../../../wasm/chebnet';
import { Convergence, type Curve } from './convergence';
import { make, makeSelect } from './dom';

const HEIGHT = 168;
/** Labels of stages closer than this, in pixels, would run into each other. */
const LABEL_ROOM = 6;
/** So long after the last iteration the record is at rest. */
const REST_MS = 1000;

export class ConvergencePlot {
  readonly element = make('div', { class: 'plot' });
  private readonly record = new Convergence();
  private readonly host = make('div', { role: 'img', 'aria-label': 'Convergence: largest deviation dL against iterations' });
  private plot: uPlot | null = null;
  private curve: Curve = { x: [], y: [], marks: [] };
  private byTime = false;
  private threshold = 1e-6;
  private stale = false;
  private resting = 0;

  constructor() {
    const choices = [
      { value: 'iterations', text: 'Iterations' },
      { value: 'milliseconds', text: 'Milliseconds' },
    ];
    const { row } = makeSelect('Max dL against', choices, (value) => {
      this.byTime = value === 'milliseconds';
      this.draw();
    });
    this.element.append(row, this.host);
    new ResizeObserver(() => this.fit()).observe(this.host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.plot?.redraw());
  }

  add(rows: readonly TraceRow[]): void {
    if (rows.length === 0) return;
    this.record.add(rows);
    this.stale = true;
    clearTimeout(this.resting);
    this.resting = window.setTimeout(() => this.rest(), REST_MS);
  }

  setThreshold(threshold: number): void {
    if (threshold === this.threshold) return;
    this.threshold = threshold;
    this.plot?.redraw();
  }

  clear(): void {
    this.record.clear();
    this.draw();
  }

  /** Draws what has been added since, if anyone can see it. */
  refresh(): void {
    if (this.stale && this.host.clientWidth > 0) this.draw();
  }

  private rest(): void {
    this.record.rest();
    this.draw();
  }

  private draw(): void {
    this.stale = false;
    this.curve = this.record.curve(this.byTime);
    this.plot?.setData([this.curve.x, this.curve.y]);
  }

  private fit(): void {
    const width = this.host.clientWidth;
    if (width === 0) return;
    if (this.plot) this.plot.setSize({ width, height: HEIGHT });
    else this.plot = new uPlot(this.options(width), [this.curve.x, this.curve.y], this.host);
  }

  private options(width: number): uPlot.Options {
    const muted = () => this.colour('--muted');
    const line = { stroke: () => this.colour('--line'), width: 1 };
    const font = `11px ${getComputedStyle(this.element).fontFamily}`;
    return {
      width,
      height: HEIGHT,
      padding: [18, 8, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: (_, low, high) => roomyRange(low, high) },
        y: { range: (_, low, high) => this.decades(low, high) },
      },
      series: [
        {},
        { stroke: () => this.colour('--link'), width: 1.5, points: { show: true, size: 4, fill: () => this.colour('--link') } },
      ],
      axes: [
        { stroke: muted, font, grid: { show: false }, ticks: { show: false }, size: 24, gap: 4, space: 48 },
        {
          stroke: muted,
          font,
          grid: line,
          ticks: { show: false },
          size: 44,
          gap: 6,
          splits: (_plot, _axis, low, high) => evenDecades(low, high),
          values: (_plot, splits) => splits.map((decade) => `1e${decade}`),
        },
      ],
      hooks: { drawClear: [(plot) => this.drawMarks(plot)] },
    };
  }

  /** Always shows the threshold; empty, the decades a solve usually goes through. */
  private decades(low: number | null, high: number | null): [number, number] {
    const goal = Math.log10(this.threshold);
    return [Math.floor(Math.min(low ?? goal, goal) - 1), Math.ceil(Math.max(high ?? -1, goal + 2))];
  }

  private drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.lineWidth = ratio;
    ctx.font = `${11 * ratio}px ${getComputedStyle(this.element).fontFamily}`;
    ctx.textAlign = 'left';
    this.drawThreshold(plot, ratio);
    let free = -Infinity;
    for (const mark of this.curve.marks) {
      const x = plot.valToPos(mark.x, 'x', true);
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      // Many of them, in the course of a drag, must not drown the curve.
      ctx.strokeStyle = this.colour(this.curve.marks.length < 8 ? '--line-strong' : '--line');
      ctx.setLineDash([]);
      strokeLine(ctx, x, bbox.top - 4 * ratio, x, bbox.top + bbox.height);
      if (x < free) continue;
      ctx.fillStyle = this.colour('--muted');
      const label = free < 0 ? `Stage ${mark.stage}` : String(mark.stage);
      ctx.fillText(label, x, bbox.top - 7 * ratio);
      free = x + ctx.measureText(label).width + LABEL_ROOM * ratio;
    }
    ctx.restore();
  }

  private drawThreshold({ ctx, bbox, valToPos }: uPlot, ratio: number): void {
    const y = valToPos(Math.log10(this.threshold), 'y', true);
    ctx.strokeStyle = this.colour('--accent');
    ctx.setLineDash([4 * ratio, 3 * ratio]);
    strokeLine(ctx, bbox.left, y, bbox.left + bbox.width, y);
  }

  private colour(name: string): string {
    return getComputedStyle(this.element).getPropertyValue(name);
  }
}

function strokeLine(ctx: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  ctx.beginPath();
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  ctx.stroke();
}

/** A few iterations do not stretch over the whole width. */
function roomyRange(low: number | null, high: number | null): [number, number] {
  const from = low ?? 0;
  return [from, Math.max(high ?? 0, from + 10)];
}

function evenDecades(low: number, high: number): number[] {
  const step = high - low > 5 ? 2 : 1;
  const decades: number[] = [];
  for (let decade = Math.ceil(low / step) * step; decade <= high; decade += step) decades.push(decade);
  return decades;
}

/** What plots of convergence have in common: axes of decades, the threshold, colours of the page. */
import type uPlot from 'uplot';
import { messageOf } from '../failure';
import { lazy } from '../lazy';
import { make } from './dom';

const load = lazy(async () => (await import('./uplot')).default);

/** Loads the library when there is something to plot: the first net is shown without it. If it cannot be loaded, that
 *  stands in the plot's place; the next call tries again. */
export async function loadPlots(place: HTMLElement): Promise<typeof uPlot | null> {
  try {
    return await load();
  } catch (error) {
    place.replaceChildren(make('p', { class: 'unplotted' }, messageOf(error)));
    return null;
  }
}

/** The current value of a colour of the style sheet, which follows dark and light. */
export function plotColour(element: Element, name: string): string {
  return getComputedStyle(element).getPropertyValue(name).trim();
}

/** Axes: x linear, y in decades. */
export function plotAxes(element: Element): uPlot.Axis[] {
  const stroke = () => plotColour(element, '--muted');
  const grid = { stroke: () => plotColour(element, '--line'), width: 1 };
  const font = `11px ${getComputedStyle(element).fontFamily}`;
  return [
    { stroke, font, grid: { show: false }, ticks: { show: false }, size: 24, gap: 4, space: 48 },
    {
      stroke,
      font,
      grid,
      ticks: { show: false },
      size: 44,
      gap: 6,
      splits: (_plot, _axis, low, high) => evenDecades(low, high),
      values: (_plot, splits) => splits.map((decade) => `1e${decade}`),
    },
  ];
}

/** Range of the x axis: few iterations do not stretch over the whole width. */
export function roomyRange(low: number | null, high: number | null): [number, number] {
  const from = low ?? 0;
  return [from, Math.max(high ?? 0, from + 10)];
}

/** Range of the y axis, which includes the threshold; without data, the decades a solve usually goes through. */
export function decadeRange(low: number | null, high: number | null, threshold: number): [number, number] {
  const goal = Math.log10(threshold);
  return [Math.floor(Math.min(low ?? goal, goal) - 1), Math.ceil(Math.max(high ?? -1, goal + 2))];
}

export function drawThreshold({ ctx, bbox, valToPos }: uPlot, threshold: number, element: Element): void {
  const ratio = devicePixelRatio;
  const y = valToPos(Math.log10(threshold), 'y', true);
  ctx.save();
  ctx.lineWidth = ratio;
  ctx.strokeStyle = plotColour(element, '--accent');
  ctx.setLineDash([4 * ratio, 3 * ratio]);
  strokeLine(ctx, bbox.left, y, bbox.left + bbox.width, y);
  ctx.restore();
}

export function strokeLine(ctx: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  ctx.beginPath();
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  ctx.stroke();
}

function evenDecades(low: number, high: number): number[] {
  const step = high - low > 5 ? 2 : 1;
  const decades: number[] = [];
  for (let decade = Math.ceil(low / step) * step; decade <= high; decade += step) decades.push(decade);
  return decades;
}

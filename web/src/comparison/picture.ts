/** Both plots of a comparison and what their curves mean, as one picture in a file. */
import { download } from '../files/download';
import { DASHES, type ComparisonPlot, type CurveStyle } from './plot';
import { plotColour } from '../elements/plot_parts';

const MARGIN = 16;
const LINE = 20;
const SWATCH = 24;

export async function savePicture(
  element: HTMLElement,
  plots: readonly ComparisonPlot[],
  curves: readonly (CurveStyle & { title: string })[],
): Promise<void> {
  const drawn = plots.flatMap(({ canvas, element: { firstChild } }) =>
    canvas ? [{ canvas, caption: firstChild?.textContent ?? '' }] : [],
  );
  const ratio = devicePixelRatio;
  const widths = drawn.map(({ canvas }) => canvas.width / ratio + MARGIN);
  const height = Math.max(0, ...drawn.map(({ canvas }) => canvas.height / ratio));
  const picture = document.createElement('canvas');
  const width = MARGIN + widths.reduce((sum, each) => sum + each, 0);
  const keys = placeKeys(curves, width);
  picture.width = width * ratio;
  picture.height = (3 * MARGIN + LINE + height + keys.height) * ratio;
  const context = picture.getContext('2d');
  if (context === null) return;
  context.scale(ratio, ratio);
  context.fillStyle = plotColour(element, '--panel');
  context.fillRect(0, 0, picture.width, picture.height);
  context.font = `12px ${getComputedStyle(element).fontFamily}`;
  context.textBaseline = 'middle';
  let x = MARGIN;
  drawn.forEach(({ canvas, caption }, i) => {
    context.fillStyle = plotColour(element, '--ink');
    context.fillText(caption, x, MARGIN + LINE / 2);
    context.drawImage(canvas, x, MARGIN + LINE, canvas.width / ratio, canvas.height / ratio);
    x += widths[i]!;
  });
  context.translate(0, 2 * MARGIN + LINE + height);
  for (const key of keys.placed) drawKey(context, element, key);
  const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, 'image/png'));
  if (blob) download('comparison.png', blob, 'image/png');
}

type Key = CurveStyle & { title: string; x: number; y: number };

/** The legend of curves, in as many columns as fit. */
function placeKeys(
  curves: readonly (CurveStyle & { title: string })[],
  width: number,
): { placed: Key[]; height: number } {
  const column = 200;
  const columns = Math.max(1, Math.floor((width - 2 * MARGIN) / column));
  const placed = curves.map((curve, i) => ({
    ...curve,
    x: MARGIN + (i % columns) * column,
    y: LINE * (Math.floor(i / columns) + 0.5),
  }));
  return { placed, height: LINE * Math.ceil(curves.length / columns) };
}

function drawKey(context: CanvasRenderingContext2D, element: HTMLElement, { title, colour, line, x, y }: Key): void {
  context.strokeStyle = plotColour(element, colour);
  context.lineWidth = 2;
  context.setLineDash([...DASHES[line]]);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + SWATCH, y);
  context.stroke();
  context.fillStyle = plotColour(element, '--ink');
  context.fillText(title, x + SWATCH + 8, y);
}

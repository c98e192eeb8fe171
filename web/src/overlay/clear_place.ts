/** Where what lies over the picture covers no handle, none of the arrows at what is selected, and nothing that can be pressed, and
 *  little of the net. */
import type { HandleData } from '../document/document';
import type { Selection } from '../handles/selection';
import type { PanelEvents } from '../panels';

/** At the lower edge of the picture, or at its top; what they are is in messages.css. The first is the usual one. */
const PLACES = ['middle', 'start', 'end', 'top', 'top-end'];
/** A handle is drawn as large as that, in pixels. */
const HANDLE_RADIUS = 12;
/** The arrow that points up from what is selected, of the height of the picture: see view/gizmo.ts. */
const ARROW = 0.15;
/** The note on an experiment stands beside its own: its text is to be read, too. */
const CONTROLS = '.over :is(button,input,summary,a,.experiment)';

type Place = ReturnType<PanelEvents['screenPositions']>[number];
type Box = Pick<DOMRect, 'left' | 'right' | 'top' | 'bottom'>;

/** It stays where it is if nothing is there, and otherwise takes the place that covers the least.
 *  @param net some of its vertices. */
export function placeClear(
  element: HTMLElement,
  handles: readonly HandleData[],
  selection: Selection,
  net: readonly number[],
  { screenPositions }: Pick<PanelEvents, 'screenPositions'>,
): void {
  // Messages are placed together.
  const messages = element.parentElement ?? element;
  const handleBoxes = screenPositions(handles.map(({ vertex }) => vertex)).map(boxAround);
  const arrows = arrowsAt(screenPositions(selection));
  const points = screenPositions(net);
  const others = [...handleBoxes, ...controlsBeside(messages)];
  const coveredAt = (place: string): number => {
    element.dataset['place'] = place;
    const box = messages.getBoundingClientRect();
    const countIn = (boxes: readonly Box[]): number => boxes.filter((other) => areOverlapping(box, other)).length;
    const covered = points.filter((point) => isIn(box, point)).length / Math.max(1, points.length);
    // The arrows are about to be used, rather than any one handle; all of the net counts as one.
    return countIn(others) + 2 * countIn(arrows) + covered;
  };
  let best = element.dataset['place'] ?? PLACES[0]!;
  let fewest = coveredAt(best);
  for (const place of PLACES) {
    if (fewest === 0) break;
    const count = coveredAt(place);
    if (count < fewest) [best, fewest] = [place, count];
  }
  element.dataset['place'] = best;
}

function boxAround({ x, y }: Place): Box {
  const [left, right] = [x - HANDLE_RADIUS, x + HANDLE_RADIUS];
  return { left, right, top: y - HANDLE_RADIUS, bottom: y + HANDLE_RADIUS };
}

/** In the middle of what is selected, if anything is. */
function arrowsAt(selected: readonly Place[]): Box[] {
  if (selected.length === 0) return [];
  const [x, y] = (['x', 'y'] as const).map(
    (axis) => selected.reduce((sum, each) => sum + each[axis], 0) / selected.length,
  );
  const box = boxAround({ x: x!, y: y! });
  return [{ ...box, top: y! - ARROW * document.querySelector('canvas')!.clientHeight }];
}

function controlsBeside(messages: HTMLElement): Box[] {
  const all = [...document.querySelectorAll<HTMLElement>(CONTROLS)];
  const beside = all.filter((each) => !messages.contains(each) && each.checkVisibility());
  return beside.map((each) => each.getBoundingClientRect());
}

function isIn(box: Box, { x, y }: Place): boolean {
  return box.left < x && x < box.right && box.top < y && y < box.bottom;
}

function areOverlapping(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

/** Where what lies over the picture covers no handle, and nothing that can be pressed. */
import type { HandleData } from '../document/document';
import type { PanelEvents } from '../panels';

/** At the lower edge of the picture, or at its top; what they are is in messages.css. The first is the usual one. */
const PLACES = ['middle', 'start', 'end', 'top', 'top-end'];
/** A handle is drawn as large as that, in pixels. */
const HANDLE_RADIUS = 12;
/** The note on an experiment stands beside its own: its text is to be read, too. */
const CONTROLS = '.over :is(button,input,summary,a,.experiment)';

type Box = Pick<DOMRect, 'left' | 'right' | 'top' | 'bottom'>;

/** It stays where it is if nothing is there, and otherwise takes the place that covers the least. */
export function placeClear(
  element: HTMLElement,
  handles: readonly HandleData[],
  { screenPositions }: Pick<PanelEvents, 'screenPositions'>,
): void {
  // Messages are placed together.
  const messages = element.parentElement ?? element;
  const handleBoxes = screenPositions(handles.map(({ vertex }) => vertex)).map(boxAround);
  const others = [...handleBoxes, ...controlsBeside(messages)];
  const coveredAt = (place: string): number => {
    element.dataset['place'] = place;
    const box = messages.getBoundingClientRect();
    return others.filter((other) => areOverlapping(box, other)).length;
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

function boxAround({ x, y }: { x: number; y: number }): Box {
  const [left, right] = [x - HANDLE_RADIUS, x + HANDLE_RADIUS];
  return { left, right, top: y - HANDLE_RADIUS, bottom: y + HANDLE_RADIUS };
}

function controlsBeside(messages: HTMLElement): Box[] {
  const all = [...document.querySelectorAll<HTMLElement>(CONTROLS)];
  const beside = all.filter((each) => !messages.contains(each) && each.checkVisibility());
  return beside.map((each) => each.getBoundingClientRect());
}

function areOverlapping(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

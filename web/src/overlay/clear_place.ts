/** Where what lies over the picture covers no handle. */
import type { HandleData } from '../document/document';
import type { PanelEvents } from '../panels';

/** At the lower edge of the picture, or at its top; what they are is in messages.css. The first is the usual one. */
const PLACES = ['middle', 'start', 'end', 'top'];
/** A handle is drawn as large as that, in pixels. */
const HANDLE_RADIUS = 12;

/** It stays where it is if no handle is there, and takes its usual place if there is one everywhere. */
export function placeClear(
  element: HTMLElement,
  handles: readonly HandleData[],
  { screenPositions }: Pick<PanelEvents, 'screenPositions'>,
): void {
  const points = screenPositions(handles.map(({ vertex }) => vertex));
  const isClearAt = (place: string): boolean => {
    element.dataset['place'] = place;
    const box = element.getBoundingClientRect();
    return !points.some((point) => isOn(box, point));
  };
  const present = element.dataset['place'] ?? PLACES[0]!;
  element.dataset['place'] = [present, ...PLACES].find(isClearAt) ?? PLACES[0]!;
}

function isOn({ left, right, top, bottom }: DOMRect, { x, y }: { x: number; y: number }): boolean {
  const [across, upright] = [Math.max(left - x, x - right), Math.max(top - y, y - bottom)];
  return Math.max(across, upright) < HANDLE_RADIUS;
}

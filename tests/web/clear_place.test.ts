/** Notices over the picture keep off the handles, and off what can be pressed. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { HandleData } from '../../web/src/document/document';
import { placeClear } from '../../web/src/overlay/clear_place';

const BOXES: Record<string, { left: number; right: number }> = {
  middle: { left: 40, right: 60 },
  start: { left: 0, right: 20 },
  end: { left: 80, right: 100 },
  top: { left: 40, right: 60 },
  'top-end': { left: 80, right: 100 },
};

const dataset: Record<string, string> = {};
const box = () => ({ ...BOXES[dataset['place']!]!, top: 80, bottom: 100 });
const messages = { getBoundingClientRect: box, contains: () => false };
const notice = { dataset, parentElement: messages } as unknown as HTMLElement;

/** Of so wide a button at the lower edge. */
const button = (left: number, right: number, isSeen = true) => ({
  checkVisibility: () => isSeen,
  getBoundingClientRect: () => ({ left, right, top: 80, bottom: 100 }),
});

let buttons: ReturnType<typeof button>[];
beforeEach(() => {
  delete dataset['place'];
  buttons = [];
  vi.stubGlobal('document', { querySelectorAll: () => buttons, querySelector: () => ({ clientHeight: 100 }) });
});
afterEach(() => vi.unstubAllGlobals());

/** @param places of handles, from the left, `height` pixels down from the top. */
function place(places: number[], height = 90, selection: number[] = [], net: number[] = []) {
  const screenPositions = vi.fn((vertices: readonly number[]) => vertices.map((vertex) => ({ x: vertex, y: height })));
  const handles = places.map((vertex): HandleData => ({ vertex, target: [0, 0, 0], anchor: false }));
  placeClear(notice, handles, selection, net, { screenPositions });
  return screenPositions;
}

test('a notice goes where no handle is, and asks once where all of them are', () => {
  const asked = place([50, 10]);
  expect(asked.mock.calls.filter(([vertices]) => vertices.length > 0)).toHaveLength(1);
  expect(dataset['place']).toBe('end');
});

test('of places without a handle a notice takes that which covers least of the net', () => {
  place([], 90, [], [45, 50, 55, 5]);
  expect(dataset['place']).toBe('end');
  // However much of it, that is less than a handle.
  dataset['place'] = 'middle';
  place([10, 90], 90, [], [45, 50, 55]);
  expect(dataset['place']).toBe('middle');
});

test('a notice leaves the arrow free that points up from what is selected', () => {
  place([30, 70], 114);
  expect(dataset['place']).toBe('middle');
  place([30, 70], 114, [30, 70]);
  expect(dataset['place']).toBe('start');
  // Also where it covers something else instead.
  dataset['place'] = 'middle';
  buttons = [button(0, 20), button(80, 100)];
  place([30, 70], 114, [30, 70]);
  expect(dataset['place']).toBe('start');
});

test('a notice goes where no button is that is seen, and stays there', () => {
  buttons = [button(30, 70), button(0, 20, false)];
  place([]);
  expect(dataset['place']).toBe('start');
  buttons = [];
  place([]);
  expect(dataset['place']).toBe('start');
});

test('where something is everywhere, a notice covers the least', () => {
  buttons = [button(0, 5), button(10, 15), button(45, 100)];
  place([50]);
  expect(dataset['place']).toBe('end');
});

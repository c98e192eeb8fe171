/** Notices over the picture keep off the handles. */
import { expect, test } from 'vitest';
import { placeClear } from '../../web/src/overlay/clear_place';

const BOXES: Record<string, { left: number; right: number }> = {
  middle: { left: 40, right: 60 },
  start: { left: 0, right: 20 },
  end: { left: 80, right: 100 },
  top: { left: 40, right: 60 },
};

test('a notice goes where no handle is, and asks once where all of them are', () => {
  const dataset: Record<string, string> = {};
  const box = () => ({ ...BOXES[dataset['place']!]!, top: 80, bottom: 100 });
  const element = { dataset, getBoundingClientRect: box } as unknown as HTMLElement;
  const handles = [50, 10].map((vertex) => ({ vertex, target: [0, 0, 0] as [number, number, number], anchor: false }));
  let asked = 0;
  const screenPositions = (vertices: readonly number[]) => {
    asked += 1;
    return vertices.map((vertex) => ({ x: vertex, y: 90 }));
  };
  placeClear(element, handles, { screenPositions });
  expect(dataset['place']).toBe('end');
  expect(asked).toBe(1);
});

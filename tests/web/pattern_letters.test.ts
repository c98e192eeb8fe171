// Where the letters of seams stand on the drawing of a flat pattern.
import { expect, test } from 'vitest';
import { type Drawing, patternSvg } from '../../web/src/export/pattern_svg';

/** Corners of cells, each with vertices of its own, from the lower left ones. */
const cornersOf = (cells: readonly [number, number][]): [number, number][] =>
  cells.flatMap(([x, y]): [number, number][] => [
    [x, y],
    [x + 1, y],
    [x + 1, y + 1],
    [x, y + 1],
  ]);

/** Cells in space, and where each lies on the drawing. */
function drawingOf(cells: readonly [number, number][], places: readonly [number, number][]): Drawing {
  const start = Int32Array.from({ length: cells.length + 1 }, (_, i) => 4 * i);
  const lists = { start, vertices: Int32Array.from({ length: 4 * cells.length }, (_, i) => i) };
  return {
    pattern: {
      places: Float64Array.from(cornersOf(places).flat()),
      columns: Math.max(...places.map(([column]) => column + 1)),
      rows: Math.max(...places.map(([, row]) => row + 1)),
      pieces: places.map(([column, row]) => ({ column, row, columns: 1, rows: 1 })),
    },
    lines: lists,
    loops: lists,
    faces: lists,
    restPositions: Float64Array.from(cornersOf(cells).flatMap(([x, y]) => [x, y, 0])),
    meanLength: 1,
    handles: [],
    name: '',
    edgeMm: 10,
  };
}

test('letters of seams stand clear of each other and in their own half of a cell that has several', () => {
  const cells: [number, number][] = [
    [0, 0],
    [1, 0],
    [0, 1],
    [-1, 0],
  ];
  const places: [number, number][] = [
    [0, 0],
    [3, 0],
    [0, 3],
    [3, 3],
  ];
  const svg = patternSvg(drawingOf(cells, places));
  const [, size, labels] = /<g id="seams"[^>]*font-size="([^"]*)">(.*?)<\/g>/.exec(svg)!;
  const letters = [...labels!.matchAll(/<text x="([^"]*)" y="([^"]*)"[^>]*>([A-Z])</g)].map(
    ([, x, y, letter]) => [Number(x), Number(y), letter] as const,
  );
  expect(letters.map(([, , letter]) => letter).sort()).toEqual(['A', 'A', 'B', 'B', 'C', 'C']);
  for (const [i, [x, y]] of letters.entries())
    for (const [u, v] of letters.slice(0, i)) expect(Math.hypot(x - u, y - v)).toBeGreaterThan(Number(size));

  // The first cell, a centimetre wide, is in the lower left of the drawing; its neighbour on the right is the second.
  const middle = [15, 45] as const;
  const inFirst = letters.filter(([x, y]) => Math.max(Math.abs(x - middle[0]), Math.abs(y - middle[1])) < 5);
  const ways = inFirst.map(([x, y]) => [Math.sign(x - middle[0]), Math.sign(y - middle[1])]);
  expect(ways).toHaveLength(3);
  expect(ways).toEqual(
    expect.arrayContaining([
      [1, 0],
      [0, -1],
      [-1, 0],
    ]),
  );
});

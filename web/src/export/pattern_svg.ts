/** A flat pattern as a drawing to cut or weave by, in millimetres. */
import type { FlatPattern, VertexLists } from '../../../wasm/chebnet';
import type { HandleData } from '../document/document';
import { listsOf } from '../handles/lines';
import { type Seam, seamsOf } from './seams';

export interface Drawing {
  pattern: FlatPattern;
  /** Net lines, those along the boundary among them. */
  lines: VertexLists;
  /** Of the boundary. */
  loops: VertexLists;
  faces: VertexLists;
  /** Of the net, where seams are looked for. */
  restPositions: Float64Array;
  meanLength: number;
  handles: readonly HandleData[];
  name: string;
  /** Length of an edge on the drawing. */
  edgeMm: number;
}

/** Sizes as fractions of an edge. */
const MARGIN = 1;
const MARK_RADIUS = 0.16;
/** Distance of a number from its piece. */
const SHIFT = 0.22;
/** Of a name from the sides of its cell. */
const PADDING = 0.12;
/** The sine of an angle, times two lengths. */
const STRAIGHT = 1e-9;
const LETTER = 0.45;
/** A longer name than has room in a cell at this size runs on over the next one. */
const SMALLEST_LETTER = 0.2;
/** Of an average character, as a fraction of its size. */
const CHARACTER_WIDTH = 0.62;
/** Of a seam: as many as a cell has sides stand in it beside each other. */
const SEAM_LETTER = 0.3;
const NUMBER = 0.7;
const END_RADIUS = 0.1;
const THIN = 0.02;
const BOLD = 0.08;
const SEAM_COLOUR = '#1f5fbf';

/** Right and down, in millimetres. */
type Place = [number, number];

/** One stroke a net line, the boundary bold; a mark at each handle, its name in a cell beside it; letters along the two sides of a seam;
 *  below, a bar of one edge. */
export function patternSvg(drawing: Drawing): string {
  const { pattern, lines, loops, name, edgeMm } = drawing;
  const seams = openSeams(drawing);
  const isBoundary = boundaryTest(listsOf(loops));
  const boundary = listsOf(lines).filter(isBoundary);
  const inner = listsOf(lines).filter((line) => !isBoundary(line));
  const width = (pattern.columns + 2 * MARGIN) * edgeMm;
  const height = (pattern.rows + 3 * MARGIN) * edgeMm;
  const strokes = (all: readonly Int32Array[]): string => all.map((line) => stroke(line, drawing)).join('');
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${mm(width)}mm" height="${mm(height)}mm" viewBox="0 0 ${mm(width)} ${mm(height)}">`,
    `<title>${escaped(name)}</title>`,
    '<g fill="none" stroke="#000" stroke-linecap="round" stroke-linejoin="round">',
    `<path id="net" stroke-width="${mm(THIN * edgeMm)}" d="${strokes(inner)}"/>`,
    `<path id="boundary" stroke-width="${mm(BOLD * edgeMm)}" d="${strokes(boundary)}"/>`,
    '</g>',
    `<g id="handles" fill="#c0271f" font-family="sans-serif">`,
    ...marks(drawing, seams),
    '</g>',
    ...(pattern.pieces.length > 1 ? [numbers(drawing)] : []),
    ...seamLabels(seams, drawing),
    scaleBar(height, edgeMm),
    '</svg>',
    '',
  ].join('\n');
}

/** Whether a net line begins, and so goes on, along the boundary. */
function boundaryTest(loops: readonly Int32Array[]): (line: Int32Array) => boolean {
  const sides = loops.flatMap((loop) => Array.from(loop, (vertex, i) => `${vertex} ${loop[(i + 1) % loop.length]}`));
  const known = new Set(sides);
  return ([a, b]) => known.has(`${a} ${b}`) || known.has(`${b} ${a}`);
}

function stroke(vertices: Int32Array, drawing: Drawing): string {
  const points = corners(vertices, drawing.pattern).map((vertex) => place(vertex, drawing).join(' '));
  return `M${points.join('L')}`;
}

/** Its ends, and the points where it turns. */
function corners(vertices: Int32Array, { places }: FlatPattern): number[] {
  const isStraight = (a: number, b: number, c: number): boolean => {
    const along = (from: number, to: number, axis: number) => places[2 * to + axis]! - places[2 * from + axis]!;
    return Math.abs(along(a, b, 0) * along(b, c, 1) - along(a, b, 1) * along(b, c, 0)) < STRAIGHT;
  };
  return [...vertices].filter((vertex, i) => {
    const [before, after] = [vertices[i - 1], vertices[i + 1]];
    return before === undefined || after === undefined || !isStraight(before, vertex, after);
  });
}

function place(vertex: number, { pattern: { places, rows }, edgeMm }: Drawing): [string, string] {
  return onPaper(places[2 * vertex]!, places[2 * vertex + 1]!, rows, edgeMm);
}

/** In SVG y points down. */
function onPaper(column: number, row: number, rows: number, edgeMm: number): [string, string] {
  return [mm((MARGIN + column) * edgeMm), mm((MARGIN + rows - row) * edgeMm)];
}

/** Above the left of each piece, from 1, as OBJ files name them. */
function numbers({ pattern: { pieces, rows: height }, edgeMm }: Drawing): string {
  const labels = pieces.map(({ column, row, rows }, i) => {
    const [x, y] = onPaper(column, row + rows, height, edgeMm);
    return `<text x="${x}" y="${y}" dy="${mm(-SHIFT * edgeMm)}">${i + 1}</text>`;
  });
  return `<g id="pieces" font-family="sans-serif" font-weight="bold" font-size="${mm(NUMBER * edgeMm)}">${labels.join('')}</g>`;
}

/** Those that do not lie closed: their sides are apart. */
function openSeams({ loops, restPositions, meanLength, pattern: { places } }: Drawing): Seam[] {
  return seamsOf(loops, restPositions, meanLength).filter(([one, other]) => {
    const differs = (i: number, axis: number) => places[2 * one[i]! + axis] !== places[2 * other[i]! + axis];
    return one.some((_, i) => differs(i, 0) || differs(i, 1));
  });
}

/** The edge at which its letter stands. */
function middleOf(side: readonly number[]): [number, number] {
  const middle = (side.length - 1) >> 1;
  return [side[middle]!, side[middle + 1]!];
}

/** One letter for both sides of a seam, beside an edge midway, half-way into its cell; at that edge an arrow, which points to
 *  the same end on both sides; dots at the ends. */
function seamLabels(seams: readonly Seam[], drawing: Drawing): string[] {
  const { pattern, edgeMm } = drawing;
  if (seams.length === 0) return [];
  const cells = cellsAtSeams(seams, drawing);
  const labels = seams.flatMap((sides, number) => sides.map((side) => label(side, letters(number))));
  return [
    `<g id="seams" fill="${SEAM_COLOUR}" font-family="sans-serif" font-size="${mm(SEAM_LETTER * edgeMm)}">${labels.join('')}</g>`,
  ];

  function label(side: readonly number[], letter: string): string {
    const [from, to] = middleOf(side);
    const cell = cells.get(sideKey(from, to))!;
    const beside = (axis: 0 | 1) =>
      (cell[axis] + (pattern.places[2 * from + axis]! + pattern.places[2 * to + axis]!) / 2) / 2;
    const [x, y] = onPaper(beside(0), beside(1), pattern.rows, edgeMm);
    const text = `<text x="${x}" y="${y}" text-anchor="middle" dy="0.35em">${letter}</text>`;
    return dot(side[0]!) + dot(side.at(-1)!) + arrow(from, to) + text;
  }

  function dot(vertex: number): string {
    const [x, y] = place(vertex, drawing);
    return `<circle cx="${x}" cy="${y}" r="${mm(END_RADIUS * edgeMm)}"/>`;
  }

  function arrow(from: number, to: number): string {
    const [[x, y], [u, v]] = [from, to].map((vertex) => place(vertex, drawing).map(Number)) as [Place, Place];
    const at = (along: number, aside: number): string =>
      `${mm(x + along * (u - x) - aside * (v - y))} ${mm(y + along * (v - y) + aside * (u - x))}`;
    return `<path d="M${at(0.7, 0)}L${at(0.4, 0.15)}L${at(0.4, -0.15)}Z"/>`;
  }
}

/** The middles of the cells, in columns and rows, by their sides in seams. */
function cellsAtSeams(seams: readonly Seam[], { faces, pattern: { places } }: Drawing): Map<string, [number, number]> {
  const along = (side: readonly number[]) => side.slice(1).map((vertex, i) => sideKey(side[i]!, vertex));
  const wanted = new Set(seams.flatMap(([one, other]) => [...along(one), ...along(other)]));
  const cells = new Map<string, [number, number]>();
  for (const face of listsOf(faces))
    face.forEach((vertex, i) => {
      const key = sideKey(vertex, face[(i + 1) % face.length]!);
      if (!wanted.has(key)) return;
      const mean = (axis: number) => face.reduce((sum, each) => sum + places[2 * each + axis]!, 0) / face.length;
      cells.set(key, [mean(0), mean(1)]);
    });
  return cells;
}

function sideKey(a: number, b: number): string {
  return `${Math.min(a, b)} ${Math.max(a, b)}`;
}

/** A to Z, then AA and so on. */
function letters(number: number): string {
  const last = String.fromCharCode(65 + (number % 26));
  return number < 26 ? last : letters(Math.floor(number / 26) - 1) + last;
}

/** Each with its name in a cell at it, where no line runs: in one without another name or the letter of a seam, if there is such. */
function marks(drawing: Drawing, seams: readonly Seam[]): string[] {
  const { handles, faces } = drawing;
  const cells = new Map<number, Int32Array[]>(handles.map(({ vertex }) => [vertex, []]));
  for (const face of listsOf(faces)) for (const vertex of face) cells.get(vertex)?.push(face);
  const lettered = new Set(seams.flatMap((sides) => sides.map((side) => sideKey(...middleOf(side)))));
  const hasLetter = (face: Int32Array) =>
    face.some((vertex, i) => lettered.has(sideKey(vertex, face[(i + 1) % face.length]!)));
  const taken = new Set([...cells.values()].flat().filter(hasLetter));
  return handles.map((handle) => {
    const all = cells.get(handle.vertex)!;
    const cell = all.find((each) => !taken.has(each)) ?? all[0]!;
    taken.add(cell);
    return mark(handle, cell, drawing);
  });
}

/** The name stands at the vertex; one too long for the cell goes to where there is more of the pattern, and stays on the drawing. */
function mark({ vertex, name = String(vertex) }: HandleData, cell: Int32Array, drawing: Drawing): string {
  const { pattern, edgeMm } = drawing;
  const [x, y] = place(vertex, drawing);
  const [low, high] = ([Math.min, Math.max] as const).map((end) =>
    [0, 1].map((axis) => end(...Array.from(cell, (each) => pattern.places[2 * each + axis]!))),
  ) as [Place, Place];
  const [width, height] = [high[0] - low[0] - 2 * PADDING, high[1] - low[1] - 2 * PADDING];
  const fitting = Math.min(LETTER, height, width / (CHARACTER_WIDTH * name.length));
  const size = Math.max(SMALLEST_LETTER, fitting);
  const centre = (low[0] + high[0]) / 2;
  const goesLeft = fitting < size ? centre > pattern.columns / 2 : centre < pattern.places[2 * vertex]!;
  const [anchor, side] = goesLeft ? ['end', high[0] - PADDING] : ['start', low[0] + PADDING];
  const [left, middle] = onPaper(side, (low[1] + high[1]) / 2, pattern.rows, edgeMm);
  return (
    `<circle cx="${x}" cy="${y}" r="${mm(MARK_RADIUS * edgeMm)}"/>` +
    `<text x="${left}" y="${middle}" text-anchor="${anchor}" dy="0.35em" font-size="${mm(size * edgeMm)}">${escaped(name)}</text>`
  );
}

function scaleBar(height: number, edgeMm: number): string {
  const [left, y] = [mm(MARGIN * edgeMm), mm(height - 0.8 * MARGIN * edgeMm)];
  return (
    `<g id="scale"><path d="M${left} ${y}h${mm(edgeMm)}" stroke="#000" stroke-width="${mm(BOLD * edgeMm)}"/>` +
    `<text x="${mm((MARGIN + 1.3) * edgeMm)}" y="${y}" dy="0.35em" font-family="sans-serif" font-size="${mm(LETTER * edgeMm)}">${mm(edgeMm)} mm</text></g>`
  );
}

/** To a thousandth. */
function mm(length: number): string {
  return String(Number(length.toFixed(3)));
}

/** Escapes a name for XML. */
function escaped(text: string): string {
  const entities: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;' };
  // What XML has no place for is a blank: controls, half characters and the two that are none.
  return text.replace(/[&<>\p{Cc}\p{Cs}\uFFFE\uFFFF]/gu, (sign) => entities[sign] ?? ' ');
}

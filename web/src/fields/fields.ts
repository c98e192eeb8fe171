/** What the net can be coloured by: a table with a row for each field, whose words are `colourFields` in `language`. */
import type { CoreFields } from '../../../wasm/chebnet';
import { lengthError, ROUNDING } from '../language/numbers';
import { words } from '../language/language';
import { type Faces, writeCurvatures, writeFolds } from '../net/fold';
import { isLonger } from '../net/longer';
import { blend, diverging, type Ends, endText, type MapColours, noOrYes, plasma, type Scale } from './colour_map';

/** A choice between the maps of a field that has several. */
export type ColourMap = 'paper' | 'log';

/** The net at one moment, as the solver sends it. */
export interface Placed {
  /** 3 numbers a vertex. */
  positions: Float64Array;
  /** What rest lengths are multiplied by. */
  lengthScale: number;
  fields: CoreFields;
}

/** A number for each vertex or each edge, and the colours it is shown in. */
export interface ColourField {
  /** Faces have colours from numbers at vertices only. */
  place: 'vertex' | 'edge';
  /** How edges that meet at a vertex are combined: the number farthest from 0, or the mean. */
  atVertex?: 'farthest' | 'mean';
  /** The maps to choose from, if there are several. */
  maps?: readonly ColourMap[];
  /** Whether ends of the map can be set by hand; above 0 only, if it is logarithmic. */
  ends?: 'any' | 'above 0';
  /** Its numbers in the unit that is shown, written in place: this is done for each frame. */
  write(numbers: Float32Array, placed: Placed, net: Faces): void;
  /**
   * @param ends in place of the map's own.
   * @param cornerLimit degrees: no corner is to be narrower; 0: any may be.
   */
  scale(colours: MapColours, map: ColourMap, ends?: Ends, cornerLimit?: number): Scale;
  /** A summary of all its numbers for the legend. */
  summary(numbers: Float32Array, placed: Placed, net: Faces): string;
}

const DEGREES = 180 / Math.PI;

/** Li et al. 2022 draw an edge blue below the threshold ε₃ = 1e-6 and red above twice that. */
const PAPER_ENDS: Ends = [1e-6, 2e-6];

/** A corner of 30° is the limit of most cloth and wire mesh, and of a net at rest unless another is chosen. */
const USUAL_CORNER_LIMIT = 30;

/** In the order in which they are offered. */
export const FIELDS = {
  /** dL of each edge. */
  deviation: {
    place: 'edge',
    atVertex: 'farthest',
    maps: ['paper', 'log'],
    ends: 'above 0',
    write: (numbers, { fields }) => numbers.set(fields.deviation),
    scale: (colours, map, ends) => (map === 'paper' ? paperScale(colours, ends) : plasmaScale(colours, ends)),
    summary: (numbers) => {
      const [, high] = rangeOf(numbers);
      if (high < ROUNDING) return words.legend.net(words.legend.exact);
      return words.legend.net(words.legend.upTo(lengthError(high)));
    },
  },
  /** At each vertex how far the corner farthest from 90° is from that. */
  shear: {
    place: 'vertex',
    ends: 'any',
    write: (numbers, { fields: { angle } }) => {
      for (let vertex = 0; vertex < angle.length; vertex++) numbers[vertex] = Math.abs(angle[vertex]! * DEGREES - 90);
    },
    scale: ({ good, warn, bad }, _, ends, cornerLimit = USUAL_CORNER_LIMIT) => {
      const [low, high] = ends ?? [0, 90 - cornerLimit];
      const scale = diverging([good, warn, bad], (low + high) / 2, [low, high], '°');
      return ends || cornerLimit === 0 ? scale : { ...scale, ticks: shearTicks(high) };
    },
    summary: (numbers) => words.legend.net(words.legend.upTo(`${rangeOf(numbers)[1].toFixed(0)}°`)),
  },
  /** The angle between the faces at each edge. */
  fold: {
    place: 'edge',
    atVertex: 'farthest',
    ends: 'any',
    write: (numbers, { positions }, net) => writeFolds(numbers, positions, net),
    scale: ({ good, warn, bad }, _, ends = [0, 60]) => diverging([good, warn, bad], (ends[0] + ends[1]) / 2, ends, '°'),
    summary: (numbers) => words.legend.net(words.legend.upTo(`${rangeOf(numbers)[1].toFixed(1)}°`)),
  },
  /** At each vertex, of a whole net as curved as it is there. */
  curvature: {
    place: 'vertex',
    ends: 'any',
    write: (numbers, { positions }, net) => writeCurvatures(numbers, positions, net),
    scale: ({ narrow, right, wide }, _, ends = [-360, 360]) => diverging([narrow, right, wide], 0, ends, '°'),
    summary: (numbers) => words.legend.net(rangeWords(numbers, 0, '°')),
  },
  /** At each vertex the corner angle farthest from 90°. */
  angle: {
    place: 'vertex',
    ends: 'any',
    write: (numbers, { fields: { angle } }) => {
      for (let vertex = 0; vertex < angle.length; vertex++) numbers[vertex] = angle[vertex]! * DEGREES;
    },
    scale: ({ narrow, right, wide }, _, ends = [45, 135]) => diverging([narrow, right, wide], 90, ends, '°'),
    summary: (numbers) => words.legend.net(rangeWords(numbers, 0, '°')),
  },
  /** Tension of each edge, below 0 compression. */
  force: {
    place: 'edge',
    atVertex: 'farthest',
    ends: 'any',
    write: (numbers, { fields }) => numbers.set(fields.force),
    scale: ({ bad, right, good }, _, ends = [-0.5, 0.5]) => diverging([bad, right, good], 0, ends, ''),
    summary: (numbers) => {
      const [low, high] = rangeOf(numbers);
      return low === 0 && high === 0 ? words.legend.noForces : words.legend.net(rangeWords(numbers, 2));
    },
  },
  /** Of each vertex over the surface beside the net, in edge lengths. */
  height: {
    place: 'vertex',
    ends: 'any',
    write: (numbers, { fields: { height }, lengthScale }, { restLengths }) => {
      const length = lengthScale * meanOf(restLengths);
      for (let vertex = 0; vertex < height.length; vertex++) numbers[vertex] = height[vertex]! / length;
    },
    scale: ({ narrow, right, wide }, _, ends = [-0.5, 0.5]) => diverging([narrow, right, wide], 0, ends, ''),
    summary: (numbers, { fields: { height } }) => {
      const [low, high] = rangeOf(height);
      return words.legend.inUnits(
        words.legend.net(rangeWords(numbers, 2)),
        words.legend.range(low.toPrecision(3), high.toPrecision(3)),
      );
    },
  },
  /** 1 for edges longer than their rest length, 0 for others. */
  longer: {
    place: 'edge',
    atVertex: 'mean',
    write: (numbers, placed, net) => {
      for (let edge = 0; edge < net.restLengths.length; edge++) numbers[edge] = Number(isLonger(net, placed, edge));
    },
    scale: ({ right, longer }) => noOrYes([right, longer], [words.legend.notLonger, words.legend.isLonger]),
    summary: (numbers) => words.legend.share((100 * meanOf(numbers)).toFixed(1)),
  },
} satisfies Record<string, ColourField>;

export type FieldName = keyof typeof FIELDS;

/** Fields whose ends can be set. */
type ScaledName = {
  [Name in FieldName]: (typeof FIELDS)[Name] extends { ends: string } ? Name : never;
}[FieldName];

export const FIELD_NAMES = Object.keys(FIELDS) as FieldName[];

export function fieldOf(name: FieldName): ColourField {
  return FIELDS[name];
}

/** The field that is shown, and its colours. */
export interface Colouring {
  field: FieldName;
  colourMap: ColourMap;
  /** Ends set by hand; other fields have the automatic ones. */
  ends?: { [Each in ScaledName]?: Ends | undefined };
}

/** As a document has it, whose corners may have a limit of their own. */
export interface ShownColouring extends Colouring {
  cornerLimit?: number | undefined;
}

/** The ends set by hand for the field that is shown. */
export function endsOf({ field, ends = {} }: Colouring): Ends | undefined {
  const all: { [Each in FieldName]?: Ends | undefined } = ends;
  return all[field];
}

export function scaleOf(colouring: ShownColouring, colours: MapColours): Scale {
  const { field, colourMap, cornerLimit } = colouring;
  return fieldOf(field).scale(colours, colourMap, endsOf(colouring), cornerLimit);
}

/** Whether a map of the field can go from one to the other. */
export function areEnds({ ends }: ColourField, [low, high]: Ends): boolean {
  return low < high && Number.isFinite(high - low) && (ends === 'any' || (ends === 'above 0' && low > 0));
}

/** One for each vertex or edge. */
export function numbersOf({ place, write }: ColourField, placed: Placed, net: Faces): Float32Array {
  const numbers = new Float32Array(place === 'edge' ? net.restLengths.length : placed.positions.length / 3);
  write(numbers, placed, net);
  return numbers;
}

/** Smallest and largest; both NaN if one is. */
export function rangeOf(numbers: Float32Array): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const each of numbers) {
    low = Math.min(low, each);
    high = Math.max(high, each);
  }
  return [low, high];
}

/** From the smallest to the largest, rounded; none of them −0. */
function rangeWords(numbers: Float32Array, decimals: number, unit = ''): string {
  const [low, high] = rangeOf(numbers).map((x) => (Number(x.toFixed(decimals)) || 0).toFixed(decimals) + unit);
  return words.legend.range(low!, high!);
}

function shearTicks(most: number): Scale['ticks'] {
  const { warn, limit } = words.legend;
  return [
    { value: 0, label: '0°' },
    { value: most / 2, label: warn(`${most / 2}°`) },
    { value: most, label: limit(`${most}°`) },
  ];
}

function meanOf(numbers: Float32Array | Float64Array): number {
  let sum = 0;
  for (const each of numbers) sum += each;
  return sum / numbers.length;
}

/** The legend's range is wider than the narrow band between the ends. */
function paperScale({ good, bad }: MapColours, ends?: Ends): Scale {
  if (ends) return { ...blend(good, bad, ends), ticks: deviationTicks(ends) };
  // A thousandth of a percent, and ten.
  const shown: Ends = [1e-10, 9.09e-3];
  return { ...blend(good, bad, PAPER_ENDS), shown, ticks: errorTicks(shown[0], PAPER_ENDS[0], shown[1]) };
}

function plasmaScale(colours: MapColours, ends?: Ends): Scale {
  if (ends) return { ...plasma(colours, ends), ticks: deviationTicks(ends) };
  return { ...plasma(colours, [1e-12, 1e-1]), ticks: errorTicks(1e-12, 1e-6, 1e-1) };
}

/** Ends set by hand are marked as they were entered. */
function deviationTicks(ends: Ends): Scale['ticks'] {
  return ends.map((value) => ({ value, label: `dL ${endText(value)}` }));
}

/** A deviation is marked by the error of a length, which says more to most people. */
function errorTicks(...deviations: number[]): Scale['ticks'] {
  return deviations.map((value) => ({ value, label: lengthError(value) }));
}

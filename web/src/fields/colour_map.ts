/** Colour maps from numbers to colours, for view and legend. */
import { PLASMA } from 'virtual:plasma';

/** Ends of a map, in the unit of its numbers. */
export type Ends = readonly [low: number, high: number];

/** Red, green, blue in 0…1, as the screen takes them (sRGB). */
export type Rgb = readonly [number, number, number];

/** The colours of the theme that maps are made from; `style.css` holds them. */
export interface MapColours {
  /** The paper's blue and red. */
  good: Rgb;
  bad: Rgb;
  /** Between good and bad. */
  warn: Rgb;
  /** Corner angles: narrower than a right angle, right, wider. */
  narrow: Rgb;
  right: Rgb;
  wide: Rgb;
  /** Edges longer than their rest length; others have the colour of a right angle. */
  longer: Rgb;
  dark: boolean;
}

export interface Scale {
  /** Ends of the map. Values beyond take the colour of the end. */
  low: number;
  high: number;
  logarithmic: boolean;
  /** Range of the legend, which may be wider than that of the map. */
  shown: Ends;
  ticks: { value: number; label: string }[];
  /** `t` in 0…1 from one end to the other. */
  colour(t: number): Rgb;
}

/** As short as it can be read again. */
export function endText(value: number): string {
  const [plain, power] = [String(value), value.toExponential()];
  return power.length < plain.length ? power : plain;
}

/** The ends of the plasma map, which fade into a light or a dark page, are cut off. */
const PLASMA_LIGHT = [0, 0.78] as const;
const PLASMA_DARK = [0.36, 1] as const;

/** Where a value stands between the ends of the map, 0…1. */
export function positionOn(scale: Scale, value: number): number {
  const [low, high, x] = scale.logarithmic
    ? [Math.log10(scale.low), Math.log10(scale.high), Math.log10(Math.max(value, Number.MIN_VALUE))]
    : [scale.low, scale.high, value];
  return Math.min(1, Math.max(0, (x - low) / (high - low)));
}

/** `size` colours from one end of the map to the other, four bytes each. */
export function lookupTable(scale: Scale, size = 256): Uint8Array<ArrayBuffer> {
  const table = new Uint8Array(4 * size);
  for (let i = 0; i < size; i++) {
    const [r, g, b] = scale.colour(i / (size - 1));
    table.set([Math.round(255 * r), Math.round(255 * g), Math.round(255 * b), 255], 4 * i);
  }
  return table;
}

export function cssColour([r, g, b]: Rgb): string {
  return `rgb(${Math.round(255 * r)} ${Math.round(255 * g)} ${Math.round(255 * b)})`;
}

/** Reads `#rrggbb` and `rgb(r, g, b)`. */
export function parseColour(text: string): Rgb {
  const hex = /^#([0-9a-f]{6})$/i.exec(text.trim());
  if (hex) {
    const value = Number.parseInt(hex[1]!, 16);
    return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
  }
  const [r, g, b] = (text.match(/[\d.]+/g) ?? []).map(Number);
  if (r === undefined || g === undefined || b === undefined) throw new Error(`not a colour: "${text}"`);
  return [r / 255, g / 255, b / 255];
}

export function mix(a: Rgb, b: Rgb, t: number): Rgb {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

/** A logarithmic map from one colour to another. */
export function blend(from: Rgb, to: Rgb, [low, high]: Ends): Scale {
  return { ...between([low, high]), logarithmic: true, colour: (t) => mix(from, to, t) };
}

/** Plasma, logarithmic. */
export function plasma({ dark }: MapColours, ends: Ends): Scale {
  const [from, to] = dark ? PLASMA_DARK : PLASMA_LIGHT;
  const colour = (t: number) => parseColour(PLASMA[Math.round((from + (to - from) * t) * (PLASMA.length - 1))]!);
  return { ...between(ends), logarithmic: true, colour };
}

/** A diverging map: the middle keeps its colour wherever the ends are. */
export function diverging(
  [below, at, above]: readonly [Rgb, Rgb, Rgb],
  middle: number,
  ends: Ends,
  unit: string,
): Scale {
  const [low, high] = ends;
  const marked = [low, middle, high].filter((value) => low <= value && value <= high);
  return {
    low,
    high,
    logarithmic: false,
    shown: ends,
    ticks: [...new Set(marked)].map((value) => ({ value, label: endText(value) + unit })),
    colour: (t) => {
      const value = low + (high - low) * t;
      return low < middle && value <= middle
        ? mix(below, at, (value - low) / (middle - low))
        : mix(at, above, (value - middle) / (high - middle));
    },
  };
}

/** Two colours for 0 and 1, without a transition. */
export function noOrYes([no, yes]: readonly [Rgb, Rgb], labels: readonly [string, string]): Scale {
  return {
    low: 0,
    high: 1,
    logarithmic: false,
    shown: [0, 1],
    ticks: labels.map((label, value) => ({ value, label })),
    colour: (t) => (t > 0.5 ? yes : no),
  };
}

function between(ends: Ends): Pick<Scale, 'low' | 'high' | 'shown' | 'ticks'> {
  return { low: ends[0], high: ends[1], shown: ends, ticks: ends.map((value) => ({ value, label: endText(value) })) };
}

/** Colours of edges and vertices: what number gets what colour, for the view and for the legend alike. */
import { PLASMA } from 'virtual:plasma';
import type { ColourMap, Ends, Field } from '../document/document';
import { words } from '../language/language';

/** Red, green, blue in 0…1, as the screen takes them (sRGB). */
export type Rgb = readonly [number, number, number];

/** The colours of the theme that maps are made from; `style.css` holds them. */
export interface MapColours {
  /** The paper's blue and red. */
  good: Rgb;
  bad: Rgb;
  /** Corner angles: narrower than a right angle, right, wider. */
  narrow: Rgb;
  right: Rgb;
  wide: Rgb;
  /** Edges longer than they are to be; others take the colour of a right angle. */
  longer: Rgb;
  dark: boolean;
}

export interface Scale {
  title: string;
  /** Ends of the map: dL, an angle in degrees, or 0 and 1 for no and yes. Values beyond take the colour of the end. */
  low: number;
  high: number;
  logarithmic: boolean;
  /** What a legend shows; it may reach farther than the map tells apart. */
  shown: Ends;
  ticks: { value: number; label: string }[];
  /** `t` in 0…1 from one end to the other. */
  colour(t: number): Rgb;
}

/** Li et al. 2022 draw an edge blue below the threshold ε₃ = 1e-6 and red above twice that. */
const PAPER_BLUE = 1e-6;
const PAPER_RED = 2e-6;

/** Ends of the plasma map fade into a light or a dark page: cut them off. */
const PLASMA_LIGHT = [0, 0.78] as const;
const PLASMA_DARK = [0.36, 1] as const;

/** @param ends in place of the map's own. */
export function scaleOf(field: Field, map: ColourMap, colours: MapColours, ends?: Ends): Scale {
  if (field === 'longer') return longerScale(colours);
  if (field === 'angle') return angleScale(colours, ends);
  const scale = map === 'paper' ? paperScale(colours) : logScale(colours);
  if (ends === undefined) return scale;
  const ticks = ends.map((value) => ({ value, label: endText(value) }));
  return { ...scale, low: ends[0], high: ends[1], shown: ends, ticks };
}

/** As short as it can be read again. */
export function endText(value: number): string {
  const [plain, power] = [String(value), value.toExponential()];
  return power.length < plain.length ? power : plain;
}

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

function paperScale({ good, bad }: MapColours): Scale {
  return {
    title: words.legend.deviation,
    low: PAPER_BLUE,
    high: PAPER_RED,
    logarithmic: true,
    shown: [1e-9, 1e-3],
    ticks: [
      { value: 1e-9, label: '1e-9' },
      { value: PAPER_BLUE, label: '1e-6' },
      { value: 1e-3, label: '1e-3' },
    ],
    colour: (t) => mix(good, bad, t),
  };
}

function logScale({ dark }: MapColours): Scale {
  const [from, to] = dark ? PLASMA_DARK : PLASMA_LIGHT;
  return {
    title: words.legend.deviation,
    low: 1e-12,
    high: 1e-1,
    logarithmic: true,
    shown: [1e-12, 1e-1],
    ticks: [
      { value: 1e-12, label: '1e-12' },
      { value: 1e-6, label: '1e-6' },
      { value: 1e-1, label: '0.1' },
    ],
    colour: (t) => parseColour(PLASMA[Math.round((from + (to - from) * t) * (PLASMA.length - 1))]!),
  };
}

/** Wherever the ends are, a right angle keeps its colour. */
function angleScale({ narrow, right, wide }: MapColours, ends: Ends = [45, 135]): Scale {
  const [low, high] = ends;
  const marked = [low, 90, high].filter((value) => low <= value && value <= high);
  return {
    title: words.legend.angle,
    low,
    high,
    logarithmic: false,
    shown: ends,
    ticks: [...new Set(marked)].map((value) => ({ value, label: `${endText(value)}°` })),
    colour: (t) => {
      const value = low + (high - low) * t;
      return low < 90 && value <= 90
        ? mix(narrow, right, (value - low) / (90 - low))
        : mix(right, wide, (value - 90) / (high - 90));
    },
  };
}

/** Two colours and nothing between them. */
function longerScale({ right, longer }: MapColours): Scale {
  return {
    title: words.legend.longer,
    low: 0,
    high: 1,
    logarithmic: false,
    shown: [0, 1],
    ticks: [
      { value: 0, label: words.legend.notLonger },
      { value: 1, label: words.legend.isLonger },
    ],
    colour: (t) => (t > 0.5 ? longer : right),
  };
}

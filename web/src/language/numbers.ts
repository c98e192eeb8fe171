/** Numbers as people read them. */
import { words } from './language';

/** Below this a deviation is the rounding of the computer, not of the net. */
export const ROUNDING = 1e-16;

/** A small number with two digits, e.g. 4.2e-7; from 100 on it has all before the point. */
export function small(value: number): string {
  if (value === 0) return '0';
  if (value <= -ROUNDING) return `-${small(-value)}`;
  if (value < ROUNDING) return '< 1e-16';
  if (!Number.isFinite(value)) return '∞';
  return value >= 0.01 && value < 1000
    ? String(Number(value.toPrecision(value < 100 ? 2 : 3)))
    : value.toExponential(1);
}

/** By how much of its length an edge of deviation dL is too long, in percent: dL = r + 1 / r − 2 for 1 + that. */
export function lengthError(deviation: number): string {
  const percent = 100 * (deviation / 2 + Math.sqrt(deviation + deviation ** 2 / 4));
  return `${Number(percent.toPrecision(2))}\u00a0%`;
}

/** Two numbers with three digits, or six where three do not tell them apart. */
export function apart(a: number, b: number): [string, string] {
  const digits = a.toPrecision(3) === b.toPrecision(3) ? 6 : 3;
  return [a.toPrecision(digits), b.toPrecision(digits)];
}

/** Of a length, as a field has them: five, since an edge of a finished net is off its length by a thousandth at most. */
export function lengthDigits(length: number): string {
  return String(Number(length.toPrecision(5)));
}

/** Stands for a number that there is not. */
export const NOTHING = '–';

export function count(value: number): string {
  return value.toLocaleString(words.locale);
}

/** How long edges are, in lengths as they were made. */
export function lengthText(scale: number): string {
  const percent = Number((100 * scale - 100).toFixed(1));
  return percent === 0 ? words.behaviour.asMade : words.behaviour.growth(percent);
}

/** Of corners: no quad shears further. */
export function limitText(degrees: number): string {
  return degrees === 0 ? words.behaviour.off : words.behaviour.degrees(degrees);
}

/** Three digits, and no more decimals than a clock in a browser is good for. */
export function milliseconds(value: number): string {
  return value < 99.95 ? value.toFixed(1) : value.toFixed(0);
}

/** With its unit. */
export function duration(ms: number): string {
  return ms < 999.5 ? `${milliseconds(ms)} ms` : `${(ms / 1000).toFixed(1)} s`;
}

/** A coordinate, to a ten-thousandth of an edge. */
export function coordinate(value: number, edgeLength: number): string {
  const decimals = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(edgeLength))));
  return String(Number(value.toFixed(decimals)));
}

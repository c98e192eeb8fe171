import { describe, expect, test } from 'vitest';
import type { MapColours, Rgb } from '../../web/src/fields/colour_map';
import { cssColour, endText, lookupTable, mix, parseColour, positionOn } from '../../web/src/fields/colour_map';
import { FIELD_NAMES, fieldOf, scaleOf } from '../../web/src/fields/fields';

const COLOURS: MapColours = {
  good: [0, 0, 1],
  bad: [1, 0, 0],
  warn: [1, 1, 0],
  narrow: [0, 1, 1],
  right: [0.5, 0.5, 0.5],
  wide: [1, 0.5, 0],
  longer: [1, 0, 1],
  dark: false,
};

const paper = fieldOf('deviation').scale(COLOURS, 'paper');
const log = fieldOf('deviation').scale(COLOURS, 'log');
const angle = fieldOf('angle').scale(COLOURS, 'paper');
const colourOf = (scale: typeof paper, value: number) => scale.colour(positionOn(scale, value));

describe("the paper's map", () => {
  test.each([0, 1e-20, 1e-7, 1e-6])('%d is blue', (dL) => expect(colourOf(paper, dL)).toEqual(COLOURS.good));
  test.each([2e-6, 1e-5, 3, Infinity])('%d is red', (dL) => expect(colourOf(paper, dL)).toEqual(COLOURS.bad));
  test('in between it blends', () => {
    const [red, green, blue] = colourOf(paper, Math.SQRT2 * 1e-6);
    expect(red).toBeCloseTo(0.5);
    expect(green).toBe(0);
    expect(blue).toBeCloseTo(0.5);
  });
});

describe('the logarithmic map', () => {
  test('goes evenly by decades from 1e-12 to 1e-1', () => {
    expect([0, 1e-12, 1e-1, 5].map((dL) => positionOn(log, dL))).toEqual([0, 0, 1, 1]);
    expect(positionOn(log, 10 ** -6.5)).toBeCloseTo(0.5);
  });
  test('keeps off the colours of the page, light or dark', () => {
    const lightness = (dark: boolean) => {
      const scale = fieldOf('deviation').scale({ ...COLOURS, dark }, 'log');
      return Array.from({ length: 50 }, (_, i) => scale.colour(i / 49)).map(
        ([r, g, b]) => 0.21 * r + 0.72 * g + 0.07 * b,
      );
    };
    expect(Math.max(...lightness(false))).toBeLessThan(0.75);
    expect(Math.min(...lightness(true))).toBeGreaterThan(0.2);
  });
});

test('a right angle has the middle colour, others lean to either side', () => {
  expect(colourOf(angle, 90)).toEqual(COLOURS.right);
  expect(colourOf(angle, 10)).toEqual(COLOURS.narrow);
  expect(colourOf(angle, 170)).toEqual(COLOURS.wide);
});

test('shear is the further from blue, by yellow, to red the sharper a corner', () => {
  const shear = fieldOf('shear').scale(COLOURS, 'paper');
  expect([0, 30, 60, 80].map((degrees) => colourOf(shear, degrees))).toEqual(
    [COLOURS.good, COLOURS.warn, COLOURS.bad, COLOURS.bad].map(([r, g, b]) => [r, g, b].map((c) => expect.closeTo(c))),
  );
});

test('shear is red where a corner comes to its own limit, which the legend names', () => {
  const shown = (cornerLimit?: number) => scaleOf({ field: 'shear', colourMap: 'paper', cornerLimit }, COLOURS);
  expect(shown().ticks.map(({ label }) => label)).toEqual(['0°', 'warn 30°', 'limit 60°']);
  expect(shown(45).ticks.map(({ label }) => label)).toEqual(['0°', 'warn 22.5°', 'limit 45°']);
  expect(colourOf(shown(45), 45)).toEqual(COLOURS.bad);
  expect(shown(0).ticks.map(({ label }) => label)).toEqual(['0°', '45°', '90°']);
});

test('an edge pulls or pushes', () => {
  const force = fieldOf('force').scale(COLOURS, 'paper');
  expect([-1, 0, 1].map((value) => colourOf(force, value))).toEqual([COLOURS.bad, COLOURS.right, COLOURS.good]);
});

test('an edge is longer than it is to be, or not', () => {
  const longer = fieldOf('longer').scale(COLOURS, 'paper');
  expect([0, 1].map((value) => colourOf(longer, value))).toEqual([COLOURS.right, COLOURS.longer]);
});

describe('with ends set by hand', () => {
  test.each(['paper', 'log'] as const)('the %s map goes from one to the other by decades', (map) => {
    const scale = fieldOf('deviation').scale(COLOURS, map, [1e-8, 1e-4]);
    expect([1e-9, 1e-8, 1e-6, 1e-4, 1].map((dL) => positionOn(scale, dL))).toEqual([0, 0, expect.closeTo(0.5), 1, 1]);
    expect(colourOf(scale, 1e-8)).toEqual((map === 'paper' ? paper : log).colour(0));
    expect(scale.ticks.map(({ label }) => label)).toEqual(['dL 1e-8', 'dL 1e-4']);
  });

  test.each([
    [80, 90],
    [60, 100],
    [90, 95],
    [100, 110],
    [10, 20],
  ])('from %d to %d degrees a right angle would keep its colour', (...ends) => {
    const scale = fieldOf('angle').scale(COLOURS, 'paper', ends);
    if (ends[0] <= 90 && 90 <= ends[1]) expect(colourOf(scale, 90)).toEqual(COLOURS.right);
    if (ends[0] < 90) expect(colourOf(scale, ends[0])).toEqual(COLOURS.narrow);
    if (ends[1] > 90) expect(colourOf(scale, ends[1])).toEqual(COLOURS.wide);
    expect(lookupTable(scale).every((byte) => byte >= 0)).toBe(true);
  });

  test('what is written can be read again', () => {
    for (const value of [1e-6, 2.5e-12, 0.1, 0.025, 45, 123.456]) expect(Number(endText(value))).toBe(value);
    expect([1e-6, 0.1, 45].map(endText)).toEqual(['1e-6', '0.1', '45']);
  });
});

test('every tick lies on the legend', () => {
  for (const { ticks, shown } of [
    ...FIELD_NAMES.map((name) => fieldOf(name).scale(COLOURS, 'paper')),
    log,
    fieldOf('angle').scale(COLOURS, 'paper', [80, 85]),
  ]) {
    for (const { value } of ticks) {
      expect(value).toBeGreaterThanOrEqual(shown[0]);
      expect(value).toBeLessThanOrEqual(shown[1]);
    }
  }
});

test('the table for the graphics card runs from one end to the other', () => {
  const table = lookupTable(paper, 3);
  expect([...table]).toEqual([0, 0, 255, 255, 128, 0, 128, 255, 255, 0, 0, 255]);
});

test('colours are read and written', () => {
  const blue: Rgb = [36 / 255, 87 / 255, 197 / 255];
  expect(parseColour(' #2457c5')).toEqual(blue);
  expect(parseColour('rgb(36, 87, 197)')).toEqual(blue);
  expect(cssColour(blue)).toBe('rgb(36 87 197)');
  expect(mix([0, 0, 0], [1, 1, 1], 0.25)).toEqual([0.25, 0.25, 0.25]);
  expect(() => parseColour('sky')).toThrow(/sky/);
});

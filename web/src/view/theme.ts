/** The view's colours, read from the page's style sheet so that there is one place to change them. */
import { type MapColours, parseColour, type Rgb } from '../fields/colour_map';

export interface Theme extends MapColours {
  accent: Rgb;
  anchor: Rgb;
  ink: Rgb;
  /** Colour that far lines fade towards, and how much. */
  fade: Rgb;
  fadeShare: number;
  faceLight: Rgb;
  faceDark: Rgb;
  shadow: Rgb;
  shadowShare: number;
  grid: Rgb;
  axes: readonly [Rgb, Rgb, Rgb];
}

const DARK = '(prefers-color-scheme: dark)';

/** Normalises a CSS colour to #rrggbb by way of a canvas: the build shortens colours in different ways. */
const speller = document.createElement('canvas').getContext('2d')!;

export function readTheme(element: Element): Theme {
  const style = getComputedStyle(element);
  const text = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const colour = (name: string) => {
    speller.fillStyle = text(name);
    return parseColour(speller.fillStyle);
  };
  return {
    dark: matchMedia(DARK).matches,
    good: colour('map-good'),
    bad: colour('map-bad'),
    warn: colour('map-warn'),
    narrow: colour('map-narrow'),
    right: colour('map-right'),
    wide: colour('map-wide'),
    longer: colour('map-longer'),
    accent: colour('accent'),
    anchor: colour('view-anchor'),
    ink: colour('ink'),
    fade: colour('view-fade'),
    fadeShare: Number(text('view-fade-share')),
    faceLight: colour('view-face-light'),
    faceDark: colour('view-face-dark'),
    shadow: colour('view-shadow'),
    shadowShare: Number(text('view-shadow-share')),
    grid: colour('view-grid'),
    axes: [colour('view-x'), colour('view-y'), colour('view-z')],
  };
}

/** Calls back when the system turns dark or light; returns how to stop that. */
export function onThemeChange(changed: () => void): () => void {
  const query = matchMedia(DARK);
  query.addEventListener('change', changed);
  return () => query.removeEventListener('change', changed);
}

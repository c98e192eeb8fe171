/** A Vite plugin for the colours of one map, of the hundred in its library. */
import { interpolatePlasma } from 'd3-scale-chromatic';
import type { Plugin } from 'vite';

/** `virtual:plasma`: the colours as `PLASMA`, from low to high. */
export function plasma(): Plugin {
  const colours = Array.from({ length: 256 }, (_, i) => interpolatePlasma(i / 255));
  return {
    name: 'plasma',
    resolveId: (id) => (id === 'virtual:plasma' ? '\0plasma' : null),
    load: (id) => (id === '\0plasma' ? `export const PLASMA = '${colours.join('')}'.match(/#.{6}/g);` : null),
  };
}

/** How the files of a net are called. */
import type { NetSource } from './document';

/** After the shape of a recipe or the file that was opened. */
export function baseNameOf(net: NetSource): string {
  return ('recipe' in net ? net.recipe.split(':')[0] : net.name.replace(/\.(obj|ply|off)$/i, '')) || 'net';
}

export function fileNameOf(net: NetSource, extension: string): string {
  return `${baseNameOf(net)}.${extension}`;
}

/** How the files of a net are called. */
import type { FormatInfo } from '../../../wasm/chebnet';
import type { NetSource } from '../document/document';
import { MODEL_FORMATS } from './model_formats';

/** After the shape of a recipe or the file that was opened. */
export function baseNameOf(net: NetSource, formats: readonly FormatInfo[]): string {
  return ('recipe' in net ? net.recipe.split(':')[0] : withoutExtension(net.name, formats)) || 'net';
}

export function fileNameOf(net: NetSource, extension: string, formats: readonly FormatInfo[]): string {
  return `${baseNameOf(net, formats)}.${extension}`;
}

/** Without what file systems refuse. */
export function asFileName(title: string): string {
  return title
    .replace(/[\\/:*?"<>|\p{Cc}]/gu, ' ')
    .replace(/^[\s.]+/, '')
    .trim();
}

function withoutExtension(file: string, formats: readonly FormatInfo[]): string {
  const extensions = [...formats.map(({ name }) => name), ...MODEL_FORMATS.flatMap((format) => format.extensions)];
  const ending = extensions.map((each) => `.${each}`).find((each) => file.toLowerCase().endsWith(each));
  return ending ? file.slice(0, -ending.length) : file;
}

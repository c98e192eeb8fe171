/** As what a net leaves the page. */
import type { NetSource } from '../document/document';
import type { ExportFormat } from '../worker/protocol';

/** `png`: the picture; all others the core and the worker write. */
export type FileKind = ExportFormat | 'png';

export interface ExportKind {
  kind: FileKind;
  type: string;
}

export const EXPORT_KINDS: readonly ExportKind[] = [
  { kind: 'obj', type: 'model/obj' },
  { kind: 'ply', type: 'application/octet-stream' },
  { kind: 'off', type: 'text/plain' },
  { kind: 'stl', type: 'model/stl' },
  { kind: 'csv', type: 'text/csv' },
  { kind: 'png', type: 'image/png' },
];

export function typeOf(kind: FileKind): string {
  return EXPORT_KINDS.find((each) => each.kind === kind)?.type ?? '';
}

export function fileNameOf(net: NetSource, kind: FileKind): string {
  return `${baseNameOf(net)}.${kind}`;
}

/** After the shape of a recipe or the file that was opened. */
export function baseNameOf(net: NetSource): string {
  const name = 'recipe' in net ? net.recipe.split(':')[0] : net.name.replace(/\.(obj|ply|off)$/i, '');
  return name || 'net';
}

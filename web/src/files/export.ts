/** As what a net leaves the page. */
import type { NetSource } from '../document/document';
import type { ExportFormat } from '../worker/protocol';

/** `png`: the picture; all others the core and the worker write. */
export type FileKind = ExportFormat | 'png';

export interface ExportKind {
  kind: FileKind;
  hint: string;
  type: string;
}

export const EXPORT_KINDS: readonly ExportKind[] = [
  { kind: 'obj', hint: 'for Rhino and Blender', type: 'model/obj' },
  { kind: 'ply', hint: 'binary, every digit', type: 'application/octet-stream' },
  { kind: 'off', hint: 'plain text', type: 'text/plain' },
  { kind: 'stl', hint: 'triangles, for printing', type: 'model/stl' },
  { kind: 'csv', hint: 'edges and their lengths', type: 'text/csv' },
  { kind: 'png', hint: 'picture without background', type: 'image/png' },
];

export function typeOf(kind: FileKind): string {
  return EXPORT_KINDS.find((each) => each.kind === kind)?.type ?? '';
}

/** After the shape of a recipe or the file that was opened. */
export function fileNameOf(net: NetSource, kind: FileKind): string {
  const name = 'recipe' in net ? net.recipe.split(':')[0] : net.name.replace(/\.(obj|ply|off)$/i, '');
  return `${name || 'net'}.${kind}`;
}

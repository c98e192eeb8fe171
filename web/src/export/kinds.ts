/** As what a net leaves the page. */
import type { ExportFormat } from '../worker/protocol';

/** Those that the export worker makes; the core writes the others, and the view gives `png`. */
export type MadeKind = '3dm' | 'glb' | 'svg';
export type FileKind = ExportFormat | MadeKind | 'png';

/** What a user wants saved, and how. */
export interface SaveWish {
  kind: FileKind;
  /** Of the pattern: how long an edge is drawn. */
  edgeMm: number;
  /** Of the picture: how many times the pixels of the screen. */
  magnification: number;
}

const TYPES: Record<FileKind, string> = {
  obj: 'model/obj',
  '3dm': 'model/vnd.3dm',
  ply: 'application/octet-stream',
  off: 'text/plain',
  stl: 'model/stl',
  glb: 'model/gltf-binary',
  svg: 'image/svg+xml',
  csv: 'text/csv',
  png: 'image/png',
};

export function typeOf(kind: FileKind): string {
  return TYPES[kind];
}

/** What page and export worker say to each other: one job, one answer. */
import type { Painted } from './glb';
import type { Drawing } from './pattern_svg';
import type { RhinoNet } from './rhino_file';

export type ExportJob = ({ kind: 'glb' } & Painted) | ({ kind: '3dm' } & RhinoNet) | ({ kind: 'svg' } & Drawing);

export type ExportAnswer =
  | { bytes: Uint8Array<ArrayBuffer> }
  /** A fault. */
  | { message: string };

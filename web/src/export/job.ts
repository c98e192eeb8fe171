/** What page and export worker say to each other: one job, one answer. */
import type { VertexLists } from '../../../wasm/chebnet';
import type { HandleData } from '../document/document';
import type { LengthNet, PatternFault } from './flat_pattern';
import type { Painted } from './glb';
import type { RhinoNet } from './rhino_file';

export type ExportJob =
  | ({ kind: 'glb' } & Painted)
  | ({ kind: '3dm' } & RhinoNet)
  | { kind: 'svg'; mesh: LengthNet; lines: VertexLists; handles: readonly HandleData[]; name: string; edgeMm: number };

export type ExportAnswer =
  | { bytes: Uint8Array<ArrayBuffer> }
  /** The net has no flat pattern. */
  | { fault: PatternFault }
  /** Something is broken. */
  | { message: string };

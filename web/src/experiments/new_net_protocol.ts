/** Messages between page and worker of figure 3: one request, then news until the end. To cancel is to terminate the worker. */
import type { SolverSettings } from '../document/document';
import type { EditScene } from './edits';

export interface NewNetRequest {
  edits: EditScene[];
  /** By which the net of each is edited. */
  ways: SolverSettings[];
  /** By which its surface alone is deformed, for a new net. */
  deforming: SolverSettings;
}

/** A net after an edit. */
export interface MadeNet {
  milliseconds: number;
  singularVertices: number;
  /** Mean distance from the deformed surface, in edge lengths of the net that was edited. */
  distance: number;
}

/** Of one edit. */
export interface TriedEdit {
  /** In the order of the ways. */
  edited: MadeNet[];
  /** Milliseconds with those of deforming the surface. A sentence: why there is none. */
  made: MadeNet | string;
}

export type NewNetResponse =
  /** `done` of the edit, 0 … 1; the net is edited, or a new one made. */
  | { type: 'progress'; edit: number; makes: boolean; done: number }
  | { type: 'tried'; edit: number; tried: TriedEdit }
  | { type: 'ended' }
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

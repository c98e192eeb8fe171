/** Messages between page and equalizing worker: one request, then news until the end. To cancel is to terminate the worker. */
import type { EqualizeOptions, EqualizeReport, Mesh } from '../../../wasm/chebnet';
import type { GuideSource } from '../document/document';

export interface EqualizeRequest {
  mesh: Mesh;
  options: EqualizeOptions;
  /** Near which it is to come; without one, near the mesh's own surface. */
  guide?: GuideSource | undefined;
}

/** Progress, and the present net. */
export interface EqualizeNews {
  report: EqualizeReport;
  positions: Float64Array;
}

export interface EqualizeEnd extends EqualizeNews {
  /** Where the vertices of the surface lie that the net is near; null if the faces are no surface. */
  surfacePositions: Float64Array | null;
}

export type EqualizeResponse =
  | ({ type: 'news' } & EqualizeNews)
  | ({ type: 'ended' } & EqualizeEnd)
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

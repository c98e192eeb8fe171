/** What page and equalizing worker say to each other: one request, then news until the end. Whoever wants no more of it ends
 *  the worker. */
import type { EqualizeOptions, EqualizeReport, Mesh } from '../../../wasm/chebnet';

export interface EqualizeRequest {
  mesh: Mesh;
  options: EqualizeOptions;
}

/** How far it is, and the net held at the moment. */
export interface EqualizeNews {
  report: EqualizeReport;
  positions: Float64Array;
}

export type EqualizeResponse =
  | ({ type: 'news' } & EqualizeNews)
  | ({ type: 'ended' } & EqualizeNews)
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

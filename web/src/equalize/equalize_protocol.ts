/** Messages between page and equalizing worker: one request, then news until the end. To cancel is to terminate the worker. */
import type { EqualizeOptions, EqualizeReport, Mesh } from '../../../wasm/chebnet';

export interface EqualizeRequest {
  mesh: Mesh;
  options: EqualizeOptions;
}

/** Progress, and the present net. */
export interface EqualizeNews {
  report: EqualizeReport;
  positions: Float64Array;
}

export type EqualizeResponse =
  | ({ type: 'news' } & EqualizeNews)
  | ({ type: 'ended' } & EqualizeNews)
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

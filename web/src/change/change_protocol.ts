/** Messages between page and changing worker: one request, then news until the end. To cancel is to terminate the worker. */
import type { ChangePlace, Mesh, NetChange } from '../../../wasm/chebnet';

/** Other faces; or the same net of another size. */
export type Way = NetChange | 'resize';

export interface ChangeRequest {
  /** The net where it stands. */
  mesh: Mesh;
  way: Way;
  place: ChangePlace;
  /** With `resize`: how many times as large the net is to be. */
  factor: number;
  /** Of all edges of the net; null: each has its own, and keeps what comes of it. */
  length: number | null;
  /** Vertices that stay where they are, if a net can be found so. */
  held: readonly number[];
  /** See EqualizeOptions. */
  shearLimit?: number;
}

/** The net that is found, every edge with its length. */
export interface ChangedNet {
  mesh: Mesh;
  /** Of each vertex the one that it was; -1: it is new. */
  origins: Int32Array;
  /** How many pieces that no edge joins. */
  pieces: number;
  /** Corners are sharper than the limit: within it no net was found. */
  sharp: boolean;
}

export type ChangeResponse =
  | { type: 'news'; iterations: number }
  /** Null: no net was found near this shape whose edges have one length. */
  | { type: 'ended'; changed: ChangedNet | null }
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

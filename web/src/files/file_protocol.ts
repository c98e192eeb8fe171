/** Messages between page and file worker; one request at a time. */
import type { Mesh } from '../../../wasm/chebnet';
import type { OpenedNet } from '../worker/protocol';
import type { FileReport } from './file_report';

/** Steps of reading a file, in this order. */
export const READ_STEPS = ['loading', 'reading', 'checking', 'measuring'] as const;
export type ReadStep = (typeof READ_STEPS)[number];

export type FileRequest =
  /** Answered with `report`, after news of the steps. `name` is what messages call the file. */
  | { type: 'read'; file: Blob; name: string }
  /** Then: the mesh as it was read, or repaired. Answered with `mesh`. */
  | { type: 'take'; repaired: boolean }
  /** The same as a net to be shown. Answered with `net`. */
  | { type: 'show'; repaired: boolean };

export type FileResponse =
  | { type: 'step'; step: ReadStep }
  | { type: 'report'; report: FileReport }
  | { type: 'mesh'; mesh: Mesh }
  | { type: 'net'; net: OpenedNet }
  /** `code` as in core/base/error.h. */
  | { type: 'error'; code: string; message: string };

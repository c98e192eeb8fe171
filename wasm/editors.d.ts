/** The core without files and equalising: what a page needs to show and edit a first net. */
import type { Editors } from './chebnet';

/** Loads the module once. In the browser give `wasmUrl`; elsewhere `wasmBinary`. */
export function loadEditors(source: { wasmUrl?: string; wasmBinary?: ArrayBuffer | Uint8Array }): Promise<Editors>;

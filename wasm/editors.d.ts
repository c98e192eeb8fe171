/**
 * As much of the core as a page needs to show and edit a first net: the shapes but those that are relaxed (`teddy`,
 * `rabbit`, `horse`, `jug`, `shirt`, and others with `smooth=1`), all tables, and the methods `projection`, `gauss_newton`,
 * `arap` and `local_global`. What else `Editors` has, other methods and files, is refused with the code "left_out" before it
 * changes anything; `loadChebnet` has it.
 */
import type { Editors } from './chebnet';

/** Loads the module once. In the browser give `wasmUrl`; elsewhere `wasmBinary`. */
export function loadEditors(source: { wasmUrl?: string; wasmBinary?: ArrayBuffer | Uint8Array }): Promise<Editors>;

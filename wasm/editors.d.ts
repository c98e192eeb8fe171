/**
 * As much of the core as a page needs to show and edit a first net: the shapes but those that are relaxed (`teddy`,
 * `rabbit`, `horse`, `jug`, `shirt`, and others with `smooth=1`), all tables, and the method `equilibrium`. What else
 * `Editors` has, other methods and files, is refused with the code "left_out" before it changes anything, and so is a
 * solve of which `equilibrium` would leave a part to `projection`: the editor's state is then what it was. `loadChebnet`
 * has it all.
 */
import type { Editors } from './chebnet';

/** Loads the module once. In the browser give `wasmUrl`; elsewhere `wasmBinary`. */
export function loadEditors(source: { wasmUrl?: string; wasmBinary?: ArrayBuffer | Uint8Array }): Promise<Editors>;

/** See wasm/keep_try_apart.mjs. Throws an Error for a module it cannot read. */
export function tryApart(module: Uint8Array): Uint8Array;

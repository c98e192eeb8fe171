/** Loads the whole core, when a request needs more than the core for a first net has. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import type { Chebnet } from '../../../wasm/chebnet';

export function loadWholeCore(): Promise<Chebnet> {
  return loadChebnet({ wasmUrl });
}

/** Comes when a net wants more than its first core has. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import type { Chebnet } from '../../../wasm/chebnet';

export function loadWholeCore(): Promise<Chebnet> {
  return loadChebnet({ wasmUrl });
}

/** What a request may need beyond the core for a first net: the whole core, and what works with it. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import type { Editors } from '../../../wasm/chebnet';
import { replay } from './replay';
import { Search } from './search';

export interface WholeCore {
  core: Editors;
  Search: typeof Search;
  replay: typeof replay;
}

export async function loadWholeCore(): Promise<WholeCore> {
  return { core: await loadChebnet({ wasmUrl }), Search, replay };
}

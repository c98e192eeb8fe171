/** The module worker for figure 3, with a core of its own. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import { tryNewNets } from './new_net';
import type { NewNetRequest, NewNetResponse } from './new_net_protocol';

function post(response: NewNetResponse): void {
  self.postMessage(response);
}

self.onmessage = async ({ data }: MessageEvent<NewNetRequest>) => {
  try {
    tryNewNets(await loadChebnet({ wasmUrl }), data, post);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: String(error) });
  }
};

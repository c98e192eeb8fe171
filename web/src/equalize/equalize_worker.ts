/** The module worker for equalising one mesh, with a core of its own. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import type { EqualizeRequest, EqualizeResponse } from './equalize_protocol';
import { equalize } from './equalize';

function post(response: EqualizeResponse): void {
  self.postMessage(response);
}

self.onmessage = async ({ data }: MessageEvent<EqualizeRequest>) => {
  try {
    equalize(await loadChebnet({ wasmUrl }), data, post);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: String(error) });
  }
};

/** The module worker for changing one net, with a core of its own. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import { changeNet } from './change_net';
import type { ChangeRequest, ChangeResponse } from './change_protocol';

function post(response: ChangeResponse): void {
  self.postMessage(response);
}

self.onmessage = async ({ data }: MessageEvent<ChangeRequest>) => {
  try {
    changeNet(await loadChebnet({ wasmUrl }), data, post);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: String(error) });
  }
};

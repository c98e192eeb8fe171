/** The module worker for nets on one surface after another, with a core of its own. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import { arrayBuffers } from '../worker/array_buffers';
import { Draper } from './draper';
import type { DrapeRequest, DrapeResponse } from './drape_protocol';

const draper = loadChebnet({ wasmUrl }).then((core) => new Draper(core, post));

function post(response: DrapeResponse): void {
  self.postMessage(response, { transfer: response.type === 'opened' ? arrayBuffers(response.surface) : [] });
}

self.onmessage = async ({ data }: MessageEvent<DrapeRequest>) => {
  try {
    (await draper).handle(data);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: String(error) });
  }
};

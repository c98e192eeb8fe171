/** The module worker for one file: loads a core of its own and passes requests to a FileImporter. */
import rhinoUrl from 'rhino3dm/rhino3dm.wasm?url';
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import { arrayBuffers } from '../worker/array_buffers';
import type { FileRequest, FileResponse } from './file_protocol';
import { FileImporter } from './file_importer';

const importer = loadChebnet({ wasmUrl }).then((core) => new FileImporter(core, post, rhinoUrl));

function post(response: FileResponse): void {
  self.postMessage(response, { transfer: response.type === 'mesh' ? arrayBuffers(response.mesh) : [] });
}

self.onmessage = async ({ data }: MessageEvent<FileRequest>) => {
  try {
    await (await importer).handle(data);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: `The file could not be read: ${String(error)}` });
  }
};

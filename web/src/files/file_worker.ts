/** The module worker for one file: loads a core of its own and lets a session answer. */
import wasmUrl from '../../../build/wasm/chebnet_core.wasm?url';
import { loadChebnet } from '../../../wasm/chebnet.js';
import type { FileRequest, FileResponse } from './file_protocol';
import { FileSession } from './file_session';

const session = loadChebnet({ wasmUrl }).then((core) => new FileSession(core, post));

function post(response: FileResponse): void {
  self.postMessage(response);
}

self.onmessage = async ({ data }: MessageEvent<FileRequest>) => {
  try {
    await (await session).handle(data);
  } catch (error) {
    post({ type: 'error', code: 'internal', message: `The file could not be read: ${String(error)}` });
  }
};

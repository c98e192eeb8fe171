/** Answers the requests of file_reading.ts, in the worker: reads one file, reports on it, and gives it as a mesh or a net. */
import type { Chebnet, Mesh } from '../../../wasm/chebnet';
import { describe } from '../worker/opened_net';
import type { FileRequest, FileResponse, ReadStep } from './file_protocol';
import { checkMesh, reportOf, withEditor } from './file_report';
import type { CheckedMesh, FileReport } from './file_report';
import { readModel } from './model';
import { withModelFormats } from './model_formats';
import { Failure, codeOf, messageOf } from '../failure';

export class FileImporter {
  readonly #core: Chebnet;
  readonly #post: (response: FileResponse) => void;
  readonly #rhinoUrl: string | undefined;
  #mesh: CheckedMesh | null = null;

  /** @param rhinoUrl see readModel. */
  constructor(core: Chebnet, post: (response: FileResponse) => void, rhinoUrl?: string) {
    this.#core = core;
    this.#post = post;
    this.#rhinoUrl = rhinoUrl;
  }

  async handle(request: FileRequest): Promise<void> {
    try {
      if (request.type === 'read') this.#post({ type: 'report', report: await this.#read(request.file, request.name) });
      // A copy, since its arrays are transferred to the page, and may be asked for again.
      else if (request.type === 'take')
        this.#post({ type: 'mesh', mesh: structuredClone(this.#take(request.repaired)) });
      else this.#post({ type: 'net', net: withEditor(this.#core, this.#take(request.repaired), describe) });
    } catch (error) {
      const code = codeOf(error);
      this.#post({ type: 'error', code, message: messageOf(error) });
    }
  }

  async #read(file: Blob, name: string): Promise<FileReport> {
    this.#begin('loading');
    const bytes = await bytesOf(file, name);
    this.#begin('reading');
    const model = await readModel(bytes, name, this.#rhinoUrl);
    const given = model?.mesh ?? this.#readMesh(bytes, name);
    this.#begin('checking');
    const mesh = inFile(name, () => checkMesh(this.#core, given));
    this.#begin('measuring');
    const report = inFile(name, () => reportOf(this.#core, mesh, model?.up));
    this.#mesh = mesh;
    return report;
  }

  #readMesh(bytes: Uint8Array, name: string): Mesh {
    try {
      return this.#core.readMesh(bytes, name);
    } catch (error) {
      throw new Failure(codeOf(error), withModelFormats(messageOf(error), this.#core.formats()), { cause: error });
    }
  }

  #take(repaired: boolean): Mesh {
    if (this.#mesh === null) throw new Failure('no_net', 'No file was read.');
    return repaired ? this.#mesh.repaired : this.#mesh.given;
  }

  #begin(step: ReadStep): void {
    this.#post({ type: 'step', step });
  }
}

async function bytesOf(file: Blob, name: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch {
    throw new Failure('file_access', `${name} could not be read; perhaps it is a folder.`);
  }
}

/** Errors about meshes do not name the file: adds its name. */
function inFile<T>(name: string, doing: () => T): T {
  try {
    return doing();
  } catch (error) {
    if (error instanceof Error && 'code' in error) throw new Failure(String(error.code), `${name}: ${error.message}`);
    throw error;
  }
}

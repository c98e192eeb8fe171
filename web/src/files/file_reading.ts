/** The page's side of the file worker. */
import type { Mesh } from '../../../wasm/chebnet';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import type { OpenedNet } from '../worker/protocol';
import type { FileRequest, FileResponse, ReadStep } from './file_protocol';
import type { FileReport } from './file_report';
import { Failure } from '../failure';

/** The part of a `Worker` that is used. */
export interface FileWorkerLike {
  postMessage(request: FileRequest): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FileResponse>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

interface Waiting {
  resolve(response: FileResponse): void;
  reject(error: Failure): void;
}

/**
 * A file being read, in a worker of its own: the open net can be edited meanwhile, and to cancel is to terminate the
 * worker.
 */
export class FileReading {
  readonly #worker: FileWorkerLike;
  #waiting: Waiting | null = null;
  readonly #stepBegan: (step: ReadStep) => void;

  constructor(spawn: () => FileWorkerLike, stepBegan: (step: ReadStep) => void) {
    this.#stepBegan = stepBegan;
    this.#worker = spawn();
    this.#worker.onmessage = ({ data }) => this.#receive(data);
    this.#worker.onerror = ({ message }) => this.#fail('internal', message || dialogWords.file.notStarted);
  }

  /** Throws Failure with what the core says. */
  async report(file: Blob, name: string): Promise<FileReport> {
    const response = await this.#ask({ type: 'read', file, name });
    if (response.type !== 'report') throw unexpected(response);
    return response.report;
  }

  /** After `report`: the mesh as it was read, or repaired. */
  async mesh(repaired: boolean): Promise<Mesh> {
    const response = await this.#ask({ type: 'take', repaired });
    if (response.type !== 'mesh') throw unexpected(response);
    return response.mesh;
  }

  /** Likewise, as a net to be shown. */
  async net(repaired: boolean): Promise<OpenedNet> {
    const response = await this.#ask({ type: 'show', repaired });
    if (response.type !== 'net') throw unexpected(response);
    return response.net;
  }

  /** At any time; pending promises then never settle. */
  close(): void {
    this.#worker.terminate();
  }

  #ask(request: FileRequest): Promise<FileResponse> {
    return new Promise((resolve, reject) => {
      this.#waiting = { resolve, reject };
      this.#worker.postMessage(request);
    });
  }

  #receive(response: FileResponse): void {
    if (response.type === 'step') this.#stepBegan(response.step);
    else if (response.type === 'error') this.#fail(response.code, sentenceOf(response));
    else this.#waiting?.resolve(response);
  }

  #fail(code: string, message: string): void {
    this.#waiting?.reject(new Failure(code, message));
  }
}

/** What is wrong with the file, and what helps. */
function sentenceOf({ code, message }: { code: string; message: string }): string {
  const { reason, unread, wayOut } = dialogWords.file;
  const { failure, sentence, sentences } = words.core;
  return sentences([sentence(unread(code) ?? failure(code, reason(message))), wayOut(code)]);
}

function unexpected({ type }: FileResponse): Failure {
  return new Failure('internal', `The file reader answered with "${type}".`);
}

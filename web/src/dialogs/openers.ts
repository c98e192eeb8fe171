/** The dialogs that open another net, from a file or by equalising. Loaded on demand. */
import type { FormatInfo } from '../../../wasm/chebnet';
import type { NetSource, Scene } from '../document/document';
import { equalizedScene, subjectOfNet } from '../equalize/subject';
import type { Subject } from '../equalize/subject';
import { EqualizeDialog } from './equalize_dialog';
import { FileDialog } from './file_dialog';
import { createView } from '../view/scene';
import type { Opening } from '../worker/opening';
import { FileOpener } from './file_opener';

/** The part of the app that they use. */
export interface OpenNet {
  readonly opening: Opening | null;
  /** The core's. */
  readonly formats: readonly FormatInfo[];
  openNet(net: NetSource): Promise<void>;
  openScene(scene: Scene): Promise<void>;
}

export class Openers {
  readonly #files: FileOpener;
  readonly #app: OpenNet;
  readonly #root: HTMLElement;

  /** @param root parent of the dialogs. */
  constructor(app: OpenNet, root: HTMLElement) {
    this.#app = app;
    this.#root = root;
    this.#files = new FileOpener({
      spawnWorker: () => new Worker(new URL('../files/file_worker.ts', import.meta.url), { type: 'module' }),
      createDialog: (name) => new FileDialog(root, name),
      createEqualizer: (subject) => this.#createEqualizer(subject),
      open: (net) => app.openNet(net),
    });
  }

  openFile(file: File): Promise<void> {
    return this.#files.open(file);
  }

  async equalizeNet(): Promise<void> {
    if (this.#app.opening === null) return;
    const { formats } = this.#app;
    const { document, net } = this.#app.opening;
    const mesh = await this.#createEqualizer(subjectOfNet(document, net, formats)).result;
    if (mesh !== null) await this.#app.openScene(equalizedScene(document, mesh, formats));
  }

  #createEqualizer(subject: Subject): EqualizeDialog {
    return new EqualizeDialog(this.#root, subject, {
      spawnWorker: () => new Worker(new URL('../equalize/equalize_worker.ts', import.meta.url), { type: 'module' }),
      createView,
      upAxis: this.#app.opening?.document.view.upAxis,
    });
  }
}

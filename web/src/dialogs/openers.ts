/** The dialogs that open another net, from a file, by equalising or on a surface. Loaded on demand. */
import type { FormatInfo } from '../../../wasm/chebnet';
import { freshScene } from '../document/defaults';
import type { NetSource, Scene, UpAxis } from '../document/document';
import { equalizedScene, subjectOfNet } from '../equalize/subject';
import type { Subject } from '../equalize/subject';
import { DrapeDialog } from './drape_dialog';
import type { GivenSurface } from './drape_dialog';
import { EqualizeDialog } from './equalize_dialog';
import { FileDialog } from './file_dialog';
import { createView } from '../view/scene';
import type { Opening } from '../worker/opening';
import { FileOpener } from './file_opener';
import type { TakenNet } from './file_opener';

/** The part of the app that they use. */
export interface OpenNet {
  readonly opening: Opening | null;
  /** The core's. */
  readonly formats: readonly FormatInfo[];
  openNet(net: NetSource, upAxis?: UpAxis): Promise<void>;
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
      createEqualizer: (subject, upAxis) => this.#createEqualizer(subject, upAxis),
      createDraper: (surface, upAxis) => this.#createDraper(surface, upAxis),
      open: (taken) => this.#open(taken),
    });
  }

  openFile(file: File): Promise<void> {
    return this.#files.open(file);
  }

  async equalizeNet(): Promise<void> {
    if (this.#app.opening === null) return;
    const { formats } = this.#app;
    const { document, net } = this.#app.opening;
    const mesh = await this.#createEqualizer(subjectOfNet(document, net, formats), document.view.upAxis).result;
    if (mesh !== null) await this.#app.openScene(equalizedScene(document, mesh, formats));
  }

  /** On one of our own surfaces. */
  async drapeNet(): Promise<void> {
    const taken = await this.#createDraper(null, 'z').result;
    if (taken !== null) await this.#open(taken);
  }

  async #open({ net, handles, guide, upAxis = 'z' }: TakenNet): Promise<void> {
    if (handles.length === 0 && guide === undefined) return this.#app.openNet(net, upAxis);
    const { document } = this.#app.opening ?? {};
    const { camera: _, upAxis: __, ...view } = document?.view ?? freshScene(net).view;
    await this.#app.openScene({
      ...freshScene(net),
      handles,
      ...(guide && { guide }),
      view: { ...view, ...(upAxis === 'y' && { upAxis }), camera: null },
    });
  }

  #createDraper(given: GivenSurface | null, upAxis: UpAxis): DrapeDialog {
    return new DrapeDialog(this.#root, given, {
      spawnWorker: () => new Worker(new URL('../drape/drape_worker.ts', import.meta.url), { type: 'module' }),
      upAxis,
    });
  }

  #createEqualizer(subject: Subject, upAxis: UpAxis | undefined): EqualizeDialog {
    return new EqualizeDialog(this.#root, subject, {
      spawnWorker: () => new Worker(new URL('../equalize/equalize_worker.ts', import.meta.url), { type: 'module' }),
      createView,
      upAxis,
    });
  }
}

/** Dialogs that lead to another net, from a file or by equalising, put together. They come when they are first wanted. */
import type { App } from '../app';
import { equalizedScene, subjectOfNet } from '../equalize/subject';
import type { Subject } from '../equalize/subject';
import { EqualizeDialog } from '../panels/equalize_dialog';
import { FileDialog } from '../panels/file_dialog';
import { createView } from '../view/scene';
import { FileOpener } from './import';

export class Openers {
  readonly #files: FileOpener;

  /** @param root where the dialogs stand. */
  constructor(
    private readonly app: App,
    private readonly root: HTMLElement,
  ) {
    this.#files = new FileOpener({
      spawnWorker: () => new Worker(new URL('./file_worker.ts', import.meta.url), { type: 'module' }),
      createDialog: (name) => new FileDialog(root, name),
      createEqualizer: (subject) => this.#createEqualizer(subject),
      open: (net) => app.openNet(net),
    });
  }

  openFile(file: File): Promise<void> {
    return this.#files.open(file);
  }

  async equalizeNet(): Promise<void> {
    if (this.app.opening === null) return;
    const { formats } = this.app;
    const { document, net } = this.app.opening;
    const obj = await this.#createEqualizer(subjectOfNet(document, net, formats)).result;
    if (obj !== null) await this.app.openScene(equalizedScene(document, obj, formats));
  }

  #createEqualizer(subject: Subject): EqualizeDialog {
    return new EqualizeDialog(this.root, subject, {
      spawnWorker: () => new Worker(new URL('../equalize/equalize_worker.ts', import.meta.url), { type: 'module' }),
      createView,
      upAxis: this.app.opening?.document.view.upAxis,
    });
  }
}

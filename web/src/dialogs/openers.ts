/** The dialogs that open another net, from a file, by equalising, on a surface or by a change of the present one. Loaded on
 *  demand. */
import type { FormatInfo } from '../../../wasm/chebnet';
import type { ChangedNet, ChangeRequest } from '../change/change_protocol';
import { Changing } from '../change/changing';
import { changedScene, nameOf, requestOf, resizedGuide, type WantedChange } from '../change/subject';
import type { NamedChange } from '../document/changes';
import { METHOD_AT_REST, MOST_VERTICES_AT_REST } from '../document/defaults';
import type { NetSource, Scene, UpAxis } from '../document/document';
import { equalizedScene, subjectOfNet } from '../equalize/subject';
import type { Subject } from '../equalize/subject';
import type { Choice } from '../handles/commands';
import { words } from '../language/language';
import { dialogWords } from '../language/dialogs';
import { count } from '../language/numbers';
import { ChangeDialog } from './change_dialog';
import { DrapeDialog } from './drape_dialog';
import type { GivenSurface } from './drape_dialog';
import { EqualizeDialog } from './equalize_dialog';
import { openTaken } from './taken_scene';
import { pickFile } from '../files/pick_file';
import { FileDialog } from './file_dialog';
import { lengthWords } from './file_words';
import { createView } from '../view/scene';
import type { Opening } from '../worker/opening';
import type { DrawnSurface } from '../worker/protocol';
import { codeOf, messageOf } from '../failure';
import { FileOpener } from './file_opener';
import type { TakenNet } from './file_opener';

/** The part of the app that they use. */
interface OpenNet {
  readonly opening: Opening | null;
  /** The same, for another to be made of it; fails where none is open, or another one is about to be. */
  netToChange(): Opening;
  /** The core's. */
  readonly formats: readonly FormatInfo[];
  openNet(net: NetSource, upAxis?: UpAxis): Promise<void>;
  openScene(scene: Scene, change?: NamedChange): Promise<void>;
  readonly handles: { readonly choice: Choice; guide(): Promise<DrawnSurface | null> };
  say(message: string): void;
  unsay(): void;
  readonly isSeenFromBehind: boolean;
  frameAll(from: 'here'): void;
}

export class Openers {
  readonly #files: FileOpener;
  readonly #app: OpenNet;
  readonly #root: HTMLElement;
  #isChanging = false;

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

  /** What was wrong with the one before is not to stand behind the questions about this one. */
  openFile(file: File): Promise<void> {
    this.#app.unsay();
    return this.#files.open(file);
  }

  async equalizeNet(): Promise<void> {
    const { formats } = this.#app;
    const opening = this.#app.netToChange();
    const { document, net } = opening;
    const subject = subjectOfNet(document, net, formats);
    const equalized = await this.#createEqualizer(subject, document.view.upAxis).result;
    if (equalized === null || !this.#isOpen(opening)) return;
    if (equalized === 'newNet') await this.#newNetOn(subject, document.view.upAxis);
    else {
      const scene = this.#fromSameSide(equalizedScene(document, equalized, formats));
      await this.#app.openScene(scene, { name: ['equalize'], key: null });
    }
  }

  async #newNetOn({ name, net, positions }: Subject, upAxis: UpAxis | undefined): Promise<void> {
    const { faceStart, faceVertices } = net;
    const mesh = { positions, faceStart, faceVertices };
    const taken = await this.#createDraper({ name, mesh }, upAxis ?? 'z').result;
    if (taken !== null) await this.#open(taken);
  }

  /** On one of our own surfaces, or on one from a file. */
  async drapeNet(): Promise<void> {
    let file: File | null = null;
    const draper = this.#createDraper(null, 'z', async () => {
      file = await pickFile(this.#app.formats, 'mesh');
      if (file !== null) draper.close();
    });
    const taken = await draper.result;
    if (file !== null) await this.openFile(file);
    else if (taken !== null) await this.#open(taken);
  }

  /** The net with other faces, in place of the one that is open. One change at a time: another would be of the same net.
   *  Resolves with whether it has been made. */
  async changeNet(wanted: WantedChange): Promise<boolean> {
    if (this.#isChanging) return false;
    this.#isChanging = true;
    try {
      return await this.#changeNet(wanted);
    } finally {
      this.#isChanging = false;
    }
  }

  async #changeNet(wanted: WantedChange): Promise<boolean> {
    const { formats } = this.#app;
    const opening = this.#app.netToChange();
    const request = requestOf(opening, wanted, this.#app.handles.choice.selection);
    const changed = await this.#changed(request);
    if (changed === null || !this.#isOpen(opening)) return false;
    const scene = this.#fromSameSide(changedScene(opening.document, request, changed, formats));
    const name = { name: nameOf(wanted.way), key: null };
    if (wanted.way === 'resize') {
      await this.#app.openScene(await this.#withResizedGuide(scene, request), name);
      this.#app.frameAll('here');
      this.#app.say(dialogWords.change.lengths(lengthWords(wanted.length)));
      return true;
    }
    await this.#app.openScene(scene, name);
    const lostHandles = opening.document.handles.length - scene.handles.length;
    const lostPieces = wanted.way === 'coarsen' ? opening.net.info.components - changed.pieces : 0;
    const { vertices, pieces, goneIfCoarser, sharp, lost, tooManyToRest, restsAgain } = dialogWords.change;
    const aboutMethod = scene.method === METHOD_AT_REST ? restsAgain : tooManyToRest;
    this.#app.say(
      words.core.sentences([
        vertices(count(changed.origins.length)),
        changed.pieces > 1 ? pieces(changed.pieces) : '',
        lostPieces > 0 ? goneIfCoarser(lostPieces) : '',
        changed.sharp ? sharp : '',
        lostHandles > 0 ? lost(lostHandles) : '',
        scene.method === opening.document.method ? '' : aboutMethod(count(MOST_VERTICES_AT_REST)),
      ]),
    );
    return true;
  }

  /** False: another net, which is not to be replaced, was opened meanwhile. Fails as well where one is about to be. */
  #isOpen({ document }: Opening): boolean {
    return this.#app.netToChange().document.net === document.net;
  }

  /** A net made of the present one is seen as that is. */
  #fromSameSide(scene: Scene): Scene {
    return { ...scene, view: { ...scene.view, behind: this.#app.isSeenFromBehind } };
  }

  async #withResizedGuide(scene: Scene, request: ChangeRequest): Promise<Scene> {
    const drawn = scene.guide && (await this.#app.handles.guide());
    return scene.guide && drawn ? { ...scene, guide: resizedGuide(scene.guide, drawn, request) } : scene;
  }

  /** Null: it was stopped, or the net does not allow it, and why is said. */
  async #changed(request: ChangeRequest): Promise<ChangedNet | null> {
    const dialog = new ChangeDialog(this.#root);
    const worker = new Worker(new URL('../change/change_worker.ts', import.meta.url), { type: 'module' });
    try {
      return await dialog.until(new Changing(worker, request, (iterations) => dialog.setProgress(iterations)));
    } catch (error) {
      if (codeOf(error) !== 'impossible_change') throw error;
      this.#app.say(words.core.sentence(messageOf(error)));
      return null;
    }
  }

  async #open(taken: TakenNet): Promise<void> {
    if (taken.handles.length === 0 && taken.guide === undefined)
      return this.#app.openNet(taken.net, taken.upAxis ?? 'z');
    await openTaken(this.#app, taken);
  }

  #createDraper(given: GivenSurface | null, upAxis: UpAxis, fileWanted?: () => Promise<void>): DrapeDialog {
    return new DrapeDialog(this.#root, given, {
      spawnWorker: () => new Worker(new URL('../drape/drape_worker.ts', import.meta.url), { type: 'module' }),
      upAxis,
      ...(fileWanted && { fileWanted: () => void fileWanted() }),
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

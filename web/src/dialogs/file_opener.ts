/** Opens nets from files: reads one in a worker, asks the user how to open it, and passes it on. */
import type { Mesh, RestLengths } from '../../../wasm/chebnet';
import type { GuideSource, HandleSeed, NetSource, UpAxis } from '../document/document';
import { dialogWords } from '../language/dialogs';
import type { Equalized, Subject } from '../equalize/subject';
import type { OpenedNet } from '../worker/protocol';
import type { ReadStep } from '../files/file_protocol';
import { FileReading } from '../files/file_reading';
import type { FileWorkerLike } from '../files/file_reading';
import type { FileReport } from '../files/file_report';
import { Failure } from '../failure';

/** Larger files are not nets one could edit: a net of 100,000 vertices has 10 MB. */
export const LARGEST_FILE = 100e6;

/** How a user wants a file to be opened. */
export interface FileChoice {
  repaired: boolean;
  /** `equalized`: as a net near it whose edges have one length; `draped`: as a surface, on which a net is laid. */
  restLengths: RestLengths | 'equalized' | 'draped';
  /** z unless it says y. */
  upAxis?: UpAxis;
}

/** The dialog with progress and questions. */
export interface FileDialogLike {
  setStep(step: ReadStep): void;
  /** Resolves when the user has chosen; may be asked again. */
  ask(report: FileReport): Promise<FileChoice>;
  /** Resolves when the user cancels, or `close` is called. */
  readonly closed: Promise<null>;
  close(): void;
}

/** The net that the user takes, or null; `newNet`: another one, on the surface of the mesh. */
export type EqualizerEnd = Equalized | 'newNet' | null;

/** The dialog that equalises a net. */
export interface EqualizerLike {
  readonly result: Promise<EqualizerEnd>;
  close(): void;
}

/** The dialog that lays a net on a surface. */
export interface DraperLike {
  /** The net that the user takes, or null. */
  readonly result: Promise<TakenNet | null>;
  close(): void;
}

/** A net that is taken, and handles to begin with. */
export interface TakenNet {
  net: NetSource;
  handles: HandleSeed[];
  /** The surface that it was laid on, or near which it was equalised. */
  guide?: GuideSource;
  upAxis?: UpAxis;
}

interface OpenerParts {
  spawnWorker(): FileWorkerLike;
  createDialog(name: string): FileDialogLike;
  createEqualizer(subject: Subject, upAxis: UpAxis): EqualizerLike;
  createDraper(surface: { name: string; mesh: Mesh }, upAxis: UpAxis): DraperLike;
  open(taken: TakenNet): Promise<void>;
}

/** One file at a time: the next one takes the place of one that is still being read or asked about. */
export class FileOpener {
  #dialog: FileDialogLike | null = null;
  readonly #parts: OpenerParts;

  constructor(parts: OpenerParts) {
    this.#parts = parts;
  }

  /** Resolves when the net is open or the user has given up. Fails with what is wrong with the file. */
  async open(file: File): Promise<void> {
    checkSize(file);
    this.#dialog?.close();
    const dialog = this.#parts.createDialog(file.name);
    this.#dialog = dialog;
    const reading = new FileReading(
      () => this.#parts.spawnWorker(),
      (step) => dialog.setStep(step),
    );
    try {
      const taken = await Promise.race([this.#readAndAsk(reading, file, dialog), dialog.closed]);
      if (taken === null) return;
      dialog.close();
      await this.#parts.open(taken);
    } finally {
      reading.close();
      dialog.close();
    }
  }

  async #readAndAsk(reading: FileReading, file: File, dialog: FileDialogLike): Promise<TakenNet> {
    const { name } = file;
    const report = await reading.report(file, name);
    for (;;) {
      const { repaired, restLengths, upAxis = 'z' } = await dialog.ask(report);
      if (restLengths !== 'draped' && restLengths !== 'equalized')
        return { net: { mesh: await reading.mesh(repaired), name, restLengths }, handles: [], upAxis };
      const equalized =
        restLengths === 'draped' ? 'newNet' : await this.#equalized(name, await reading.net(repaired), upAxis, dialog);
      const taken =
        equalized === 'newNet'
          ? await this.#draped({ name, mesh: await reading.mesh(repaired) }, upAxis, dialog)
          : equalized && takenNet(name, equalized);
      // One of our own surfaces may have been chosen instead, which lies otherwise.
      if (taken !== null) return { upAxis, ...taken };
    }
  }

  #draped(surface: { name: string; mesh: Mesh }, upAxis: UpAxis, dialog: FileDialogLike): Promise<TakenNet | null> {
    const draper = this.#parts.createDraper(surface, upAxis);
    void dialog.closed.then(() => draper.close());
    return draper.result;
  }

  #equalized(name: string, net: OpenedNet, upAxis: UpAxis, dialog: FileDialogLike): Promise<EqualizerEnd> {
    const equalizer = this.#parts.createEqualizer({ name, net, positions: net.restPositions, handles: [] }, upAxis);
    void dialog.closed.then(() => equalizer.close());
    return equalizer.result;
  }
}

function takenNet(name: string, { mesh, surface }: Equalized): TakenNet {
  return { net: { mesh, name }, handles: [], ...(surface && { guide: { mesh: surface, name } }) };
}

function checkSize({ name, size }: File): void {
  if (size <= LARGEST_FILE) return;
  const [megabytes = 0, largest = 0] = [size, LARGEST_FILE].map((bytes) => Math.round(bytes / 1e6));
  throw new Failure('too_large', dialogWords.file.tooLarge(name, megabytes, largest));
}

/** The controller: owns the document, its history and the worker's client, and keeps view and panels in step with them.
 *  Everything a user or a script can do to the net is a method here. */
import type { Handle, OptionInfo } from '../../wasm/chebnet';
import { Beside } from './compare/beside';
import { Comparer } from './compare/comparer';
import type { ComparisonWish, Run } from './compare/run';
import { freshScene } from './document/defaults';
import type { ChebnetDocument, HandleData, NetSource, Scene, SolverSettings, ViewState } from './document/document';
import { encodeScene } from './document/share';
import type { Shared } from './document/share';
import { UndoHistory } from './document/undo';
import type { Snapshot } from './document/undo';
import type { FileKind } from './files/export';
import { type HandleDesk, HandleEditor, targetsOf } from './handles/handle_editor';
import { words } from './language/language';
import type { PanelEvents, Panels } from './panels/panels';
import type { View, ViewEvents } from './view/view';
import { Client, SolverError } from './worker/client';
import type { Opened, WorkerLike } from './worker/client';
import type { ExportFormat, FrameData, OpenedNet } from './worker/protocol';

/** What an app is made from. */
export interface AppParts {
  createView(events: ViewEvents): View;
  /** Another view, to the right of it. */
  createBeside(events: ViewEvents): View;
  createPanels(events: PanelEvents): Panels;
  spawnWorker(): WorkerLike;
}

/** What the outside wants of a user's wish that is not about the net itself. */
export interface AppServices {
  pickFile(): void;
  equalize(): void;
  copyLink(): void;
  exportFile(kind: FileKind): void;
}

/** A net that is open, and all that belongs to it. */
export interface Opening {
  document: ChebnetDocument;
  net: OpenedNet;
  frame: FrameData;
}

/** Whoever waits longer than this wants to be told what for. */
const LATE_MS = 250;

type Listener = (error?: unknown) => void;
export type AppEvent = 'frame' | 'settled' | 'error';

export class App {
  readonly handles: HandleEditor;
  readonly #view: View;
  readonly #panels: Panels;
  readonly #client: Client;
  readonly #tables: ReturnType<Client['hello']>;
  readonly #history = new UndoHistory();
  readonly #comparer: Comparer;
  readonly #beside: Beside;
  readonly #listeners: Record<AppEvent, Set<Listener>> = { frame: new Set(), settled: new Set(), error: new Set() };
  #optionTable: OptionInfo[] = [];
  #opening: Opening | null = null;
  /** Nets on their way. */
  #awaited = 0;
  /** The run whose net the view shows in place of the user's. */
  #shownRun: Run | null = null;
  /** The run whose net stands beside it. */
  #runBeside: Run | null = null;
  #saidUnreachable = false;

  constructor({ createView, createBeside, createPanels, spawnWorker }: AppParts, services: AppServices) {
    this.#client = new Client(spawnWorker, {
      frame: (frame, settled) => this.#showFrame(frame, settled),
      restarted: (reason, opened) => this.#restarted(reason, opened),
    });
    this.#comparer = new Comparer(spawnWorker, (comparison) => this.#panels.showComparison(comparison));
    this.#beside = new Beside(createBeside, (camera) => {
      this.#view.setCamera(camera);
      this.#changeView({ camera });
    });
    this.handles = this.#createHandleEditor();
    // Before the view, whose making holds the page up for a while: the worker loads meanwhile.
    this.#tables = this.#client.hello();
    this.#view = createView(this.#viewEvents());
    this.#panels = createPanels(this.#panelEvents(services));
  }

  /** The net that is open; null before the first. Not to be changed. */
  get opening(): Opening | null {
    return this.#opening;
  }

  get framesPerSecond(): number {
    return this.#view.framesPerSecond();
  }

  screenPosition(vertex: number): { x: number; y: number } {
    return this.#view.screenPosition(vertex);
  }

  /** Waits for the solver and fills the tables of the panels. */
  async start(): Promise<void> {
    const tables = await this.#tables;
    this.#optionTable = tables.options;
    this.#panels.showTables(words.core.tables(tables), (recipe) => this.#client.thumbnail(recipe));
  }

  /** Calls `listener` on every event of that kind; returns what ends this. */
  on(event: AppEvent, listener: Listener): () => void {
    this.#listeners[event].add(listener);
    return () => this.#listeners[event].delete(listener);
  }

  /** Resolves when nothing is under way and the net is settled. */
  settled(): Promise<void> {
    return this.#client.idle();
  }

  /** Shows a failure to the user and to listeners. */
  report(error: unknown): void {
    // When a worker is lost everything that waits for it fails; that is said once, by #restarted.
    const known = error instanceof SolverError && error.code === 'worker_lost' && this.#opening !== null;
    if (!known) this.#panels.say(sentence(error), 'error');
    this.#emit('error', error);
  }

  say(message: string): void {
    this.#panels.say(message, 'info');
  }

  /** A line with a button. */
  offer(message: string, button: string, accept: () => void): void {
    this.#panels.offer(message, button, accept);
  }

  // ------------------------------------------------------------------------------------------------------ whole scenes

  /** Opens a scene in place of the present one, to which undo returns. If it fails, the present one stays. */
  async openScene(scene: Scene): Promise<void> {
    const opened = await this.#await(this.#client.open(scene));
    this.handles.endDrag(false);
    const before = this.#snapshot();
    if (before) this.#history.record(before);
    this.#showOpened(scene, opened);
    if (opened.frame.handles.length === 0) this.say(words.intro.noHandles);
  }

  /** Opens a net as it comes, to be solved and shown as the present one is. */
  openNet(net: NetSource): Promise<void> {
    const fresh = freshScene(net);
    if (this.#opening === null) return this.openScene(fresh);
    const { method, initialisation, options, view } = this.#opening.document;
    return this.openScene({ ...fresh, method, initialisation, options, view: { ...view, camera: null } });
  }

  /** The present scene as the hash of a link. */
  share(): Shared {
    if (this.#opening === null) return { hash: null };
    const { net } = this.#opening;
    const document = { ...this.#opening.document, settled: this.#isSettled() };
    return encodeScene(document, net, this.#threshold());
  }

  /** The present net as the bytes of a file. */
  exported(format: ExportFormat): Promise<Uint8Array<ArrayBuffer>> {
    return this.#client.exportFile(format);
  }

  /** What the view shows, as PNG without a background. */
  picture(): Promise<Blob> {
    return this.#view.picture();
  }

  // ----------------------------------------------------------------------------------------------------------- solving

  async setOptions(settings: SolverSettings): Promise<void> {
    await this.#client.setOptions(settings);
    const usual = new Map(this.#optionTable.map(({ name, value }) => [name, value]));
    const unusual = Object.entries(settings.options).filter(([name, value]) => Number(value) !== usual.get(name));
    this.#change({ ...settings, options: Object.fromEntries(unusual) });
    this.#showDocument();
  }

  /** Back to rest, handles too. */
  async reset(): Promise<void> {
    const before = this.#snapshot();
    if (before === null || this.#opening === null) return;
    const { restPositions } = this.#opening.net;
    const atRest = (handle: HandleData): HandleData => {
      const [x = 0, y = 0, z = 0] = restPositions.subarray(3 * handle.vertex, 3 * handle.vertex + 3);
      return { ...handle, target: [x, y, z] };
    };
    this.#history.record(before);
    this.#change({ handles: before.handles.map(atRest) });
    this.#showDocument();
    await this.#client.reset();
  }

  // --------------------------------------------------------------------------------------------------------- comparing

  /** Runs methods on the present edit, in a worker of their own. */
  compare({ methods, start }: ComparisonWish): void {
    if (this.#opening === null) return;
    this.#showOwnNet();
    const { document } = this.#opening;
    const scene = { ...document, positions: start === 'rest' ? null : document.positions };
    void this.#comparer.start(scene, this.#threshold(), methods);
  }

  /** Puts the net of a run in the place of the user's, which comes back with null or whenever it changes. */
  showRun(run: Run | null): void {
    if (run === this.#shownRun || this.#opening === null) return;
    this.#shownRun = run;
    this.#view.showFrame(run?.frame ?? this.#opening.frame);
    this.#panels.showRuns(run, this.#runBeside);
    this.#showDocument();
  }

  /** Shows the net of a run beside the other, seen from the same place; null: no longer. */
  showBeside(run: Run | null): void {
    if (run === this.#runBeside || this.#opening === null) return;
    this.#runBeside = run;
    const { net, document } = this.#opening;
    if (run?.frame) this.#beside.show(net, run.frame, { ...document.view, camera: this.#view.camera() });
    else this.#beside.hide();
    this.#panels.showRuns(this.#shownRun, run);
  }

  #showOwnNet(): void {
    this.showRun(null);
    this.showBeside(null);
  }

  // -------------------------------------------------------------------------------------------------------------- undo

  undo(): void {
    this.#goTo((now) => this.#history.undo(now));
  }

  redo(): void {
    this.#goTo((now) => this.#history.redo(now));
  }

  #goTo(choose: (now: Snapshot) => Snapshot | null): void {
    const now = this.#snapshot();
    const state = now === null || this.#awaited > 0 ? null : choose(now);
    if (state) this.#restore(state);
  }

  #restore(state: Snapshot): void {
    const document = this.#opening?.document;
    if (document === undefined) return;
    const { net, handles, symmetry, positions, settled } = state;
    if (net !== document.net) return this.#reopen(document, state);
    this.#change({ handles: [...handles], symmetry, positions, settled });
    this.#showDocument();
    this.#try(this.#client.restore(positions, targetsOf(handles), settled));
  }

  #reopen(document: ChebnetDocument, { net, handles, symmetry, positions, settled }: Snapshot): void {
    const { method, initialisation, options } = document;
    const view = { ...document.view, camera: null };
    const scene: Scene = { net, handles: [...handles], symmetry, positions, settled, method, initialisation, options, view };
    this.#try(this.#await(this.#client.open(scene)).then((opened) => this.#showOpened(scene, opened)));
  }

  /** Says so if a net takes long to open. */
  async #await(opening: Promise<Opened>): Promise<Opened> {
    this.#awaited += 1;
    const late = setTimeout(() => this.#view.setWaiting(words.view.opening), LATE_MS);
    try {
      return await opening;
    } finally {
      clearTimeout(late);
      this.#view.setWaiting(null);
      this.#awaited -= 1;
    }
  }

  #snapshot(): Snapshot | null {
    if (this.#opening === null) return null;
    const { net, handles, symmetry } = this.#opening.document;
    return { net, handles, symmetry, positions: this.#positions(), settled: this.#isSettled() };
  }

  /** While something is under way, the positions shown are not the last. */
  #isSettled(): boolean {
    return this.#opening?.document.settled === true && !this.#client.busy;
  }

  // ----------------------------------------------------------------------------------------------- from view and panels

  #viewEvents(): ViewEvents {
    return {
      addHandle: (vertex, also) => this.handles.add(vertex, also),
      select: (selection) => this.handles.select(selection),
      dragStart: () => {
        this.showRun(null);
        this.handles.beginDrag();
      },
      dragMove: (targets) => this.handles.drag(targets),
      dragEnd: (cancelled) => this.handles.endDrag(cancelled),
      cameraChanged: (camera) => this.#changeView({ camera }),
      cameraMoved: (camera) => this.#beside.setCamera(camera),
    };
  }

  #panelEvents({ pickFile, equalize, copyLink, exportFile }: AppServices): PanelEvents {
    return {
      pickFile,
      equalize,
      copyLink,
      exportFile,
      openRecipe: (recipe) => this.#try(this.openNet({ recipe })),
      handles: this.handles,
      previewLine: (name) => this.#view.setPreview(name === null ? [] : this.handles.line(name)),
      setOptions: (settings) => this.#try(this.setOptions(settings)),
      setView: (change) => this.#changeView(change),
      solve: () => this.#try(this.#client.solve()),
      step: () => this.#try(this.#client.step()),
      setStepArrows: (shown) => this.#view.setStepArrows(shown),
      cancel: () => this.#try(this.#client.cancel()),
      reset: () => this.#try(this.reset()),
      compare: (wish) => this.compare(wish),
      cancelComparison: () => this.#comparer.cancel(),
      showRun: (run) => this.showRun(run),
      showBeside: (run) => this.showBeside(run),
      undoDrag: () => this.undo(),
      frameAll: () => this.#view.frameAll(),
    };
  }

  #createHandleEditor(): HandleEditor {
    const desk: HandleDesk = {
      opening: () => this.#opening,
      // While a net is on its way, the one in hand is about to go.
      snapshot: () => (this.#awaited > 0 ? null : this.#snapshot()),
      change: (change) => this.#change(change),
      restore: (state) => this.#restore(state),
      show: () => this.#showDocument(),
      showDrag: () => this.#showDrag(),
      say: (message) => this.say(message),
      attempt: (doing) => this.#try(doing),
    };
    return new HandleEditor(desk, this.#client, this.#history);
  }

  #changeView(change: Partial<ViewState>): void {
    if (this.#opening === null) return;
    const view = { ...this.#opening.document.view, ...change };
    this.#change({ view });
    if (change.camera !== undefined) return;
    this.#view.setAppearance(view);
    this.#beside.setAppearance(view);
    this.#showDocument();
  }

  // ---------------------------------------------------------------------------------------------------------- the state

  #threshold(): number {
    const usual = this.#optionTable.find(({ name }) => name === 'threshold')?.value;
    return Number(this.#opening?.document.options.threshold ?? usual);
  }

  #handles(): HandleData[] {
    return this.#opening?.document.handles ?? [];
  }

  #positions(): Float64Array {
    return this.#opening?.document.positions ?? new Float64Array();
  }

  /** The document is never changed in place: history and links may hold parts of it. */
  #change(change: Partial<ChebnetDocument>): void {
    if (this.#opening) this.#opening = { ...this.#opening, document: { ...this.#opening.document, ...change } };
  }

  // ------------------------------------------------------------------------------------------------------------ showing

  #showOpened(scene: Scene, { net, frame }: Opened): void {
    this.#showOwnNet();
    const { method, initialisation, options, view, settled, experiment, compare } = scene;
    const last = frame.handles.length - 1;
    // Of the handles that come with a recipe the last is the one to drag.
    const isAnchor = (i: number): boolean => (scene.handles === 'suggested' ? i < last : (scene.handles[i]?.anchor ?? false));
    const seeds = scene.handles === 'suggested' ? [] : scene.handles;
    const handles = frame.handles.map(({ vertex, target }, i) => ({ ...seeds[i], vertex, target, anchor: isAnchor(i) }));
    this.#opening = {
      net,
      frame,
      document: {
        net: scene.net,
        handles,
        symmetry: scene.symmetry,
        method,
        initialisation,
        options,
        view,
        positions: frame.positions,
        settled,
        experiment,
        compare,
      },
    };
    this.handles.netChanged();
    // First, for the view leaves room for what the panels say.
    this.#panels.showDocument(this.#opening.document, this.handles.choice, this.#history.canUndo);
    this.#view.setAppearance(view);
    this.#view.showNet(net, frame, view.camera);
    this.#panels.showNet(net);
    this.#showDocument();
    this.#showLive();
  }

  #showFrame(frame: FrameData, settled: boolean): void {
    if (this.#opening === null) return;
    this.showRun(null);
    this.#opening = { ...this.#opening, frame };
    this.#change({ positions: frame.positions, settled });
    this.#view.showFrame(frame);
    this.#showLive();
    this.#emit('frame');
    if (!settled) return;
    this.#sayUnreachable(frame);
    this.#emit('settled');
  }

  #restarted(reason: string, opened: Opened | null): void {
    if (opened === null || this.#opening === null) {
      this.#panels.say(words.solver.stopped(sentence(reason)), 'error');
      return;
    }
    this.#change({ handles: opened.frame.handles.map((handle) => this.#withTraits(handle)) });
    this.#showDocument();
    this.#panels.say(words.solver.restarted(sentence(reason)), 'error');
  }

  #showDocument(): void {
    if (this.#opening === null) return;
    const { document } = this.#opening;
    const { choice } = this.handles;
    this.#view.setSymmetry(document.symmetry);
    this.#view.showHandles(this.#shownHandles(document), choice);
    this.#panels.showDocument(document, choice, this.#history.canUndo);
  }

  #showDrag(): void {
    if (this.#opening === null) return;
    const { handles } = this.#opening.document;
    this.#view.showHandles(handles, this.handles.choice);
    this.#panels.showHandles(handles, this.handles.choice);
  }

  /** Those of the run whose net is shown stand where they stood when it began. */
  #shownHandles({ handles }: ChebnetDocument): HandleData[] {
    return this.#shownRun?.frame?.handles.map((handle) => this.#withTraits(handle)) ?? handles;
  }

  /** A handle of the solver, with what only the document knows about it. */
  #withTraits({ vertex, target }: Handle): HandleData {
    const known = this.#handles().find((handle) => handle.vertex === vertex);
    return { anchor: false, ...known, vertex, target };
  }

  #showLive(): void {
    if (this.#opening) this.#panels.showFrame(this.#opening.frame, this.framesPerSecond, this.#client.solving);
  }

  /** Once, until all handles are within reach again. */
  #sayUnreachable({ unreachable }: FrameData): void {
    const [worst] = unreachable;
    const said = this.#saidUnreachable;
    this.#saidUnreachable = worst !== undefined;
    if (worst === undefined || said) return;
    const { vertexA, vertexB, distance, reach } = worst;
    this.say(words.handles.unreachable(vertexA, vertexB, distance.toPrecision(3), reach.toPrecision(3)));
  }

  #emit(event: AppEvent, error?: unknown): void {
    for (const listener of this.#listeners[event]) listener(error);
  }

  /** For what the user does: a failure is shown, not thrown. */
  #try(doing: Promise<unknown>): void {
    doing.catch((error: unknown) => this.report(error));
  }
}

/** What went wrong, as a sentence. */
function sentence(error: unknown): string {
  return words.core.sentence(error instanceof Error ? error.message : String(error));
}

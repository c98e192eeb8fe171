/** The controller: owns the document, its history and the worker's client, and keeps view and panels in step with them.
 *  Everything a user or a script can do to the net is a method here. */
import type { FlatPattern, Handle, OptionInfo, PatternFault } from '../../wasm/chebnet';
import { Beside } from './compare/beside';
import { Comparer } from './compare/comparer';
import type { ComparisonWish, Run, RunPlan, RunWish } from './compare/run';
import { netChange, netTitle, settingsChange } from './document/changes';
import type { NamedChange } from './document/changes';
import { freshScene } from './document/defaults';
import type { ChebnetDocument, HandleData, NetSource, Scene, SolverSettings, ViewState } from './document/document';
import type { ChangeName } from './document/naming';
import type { Project } from './document/project';
import { UndoHistory } from './document/undo';
import type { HistoryView, Snapshot } from './document/undo';
import { DragGuide } from './handles/drag_guide';
import { type HandleDesk, HandleEditor } from './handles/handle_editor';
import { words } from './language/language';
import type { Action, PanelEvents, Panels } from './panels';
import type { Film, View, ViewEvents } from './view/view';
import { Client, isCancelled, SolverError } from './worker/client';
import type { Opened, WorkerLike } from './worker/client';
import type { Opening } from './worker/opening';
import { LEFT_OUT } from './worker/protocol';
import type { ExportFormat, FrameData, OpenedNet } from './worker/protocol';
import type { ThumbnailNet } from './worker/thumbnail_net';

/** What an app is made from. */
export interface AppParts {
  createView(events: ViewEvents): View;
  /** Another view, in the first or second place to the right of it. */
  createBeside(events: ViewEvents, place: number): View;
  createPanels(events: PanelEvents): Panels;
  spawnWorker(): WorkerLike;
}

/** What a user wishes that is not about the net itself. */
export type AppServices = Pick<
  PanelEvents,
  | 'pickFile'
  | 'newNet'
  | 'saveProject'
  | 'restoreLast'
  | 'equalize'
  | 'share'
  | 'save'
  | 'record'
  | 'chooseLanguage'
  | 'showKeys'
  | 'showLesson'
>;

/** Whoever waits longer than this wants to be told what for. */
const LATE_MS = 250;

type Listener = (error?: unknown) => void;
/** `changed`: anything in the document; `restarted`: the worker was lost. */
export type AppEvent = 'frame' | 'settled' | 'error' | 'changed' | 'restarted';

export class App {
  readonly handles: HandleEditor;
  readonly #view: View;
  readonly #panels: Panels;
  readonly #client: Client;
  readonly #tables: ReturnType<Client['hello']>;
  readonly #history = new UndoHistory();
  readonly #comparer: Comparer;
  readonly #beside: Beside;
  readonly #listeners: Record<AppEvent, Set<Listener>> = {
    frame: new Set(),
    settled: new Set(),
    error: new Set(),
    changed: new Set(),
    restarted: new Set(),
  };
  #optionTable: OptionInfo[] = [];
  #methods: string[] = [];
  #opening: Opening | null = null;
  /** Nets on their way. */
  #awaited = 0;
  /** The run whose net the view shows in place of the user's. */
  #shownRun: Run | null = null;
  /** The runs whose nets stand beside it. */
  #runsBeside: readonly Run[] = [];
  #saidUnreachable = false;

  constructor({ createView, createBeside, createPanels, spawnWorker }: AppParts, services: AppServices) {
    this.#client = new Client(spawnWorker, {
      document: () => this.#opening?.document ?? null,
      frame: (frame, settled) => this.#showFrame(frame, settled),
      restarted: (why, isBack) => this.#restarted(why, isBack),
      gaveUp: (why) => this.report(why),
    });
    this.#comparer = new Comparer(spawnWorker, (comparison) => this.#panels.showComparison(comparison));
    this.#beside = new Beside(createBeside, (camera) => {
      this.#view.setCamera(camera);
      this.setView({ camera });
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
    this.#methods = tables.methods.map(({ name }) => name);
    this.#panels.showTables(words.core.tables(tables), (recipe) => this.#thumbnail(recipe));
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
    if (isCancelled(error)) return;
    // When a worker is lost everything that waits for it fails; that is said once, by #restarted.
    const known = error instanceof SolverError && error.code === 'worker_lost' && this.#opening !== null;
    if (!known) this.#panels.say(sentence(error), 'error');
    this.#emit('error', error);
  }

  /** @param action what a button beside the message does. */
  say(message: string, action?: Action): void {
    this.#panels.say(message, 'info', action);
  }

  get history(): HistoryView {
    return this.#history;
  }

  /** Nothing is under way, neither in the solver nor in the user's hand. */
  get isQuiet(): boolean {
    return this.#awaited === 0 && !this.#history.inGesture && !this.#client.changing;
  }

  /** A line with a button. */
  offer(message: string, button: string, accept: () => void): void {
    this.#panels.offer(message, button, accept);
  }

  // ------------------------------------------------------------------------------------------------------ whole scenes

  /** Opens a scene in place of the present one, to which undo returns. If it fails, the present one stays.
   *  @param change what the history calls it. */
  async openScene(
    scene: Scene,
    change: NamedChange = { name: ['open', netTitle(scene.net)], key: null },
  ): Promise<void> {
    const opened = await this.#await(this.#client.open(scene));
    this.handles.endDrag(false);
    const before = this.#snapshot();
    this.#showOpened(scene, opened);
    if (before) this.#history.record(before, change.name, change.key);
    else this.#history.begin([{ name: change.name, state: this.#snapshot()! }], 0);
    this.#showDocument();
    if (opened.frame.handles.length === 0) this.say(words.intro.noHandles);
  }

  /** Opens a project with its history in place of the present one. If it fails, the present one stays. */
  async openProject({ entries, present, view }: Project): Promise<void> {
    const scene = { ...entries[present]!.state, view };
    const opened = await this.#await(this.#client.open(scene));
    this.#showOpened(scene, opened);
    this.#history.begin(entries, present);
    this.#showDocument();
  }

  /** The document and its history, in the middle of a gesture as before it; null before the first net. */
  project(): Project | null {
    const now = this.#history.beforeGesture ?? this.#snapshot();
    if (now === null || this.#opening === null) return null;
    return { entries: this.#history.entries(now), present: this.#history.present, view: this.#opening.document.view };
  }

  /** Opens a net as it comes, to be solved and shown as the present one is. */
  openNet(net: NetSource): Promise<void> {
    const fresh = freshScene(net);
    if (this.#opening === null) return this.openScene(fresh);
    const { method, initialisation, options, view } = this.#opening.document;
    const change = netChange(this.#opening.document.net, net);
    return this.openScene({ ...fresh, method, initialisation, options, view: { ...view, camera: null } }, change);
  }

  /** What a link to the present scene is made of; null before the first net. */
  toShare(): { document: ChebnetDocument; net: OpenedNet; threshold: number } | null {
    if (this.#opening === null) return null;
    const { document, net } = this.#opening;
    return { document: { ...document, settled: this.#isSettled() }, net, threshold: this.#threshold(document) };
  }

  /** The present net as the bytes of a file. */
  exported(format: ExportFormat): Promise<Uint8Array<ArrayBuffer>> {
    return this.#client.exportFile(format);
  }

  /** The net laid flat, or why it cannot be. */
  flatPattern(): Promise<FlatPattern | PatternFault> {
    return this.#client.flatPattern();
  }

  /** What the view shows, as PNG without a background, with so many times the pixels of the screen. */
  picture(magnification: number): Promise<Blob> {
    return this.#view.picture(magnification);
  }

  /** What the view shows from now on. */
  film(): Film {
    return this.#view.film();
  }

  // ----------------------------------------------------------------------------------------------------------- solving

  async setOptions(settings: SolverSettings): Promise<void> {
    const before = this.#snapshot();
    await this.#client.setOptions(settings);
    const usual = new Map(this.#optionTable.map(({ name, value }) => [name, value]));
    const unusual = Object.entries(settings.options).filter(([name, value]) => Number(value) !== usual.get(name));
    const after = { ...settings, options: Object.fromEntries(unusual) };
    const change = before && settingsChange(before, after);
    if (change) this.#history.record(before, change.name, change.key);
    this.#change(after);
    this.#showDocument();
  }

  /** One iteration, then stop. */
  step(): Promise<void> {
    return this.#client.step();
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
    this.#history.record(before, ['reset']);
    this.#change({ handles: before.handles.map(atRest), positions: restPositions });
    this.#showDocument();
    await this.#client.reset();
  }

  // --------------------------------------------------------------------------------------------------------- comparing

  /** Runs methods on the present edit, in a worker of their own. */
  compare({ methods, start }: ComparisonWish): void {
    if (this.#opening === null) return;
    const { document } = this.#opening;
    const positions = start === 'rest' ? null : document.positions;
    const planOf = (method: string): RunPlan => ({
      label: words.core.method(method),
      style: this.#methods.indexOf(method), // the same in every comparison
      scene: { ...document, method, positions },
      threshold: this.#threshold(document),
      isOfOpenNet: true,
    });
    this.#run(methods.map(planOf));
  }

  /** Runs these from rest, in a worker of their own; those without an edit of their own on the present one. */
  runAll(wishes: readonly RunWish[]): void {
    if (this.#opening === null) return;
    const { document } = this.#opening;
    const planOf = ({ label, edit, ...settings }: RunWish, style: number): RunPlan => ({
      label,
      style,
      scene: { ...document, ...settings, ...(edit ? { ...edit, numbering: undefined } : {}), positions: null },
      threshold: this.#threshold(settings),
      isOfOpenNet: edit === undefined,
    });
    this.#run(wishes.map(planOf));
  }

  #run(plans: readonly RunPlan[]): void {
    this.#showOwnNet();
    void this.#comparer.start(plans);
  }

  /** Puts the net of a run in the place of the user's, which comes back with null or whenever it changes. */
  showRun(run: Run | null): void {
    if (run === this.#shownRun || this.#opening === null) return;
    this.#shownRun = run;
    this.#view.showFrame(run?.frame ?? this.#opening.frame);
    this.#panels.showRuns(run, this.#runsBeside);
    this.#showDocument();
  }

  /** Shows the nets of these runs beside the other, seen from the same place, and no more. */
  showBeside(runs: readonly Run[]): void {
    if (this.#opening === null || (runs.length === 0 && this.#runsBeside.length === 0)) return;
    this.#runsBeside = runs;
    const { net, document } = this.#opening;
    const frames = runs.flatMap(({ frame }) => frame ?? []);
    this.#beside.show(net, frames, { ...document.view, camera: this.#view.camera() });
    this.#panels.showRuns(this.#shownRun, runs);
  }

  #showOwnNet(): void {
    this.showRun(null);
    this.showBeside([]);
  }

  // -------------------------------------------------------------------------------------------------------------- undo

  undo(): void {
    this.goTo(this.#history.present - 1);
  }

  redo(): void {
    this.goTo(this.#history.present + 1);
  }

  /** Goes to an entry of the history. */
  goTo(index: number): void {
    this.#try(this.#goTo(index));
  }

  async #goTo(index: number): Promise<void> {
    const now = this.#snapshot();
    const from = this.#history.present;
    const state = now === null || this.#awaited > 0 ? null : this.#history.goTo(index, now);
    if (now === null || state === null) return;
    try {
      await this.#restore(state);
    } catch (error) {
      // A history from a file may hold what no net can be.
      if (this.#history.goTo(from, state)) await this.#restore(now);
      throw error;
    }
  }

  async #restore(state: Snapshot): Promise<void> {
    if (this.#opening === null) return;
    const { document } = this.#opening;
    const { net, ...rest } = state;
    if (net !== document.net) return this.#reopen({ ...state, view: { ...document.view, camera: null } });
    this.#setDocument({ ...state, numbering: document.numbering, view: document.view });
    this.#showDocument();
    await this.#client.restore(rest);
  }

  async #reopen(scene: Scene): Promise<void> {
    this.#showOpened(scene, await this.#await(this.#client.open(scene)));
  }

  /** Says so if a net takes long to open. */
  async #await(opening: Promise<Opened>): Promise<Opened> {
    this.#awaited += 1;
    const late = setTimeout(() => this.#panels.showOpening(true, this.canCancelOpening), LATE_MS);
    try {
      return await opening;
    } finally {
      clearTimeout(late);
      this.#panels.showOpening(false, false);
      this.#awaited -= 1;
    }
  }

  /** Whether a net is on its way that can be given up for the one that is open. */
  get canCancelOpening(): boolean {
    return this.#awaited > 0 && this.#opening !== null;
  }

  /** Gives up the net on its way; the one that is open stays. */
  cancelOpening(): void {
    if (this.canCancelOpening) this.#client.cancelOpening();
  }

  #snapshot(): Snapshot | null {
    if (this.#opening === null) return null;
    const { view: _, ...state } = this.#opening.document;
    return { ...state, settled: this.#isSettled() };
  }

  /** While something is under way, the positions shown are not the last. */
  #isSettled(): boolean {
    return this.#opening?.document.settled === true && !this.#client.changing;
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
      cameraChanged: (camera) => this.setView({ camera }),
      cameraMoved: (camera) => this.#beside.setCamera(camera),
      failed: (error) => this.report(error),
    };
  }

  #panelEvents(services: AppServices): PanelEvents {
    return {
      ...services,
      openRecipe: (recipe) => this.#try(this.openNet({ recipe })),
      cancelOpening: () => this.cancelOpening(),
      handles: this.handles,
      previewLine: (name) => this.#view.setPreview(name === null ? [] : this.handles.line(name)),
      setOptions: (settings) => this.#try(this.setOptions(settings)),
      setView: (change) => this.setView(change),
      solve: () => this.#tryNamed(['solve'], () => this.#client.solve()),
      step: () => this.#tryNamed(['step'], () => this.step()),
      setStepArrows: (shown) => this.#view.setStepArrows(shown),
      cancel: () => this.#try(this.#client.cancel()),
      reset: () => this.#try(this.reset()),
      compare: (wish) => this.compare(wish),
      runAll: (wishes) => this.runAll(wishes),
      cancelComparison: () => this.#comparer.cancel(),
      showRun: (run) => this.showRun(run),
      showBeside: (runs) => this.showBeside(runs),
      undo: () => this.undo(),
      redo: () => this.redo(),
      goTo: (index) => this.goTo(index),
      frameAll: () => this.#view.frameAll(),
    };
  }

  #createHandleEditor(): HandleEditor {
    const desk: HandleDesk = {
      opening: () => this.#opening,
      // While a net is on its way, the one in hand is about to go.
      snapshot: () => (this.#awaited > 0 ? null : this.#snapshot()),
      change: (change) => this.#change(change),
      restore: (state) => this.#try(this.#restore(state)),
      show: () => this.#showDocument(),
      showDrag: () => this.#showDrag(),
      say: (message) => this.say(message),
      attempt: (doing) => this.#try(doing),
    };
    const guide = new DragGuide(this.#client, {
      setRegion: (mobility) => this.#view.setRegion(mobility),
      setReach: (balls) => this.#view.setReach(balls),
    });
    return new HandleEditor(desk, this.#client, this.#history, guide);
  }

  setView(change: Partial<ViewState>): void {
    if (this.#opening === null) return;
    const view = { ...this.#opening.document.view, ...change };
    this.#change({ view });
    if (change.camera !== undefined) return;
    this.#view.setAppearance(view);
    this.#beside.setAppearance(view);
    this.#showDocument();
  }

  // ---------------------------------------------------------------------------------------------------------- the state

  #threshold({ options }: Pick<SolverSettings, 'options'>): number {
    const usual = this.#optionTable.find(({ name }) => name === 'threshold')?.value;
    return Number(options.threshold ?? usual);
  }

  #handles(): HandleData[] {
    return this.#opening?.document.handles ?? [];
  }

  /** The document is never changed in place: history and links may hold parts of it. */
  #change(change: Partial<ChebnetDocument>): void {
    if (this.#opening) this.#setDocument({ ...this.#opening.document, ...change });
  }

  #setDocument(document: ChebnetDocument): void {
    if (this.#opening) this.#opening = { ...this.#opening, document };
    this.#emit('changed');
  }

  // ------------------------------------------------------------------------------------------------------------ showing

  async #thumbnail(recipe: string): Promise<ThumbnailNet> {
    try {
      return await this.#client.thumbnail(recipe);
    } catch (error) {
      if (!(error instanceof SolverError) || error.code !== LEFT_OUT) throw error;
      const { lateThumbnail } = await import('./worker/late_thumbnail');
      return lateThumbnail(recipe);
    }
  }

  #showOpened(scene: Scene, { net, frame }: Opened): void {
    this.#showOwnNet();
    const { view } = scene;
    const last = frame.handles.length - 1;
    // Of the handles that come with a recipe the last is the one to drag.
    const handles = frame.handles.map(({ vertex, target }, i) =>
      scene.handles === 'suggested'
        ? { vertex, target, anchor: i < last }
        : { anchor: false, ...scene.handles[i], vertex, target },
    );
    this.#opening = {
      net,
      frame,
      document: { ...scene, numbering: net.numbering, handles, positions: frame.positions },
    };
    this.#emit('changed');
    this.handles.netChanged();
    // First, for the view leaves room for what the panels say.
    this.#panels.showDocument(this.#opening.document, this.handles.choice);
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

  #restarted(why: SolverError, isBack: boolean): void {
    if (!isCancelled(why)) this.#emit('restarted');
    if (!isBack) {
      this.#panels.say(words.solver.stopped(sentence(why)), 'error');
      return;
    }
    this.handles.resumeDrag();
    this.#showDocument();
    if (!isCancelled(why)) this.#panels.say(words.solver.restarted(sentence(why)), 'error');
  }

  #showDocument(): void {
    if (this.#opening === null) return;
    const { document } = this.#opening;
    const { choice } = this.handles;
    this.#view.setSymmetry(document.symmetry);
    this.#view.showHandles(this.#shownHandles(document), choice);
    this.#panels.showDocument(document, choice);
    this.#panels.showHistory(this.#history);
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
    if (!this.#handles().some(({ vertex }) => vertex === vertexB)) return this.say(words.drag.tooLocal);
    this.say(words.handles.unreachable(vertexA, vertexB, distance.toPrecision(3), reach.toPrecision(3)));
  }

  #emit(event: AppEvent, error?: unknown): void {
    for (const listener of this.#listeners[event]) listener(error);
  }

  /** For what the user does: a failure is shown, not thrown. */
  #try(doing: Promise<unknown>): void {
    doing.catch((error: unknown) => this.report(error));
  }

  /** Likewise, as an entry of the history. */
  #tryNamed(name: ChangeName, doing: () => Promise<unknown>): void {
    const before = this.#snapshot();
    if (before) this.#history.record(before, name);
    this.#showDocument();
    this.#try(doing());
  }
}

/** What went wrong, as a sentence. */
function sentence(error: unknown): string {
  return words.core.sentence(error instanceof Error ? error.message : String(error));
}

/** The controller: everything a user or a script can ask of the page is a method here. State, Opener, Presenter and
 *  HandleEditor do it. */
import type { FlatPattern, FormatInfo, OptionInfo, PatternFault, VertexLists } from '../../../wasm/chebnet';
import type { Comparer } from '../compare/comparer';
import type { ComparisonRequest, RunPlan, RunRequest } from '../compare/run';
import { guideTitle, type NamedChange, settingsChange } from '../document/changes';
import type {
  ChebnetDocument,
  GuideSource,
  HandleData,
  NetSource,
  Scene,
  SolverOptions,
  SolverSettings,
  UpAxis,
  ViewState,
} from '../document/document';
import { asMade, weighed } from '../document/defaults';
import type { ChangeName } from '../document/naming';
import { pointOf } from '../document/point_of';
import type { Project } from '../document/project';
import type { HistoryView, Snapshot } from '../document/undo';
import { DragGuide } from '../handles/drag_guide';
import { HandleEditor } from '../handles/handle_editor';
import { words } from '../language/language';
import { lazy } from '../lazy';
import type { Action, PanelEvents } from '../panels';
import type { Side } from '../view/camera_fit';
import type { Film, ViewEvents } from '../view/view';
import { Client, isCancelled } from '../worker/client';
import type { WorkerLike } from '../worker/client';
import type { Opening } from '../worker/opening';
import type { FrameData, OpenedNet, SearchProgress } from '../worker/protocol';
import { latestOnly } from './latest';
import { Opener } from './opener';
import { Presenter, type Screen } from './presenter';
import { noNet, State } from './state';
import { Failure, messageOf } from '../failure';

/** What an app is made from. */
export interface AppParts extends Screen {
  spawnWorker(): WorkerLike;
}

/** What a user asks for that is not about the net itself. */
export type AppServices = Pick<
  PanelEvents,
  | 'pickFile'
  | 'newNet'
  | 'saveProject'
  | 'chooseProject'
  | 'restoreLast'
  | 'equalize'
  | 'drape'
  | 'changeNet'
  | 'share'
  | 'save'
  | 'record'
  | 'chooseLanguage'
  | 'showKeys'
  | 'showLesson'
>;

const flipper = lazy(() => import('./flip'));

type Listener = (error?: unknown) => void;
/** `changed`: anything in the document; `opening`: a net is about to be opened; `restarted`: the worker was lost. */
export type AppEvent = 'frame' | 'settled' | 'error' | 'changed' | 'opening' | 'restarted';

export class App {
  readonly handles: HandleEditor;
  readonly #client: Client;
  readonly #state: State;
  readonly #opener: Opener;
  readonly #presenter: Presenter;
  readonly #comparer: () => Promise<Comparer>;
  readonly #tables: ReturnType<Client['hello']>;
  readonly #listeners: Record<AppEvent, Set<Listener>> = {
    frame: new Set(),
    settled: new Set(),
    error: new Set(),
    changed: new Set(),
    opening: new Set(),
    restarted: new Set(),
  };
  #making = Promise.resolve();
  #optionTable: OptionInfo[] = [];
  #methods: string[] = [];
  #formats: readonly FormatInfo[] = [];

  constructor(parts: AppParts, services: AppServices) {
    this.#client = this.#createClient(parts);
    this.#state = new State(() => this.#client.changing, {
      document: () => this.#emit('changed'),
      presentation: () => this.#presenter.schedule(),
      handles: () => this.#presenter.presentHandles(),
    });
    this.handles = this.#createHandleEditor();
    // Before the view, whose construction blocks the page for a while: the worker loads meanwhile.
    this.#tables = this.#client.hello();
    this.#presenter = new Presenter(parts, this.#viewEvents(), this.#panelEvents(services), {
      state: this.#state,
      choice: () => this.handles.choice,
      solving: () => this.#client.solving,
      guide: () => this.#client.guide(),
    });
    this.#opener = this.#createOpener();
    this.#comparer = lazy(
      async () =>
        new (await import('../compare/comparer')).Comparer(parts.spawnWorker, (comparison) =>
          this.#presenter.panels.setComparison(comparison),
        ),
    );
  }

  /** Waits for the solver and fills the tables of the panels. */
  async start(): Promise<void> {
    const tables = await this.#tables;
    this.#optionTable = tables.options;
    this.#methods = tables.methods.map(({ name }) => name);
    this.#formats = tables.formats;
    this.#presenter.panels.setTables(words.core.tables(tables));
  }

  // ----------------------------------------------------------------------------------------------------------- state

  /** The net that is open; null before the first. Not to be changed. */
  get opening(): Opening | null {
    return this.#state.opening;
  }

  get history(): HistoryView {
    return this.#state.history;
  }

  get framesPerSecond(): number {
    return this.#presenter.view.framesPerSecond();
  }

  /** The core's; none before the solver is there. */
  get formats(): readonly FormatInfo[] {
    return this.#formats;
  }

  screenPosition(vertex: number): { x: number; y: number } {
    return this.#presenter.view.screenPositions([vertex])[0]!;
  }

  /** Neither a solve nor a drag is under way. */
  get isQuiet(): boolean {
    return !this.#opener.isOpening && !this.#state.history.inGesture && !this.#client.changing;
  }

  /** The net is being made anew, or brought to another shape: until it is there, nothing is settled. */
  awaitNet<T>(making: Promise<T>): Promise<T> {
    // Not this one alone: it may be refused at once, because another is under way.
    this.#making = Promise.allSettled([this.#making, making]).then(() => {});
    return making;
  }

  /** Resolves when nothing is under way and the net is settled. */
  async settled(): Promise<void> {
    await this.#making; // if that fails, it is reported where it was asked for
    await this.#client.idle();
  }

  /** Calls `listener` on every event of that kind; returns what ends this. */
  on(event: AppEvent, listener: Listener): () => void {
    this.#listeners[event].add(listener);
    return () => this.#listeners[event].delete(listener);
  }

  // ------------------------------------------------------------------------------------------------------------ messages

  /** Shows a failure to the user and to listeners. */
  report(error: unknown): void {
    if (isCancelled(error)) return;
    // When a worker is lost everything that waits for it fails; that is said once, by #restarted. Of other workers it is not.
    const known = this.#client.isLoss(error) && this.opening !== null;
    if (!known) this.#presenter.panels.say(sentence(error), 'error');
    this.#emit('error', error);
  }

  /** @param action what a button beside the message does. */
  say(message: string, action?: Action): void {
    this.#presenter.panels.say(message, 'info', action);
  }

  /** Takes away what was said: something else is being done. */
  unsay(): void {
    this.#presenter.panels.unsay();
  }

  /** A line with a button. */
  offer(message: string, button: string, accept: () => void): void {
    this.#presenter.panels.offer(message, button, accept);
  }

  // ------------------------------------------------------------------------------------------------------ whole scenes

  /** Opens a scene in place of the present one, to which undo returns. If it fails, the present one stays.
   *  @param change what the history calls it. */
  openScene(scene: Scene, change?: NamedChange): Promise<void> {
    this.#emit('opening');
    return this.#opener.openScene(scene, change);
  }

  /** Opens a project with its history in place of the present one. If it fails, the present one stays. */
  openProject(project: Project): Promise<void> {
    this.#emit('opening');
    return this.#opener.openProject(project);
  }

  /** Opens a net at rest, with the settings and the view of the present document, its own axis up. */
  openNet(net: NetSource, upAxis?: UpAxis): Promise<void> {
    this.#emit('opening');
    return this.#opener.openNet(net, upAxis);
  }

  /** Whether a net is being opened, and can be cancelled in favour of the present one. */
  get canCancelOpening(): boolean {
    return this.#opener.canCancel;
  }

  /** Cancels the opening; the present net stays. */
  cancelOpening(): void {
    this.#opener.cancel();
  }

  /** The document and its history, during a gesture the state before it; null before the first net. */
  project(): Project | null {
    const { opening, history } = this.#state;
    const now = history.beforeGesture ?? this.#state.snapshot();
    if (now === null || opening === null) return null;
    return { entries: this.#opener.entries(now), present: history.present, view: this.#viewOf(opening.document) };
  }

  /** What a link to the present scene is made of; null before the first net. */
  toShare(): { document: ChebnetDocument; net: OpenedNet; threshold: number } | null {
    if (this.opening === null) return null;
    const { net } = this.opening;
    const view = this.#viewOf(this.opening.document);
    // Opened, a net is framed as it is: one that was dragged since it was framed here would be seen from elsewhere.
    const camera = view.camera ?? this.#presenter.view.unframed();
    const document = { ...this.opening.document, view: { ...view, camera } };
    return { document: { ...document, settled: this.#state.isSettled }, net, threshold: this.#threshold(document) };
  }

  /** As it will be when the camera, which may be moving, rests. */
  #viewOf({ view }: ChebnetDocument): ViewState {
    return { ...view, camera: this.#presenter.view.heading() ?? view.camera };
  }

  /** The present net as the bytes of a file. */
  exported(format: string): Promise<Uint8Array<ArrayBuffer>> {
    return this.#client.exportFile(format);
  }

  /** The net laid flat, or why it cannot be. */
  flatPattern(): Promise<FlatPattern | PatternFault> {
    return this.#client.flatPattern();
  }

  /** The lines that its rods are laid along. */
  rods(): Promise<VertexLists> {
    return this.#client.rods();
  }

  /** What the view shows, as PNG without a background, with so many times the pixels of the screen. */
  picture(magnification: number): Promise<Blob> {
    return this.#presenter.view.picture(magnification);
  }

  /** What the view shows from now on. */
  film(): Promise<Film> {
    return this.#presenter.view.film();
  }

  /** Whether the net is seen from behind while nobody has turned the view. */
  get isSeenFromBehind(): boolean {
    return this.#presenter.view.behind;
  }

  frameAll(from?: Side): void {
    this.#presenter.view.frameAll(from);
  }

  setView(change: Partial<ViewState>): void {
    if (this.opening === null) return;
    const { view: before } = this.opening.document;
    const isTurned = change.upAxis !== undefined && change.upAxis !== (before.upAxis ?? 'z');
    // The view frames it anew: the camera was that of how it lay.
    const view = { ...before, ...(isTurned && { camera: null, behind: undefined }), ...change };
    this.#state.change({ view });
    if (change.camera === undefined) this.#presenter.setAppearance({ ...this.opening.document, view });
    if (isTurned && !this.#opener.isOpening) this.#turnWeight();
  }

  /** What hangs, hangs downwards as it is seen now. No step of its own: the history goes along. */
  #turnWeight(): void {
    const { method, initialisation, options: before, view } = this.opening!.document;
    const options = weighed(before, view.upAxis);
    if (options.y_up === before.y_up) return;
    this.#state.change({ options });
    const asked = this.#client.setOptions({ method, initialisation, options: { y_up: false, ...options } });
    this.#attempt(Promise.all([asked, this.#client.solve()]));
  }

  // ----------------------------------------------------------------------------------------------------------- solving

  /** They stand in the document at once, so that the next choice builds on this one, and are taken back if refused. `name`: what
   *  the history calls them, if not by themselves. */
  async setOptions(given: SolverSettings, name?: ChangeName): Promise<void> {
    const before = this.#before();
    const options = { y_up: false, ...weighed(given.options, this.opening?.document.view.upAxis) };
    const settings = { ...given, options };
    const after = { ...settings, options: this.#unusual(options) };
    const asked = this.#client.setOptions(settings);
    const change = settingsChange(before, after);
    if (change) this.#state.history.record(before, name || change.name, change.key);
    this.#state.change(after);
    try {
      await asked;
    } catch (error) {
      // A solver that replaces a lost one takes them from the document.
      if (this.#client.returning) return;
      if (change) this.#state.history.takeBack(before);
      if (this.opening?.document.options === after.options) {
        const { method, initialisation, options } = before;
        this.#state.change({ method, initialisation, options });
      }
      throw error;
    }
  }

  /** The net is solved for them at once. Both are asked for together: what is done next, be it undo or stop, comes after both. */
  async #behave(settings: SolverSettings, name?: ChangeName): Promise<void> {
    this.#before();
    await Promise.all([this.setOptions(settings, name), this.#client.solve()]);
  }

  /** Those that a document has: usual ones need no place. */
  #unusual(options: SolverOptions): SolverOptions {
    const usual = new Map(this.#optionTable.map(({ name, value }) => [name, value]));
    return Object.fromEntries(Object.entries(options).filter(([name, value]) => Number(value) !== usual.get(name)));
  }

  /** All edges grow by one factor, as little as brings handles to where they were to be. The option `length_scale` then; null
   *  if none does, and nothing has changed. Fails as "cancelled" where the net is touched meanwhile. */
  async adaptLengths(progress: (passed: SearchProgress) => void): Promise<number | null> {
    this.#before();
    const scale = await this.#client.adaptLengths(progress);
    // Names, and what else leaves the net alone, may have changed meanwhile.
    const before = this.#state.snapshot();
    if (before === null || scale === null) return scale;
    this.#state.history.record(before, ['option', { option: 'length_scale' }, scale.toPrecision(4)]);
    this.#state.change({ options: { ...before.options, length_scale: scale } });
    return scale;
  }

  /** Puts a surface beside the net, or takes it away; the net is solved anew. */
  async setGuide(guide: GuideSource | undefined): Promise<void> {
    const before = this.#before();
    if (before.guide === guide) return;
    const { guide: _, ...without } = before;
    this.#state.history.record(before, guide ? ['guide', guideTitle(guide)] : ['noGuide']);
    await this.#restoreFrom(before, { ...without, ...(guide ? { guide } : {}), settled: false });
  }

  /** Refused, the change that has just been recorded is taken back. */
  async #restoreFrom(before: Snapshot, after: Snapshot): Promise<void> {
    try {
      await this.#opener.restore(after);
    } catch (error) {
      if (this.#state.history.takeBack(before)) await this.#opener.restore(before);
      // What has been done since stays; the solver, unless it is a new one, does it beside the surface of before.
      else if (!this.#client.returning && this.opening?.document.guide === after.guide)
        this.#state.change({ guide: before.guide });
      throw error;
    }
  }

  /** Moves the handles that are not locked onto the surface beside the net. */
  async putHandlesOnGuide(): Promise<void> {
    const handles = this.#state.handles.filter(({ anchor }) => !anchor);
    const targets = await this.#client.nearest(handles.map(({ target }) => target));
    await this.handles.moveByHand(handles.map(({ vertex }, i) => ({ vertex, target: targets[i]! })));
  }

  /** Pushes the net through between its handles, to look for its other equilibrium. Where it comes to no rest, or to a crumpled
   *  one, it goes back. How far the vertex that moves most has come once the net has settled, in edge lengths; null: something
   *  else is done by then. */
  async flip(): Promise<number | null> {
    this.#before();
    const flipping = flipper().then(({ flip }) =>
      flip(this.#client, this.#state, {
        before: () => this.#before(),
        restoreFrom: (before, after) => this.#restoreFrom(before, after),
        restore: (snapshot) => this.#opener.restore(snapshot),
        isQuiet: () => this.isQuiet,
      }),
    );
    // Until it stays or has gone back, nothing is settled.
    return this.awaitNet(flipping);
  }

  /** Looks for another net at rest, with less energy, by other ways to the same handles. The part of the energy that is gone then;
   *  null if none has less, and nothing has changed. Fails as "cancelled" where the net is touched meanwhile. */
  async searchRest(progress: (passed: SearchProgress) => void): Promise<number | null> {
    this.#before();
    const left = await this.#client.searchRest(progress);
    const before = this.#state.snapshot();
    if (before === null || left === null) return null;
    this.#state.history.record(before, ['relax']);
    return 1 - left;
  }

  /** One iteration, then stop. */
  step(): Promise<void> {
    return this.#client.step();
  }

  /** Back to rest, handles too, with edges as long as they were made; by other options from then on, if any are `given`. */
  async reset(given?: SolverOptions): Promise<void> {
    const before = this.#before();
    if (this.opening === null) return;
    const { restPositions } = this.opening.net;
    const atRest = (handle: HandleData): HandleData => ({ ...handle, target: pointOf(restPositions, handle.vertex) });
    const { method, initialisation } = before;
    const options = asMade(given ? this.#unusual(given) : before.options);
    this.#state.history.record(before, ['reset']);
    this.#state.change({ handles: before.handles.map(atRest), positions: restPositions, options });
    const isToldOptions = given !== undefined || 'length_scale' in before.options;
    // Both at once: another net may be opened before the first is answered.
    await Promise.all([
      isToldOptions && this.#client.setOptions({ method, initialisation, options }),
      this.#client.reset(),
    ]);
  }

  /** All of the net moves with its handles from now on, and comes to rest so at once. */
  async moveWhole(): Promise<void> {
    this.#before();
    this.handles.setLocality(undefined);
    await this.#client.solve();
  }

  /** The net that is open, for another to be made of it. Fails where a change of it would. */
  netToChange(): Opening {
    this.#before();
    return this.opening!;
  }

  /** The state before a change of the net. Fails where there is none to be changed: the worker would take the change for the
   *  net that it is just opening. */
  #before(): Snapshot {
    const before = this.#beforeIfAny();
    if (before !== null) return before;
    // So that controls show again what is.
    this.#presenter.schedule();
    throw this.#opener.isOpening ? new Failure('cancelled', words.opening.underWay) : noNet();
  }

  #beforeIfAny(): Snapshot | null {
    return this.#opener.isOpening ? null : this.#state.snapshot();
  }

  // -------------------------------------------------------------------------------------------------------------- undo

  undo(): void {
    this.#attempt(this.#opener.goBy(-1));
  }

  redo(): void {
    this.#attempt(this.#opener.goBy(1));
  }

  /** Goes to an entry of the history. */
  goTo(index: number): void {
    this.#attempt(this.#opener.goTo(index));
  }

  // --------------------------------------------------------------------------------------------------------- comparing

  /** Runs methods on the present edit, in a worker of their own. */
  compare({ methods, start }: ComparisonRequest): void {
    if (this.opening === null) return;
    const { document } = this.opening;
    const { net, numbering } = document;
    const positions = start === 'rest' ? null : document.positions;
    const planOf = (method: string): RunPlan => ({
      label: words.core.method(method),
      style: this.#methods.indexOf(method), // the same in every comparison
      scene: { ...document, method, positions },
      threshold: this.#threshold(document),
      net: { net, numbering },
    });
    this.#run(methods.map(planOf));
  }

  /** Runs these from rest, in a worker of their own; those without an edit of their own on the present one. */
  runAll(requests: readonly RunRequest[]): void {
    if (this.opening === null) return;
    const { document } = this.opening;
    const { net, numbering } = document;
    const planOf = ({ label, edit, ...settings }: RunRequest, style: number): RunPlan => ({
      label,
      style,
      scene: { ...document, ...settings, ...(edit ? { ...edit, numbering: undefined } : {}), positions: null },
      threshold: this.#threshold(settings),
      net: edit === undefined ? { net, numbering } : null,
    });
    this.#run(requests.map(planOf));
  }

  #run(plans: readonly RunPlan[]): void {
    this.#presenter.showOwnNet();
    this.#attempt(this.#comparer().then((comparer) => comparer.start(plans)));
  }

  #threshold({ options }: Pick<SolverSettings, 'options'>): number {
    const usual = this.#optionTable.find(({ name }) => name === 'threshold')?.value;
    return Number(options.threshold ?? usual);
  }

  // ----------------------------------------------------------------------------------------------- what it is made from

  #createClient({ spawnWorker }: AppParts): Client {
    return new Client(spawnWorker, {
      document: () => this.opening?.document ?? null,
      frame: (frame, settled) => this.#takeFrame(frame, settled),
      restarted: (why, isBack) => this.#restarted(why, isBack),
      gaveUp: (why) => this.report(why),
    });
  }

  #createOpener(): Opener {
    return new Opener(this.#client, this.#state, {
      leaving: () => {
        this.#presenter.showOwnNet();
        this.handles.endDrag(false);
      },
      opened: () => {
        this.handles.netChanged();
        this.#presenter.presentNet();
      },
      say: (message) => this.say(message),
      unsay: () => this.unsay(),
      notice: (isShown, canCancel) => this.#presenter.panels.setOpening(isShown, canCancel),
    });
  }

  #createHandleEditor(): HandleEditor {
    const guide = new DragGuide(this.#client, {
      setRegion: (mobility) => this.#presenter.view.setRegion(mobility),
      setShares: (shares) => this.#presenter.view.setShares(shares),
      setReach: (balls) => this.#presenter.view.setReach(balls),
      setReadout: (text) => this.#presenter.view.setReadout(text),
    });
    return new HandleEditor(
      {
        opening: () => this.opening,
        before: () => this.#before(),
        beforeIfAny: () => this.#beforeIfAny(),
        change: (change) => this.#state.change(change),
        drag: (handles) => {
          this.#state.drag(handles);
          this.#presenter.presentHandles();
        },
        restore: (snapshot) => this.#attempt(this.#opener.restore(snapshot)),
        choiceChanged: () => this.#presenter.schedule(),
        say: (message) => this.say(message),
        attempt: (doing) => this.#attempt(doing),
      },
      this.#client,
      this.#state.history,
      guide,
    );
  }

  #viewEvents(): Omit<ViewEvents, 'cameraMoved'> {
    return {
      addHandle: (vertex, also) => this.handles.add(vertex, also),
      select: (selection) => this.handles.select(selection),
      dragStart: () => {
        this.#presenter.showRun(null);
        return this.handles.beginDrag();
      },
      dragMove: (targets, along) => this.handles.drag(targets, along),
      dragEnd: (cancelled) => this.handles.endDrag(cancelled),
      lockedStay: () => this.handles.sayLocked(),
      cameraChanged: (camera) => this.setView({ camera }),
      failed: (error) => this.report(error),
    };
  }

  #panelEvents(services: AppServices): PanelEvents {
    return {
      ...services,
      openRecipe: latestOnly(
        (recipe) => this.openNet({ recipe }),
        (error) => this.report(error),
      ),
      cancelOpening: () => this.cancelOpening(),
      handles: this.handles,
      preview: (vertices) => this.#presenter.view.setPreview(this.handles.bothSides(vertices)),
      previewAlone: (vertices) => this.#presenter.view.setPreview(vertices),
      mark: (cells) => this.#presenter.view.setMarks(cells),
      fade: (stays) => this.#presenter.view.setRegion(stays),
      takePen: (pen) => this.#presenter.view.takePen(pen),
      setOptions: (settings) => this.#attempt(this.setOptions(settings)),
      setBehaviour: (settings, name) => this.#attempt(this.#behave(settings, name)),
      adaptLengths: (progress) => this.adaptLengths(progress),
      setView: (change) => this.setView(change),
      putHandlesOnGuide: () => this.#attempt(this.putHandlesOnGuide()),
      letGoOfGuide: () => this.#attempt(this.setGuide(undefined)),
      flip: () =>
        this.flip().catch((error: unknown) => {
          this.report(error);
          return null;
        }),
      searchRest: (progress) =>
        this.searchRest(progress).catch((error: unknown) => {
          this.report(error);
          return undefined;
        }),
      solve: () => this.#attemptNamed(['solve'], () => this.#client.solve()),
      step: () => this.#attemptNamed(['step'], () => this.step()),
      setStepArrows: (shown) => this.#presenter.view.setStepArrows(shown),
      cancel: () => this.#attempt(this.#client.cancel()),
      moveWhole: () => this.#attempt(this.moveWhole()),
      reset: (options) => this.#attempt(this.reset(options)),
      compare: (request) => this.compare(request),
      runAll: (requests) => this.runAll(requests),
      cancelComparison: () => this.#attempt(this.#comparer().then((comparer) => comparer.cancel())),
      showRun: (run) => this.#presenter.showRun(run),
      showBeside: (runs) => this.#presenter.showBeside(runs),
      undo: () => this.undo(),
      redo: () => this.redo(),
      goTo: (index) => this.goTo(index),
      frameAll: (from) => this.frameAll(from),
      isFramed: () => this.#presenter.view.framed,
      screenPositions: (vertices) => this.#presenter.view.screenPositions(vertices),
      isChanging: () => this.#client.changing,
    };
  }

  // ------------------------------------------------------------------------------------------------------- from the solver

  #takeFrame(frame: FrameData, settled: boolean): void {
    if (this.opening === null) return;
    this.#state.takeFrame(frame, settled);
    this.#presenter.presentFrame(frame);
    this.#emit('frame');
    if (settled) this.#emit('settled');
  }

  #restarted(why: Failure, isBack: boolean): void {
    if (!isCancelled(why)) this.#emit('restarted');
    if (!isBack) {
      this.#presenter.panels.say(words.solver.stopped(sentence(why)), 'error');
      return;
    }
    this.handles.resumeDrag();
    if (!isCancelled(why)) this.#presenter.panels.say(words.solver.restarted(sentence(why)), 'error');
  }

  /** A listener that fails, as one of a script may, keeps nothing else from going on. */
  #emit(event: AppEvent, error?: unknown): void {
    for (const listener of this.#listeners[event]) {
      try {
        listener(error);
      } catch (fault) {
        reportError(fault);
      }
    }
  }

  /** For what the user does: a failure is shown, not thrown. */
  #attempt(doing: Promise<unknown>): void {
    doing.catch((error: unknown) => this.report(error));
  }

  /** Likewise, as an entry of the history. */
  #attemptNamed(name: ChangeName, doing: () => Promise<unknown>): void {
    const before = this.#beforeIfAny();
    if (before === null) return;
    this.#state.history.record(before, name);
    this.#attempt(doing());
  }
}

/** What went wrong, as a sentence. */
function sentence(error: unknown): string {
  return words.core.sentence(messageOf(error));
}

/** Keeps view and panels up to date. All changes within one task are presented once, after it. */
import { Beside } from '../compare/beside';
import { canShow, type Run } from '../compare/run';
import { type ChebnetDocument, type GuideSource, type HandleData, lookOf } from '../document/document';
import type { Choice } from '../handles/commands';
import type { PanelEvents, Panels } from '../panels';
import type { View, ViewEvents } from '../view/view';
import type { DrawnSurface, FrameData } from '../worker/protocol';
import type { State } from './state';

/** Factories for the parts of the page. */
export interface Screen {
  createView(events: ViewEvents): View;
  /** Another view, in the first or second place to the right of it. */
  createBeside(events: ViewEvents, place: number): View;
  createPanels(events: PanelEvents): Panels;
}

/** The state that is presented. */
interface Presented {
  state: Pick<State, 'opening' | 'handles' | 'history' | 'withTraits'>;
  choice(): Choice;
  /** Whether the solver is at work. */
  solving(): boolean;
  /** What is drawn of the surface beside the net. */
  guide(): Promise<DrawnSurface | null>;
}

export class Presenter {
  readonly view: View;
  readonly panels: Panels;
  readonly #beside: Beside;
  readonly #presented: Presented;
  #isScheduled = false;
  /** Their pictures come first. */
  #unsaid: FrameData[] = [];
  #shownGuide: GuideSource | undefined;
  /** Of corners, in the view's colours. */
  #shownLimit: number | undefined;
  /** The run whose net the view shows in place of the user's. */
  #shownRun: Run | null = null;
  /** The runs whose nets stand beside it. */
  #runsBeside: readonly Run[] = [];

  constructor(
    screen: Screen,
    viewEvents: Omit<ViewEvents, 'cameraMoved'>,
    panelEvents: PanelEvents,
    presented: Presented,
  ) {
    this.#presented = presented;
    this.#beside = new Beside(screen.createBeside, (camera) => {
      this.view.setCamera(camera);
      viewEvents.cameraChanged(camera);
    });
    this.view = screen.createView({ ...viewEvents, cameraMoved: (camera) => this.#beside.setCamera(camera) });
    this.panels = screen.createPanels(panelEvents);
  }

  /** Presents document, choice and history after the current task. */
  schedule(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    queueMicrotask(() => {
      this.#isScheduled = false;
      this.#present();
    });
  }

  #present(): void {
    const { opening, history } = this.#presented.state;
    if (opening === null) return;
    const { document } = opening;
    const choice = this.#presented.choice();
    this.view.setSymmetry(document.symmetry);
    this.#presentGuide(document);
    this.view.setHandles(this.#shownHandles(), choice);
    this.#presentLimit(document);
    this.panels.setDocument(document, choice);
    this.panels.setHistory(history);
  }

  /** Colours by shear go up to the limit of the corners. */
  #presentLimit(document: ChebnetDocument): void {
    const { cornerLimit } = lookOf(document);
    if (cornerLimit !== this.#shownLimit) this.setAppearance(document);
  }

  #presentGuide({ guide, view }: ChebnetDocument): void {
    const shown = view.guideHidden ? undefined : guide;
    if (shown === this.#shownGuide) return;
    this.#shownGuide = shown;
    const show = (surface: DrawnSurface | null) => {
      if (shown === this.#shownGuide) this.view.setGuide(surface);
    };
    if (shown === undefined) show(null);
    // What is lost with the solver is asked for again with the next surface.
    else this.#presented.guide().then(show, () => show(null));
  }

  /** Another net is open; before, the user's own was shown. */
  presentNet(): void {
    const { opening } = this.#presented.state;
    if (opening === null) return;
    const { document, net, frame } = opening;
    // Before the view, which fits the net into the space that the panels leave.
    this.panels.setDocument(document, this.#presented.choice());
    this.setAppearance(document);
    this.view.setNet(net, frame, document.view);
    this.panels.setNet(net);
    this.#unsaid = [];
    this.#presentNumbers(frame);
    this.schedule();
  }

  /** The net has moved. The user's own is shown again. While it goes on moving, its numbers follow the picture, or the next frame. */
  presentFrame(frame: FrameData): void {
    this.showRun(null);
    this.view.setFrame(frame);
    this.#unsaid.push(frame);
    if (this.#unsaid.length > 1 || !this.#presented.solving()) this.#presentUnsaid();
    else requestAnimationFrame(() => setTimeout(() => this.#presentUnsaid()));
  }

  /** Handles only, and at once: they follow the pointer, or the net on which they slide. */
  presentHandles(): void {
    const { handles } = this.#presented.state;
    const choice = this.#presented.choice();
    this.view.setHandles(handles, choice);
    this.panels.setHandles(handles, choice);
  }

  setAppearance(document: ChebnetDocument): void {
    const look = lookOf(document);
    this.#shownLimit = look.cornerLimit;
    this.view.setAppearance(look);
    this.#beside.setAppearance(look, () => this.view.camera());
  }

  // -------------------------------------------------------------------------------------------------- nets of a comparison

  /** Shows the net of a run in place of the user's, which comes back with null or whenever it moves. One of another net is not
   *  shown: it has other vertices. */
  showRun(run: Run | null): void {
    const { opening } = this.#presented.state;
    if (run === this.#shownRun || opening === null || (run && !canShow(run, opening.document))) return;
    this.#shownRun = run;
    this.view.setFrame(run?.frame ?? opening.frame);
    this.panels.setRuns(run, this.#runsBeside);
    this.schedule();
  }

  /** Shows the nets of these runs beside the other, seen from the same place, and no more. */
  showBeside(wanted: readonly Run[]): void {
    const { opening } = this.#presented.state;
    const runs = wanted.filter((run) => canShow(run, opening?.document ?? null));
    if (opening === null || (runs.length === 0 && this.#runsBeside.length === 0)) return;
    this.#runsBeside = runs;
    const frames = runs.flatMap(({ frame }) => frame ?? []);
    this.#beside.show(opening.net, frames, { ...lookOf(opening.document), camera: this.view.camera() });
    this.panels.setRuns(this.#shownRun, runs);
  }

  /** Shows the user's net only. */
  showOwnNet(): void {
    this.showRun(null);
    this.showBeside([]);
  }

  /** The user's, or those of the run whose net is shown. */
  #shownHandles(): readonly HandleData[] {
    const { state } = this.#presented;
    return this.#shownRun?.frame?.handles.map((handle) => state.withTraits(handle)) ?? state.handles;
  }

  // ------------------------------------------------------------------------------------------------------------- numbers

  #presentUnsaid(): void {
    for (const frame of this.#unsaid.splice(0)) this.#presentNumbers(frame);
  }

  #presentNumbers(frame: FrameData): void {
    this.panels.setFrame(frame, this.view.framesPerSecond(), this.#presented.solving());
  }
}

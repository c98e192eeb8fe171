/** The contract between the page and its controls; built from native HTML elements. Panels show state and report
 *  intentions; they never change the document themselves. */
import type { Comparison, ComparisonRequest, Run, RunRequest } from './compare/run';
import type { WantedChange } from './change/subject';
import type { ChebnetDocument, HandleData, SolverOptions, SolverSettings, ViewState } from './document/document';
import type { ChangeName } from './document/naming';
import type { HistoryView } from './document/undo';
import type { SaveRequest } from './export/kinds';
import type { Language } from './language/choice';
import type { Choice, HandleCommands } from './handles/commands';
import type { Tables } from './net/tables';
import type { Side } from './view/camera_fit';
import type { Pen, PenEvents } from './view/view';
import type { FrameData, OpenedNet, SearchProgress } from './worker/protocol';

/** Lessons that the net can demonstrate. */
export type Lesson = 'net' | 'deviation' | 'energy' | 'stages';
/** The method whose stages are taught. */
export const TAUGHT_METHOD = 'li2022';

export interface PanelEvents {
  /** Open a shape; of those asked for while one is being opened, only the last. Resolves once that is open, or refused. */
  openRecipe(recipe: string): Promise<void>;
  /** Cancel the opening of a net. */
  cancelOpening(): void;
  /** The user wants to pick a file, a net or a project. */
  pickFile(): void;
  showKeys(): void;
  /** Demonstrate a lesson on the net. */
  showLesson(lesson: Lesson): void;
  /** Give all edges of the net that is open one length. */
  equalize(): void;
  drape(): void;
  /** Give the net that is open other faces, or edges of another length. */
  changeNet(wanted: WantedChange): void;
  /** Open the default net in place of the present one. */
  newNet(): void;
  saveProject(): void;
  /** Show the projects that the browser keeps. */
  chooseProject(): void;
  /** Open the project stored before the present one. */
  restoreLast(): void;
  chooseLanguage(language: Language): void;
  handles: HandleCommands;
  /** Preview the vertices that a button would select, with their mirror images; none: no longer. */
  preview(vertices: readonly number[]): void;
  /** Likewise vertices alone. */
  previewAlone(vertices: readonly number[]): void;
  /** Mark cells of the net, each by the vertices at its corners; none: no longer. */
  mark(cells: readonly (readonly number[])[]): void;
  /** Fade vertices by how little they stay, 1 … 0; null: no longer. */
  fade(stays: Float32Array | null): void;
  /** Until it is put away, pointers draw on the net. */
  takePen(events: PenEvents): Promise<Pen>;
  setOptions(settings: SolverSettings): void;
  /** As setOptions, and the net comes to rest by them at once. `name`: what the history calls it, if it is more than they. */
  setBehaviour(settings: SolverSettings, name?: ChangeName): void;
  /** Let all edges grow by one factor, as little as brings handles to where they were to be; see App.adaptLengths(). */
  adaptLengths(progress: (passed: SearchProgress) => void): Promise<number | null>;
  setView(change: Partial<Omit<ViewState, 'camera'>>): void;
  /** Move the handles onto the surface beside the net. */
  putHandlesOnGuide(): void;
  /** Take the surface beside the net away. */
  letGoOfGuide(): void;
  /** Look for the net's other equilibrium; see App.flip(). */
  flip(): Promise<number | null>;
  /** Look for a net at rest with less energy; see App.searchRest(). undefined: nothing has come of it. */
  searchRest(progress: (passed: SearchProgress) => void): Promise<number | null | undefined>;
  solve(): void;
  /** Let all of the net move with its handles, without a locality, and come to rest so at once. */
  moveWhole(): void;
  step(): void;
  setStepArrows(shown: boolean): void;
  cancel(): void;
  /** Back to rest; by other options from then on, if any are given. */
  reset(options?: SolverOptions): void;
  undo(): void;
  redo(): void;
  /** Goes to an entry of the history. */
  goTo(index: number): void;
  /** Run these methods one after another on the present edit. */
  compare(request: ComparisonRequest): void;
  /** Run these from rest, those without an edit of their own on the present one. */
  runAll(requests: readonly RunRequest[]): void;
  cancelComparison(): void;
  /** Show the net of a run in place of the user's; null: the user's again. */
  showRun(run: Run | null): void;
  /** Show the nets of these runs, two at most, in views beside it. */
  showBeside(runs: readonly Run[]): void;
  /** Make a link to the present scene and offer it. */
  share(): void;
  /** Save the net as a file. */
  save(request: SaveRequest): void;
  /** Record the view as a video. */
  record(): void;
  /** Shows the whole net. */
  frameAll(from?: Side): void;
  /** Whether it is shown, or will be in a moment: since that was asked for no hand has moved the camera. */
  isFramed(): boolean;
  /** Whether requests that change the net are unanswered, or it is yet to settle. */
  isChanging(): boolean;
  /** Where vertices stand, CSS pixels from the top left of the page. */
  screenPositions(vertices: readonly number[]): { x: number; y: number }[];
}

/** A button beside a message. */
export interface Action {
  label: string;
  run(): void;
}

/** One of the controls: its element, and those methods of Panels that concern it. */
export interface Panel extends Partial<Omit<Panels, 'say' | 'unsay' | 'offer'>> {
  readonly element: HTMLElement;
  /** Each frame; setFrame() has the latest, no more often than numbers can be read. */
  onFrame?(frame: FrameData): void;
}

export interface Panels {
  /** Once the worker is ready. */
  setTables(tables: Tables): void;
  /** After anything in the document changed. */
  setDocument(document: ChebnetDocument, choice: Choice): void;
  /** After anything was done, undone or redone. */
  setHistory(history: HistoryView): void;
  setNet(net: OpenedNet): void;
  /** When opening another net takes long, and when that is over. */
  setOpening(isUnderWay: boolean, canCancel: boolean): void;
  /** Live numbers and the plot. `solving`: the worker is busy. */
  setFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void;
  setHandles(handles: readonly HandleData[], choice: Choice): void;
  /** After every change of a comparison. */
  setComparison(comparison: Comparison): void;
  /** The run whose net is in the view (null: the user's own is), and those beside it. */
  setRuns(run: Run | null, beside: readonly Run[]): void;
  /** A toast for the user; `error` stays until dismissed. Read out by screen readers. */
  say(message: string, kind: 'info' | 'error', action?: Action): void;
  /** Takes away what was said: it is of what is no more. */
  unsay(): void;
  /** A message with a button; it stays until that is pressed or the message is dismissed. */
  offer(message: string, button: string, accept: () => void): void;
}

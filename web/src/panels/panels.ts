/** The contract between the page and its controls; built from native HTML elements. Panels show state and report
 *  intentions; they never change the document themselves. */
import type { MethodInfo, OptionInfo, ShapeInfo } from '../../../wasm/chebnet';
import type { ChebnetDocument, HandleData, SolverOptions, Vec3, ViewState } from '../document/document';
import type { FrameData, OpenedNet } from '../worker/protocol';

export interface PanelEvents {
  openRecipe(recipe: string): void;
  /** The user wants to pick a file. */
  pickFile(): void;
  selectHandle(vertex: number | null): void;
  /** A vertex typed in, for whoever cannot click on it; below the number of vertices, and no handle yet. */
  addHandle(vertex: number): void;
  deleteHandle(vertex: number): void;
  setHandleTarget(vertex: number, target: Vec3): void;
  setAnchor(vertex: number, anchor: boolean): void;
  setOptions(method: string, options: SolverOptions): void;
  setView(change: Partial<Omit<ViewState, 'camera'>>): void;
  solve(): void;
  step(): void;
  cancel(): void;
  reset(): void;
  undoDrag(): void;
  copyLink(): void;
  exportObj(): void;
  frameAll(): void;
}

export interface Panels {
  /** Once the worker is ready; `thumbnail` draws a recipe small, when the panel needs it. */
  showTables(
    shapes: ShapeInfo[],
    methods: MethodInfo[],
    options: OptionInfo[],
    thumbnail: (recipe: string) => Promise<{ edges: Int32Array; positions: Float32Array }>,
  ): void;
  /** After anything in the document changed. */
  showDocument(document: ChebnetDocument, selected: number | null, canUndo: boolean): void;
  showNet(net: OpenedNet): void;
  /** Live numbers and the plot. `solving`: the worker is busy. */
  showFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void;
  showHandles(handles: readonly HandleData[], selected: number | null): void;
  /** A passing line for the user; `error` stays until dismissed. Read out by screen readers. */
  say(message: string, kind: 'info' | 'error'): void;
}

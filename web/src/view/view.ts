/** The contract between the page and the 3D view; `scene.ts` implements it. The view draws and reports what hands do;
 *  it never changes the document itself. */
import type { Handle } from '../../../wasm/chebnet';
import type { HandleData, Symmetry, Vec3, ViewState } from '../document/document';
import type { Limit } from '../handles/reach';
import type { Selection } from '../handles/selection';
import type { Choice } from '../handles/commands';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** What a hand did in the view. */
export interface ViewEvents {
  /** A click on a vertex that is no handle; `also`: what is to stay selected beside it. */
  addHandle(vertex: number, also: Selection): void;
  /** A click on a handle or on nothing, or an outline drawn around handles. */
  select(selection: Selection): void;
  dragStart(): void;
  /** At most once an animation frame. */
  dragMove(targets: Handle[]): void;
  /** `cancelled`: Esc was pressed, the handles go back to where the drag began. */
  dragEnd(cancelled: boolean): void;
  /** The camera came to rest after orbit, pan or zoom. */
  cameraChanged(camera: { position: Vec3; target: Vec3 }): void;
  /** While it moves, but not by setCamera(). */
  cameraMoved(camera: { position: Vec3; target: Vec3 }): void;
  /** Something could not be shown. */
  failed(error: unknown): void;
}

const nothing = (): void => {};
/** For a net that is only looked at. */
export const LOOKING_ONLY: ViewEvents = {
  addHandle: nothing,
  select: nothing,
  dragStart: nothing,
  dragMove: nothing,
  dragEnd: nothing,
  cameraChanged: nothing,
  cameraMoved: nothing,
  failed: nothing,
};

/** What the view shows of a choice. */
export type ViewChoice = Pick<Choice, 'selection' | 'mode' | 'selecting'>;

/** The picture as it goes on. */
export interface Film {
  stream: MediaStream;
  end(): void;
}

export interface View {
  /** Shows another net; frames the camera unless one is given. */
  setNet(net: OpenedNet, frame: FrameData, camera: { position: Vec3; target: Vec3 } | null): void;
  /** New positions and fields; called once a frame, allocates nothing that grows with the net. */
  setFrame(frame: FrameData): void;
  setHandles(handles: readonly HandleData[], choice: ViewChoice): void;
  /** The plane of symmetry, if there is one. */
  setSymmetry(symmetry: Symmetry | undefined): void;
  /** Shades what moves less or not at all, 1 … 0 for each vertex; null: nothing. */
  setRegion(mobility: Float32Array | null): void;
  /** The points within all these limits, as a surface; null: none. */
  setReach(limits: readonly Limit[] | null): void;
  /** Marks vertices that a button would take. */
  setPreview(vertices: readonly number[]): void;
  setAppearance(appearance: Omit<ViewState, 'camera'>): void;
  /** Whether the direction of a single step is drawn, as arrows from where the vertices stood. */
  setStepArrows(shown: boolean): void;
  /** Back to a view of the whole net. */
  frameAll(): void;
  camera(): { position: Vec3; target: Vec3 };
  /** Looks from there at once, as another view does. */
  setCamera(camera: { position: Vec3; target: Vec3 }): void;
  /** What is seen, as PNG, with so many times the pixels of the screen; where there is nothing it is transparent. */
  picture(magnification: number): Promise<Blob>;
  /** What is seen from now on until its end, before a plain background. */
  film(): Film;
  /** Frames drawn in the last second. */
  framesPerSecond(): number;
  /** Where a vertex stands on the canvas, CSS pixels from the top left of the page; for tests and labels. */
  screenPosition(vertex: number): { x: number; y: number };
  dispose(): void;
}

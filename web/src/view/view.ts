/** The contract between the page and the 3D view; `scene.ts` implements it. The view draws and reports gestures; it
 *  never changes the document itself. */
import type { Handle } from '../../../wasm/chebnet';
import type { CameraPlace, HandleData, Look, Symmetry, ViewPlace } from '../document/document';
import type { DrawnLine } from '../change/drawn_line';
import type { Along } from '../handles/along';
import type { Limit } from '../handles/reach';
import type { Selection } from '../handles/selection';
import type { Choice } from '../handles/commands';
import type { Side } from './camera_fit';
import type { DrawnSurface, FrameData, OpenedNet } from '../worker/protocol';

/** Gestures in the view. */
export interface ViewEvents {
  /** A click on a vertex that is no handle; `also`: handles that stay selected. */
  addHandle(vertex: number, also: Selection): void;
  /** A click on a handle or on nothing, or an outline drawn around handles. */
  select(selection: Selection): void;
  /** Returns whether handles may be dragged now. */
  dragStart(): boolean;
  /** At most once an animation frame. `along`: what keys keep it to. */
  dragMove(targets: Handle[], along: Along | null): void;
  /** `cancelled`: Esc was pressed, the handles go back to where the drag began. */
  dragEnd(cancelled: boolean): void;
  /** Keys would move the selection, but all of it is locked. */
  lockedStay(): void;
  /** The camera came to rest after orbit, pan or zoom. */
  cameraChanged(camera: CameraPlace): void;
  /** While it moves, but not by setCamera(). */
  cameraMoved(camera: CameraPlace): void;
  /** Something could not be shown. */
  failed(error: unknown): void;
}

const nothing = (): void => {};
/** For a view in which nothing can be edited. */
export const LOOKING_ONLY: ViewEvents = {
  addHandle: nothing,
  select: nothing,
  dragStart: () => false,
  dragMove: nothing,
  dragEnd: nothing,
  lockedStay: nothing,
  cameraChanged: nothing,
  cameraMoved: nothing,
  failed: nothing,
};

/** The part of a choice that the view shows. */
export type ViewChoice = Pick<Choice, 'selection' | 'mode' | 'selecting' | 'part' | 'snapping'>;

/** What is done with a pen that draws on the net. */
export interface PenEvents {
  /** What the sheet that is drawn on is called, with its keys. */
  label: string;
  /** A stroke has ended; without a point, if it missed the net. */
  drawn(stroke: DrawnLine): void;
  putAway(): void;
}

export interface Pen {
  /** For its keys. */
  focus(): void;
  putAway(): void;
}

/** A video stream of the view. */
export interface Film {
  stream: MediaStream;
  end(): void;
}

export interface View {
  /** Shows another net; frames the camera unless one is given: from behind if that is said, or if the handle to begin with
   *  is there in the net at rest. */
  setNet(net: OpenedNet, frame: FrameData, place: ViewPlace): void;
  /** Whether the net is seen from behind when the camera is framed. */
  readonly behind: boolean;
  /** New positions and fields; called once a frame, allocates nothing that grows with the net. */
  setFrame(frame: FrameData): void;
  setHandles(handles: readonly HandleData[], choice: ViewChoice): void;
  /** The surface beside the net, faint, if there is one to be shown. */
  setGuide(surface: DrawnSurface | null): void;
  /** The plane of symmetry, if there is one. */
  setSymmetry(symmetry: Symmetry | undefined): void;
  /** Shades vertices by how freely they move, 1 … 0; null: nothing. */
  setRegion(mobility: Float32Array | null): void;
  /** Tints handles by what share of a move they make; those that are not named make none. null: all look alike. */
  setShares(shares: ReadonlyMap<number, number> | null): void;
  /** The points within all these limits, as a surface; null: none. */
  setReach(limits: readonly Limit[] | null): void;
  /** Says something beside the handle that leads a drag. */
  setReadout(text: string): void;
  /** Highlights the vertices that a button would select. */
  setPreview(vertices: readonly number[]): void;
  /** Until it is put away, pointers draw on the net. */
  takePen(events: PenEvents): Promise<Pen>;
  /** Marks cells, each by the vertices at its corners. */
  setMarks(cells: readonly (readonly number[])[]): void;
  setAppearance(appearance: Omit<Look, 'camera'>): void;
  /** Whether the direction of a single step is drawn, as arrows from where the vertices stood. */
  setStepArrows(shown: boolean): void;
  /** Back to a view of the whole net. */
  frameAll(from?: Side): void;
  /** Whether no hand has moved the camera since. */
  readonly framed: boolean;
  camera(): CameraPlace;
  /** Where a camera that moves will rest; null: it rests. */
  heading(): CameraPlace | null;
  /** Where it stands, if framing the net as it is now would move it; null: it would not. */
  unframed(): CameraPlace | null;
  /** Moves the camera there without animation. */
  setCamera(camera: CameraPlace): void;
  /** The view as PNG with a transparent background, at a multiple of the screen's resolution. */
  picture(magnification: number): Promise<Blob>;
  /** A stream of the view on a plain background, until its end() is called. */
  film(): Promise<Film>;
  /** Frames drawn in the last second. */
  framesPerSecond(): number;
  /** Where vertices stand on the canvas, CSS pixels from the top left of the page; for tests and labels. */
  screenPositions(vertices: readonly number[]): { x: number; y: number }[];
  dispose(): void;
}

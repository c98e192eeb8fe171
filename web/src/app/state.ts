/** What is open: a net with its document, and the history of that. */
import type { Handle } from '../../../wasm/chebnet';
import type { ChebnetDocument, DocumentNet, HandleData, NetSource, Scene, Vec3 } from '../document/document';
import { endingOf } from '../document/document';
import { type Snapshot, UndoHistory } from '../document/undo';
import { Failure } from '../failure';
import { words } from '../language/language';
import type { Opened } from '../worker/client';
import type { Opening } from '../worker/opening';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** Callbacks after a change. */
interface StateEvents {
  /** Anything in the document changed. */
  document(): void;
  /** There is something new to be presented, beyond what a frame or a drag changes. */
  presentation(): void;
  /** Handles that slide have followed the net, in a frame. */
  handles(): void;
}

/** Where handles were dragged to that stand elsewhere, as no net leads there, by the targets they have instead. */
const draggedTo = new WeakMap<Vec3, Vec3>();

/** Where a hand dragged a handle that has this target. */
export function whereDragged(target: Vec3): Vec3 {
  return draggedTo.get(target) ?? target;
}

/** Something was asked of the net that is open. */
export function noNet(): Failure {
  return new Failure('no_net', words.opening.none);
}

export class State {
  readonly history: UndoHistory;
  readonly #isChanging: () => boolean;
  readonly #events: StateEvents;
  #opening: Opening | null = null;

  /** @param isChanging whether requests that change the net are still unanswered. */
  constructor(isChanging: () => boolean, events: StateEvents) {
    this.#isChanging = isChanging;
    this.#events = events;
    this.history = new UndoHistory(() => events.presentation());
  }

  /** Null before the first net. Never changed in place: history and links may hold parts of it. */
  get opening(): Opening | null {
    return this.#opening;
  }

  get handles(): readonly HandleData[] {
    return this.#opening?.document.handles ?? [];
  }

  /** What undo may return to; null before the first net. */
  snapshot(): Snapshot | null {
    if (this.#opening === null) return null;
    const { view: _, ...state } = this.#opening.document;
    return { ...state, settled: this.isSettled };
  }

  /** While something is under way, the positions are not final. */
  get isSettled(): boolean {
    return this.#opening?.document.settled === true && !this.#isChanging();
  }

  /** Another net. */
  open(scene: Scene, { net, frame }: Opened): void {
    const last = frame.handles.length - 1;
    // Of the handles that come with a recipe the last is the one to drag.
    const handles = frame.handles.map(({ vertex, target }, i) =>
      scene.handles === 'suggested'
        ? { vertex, target, anchor: i < last }
        : { anchor: false, ...scene.handles[i], vertex, target: scene.handles[i]?.target ?? target },
    );
    const source = withArrays(scene.net, net);
    this.history.replaceNet(scene.net, source);
    const document = {
      ...scene,
      net: source,
      numbering: net.numbering,
      handles: whereTheyStand(handles, frame),
      positions: frame.positions,
      replay: undefined,
    };
    this.#set({ net, frame, document });
  }

  change(change: Partial<ChebnetDocument>): void {
    this.#change(change);
    this.#events.presentation();
  }

  /** Handles are being dragged. */
  drag(handles: HandleData[]): void {
    this.#change({ handles });
  }

  /** Goes to a state of the same net. */
  restore(state: Snapshot): void {
    if (this.#opening === null) return;
    const { net, numbering, view } = this.#opening.document;
    this.#set({ ...this.#opening, document: { ...state, net, numbering, view } });
    this.#events.presentation();
  }

  /** Takes a frame of the solver. */
  takeFrame(frame: FrameData, settled: boolean): void {
    if (this.#opening === null) return;
    const { document: before } = this.#opening;
    const stand = settled || frame.holdsBack;
    const handles = stand ? whereTheyStand(before.handles, frame) : whereTheySlide(before.handles, frame);
    const ending = settled ? endingOf(frame.status) : undefined;
    const document = { ...before, handles, positions: frame.positions, settled, ending };
    this.#set({ ...this.#opening, frame, document });
    if (handles === before.handles) return;
    if (stand) this.#events.presentation();
    else this.#events.handles();
  }

  /** A handle of the solver, with what only the document knows about it. */
  withTraits({ vertex, target }: Handle): HandleData {
    const known = this.handles.find((handle) => handle.vertex === vertex);
    return { anchor: false, ...known, vertex, target };
  }

  #change(change: Partial<ChebnetDocument>): void {
    if (this.#opening) this.#set({ ...this.#opening, document: { ...this.#opening.document, ...change } });
  }

  #set(opening: Opening): void {
    this.#opening = opening;
    this.#events.document();
  }
}

/** Handles that are held back, or were until the hand let go, have other targets than the hand gave them. */
function whereTheyStand(handles: HandleData[], frame: FrameData): HandleData[] {
  const targets = new Map(frame.handles.map(({ vertex, target }) => [vertex, target]));
  return withTargets(handles, ({ vertex, target }) => targets.get(vertex) ?? target);
}

/** Handles that slide follow the net; what else of their targets is newer than the frame stays. */
function whereTheySlide(handles: HandleData[], frame: FrameData): HandleData[] {
  return withTargets(handles, ({ vertex, target, slides }) => {
    const slid = (x: number, i: number): number =>
      slides!.includes('xyz'[i]!) ? (frame.positions[3 * vertex + i] ?? x) : x;
    return slides ? (target.map(slid) as Vec3) : target;
  });
}

/** The same array where none has another target. */
function withTargets(handles: HandleData[], targetOf: (handle: HandleData) => Vec3): HandleData[] {
  const moved = handles.map((handle) => {
    const target = targetOf(handle);
    if (target.every((x, i) => x === handle.target[i])) return handle;
    draggedTo.set(target, whereDragged(handle.target));
    return { ...handle, target };
  });
  return moved.some((handle, i) => handle !== handles[i]) ? moved : handles;
}

/** Those that the page has of an open net anyway, in place of the text it came from. */
function withArrays(source: NetSource, { restPositions, faceStart, faceVertices }: OpenedNet): DocumentNet {
  if (!('obj' in source)) return source;
  const { obj: _, ...traits } = source;
  return { ...traits, mesh: { positions: restPositions, faceStart, faceVertices } };
}

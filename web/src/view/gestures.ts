/** Pointer and key gestures in the view: a click picks, with Shift it adds; a drag on a handle moves it and what is selected with it, with Shift it
 *  draws a box around handles; a drag elsewhere moves the camera. A long touch on a handle does what Shift and a click do.
 *  While several are being selected, each click adds, and a drag beside what is selected draws a lasso. Two fingers move
 *  the camera, even if the first has just begun a drag. */
import { type Camera, Matrix4, TOUCH, Vector2, Vector3 } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Selection, toggled, united } from '../handles/selection';
import { ARROW_KEYS, chordOf } from '../elements/keys';
import type { Along } from '../handles/along';
import type { AxisDrag } from './axis_drag';
import { type DragReport, ViewPlane } from './drag';
import type { Gizmo } from './gizmo';
import type { HandleMarkers } from './handles';
import type { NetData } from './net_data';
import { Outline } from './outline';
import type { Place } from './overlay';
import { HANDLE_SLACK, nearestVertex, type Plane, type Projection, pointerKind, STILL } from './picking';
import type { ViewEvents } from './view';

/** The part of the scene that gestures use. */
export interface GestureContext {
  canvas: HTMLCanvasElement;
  camera(): Camera;
  orbit: OrbitControls;
  gizmo: Gizmo;
  markers: HandleMarkers;
  report: DragReport;
  events: ViewEvents;
  data(): NetData | null;
  /** What is beyond is not drawn. */
  section: Plane;
  selection(): Selection;
  /** Whether several are being selected. */
  selecting(): boolean;
  /** Those that move with a handle, itself first; without one, those of the selection. */
  moving(handle?: number): readonly number[];
  /** Spacing of the grid to which drags snap, in the net's unit, if there is one. */
  grid(): number | null | undefined;
  projection(): Projection;
  /** Starts a drag of handles. */
  grab(vertices: readonly number[]): void;
  /** Where those in hand are now, from where they were taken. */
  carry(motion: Matrix4, along?: Along | null): void;
  /** What keeps a drag to axes. */
  axes(): Promise<AxisDrag>;
  outline(corners: readonly Place[] | null): void;
  /** What is hovered; null: nothing. */
  hovered(found: Found | null): void;
  frameAll(): void;
}

export interface Found {
  vertex: number;
  handle: boolean;
}

interface Press {
  pointer: number;
  at: Place;
  /** Where it was last. */
  last: Place;
  /** What the pointer does if it moves: drag this handle from this point, draw an outline, or neither. */
  handle: { vertex: number; from: Vector3 } | null;
  outline: Outline | null;
  onGizmo: boolean;
  /** How far it has been from where it went down, in pixels. */
  gone: number;
  /** It has moved too far to be a click. */
  moved: boolean;
}

/** How far a click may be from the vertex that it is meant for, pixels. */
const REACH = { mouse: 12, touch: 24 };
const LONG_TOUCH_MS = 450;
/** A finger that has dragged something no farther than this may still turn out to be the first of a pinch. */
const FAR = 24;
/** How far behind the nearest vertex the front layer of the net ends, in edge lengths. */
const LAYER = 3;
/** One arrow key: a turn in radians, a shift in pixels, a nudge in edge lengths. On a grid a nudge is a step of it. */
const KEY = { turn: 0.12, pan: 40, zoom: 0.87, nudge: 0.2, bigNudge: 2 };

const AXIS_KEY = /^(Shift\+)?[XYZ]$/;

export class Gestures {
  #press: Press | null = null;
  /** Where the canvas is on the page. Asked for once a press: while it moves something, the page would be laid out for each answer. */
  #box: Pick<DOMRect, 'left' | 'top' | 'width' | 'height'> = { left: 0, top: 0, width: 1, height: 1 };
  #isBoxOld = false;
  #hover: PointerEvent | null = null;
  #hoverFrame = 0;
  /** How far the arrow keys have moved the selection while they are held; null: they are not. */
  #nudged: Vector3 | null = null;
  #longTouch: ReturnType<typeof setTimeout> | undefined;
  #axes: AxisDrag | null = null;
  readonly #plane = new ViewPlane();
  readonly #listeners = new AbortController();
  readonly #context: GestureContext;

  constructor(context: GestureContext) {
    this.#context = context;
    const { canvas } = context;
    const { signal } = this.#listeners;
    // In the capture phase of the parent: before the listeners of the camera and the gizmo.
    const above = canvas.parentElement!;
    above.addEventListener('pointerdown', (event) => this.#down(event), { signal, capture: true });
    above.addEventListener('pointermove', (event) => this.#move(event), { signal, capture: true });
    above.addEventListener('pointerup', (event) => this.#up(event), { signal, capture: true });
    above.addEventListener('pointercancel', (event) => this.#lost(event), { signal, capture: true });
    // If text of the page is selected, browsers would drag that text instead of the handle.
    above.addEventListener('dragstart', (event) => event.preventDefault(), { signal });
    // A menu, as Ctrl and a click open it on a Mac, would take the release of the pointer.
    canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    canvas.addEventListener('pointerleave', () => this.#leave(), { signal });
    canvas.addEventListener('keydown', (event) => this.#key(event), { signal });
    canvas.addEventListener('keyup', (event) => this.#keyUp(event), { signal });
    canvas.addEventListener('blur', () => this.#endNudge(), { signal });
    window.addEventListener('resize', () => (this.#isBoxOld = true), { signal });
    window.addEventListener('keydown', (event) => this.#escape(event), { signal, capture: true });
    window.addEventListener('keydown', (event) => this.#axisKey(event), { signal, capture: true });
  }

  dispose(): void {
    this.#listeners.abort();
    cancelAnimationFrame(this.#hoverFrame);
    clearTimeout(this.#longTouch);
  }

  #down(event: PointerEvent): void {
    const { canvas, orbit, gizmo } = this.#context;
    if (event.target !== canvas) return;
    this.#setHover(null);
    if (this.#press) return this.#downToo(event, this.#press);
    if (event.button !== 0 || !event.isPrimary) return;
    const isTouch = event.pointerType === 'touch';
    this.#findBox();
    const at = this.#place(event);
    const vertex = this.#handleAt(at, event);
    if (isTouch && vertex !== null && !this.#context.selecting()) this.#awaitLongTouch(event.pointerId, vertex);
    const handle = event.shiftKey ? null : this.#grip(vertex);
    const onGizmo = vertex === null && gizmo.takes(this.#toDevice(at));
    const outline = handle || onGizmo ? null : this.#outlineFrom(at, event);
    this.#press = { pointer: event.pointerId, at, last: at, handle, outline, onGizmo, gone: 0, moved: false };
    const isCameras = !handle && !onGizmo && !outline;
    // One finger does not turn the view, but OrbitControls must know of it: with another it is a pinch.
    orbit.touches.ONE = isCameras ? TOUCH.ROTATE : null;
    orbit.enabled = isCameras || isTouch;
    if (isCameras || onGizmo) return;
    gizmo.setEnabled(false);
    canvas.setPointerCapture(event.pointerId);
    if (!handle) return;
    this.#plane.grab(this.#context.camera(), handle.from, this.#toDevice(at));
    this.#loadAxes();
  }

  /** Another finger: a gesture of the camera, unless a drag is well under way; then it is ignored. */
  #downToo(event: PointerEvent, press: Press): void {
    if (isUnderWay(press)) return event.stopPropagation();
    clearTimeout(this.#longTouch);
    this.giveUp();
    this.#context.gizmo.setEnabled(false);
  }

  #move(event: PointerEvent): void {
    const press = this.#press;
    if (!press) {
      if (event.pointerType !== 'touch' && event.buttons === 0) this.#lookUnder(event);
      return;
    }
    if (event.pointerId !== press.pointer) {
      if (isUnderWay(press)) event.stopPropagation();
      return;
    }
    if (event.buttons === 0) return this.#upUnseen(event, press);
    if (this.#isBoxOld) this.#findBox();
    const at = (press.last = this.#place(event));
    press.gone = Math.max(press.gone, Math.hypot(at.x - press.at.x, at.y - press.at.y));
    if (!press.moved && press.gone > STILL[pointerKind(event)]) this.#begin(press);
    if (!press.moved) return;
    if (press.outline) this.#draw(press.outline, at);
    else this.#carry(press);
  }

  #begin(press: Press): void {
    press.moved = true;
    clearTimeout(this.#longTouch);
    if (!press.handle) return;
    this.#context.grab(this.#context.moving(press.handle.vertex));
    this.#context.canvas.style.cursor = 'grabbing';
  }

  #draw(outline: Outline, at: Place): void {
    outline.extend(at);
    this.#context.outline(outline.corners);
  }

  /** Takes the handle in hand to the pointer, as far as keys let it. */
  #carry({ handle, last }: Press): void {
    if (!handle || !this.#context.report.isUnderWay) return;
    const camera = this.#context.camera();
    const aim = this.#plane.carry(camera, this.#toDevice(last));
    const point = aim && (this.#axes?.carry(camera, handle.from, aim) ?? aim);
    if (point) this.#context.carry(shift(point.sub(handle.from)), this.#axes?.along);
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    if (!press || event.pointerId !== press.pointer) return;
    this.#letGo();
    if (press.outline && press.moved) this.#chooseInside(press.outline);
    else if (press.handle && press.moved) this.#context.report.end(false);
    else if (!press.moved && !press.onGizmo) this.#click(press.at, event);
  }

  /** It was released where neither the page nor the gizmo was told of it. */
  #upUnseen(event: PointerEvent, { onGizmo }: Press): void {
    this.#up(event);
    if (!onGizmo) return;
    this.#context.gizmo.release();
    this.#context.report.end(false);
  }

  /** pointercancel: the system uses the pointer for a gesture of its own. */
  #lost(event: PointerEvent): void {
    if (event.pointerId !== this.#press?.pointer) return;
    this.#letGo();
    this.#context.gizmo.release();
    this.#context.report.end(true);
  }

  #letGo(): void {
    clearTimeout(this.#longTouch);
    this.#press = null;
    this.#axes?.free();
    this.#context.orbit.enabled = true;
    this.#context.gizmo.setEnabled(true);
    this.#context.canvas.style.cursor = '';
    this.#context.outline(null);
  }

  /** Forgets what pointer and keys were about to do, and cancels the drag under way. */
  giveUp(): void {
    this.#nudged = null;
    if (this.#press) this.#press = { ...this.#press, moved: true, handle: null, outline: null, onGizmo: false };
    this.#axes?.free();
    this.#context.outline(null);
    this.#context.gizmo.release();
    this.#context.report.end(true);
    this.#context.canvas.style.cursor = '';
  }

  #click(at: Place, event: PointerEvent): void {
    const { events } = this.#context;
    const selection = this.#context.selection();
    const found = this.#find(at, event);
    const adds = event.shiftKey || this.#context.selecting();
    if (found && !found.handle) events.addHandle(found.vertex, adds ? selection : []);
    else if (found) events.select(adds ? toggled(selection, found.vertex) : [found.vertex]);
    else if (!adds) events.select([]);
  }

  #outlineFrom(at: Place, { shiftKey }: PointerEvent): Outline | null {
    if (shiftKey) return new Outline('box', at);
    return this.#context.selecting() ? new Outline('lasso', at) : null;
  }

  #chooseInside({ corners }: Outline): void {
    const { markers, events } = this.#context;
    events.select(united(this.#context.selection(), markers.inside(this.#context.projection(), corners)));
  }

  #awaitLongTouch(pointer: number, vertex: number): void {
    // A frame later: a busy page may still have moves to process that come before it.
    this.#longTouch = setTimeout(
      () => requestAnimationFrame(() => this.#takeLongTouch(pointer, vertex)),
      LONG_TOUCH_MS,
    );
  }

  #takeLongTouch(pointer: number, vertex: number): void {
    if (this.#press?.pointer !== pointer || this.#press.moved) return;
    // The long touch is over: moving or lifting the finger does nothing more.
    this.#press = { ...this.#press, moved: true, handle: null };
    this.#context.events.select(toggled(this.#context.selection(), vertex));
  }

  /** A handle that can be dragged; null: there is none, or it is locked, or not selected yet. */
  #grip(vertex: number | null): Press['handle'] {
    const { markers } = this.#context;
    if (this.#context.selecting() && !this.#context.selection().includes(vertex ?? -1)) return null;
    const point = vertex === null || markers.isLocked(vertex) ? undefined : markers.point(vertex);
    return point ? { vertex: vertex!, from: point.clone() } : null;
  }

  #find(at: Place, event: PointerEvent): Found | null {
    const handle = this.#handleAt(at, event);
    if (handle !== null) return { vertex: handle, handle: true };
    const data = this.#context.data();
    if (!data || this.#context.selecting()) return null;
    const layer = LAYER * data.edgeLength;
    const { points, vertexCount } = data;
    const projection = this.#context.projection();
    const vertex = nearestVertex(
      points,
      vertexCount,
      projection,
      at.x,
      at.y,
      REACH[pointerKind(event)],
      layer,
      this.#context.section,
    );
    if (vertex === null || this.#context.markers.isHidden(vertex)) return null;
    return { vertex, handle: this.#context.markers.point(vertex) !== undefined };
  }

  #handleAt(at: Place, event: PointerEvent): number | null {
    return this.#context.markers.at(this.#context.projection(), at.x, at.y, HANDLE_SLACK[pointerKind(event)]);
  }

  /** At most once a frame, however many events the mouse sends. */
  #lookUnder(event: PointerEvent): void {
    const pending = this.#hover !== null;
    this.#hover = event;
    if (pending) return;
    this.#hoverFrame = requestAnimationFrame(() => {
      const last = this.#hover;
      this.#hover = null;
      if (!last || this.#press) return;
      this.#findBox();
      this.#setHover(last.target === this.#context.canvas ? this.#find(this.#place(last), last) : null);
    });
  }

  #leave(): void {
    if (!this.#press) this.#setHover(null);
  }

  #setHover(found: Found | null): void {
    const { canvas } = this.#context;
    canvas.style.cursor = !found ? '' : !found.handle ? 'crosshair' : this.#grip(found.vertex) ? 'grab' : 'pointer';
    this.#context.hovered(found);
  }

  /** Before all other listeners: Esc in a gesture cancels this gesture, and does nothing else. */
  #escape(event: KeyboardEvent): void {
    const isDrawing = this.#press?.outline && this.#press.moved;
    if (event.key !== 'Escape' || (!this.#context.report.isUnderWay && !isDrawing)) return;
    event.stopPropagation();
    event.preventDefault();
    this.giveUp();
  }

  /** Likewise X, Y and Z keep a drag to axes. */
  #axisKey(event: KeyboardEvent): void {
    const press = this.#press;
    const chord = chordOf(event);
    if (!press?.handle || !this.#context.report.isUnderWay || !AXIS_KEY.test(chord)) return;
    event.stopPropagation();
    event.preventDefault();
    if (!event.repeat) this.#loadAxes((axes) => this.#keepTo(axes, chord, press));
  }

  #keepTo(axes: AxisDrag, chord: string, press: Press): void {
    if (press !== this.#press) return;
    axes.press(chord);
    this.#carry(press);
  }

  #loadAxes(then: (axes: AxisDrag) => void = () => {}): void {
    this.#context
      .axes()
      .then((axes) => then((this.#axes = axes)))
      .catch((error: unknown) => this.#context.events.failed(error));
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROW_KEYS[event.key];
    if (arrow) this.#arrowKey(arrow[0], -arrow[1], event.shiftKey);
    else if (event.key === '+' || event.key === '=') this.#context.orbit.dollyIn(KEY.zoom);
    else if (event.key === '-') this.#context.orbit.dollyOut(KEY.zoom);
    else if (event.key === 'Home') this.#context.frameAll();
    else return;
    event.preventDefault();
  }

  #keyUp(event: KeyboardEvent): void {
    if (event.key in ARROW_KEYS) this.#endNudge();
  }

  #endNudge(): void {
    if (!this.#nudged) return;
    this.#nudged = null;
    this.#context.report.end(false);
  }

  #arrowKey(dx: number, dy: number, big: boolean): void {
    const { orbit } = this.#context;
    if (this.#context.selection().length > 0) this.#nudge(dx, dy, big ? KEY.bigNudge : KEY.nudge);
    else if (big) orbit.pan(-dx * KEY.pan, dy * KEY.pan);
    else if (dx) orbit.rotateLeft(dx * KEY.turn);
    else orbit.rotateUp(dy * KEY.turn);
  }

  /** Moves the selection in the view plane, or on a grid along the axes nearest to it; held keys and their repeats make one drag. */
  #nudge(dx: number, dy: number, edges: number): void {
    const camera = this.#context.camera();
    const moving = this.#context.moving();
    const data = this.#context.data();
    if (!data || this.#press) return;
    if (moving.length === 0) return this.#context.events.lockedStay();
    if (!this.#nudged) {
      this.#nudged = new Vector3();
      this.#context.grab(moving);
    }
    const grid = this.#context.grid();
    const step = grid ? (edges / KEY.nudge) * grid * data.space.scale : edges * data.edgeLength;
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    if (grid) up.setComponent(toAxis(right), 0);
    if (grid) toAxis(up);
    this.#nudged.addScaledVector(right, dx * step).addScaledVector(up, dy * step);
    this.#context.carry(shift(this.#nudged));
  }

  #findBox(): void {
    this.#isBoxOld = false;
    this.#box = this.#context.canvas.getBoundingClientRect();
  }

  #place({ clientX, clientY }: PointerEvent): Place {
    return { x: clientX - this.#box.left, y: clientY - this.#box.top };
  }

  #toDevice({ x, y }: Place): Vector2 {
    const { width, height } = this.#box;
    return new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
  }
}

/** Whether it is too far advanced to be given up for the camera. */
function isUnderWay({ handle, onGizmo, gone }: Press): boolean {
  return (handle !== null || onGizmo) && gone > FAR;
}

/** Makes a direction that of the nearest axis, whose number it returns. */
function toAxis(way: Vector3): number {
  const sizes = way.toArray().map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const sign = Math.sign(way.getComponent(axis));
  way.set(0, 0, 0).setComponent(axis, sign);
  return axis;
}

function shift(by: Vector3): Matrix4 {
  return new Matrix4().makeTranslation(by);
}

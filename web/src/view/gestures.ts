/** What hands mean: a click picks, a drag on a handle moves it, a drag elsewhere is the camera's. */
import { Vector2, Vector3, type PerspectiveCamera } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { AxisArrows } from './axis_arrows';
import { type DragReport, ViewPlane } from './drag';
import type { HandleMarks } from './handles';
import type { NetData } from './net_data';
import type { Place } from './overlay';
import { nearestVertex, type Projection } from './picking';
import type { ViewEvents } from './view';

/** What the scene lends to the hands. */
export interface GestureStage {
  canvas: HTMLCanvasElement;
  camera: PerspectiveCamera;
  orbit: OrbitControls;
  arrows: AxisArrows;
  marks: HandleMarks;
  report: DragReport;
  events: ViewEvents;
  data(): NetData | null;
  selected(): number | null;
  projection(): Projection;
  /** The handle in hand is at this point of the scene. */
  carry(point: Vector3): void;
  /** What lies under a resting pointer; null: nothing. */
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
  /** The handle that will move if the pointer does. */
  handle: number | null;
  onArrow: boolean;
  moved: boolean;
}

/** A fingertip hides what it points at: it may miss by more, and trembles more. */
const REACH = { mouse: 12, touch: 24 };
const HANDLE_SLACK = { mouse: 4, touch: 16 };
const STILL = { mouse: 3, touch: 8 };
/** How far behind the nearest vertex the front layer of the net ends, in edge lengths. */
const LAYER = 3;
/** One arrow key: a turn in radians, a shift in pixels, a nudge in edge lengths. */
const KEY = { turn: 0.12, pan: 40, zoom: 1.15, nudge: 0.2, bigNudge: 2 };
const ARROW_KEYS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class Gestures {
  private press: Press | null = null;
  private hover: PointerEvent | null = null;
  private hoverFrame = 0;
  private nudging = false;
  private readonly plane = new ViewPlane();
  private readonly listeners = new AbortController();

  constructor(private readonly stage: GestureStage) {
    const { canvas } = stage;
    const { signal } = this.listeners;
    // In the capture phase of the parent: decided before the camera's and the arrows' own listeners hear of it.
    const above = canvas.parentElement!;
    above.addEventListener('pointerdown', (event) => this.down(event), { signal, capture: true });
    above.addEventListener('pointermove', (event) => this.move(event), { signal, capture: true });
    above.addEventListener('pointerup', (event) => this.up(event), { signal, capture: true });
    above.addEventListener('pointercancel', (event) => this.lost(event), { signal, capture: true });
    canvas.addEventListener('pointerleave', () => this.leave(), { signal });
    canvas.addEventListener('keydown', (event) => this.key(event), { signal });
    canvas.addEventListener('keyup', (event) => this.keyUp(event), { signal });
    canvas.addEventListener('blur', () => this.endNudge(), { signal });
    window.addEventListener('keydown', (event) => this.escape(event), { signal, capture: true });
  }

  dispose(): void {
    this.listeners.abort();
    cancelAnimationFrame(this.hoverFrame);
  }

  private down(event: PointerEvent): void {
    const { canvas, camera, orbit, arrows, marks } = this.stage;
    if (event.target !== canvas) return;
    this.setHover(null);
    if (this.press) {
      // A second finger: the camera's business, no click any more.
      this.press.moved = true;
      return;
    }
    if (event.button !== 0) return;
    const at = this.place(event);
    const handle = this.handleAt(at, event);
    const held = handle !== null && this.mayDrag(handle) && !event.shiftKey ? handle : null;
    const onArrow = held === null && this.stage.selected() !== null && arrows.takes(this.toDevice(at));
    this.press = { pointer: event.pointerId, at, handle: held, onArrow, moved: false };
    if (held === null && !onArrow) return;
    orbit.enabled = false;
    if (held === null) return;
    arrows.setEnabled(false);
    canvas.setPointerCapture(event.pointerId);
    this.plane.grab(camera, marks.point(held)!, this.toDevice(at));
  }

  private move(event: PointerEvent): void {
    const { press } = this;
    if (!press) {
      if (event.pointerType !== 'touch' && event.buttons === 0) this.lookUnder(event);
      return;
    }
    if (event.pointerId !== press.pointer) return;
    const at = this.place(event);
    if (!press.moved && Math.hypot(at.x - press.at.x, at.y - press.at.y) > STILL[kind(event)]) {
      press.moved = true;
      if (press.handle !== null) {
        this.stage.report.begin(press.handle);
        this.stage.canvas.style.cursor = 'grabbing';
      }
    }
    if (!press.moved || press.handle === null || this.stage.report.vertex === null) return;
    const point = this.plane.carry(this.stage.camera, this.toDevice(at));
    if (point) this.stage.carry(point);
  }

  private up(event: PointerEvent): void {
    const { press } = this;
    if (!press || event.pointerId !== press.pointer) return;
    this.letGo();
    if (press.handle !== null && press.moved) this.stage.report.end(false);
    else if (!press.moved && !press.onArrow) this.click(press.at, event);
  }

  /** The system took the pointer away, for a gesture of its own. */
  private lost(event: PointerEvent): void {
    if (event.pointerId !== this.press?.pointer) return;
    this.letGo();
    this.stage.arrows.release();
    this.stage.report.end(true);
  }

  private letGo(): void {
    this.press = null;
    this.stage.orbit.enabled = true;
    this.stage.arrows.setEnabled(true);
    this.stage.canvas.style.cursor = '';
  }

  private click(at: Place, event: PointerEvent): void {
    const { events } = this.stage;
    const found = this.find(at, event);
    if (!found) events.selectHandle(null);
    else if (found.handle) events.selectHandle(found.vertex);
    else events.addHandle(found.vertex);
  }

  /** Anchors hold the net: one must be selected before it moves. */
  private mayDrag(handle: number): boolean {
    return !this.stage.marks.isAnchor(handle) || this.stage.selected() === handle;
  }

  private find(at: Place, event: PointerEvent): Found | null {
    const handle = this.handleAt(at, event);
    if (handle !== null) return { vertex: handle, handle: true };
    const data = this.stage.data();
    if (!data) return null;
    const layer = LAYER * data.edgeLength;
    const { points, vertexCount } = data;
    const projection = this.stage.projection();
    const vertex = nearestVertex(points, vertexCount, projection, at.x, at.y, REACH[kind(event)], layer);
    if (vertex === null) return null;
    return { vertex, handle: this.stage.marks.point(vertex) !== undefined };
  }

  private handleAt(at: Place, event: PointerEvent): number | null {
    return this.stage.marks.at(this.stage.projection(), at.x, at.y, HANDLE_SLACK[kind(event)]);
  }

  /** At most once a frame, however many events the mouse sends. */
  private lookUnder(event: PointerEvent): void {
    const pending = this.hover !== null;
    this.hover = event;
    if (pending) return;
    this.hoverFrame = requestAnimationFrame(() => {
      const last = this.hover;
      this.hover = null;
      if (last && !this.press) this.setHover(last.target === this.stage.canvas ? this.find(this.place(last), last) : null);
    });
  }

  private leave(): void {
    if (!this.press) this.setHover(null);
  }

  private setHover(found: Found | null): void {
    const { canvas } = this.stage;
    canvas.style.cursor = !found ? '' : !found.handle ? 'crosshair' : this.mayDrag(found.vertex) ? 'grab' : 'pointer';
    this.stage.hovered(found);
  }

  /** Takes part before anyone else hears of the key: Esc in a drag means this drag, nothing else. */
  private escape(event: KeyboardEvent): void {
    const { report, arrows } = this.stage;
    if (event.key !== 'Escape' || report.vertex === null) return;
    event.stopPropagation();
    event.preventDefault();
    this.nudging = false;
    arrows.release();
    report.end(true);
    this.stage.canvas.style.cursor = '';
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const direction = ARROW_KEYS[event.key];
    if (direction) this.arrowKey(direction, event.shiftKey);
    else if (event.key === '+' || event.key === '=') this.stage.orbit.dollyIn(KEY.zoom);
    else if (event.key === '-') this.stage.orbit.dollyOut(KEY.zoom);
    else if (event.key === 'Home') this.stage.frameAll();
    else return;
    event.preventDefault();
  }

  private keyUp(event: KeyboardEvent): void {
    if (event.key in ARROW_KEYS) this.endNudge();
  }

  private endNudge(): void {
    if (!this.nudging) return;
    this.nudging = false;
    this.stage.report.end(false);
  }

  private arrowKey([dx, dy]: readonly [number, number], shift: boolean): void {
    const { orbit } = this.stage;
    if (this.stage.selected() !== null) this.nudge(dx, dy, shift ? KEY.bigNudge : KEY.nudge);
    else if (shift) orbit.pan(-dx * KEY.pan, dy * KEY.pan);
    else if (dx) orbit.rotateLeft(dx * KEY.turn);
    else orbit.rotateUp(dy * KEY.turn);
  }

  /** Moves the selected handle in the view plane; held keys and their repeats make one drag. */
  private nudge(dx: number, dy: number, edges: number): void {
    const { marks, report, camera } = this.stage;
    const vertex = this.stage.selected()!;
    const from = marks.point(vertex);
    const data = this.stage.data();
    if (!from || !data || this.press) return;
    if (!this.nudging) {
      this.nudging = true;
      report.begin(vertex);
    }
    const step = edges * data.edgeLength;
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    this.stage.carry(from.clone().addScaledVector(right, dx * step).addScaledVector(up, dy * step));
  }

  private place(event: PointerEvent): Place {
    const box = this.stage.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private toDevice({ x, y }: Place): Vector2 {
    const { clientWidth, clientHeight } = this.stage.canvas;
    return new Vector2((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight);
  }
}

function kind(event: PointerEvent): 'mouse' | 'touch' {
  return event.pointerType === 'touch' ? 'touch' : 'mouse';
}

/** Arrows, rings and boxes along x, y, z at the selected handles: three's TransformControls, bound to this page's way of
 *  dragging. Loaded when the first handle is selected. */
import { Color, Group, Matrix4, Mesh, Object3D, SRGBColorSpace, type Vector2, Vector3 } from 'three';
import type { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { UpAxis } from '../document/document';
import type { GizmoMode } from '../handles/commands';
import { lazy } from '../lazy';
import type { Eye } from './camera_rig';
import type { Theme } from './theme';

interface GizmoEvents {
  start(): void;
  /** From where they stood at the start, in the scene. */
  move(motion: Matrix4): void;
  end(): void;
  /** It must be redrawn. */
  changed(): void;
  /** It could not be loaded. */
  failed(error: unknown): void;
}

const loadControls = lazy(() => import('./rings'));

/** Larger for touch. */
const SIZE = matchMedia('(pointer: coarse)').matches ? 1 : 0.75;

export class Gizmo {
  /** To be put into the scene. */
  readonly object = new Group();
  readonly #pivot = new Object3D();
  readonly #toStart = new Matrix4();
  #controls: TransformControls | null = null;
  #mode: GizmoMode = 'translate';
  #colours: Color[] = [];
  #enabled = true;
  #point: Vector3 | null = null;
  #disposed = false;
  #camera: Eye;
  readonly #canvas: HTMLCanvasElement;
  readonly #events: GizmoEvents;

  constructor(camera: Eye, canvas: HTMLCanvasElement, events: GizmoEvents) {
    this.#camera = camera;
    this.#canvas = canvas;
    this.#events = events;
    this.object.add(this.#pivot);
  }

  /** What it is seen with. */
  setCamera(camera: Eye): void {
    this.#camera = camera;
    if (this.#controls) this.#controls.camera = camera;
  }

  setMode(mode: GizmoMode): void {
    this.#mode = mode;
    this.#controls?.setMode(mode);
  }

  /** Where it stands; null: nothing is selected that could move. */
  setPosition(point: Vector3 | null): void {
    const isFirst = this.#point === null && point !== null;
    this.#point = point;
    if (this.#controls) this.#place(this.#controls);
    else if (isFirst) this.#load().catch((error: unknown) => this.#events.failed(error));
  }

  async #load(): Promise<void> {
    const { thickenRings, TransformControls, TransformControlsGizmo } = await loadControls();
    if (this.#controls || this.#disposed) return;
    const controls = new TransformControls(this.#camera, this.#canvas);
    // A handle itself drags in the view plane; squares for two axes at a time would only cover the net.
    controls.showXY = controls.showYZ = controls.showXZ = false;
    // No free rotation, which follows no axis.
    controls.showXYZE = false;
    controls.size = SIZE;
    for (const child of controls.getHelper().children) {
      if (!(child instanceof TransformControlsGizmo)) continue;
      for (const { translate, scale } of [child.gizmo, child.picker]) [translate, scale].forEach(dropBackwardArrows);
      thickenRings(child.gizmo.rotate);
    }
    this.#listen(controls);
    this.object.add(controls.getHelper());
    this.#controls = controls;
    this.setMode(this.#mode);
    this.setEnabled(this.#enabled);
    this.#applyColours();
    this.#place(controls);
    this.#events.changed();
  }

  #listen(controls: TransformControls): void {
    controls.addEventListener('change', () => this.#events.changed());
    controls.addEventListener('mouseDown', () => {
      this.#toStart.copy(this.#pivotMatrix()).invert();
      this.#events.start();
    });
    controls.addEventListener('objectChange', () =>
      this.#events.move(this.#pivotMatrix().clone().multiply(this.#toStart)),
    );
    controls.addEventListener('mouseUp', () => this.#events.end());
  }

  #place(controls: TransformControls): void {
    if (!this.#point) {
      if (controls.object) controls.detach();
      return;
    }
    if (controls.dragging) return;
    this.#pivot.position.copy(this.#point);
    this.#pivot.quaternion.identity();
    this.#pivot.scale.setScalar(1);
    if (!controls.object) controls.attach(this.#pivot);
  }

  /** Whether a press at `pointer` (−1…1) takes a part of it. */
  takes(pointer: Vector2): boolean {
    if (!this.#controls) return false;
    this.#controls.getHelper().updateMatrixWorld();
    // The types ask for a PointerEvent; what is read are these numbers.
    this.#controls.pointerHover({ x: pointer.x, y: pointer.y, button: 0 } as PointerEvent);
    // The plane in which an arrow slides turns with the arrow chosen.
    this.#controls.getHelper().updateMatrixWorld();
    return this.#controls.axis !== null;
  }

  /** Disabled while a handle itself is dragged. */
  setEnabled(enabled: boolean): void {
    this.#enabled = enabled;
    if (!this.#controls) return;
    this.#controls.enabled = enabled;
    if (!enabled) this.#controls.axis = null;
  }

  /** Ends its drag. */
  release(): void {
    if (!this.#controls) return;
    this.#controls.dragging = false;
    this.#controls.axis = null;
  }

  /** It has the colours of the net's axes, whichever of them is up. */
  setTheme({ axes, accent }: Theme, up: UpAxis): void {
    const [x, y, z] = up === 'z' ? axes : [axes[0], axes[2], axes[1]];
    this.#colours = [x, y, z, accent].map((rgb) => new Color().setRGB(...rgb, SRGBColorSpace));
    this.#applyColours();
  }

  dispose(): void {
    this.#disposed = true;
    this.#controls?.dispose();
  }

  #applyColours(): void {
    const [x, y, z, active] = this.#colours;
    this.#controls?.setColors(x!, y!, z!, active!);
  }

  #pivotMatrix(): Matrix4 {
    this.#pivot.updateMatrix();
    return this.#pivot.matrix;
  }
}

/** three adds a cone or a box without a shaft at the far side of each axis, which looks like a stray mark on the net. */
function dropBackwardArrows(parts: Object3D): void {
  for (const part of [...parts.children]) {
    if (!(part instanceof Mesh)) continue;
    part.geometry.computeBoundingBox();
    const { x, y, z } = part.geometry.boundingBox.getCenter(new Vector3());
    if (x + y + z > -0.1) continue;
    parts.remove(part);
    part.geometry.dispose();
  }
}

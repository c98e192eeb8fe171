/** Arrows, rings and boxes along x, y, z at the selected handles: three's TransformControls, bound to this page's way of
 *  dragging. */
import { Color, Matrix4, Mesh, Object3D, type PerspectiveCamera, SRGBColorSpace, type Vector2, Vector3 } from 'three';
import { TransformControls, TransformControlsGizmo } from 'three/addons/controls/TransformControls.js';
import type { UpAxis } from '../document/document';
import type { GizmoMode } from '../handles/wishes';
import type { Theme } from './theme';

export interface GizmoEvents {
  start(): void;
  /** From where they stood at the start, in the scene. */
  move(motion: Matrix4): void;
  end(): void;
  /** Something looks different. */
  changed(): void;
}

/** A fingertip needs more to take hold of. */
const SIZE = matchMedia('(pointer: coarse)').matches ? 1 : 0.75;

export class Gizmo {
  /** To be put into the scene. */
  readonly objects: Object3D[];
  private readonly controls: TransformControls;
  private readonly pivot = new Object3D();
  private readonly toStart = new Matrix4();

  constructor(camera: PerspectiveCamera, canvas: HTMLCanvasElement, events: GizmoEvents) {
    this.controls = new TransformControls(camera, canvas);
    // A handle itself drags in the view plane; squares for two axes at a time would only cover the net.
    this.controls.showXY = this.controls.showYZ = this.controls.showXZ = false;
    // Free turning follows no axis and ends nowhere in particular.
    this.controls.showXYZE = false;
    this.controls.size = SIZE;
    for (const part of this.controls.getHelper().children) {
      if (!(part instanceof TransformControlsGizmo)) continue;
      for (const { translate, scale } of [part.gizmo, part.picker]) [translate, scale].forEach(dropBackwardArrows);
    }
    this.controls.addEventListener('change', () => events.changed());
    this.controls.addEventListener('mouseDown', () => {
      this.toStart.copy(this.pivotMatrix()).invert();
      events.start();
    });
    this.controls.addEventListener('objectChange', () => events.move(this.pivotMatrix().clone().multiply(this.toStart)));
    this.controls.addEventListener('mouseUp', () => events.end());
    this.objects = [this.pivot, this.controls.getHelper()];
  }

  setMode(mode: GizmoMode): void {
    this.controls.setMode(mode);
  }

  /** Where it stands; null: nothing is selected that could move. */
  show(point: Vector3 | null): void {
    if (!point) {
      if (this.controls.object) this.controls.detach();
      return;
    }
    if (this.controls.dragging) return;
    this.pivot.position.copy(point);
    this.pivot.quaternion.identity();
    this.pivot.scale.setScalar(1);
    if (!this.controls.object) this.controls.attach(this.pivot);
  }

  /** Whether a press at `pointer` (−1…1) takes a part of it. */
  takes(pointer: Vector2): boolean {
    this.controls.getHelper().updateMatrixWorld();
    // The types ask for a PointerEvent; what is read are these numbers.
    this.controls.pointerHover({ x: pointer.x, y: pointer.y, button: 0 } as PointerEvent);
    // The plane in which an arrow slides turns with the arrow chosen.
    this.controls.getHelper().updateMatrixWorld();
    return this.controls.axis !== null;
  }

  /** Deaf while a handle itself is dragged. */
  setEnabled(enabled: boolean): void {
    this.controls.enabled = enabled;
    if (!enabled) this.controls.axis = null;
  }

  /** Lets go of it. */
  release(): void {
    this.controls.dragging = false;
    this.controls.axis = null;
  }

  /** It has the colours of the net's axes, whichever of them is up. */
  setTheme({ axes, accent }: Theme, up: UpAxis): void {
    const [x, y, z, active] = [...axes, accent].map((rgb) => new Color().setRGB(...rgb, SRGBColorSpace));
    if (up === 'z') this.controls.setColors(x!, y!, z!, active!);
    else this.controls.setColors(x!, z!, y!, active!);
  }

  dispose(): void {
    this.controls.dispose();
  }

  private pivotMatrix(): Matrix4 {
    this.pivot.updateMatrix();
    return this.pivot.matrix;
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

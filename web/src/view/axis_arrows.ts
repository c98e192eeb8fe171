/** Arrows along x, y, z at the selected handle: three's TransformControls, bound to this page's way of dragging. */
import { Color, Mesh, Object3D, type PerspectiveCamera, SRGBColorSpace, type Vector2, Vector3 } from 'three';
import { TransformControls, TransformControlsGizmo } from 'three/addons/controls/TransformControls.js';
import type { UpAxis } from '../document/document';
import type { Theme } from './theme';

export interface ArrowEvents {
  start(): void;
  move(point: Vector3): void;
  end(): void;
  /** Something looks different. */
  changed(): void;
}

export class AxisArrows {
  /** To be put into the scene. */
  readonly objects: Object3D[];
  private readonly controls: TransformControls;
  private readonly tip = new Object3D();

  constructor(camera: PerspectiveCamera, canvas: HTMLCanvasElement, events: ArrowEvents) {
    this.controls = new TransformControls(camera, canvas);
    // The handle itself drags in the view plane; squares for two axes at a time would only cover the net.
    this.controls.showXY = this.controls.showYZ = this.controls.showXZ = false;
    this.controls.size = 0.75;
    for (const part of this.controls.getHelper().children) {
      if (part instanceof TransformControlsGizmo) [part.gizmo.translate, part.picker.translate].forEach(dropBackwardArrows);
    }
    this.controls.addEventListener('change', () => events.changed());
    this.controls.addEventListener('mouseDown', () => events.start());
    this.controls.addEventListener('objectChange', () => events.move(this.tip.position));
    this.controls.addEventListener('mouseUp', () => events.end());
    this.objects = [this.tip, this.controls.getHelper()];
  }

  /** Where the arrows stand; null: no handle is selected. */
  show(point: Vector3 | null): void {
    if (!point) {
      if (this.controls.object) this.controls.detach();
      return;
    }
    this.tip.position.copy(point);
    if (!this.controls.object) this.controls.attach(this.tip);
  }

  /** Whether a press at `pointer` (−1…1) takes an arrow. */
  takes(pointer: Vector2): boolean {
    this.controls.getHelper().updateMatrixWorld();
    // The types ask for a PointerEvent; what is read are these numbers.
    this.controls.pointerHover({ x: pointer.x, y: pointer.y, button: 0 } as PointerEvent);
    // The plane in which an arrow slides turns with the arrow chosen.
    this.controls.getHelper().updateMatrixWorld();
    return this.controls.axis !== null;
  }

  /** Deaf while the handle itself is dragged. */
  setEnabled(enabled: boolean): void {
    this.controls.enabled = enabled;
    if (!enabled) this.controls.axis = null;
  }

  /** Lets go of the arrow. */
  release(): void {
    this.controls.dragging = false;
    this.controls.axis = null;
  }

  /** Arrows have the colours of the net's axes, whichever of them is up. */
  setTheme({ axes, accent }: Theme, up: UpAxis): void {
    const [x, y, z, active] = [...axes, accent].map((rgb) => new Color().setRGB(...rgb, SRGBColorSpace));
    if (up === 'z') this.controls.setColors(x!, y!, z!, active!);
    else this.controls.setColors(x!, z!, y!, active!);
  }

  dispose(): void {
    this.controls.dispose();
  }
}

/** three adds a cone without a shaft at the far side of each axis, which looks like a stray mark on the net. */
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

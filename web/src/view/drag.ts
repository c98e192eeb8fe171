/** One drag of a handle, whoever moves it: a pointer in the view plane, an axis arrow or the arrow keys. */
import { type Camera, Plane, Raycaster, Vector2, Vector3 } from 'three';
import type { Vec3 } from '../document/document';
import type { ViewEvents } from './view';

export type DragEvents = Pick<ViewEvents, 'dragStart' | 'dragMove' | 'dragEnd'>;

/** Reports a drag in good order: a start, at most one move a frame, an end. */
export class DragReport {
  private held: number | null = null;
  private pending: Vec3 | null = null;

  constructor(private readonly events: DragEvents) {}

  /** The handle in hand. */
  get vertex(): number | null {
    return this.held;
  }

  begin(vertex: number): void {
    this.held = vertex;
    this.pending = null;
    this.events.dragStart(vertex);
  }

  move(target: Vec3): void {
    this.pending = target;
  }

  /** Called once a frame. */
  flush(): void {
    if (this.held === null || this.pending === null) return;
    const target = this.pending;
    this.pending = null;
    this.events.dragMove(this.held, target);
  }

  end(cancelled: boolean): void {
    if (this.held === null) return;
    if (!cancelled) this.flush();
    const vertex = this.held;
    this.held = null;
    this.pending = null;
    this.events.dragEnd(vertex, cancelled);
  }
}

/** Carries a point along under the pointer, in the plane through it that faces the camera. */
export class ViewPlane {
  private readonly plane = new Plane();
  private readonly grip = new Vector3();
  private readonly ray = new Raycaster();

  /** `pointer` in −1…1. The point keeps its distance from where it was gripped. */
  grab(camera: Camera, point: Vector3, pointer: Vector2): void {
    camera.getWorldDirection(this.plane.normal);
    this.plane.setFromNormalAndCoplanarPoint(this.plane.normal, point);
    this.grip.set(0, 0, 0);
    const hit = this.carry(camera, pointer);
    if (hit) this.grip.copy(point).sub(hit);
  }

  carry(camera: Camera, pointer: Vector2): Vector3 | null {
    this.ray.setFromCamera(pointer, camera);
    return this.ray.ray.intersectPlane(this.plane, new Vector3())?.add(this.grip) ?? null;
  }
}

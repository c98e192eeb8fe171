/** A drag of handles, by a pointer in the view plane, the gizmo or the arrow keys. */
import { type Camera, Plane, Raycaster, type Vector2, Vector3 } from 'three';
import type { Handle } from '../../../wasm/chebnet';
import type { Along } from '../handles/along';
import type { ViewEvents } from './view';

export type DragEvents = Pick<ViewEvents, 'dragStart' | 'dragMove' | 'dragEnd'>;

/** Reports a drag as events: a start, the first move at once, then at most one a frame, an end. Nothing is reported of one that may
 *  not begin. */
export class DragReport {
  #held: readonly number[] = [];
  #hasMoved = false;
  #pending: { targets: Handle[]; along: Along | null } | null = null;
  readonly #events: DragEvents;

  constructor(events: DragEvents) {
    this.#events = events;
  }

  /** The dragged handles, the leading one first; empty: no drag is under way. */
  get vertices(): readonly number[] {
    return this.#held;
  }

  get isUnderWay(): boolean {
    return this.#held.length > 0;
  }

  begin(vertices: readonly number[]): void {
    this.#pending = null;
    this.#hasMoved = false;
    this.#held = vertices;
    if (!this.#events.dragStart()) this.#held = [];
  }

  /** `along`: what the move is kept to. */
  move(targets: Handle[], along: Along | null = null): void {
    this.#pending = { targets, along };
    const isFirst = !this.#hasMoved;
    this.#hasMoved = true;
    if (isFirst) this.flush();
  }

  /** Called once a frame. */
  flush(): void {
    if (this.#pending === null) return;
    const { targets, along } = this.#pending;
    this.#pending = null;
    this.#events.dragMove(targets, along);
  }

  end(cancelled: boolean): void {
    if (!this.isUnderWay) return;
    try {
      if (!cancelled) this.flush();
    } finally {
      // Also where the last move fails: undo would wait for the end of the drag.
      this.#held = [];
      this.#pending = null;
      this.#events.dragEnd(cancelled);
    }
  }
}

/** Moves a point with the pointer, in the plane through it that faces the camera. */
export class ViewPlane {
  readonly #plane = new Plane();
  readonly #grip = new Vector3();
  readonly #ray = new Raycaster();

  /** `pointer` in −1…1. The offset at the start of the drag is kept. */
  grab(camera: Camera, point: Vector3, pointer: Vector2): void {
    camera.getWorldDirection(this.#plane.normal);
    this.#plane.setFromNormalAndCoplanarPoint(this.#plane.normal, point);
    this.#grip.set(0, 0, 0);
    const hit = this.carry(camera, pointer);
    if (hit) this.#grip.copy(point).sub(hit);
  }

  carry(camera: Camera, pointer: Vector2): Vector3 | null {
    this.#ray.setFromCamera(pointer, camera);
    return this.#ray.ray.intersectPlane(this.#plane, new Vector3())?.add(this.#grip) ?? null;
  }
}

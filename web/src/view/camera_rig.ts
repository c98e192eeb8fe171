/** The camera and its motion: three's OrbitControls, and animations to a given place. What is seen is drawn in perspective or
 *  in parallel; a hand moves the camera in perspective all the same, and the other goes with it. */
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Stand } from './camera_fit';

const FIELD_OF_VIEW = 32;
/** In parallel, depth that is seen on either side of the target, in the scene. */
const PARALLEL_DEPTH = 8;
const GLIDE_MS = 280;
/** Damping: fraction of the camera's momentum lost in 1/60 s. */
const DAMPING = 0.16;
/** After a longer pause than this it is the first frame of a motion. */
const LONG_FRAME_MS = 300;

interface RigEvents {
  /** The view must be redrawn. */
  moved(): void;
  /** After orbit, pan, zoom or glide. */
  rested(): void;
}

/** What a picture is drawn with. */
export type Eye = PerspectiveCamera | OrthographicCamera;

/** Half the height of the picture at this depth, in the scene. */
export function halfHeight(eye: Eye, depth: number): number {
  return eye instanceof OrthographicCamera ? eye.top : Math.tan((eye.fov * Math.PI) / 360) * depth;
}

export class CameraRig {
  /** What the hand moves. */
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW);
  /** Whether it is seen in parallel. */
  isParallel = false;
  readonly #parallel = new OrthographicCamera();
  readonly orbit: OrbitControls;
  /** The camera has not been moved by hand since it was fitted to the whole net. */
  framed = true;
  readonly #calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  #steering = false;
  #restless = false;
  #glide: { from: Stand; to: Stand; start: number } | null = null;
  #lastUpdate = 0;
  readonly #events: RigEvents;

  constructor(canvas: HTMLCanvasElement, events: RigEvents) {
    this.#events = events;
    // OrbitControls reads it only in its constructor.
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = !this.#calm;
    this.orbit.zoomSpeed = 1.2;
    this.orbit.minDistance = 0.02;
    this.orbit.maxDistance = 30;
    this.orbit.addEventListener('start', () => this.#begin());
    this.orbit.addEventListener('end', () => this.#end());
    this.orbit.addEventListener('change', () => this.#changed());
  }

  /** The camera that draws. Both show what is at the target in the same size. */
  get eye(): Eye {
    if (!this.isParallel) return this.camera;
    const { camera, distance } = this;
    const eye = this.#parallel;
    const top = halfHeight(camera, distance);
    eye.position.copy(camera.position);
    eye.quaternion.copy(camera.quaternion);
    [eye.top, eye.bottom, eye.right, eye.left] = [top, -top, top * camera.aspect, -top * camera.aspect];
    [eye.near, eye.far] = [distance - PARALLEL_DEPTH, distance + PARALLEL_DEPTH];
    eye.updateProjectionMatrix();
    eye.updateMatrixWorld();
    return eye;
  }

  get distance(): number {
    return this.camera.position.distanceTo(this.orbit.target);
  }

  get stand(): Stand {
    return { position: this.camera.position.clone(), target: this.orbit.target.clone() };
  }

  /** Where it will stand when it rests; null: it does. */
  get heading(): Stand | null {
    return this.#restless ? (this.#glide?.to ?? this.stand) : null;
  }

  standAt({ position, target }: Stand): void {
    this.#glide = null;
    this.#loseMomentum();
    this.camera.position.copy(position);
    this.orbit.target.copy(target);
    this.orbit.update();
    this.#restless = false;
    this.#events.moved();
  }

  glideTo(to: Stand): void {
    if (this.#calm) this.standAt(to);
    else this.#glide = { from: this.stand, to, start: performance.now() };
    this.#changed();
  }

  /** Shifts the picture, so that this point of the scene is so many pixels further right and down. */
  glideBy(right: number, down: number, point: Vector3, height: number): void {
    const { eye } = this;
    const depth = -point.clone().applyMatrix4(eye.matrixWorldInverse).z;
    const pixel = (2 * halfHeight(eye, depth)) / height;
    const shift = new Vector3(-right * pixel, down * pixel, 0).applyQuaternion(eye.quaternion);
    const { position, target } = this.stand;
    this.framed = false;
    this.glideTo({ position: position.add(shift), target: target.add(shift) });
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** Once a frame, before drawing. */
  update(): void {
    const now = performance.now();
    // By time, not by frame: on a slow machine the camera would coast for seconds.
    const elapsed = now - this.#lastUpdate;
    this.orbit.dampingFactor = 1 - (1 - DAMPING) ** (elapsed < LONG_FRAME_MS ? 0.06 * elapsed : 1);
    this.#lastUpdate = now;
    if (this.#glide) this.#glideOn(this.#glide, now);
    if (!this.orbit.update() && !this.#glide && !this.#steering) this.#rest();
    this.#fitDepth();
  }

  dispose(): void {
    this.orbit.dispose();
  }

  /** OrbitControls gives its momentum up only where it has no damping; what is left of it would move the camera on. */
  #loseMomentum(): void {
    const { enableDamping } = this.orbit;
    this.orbit.enableDamping = false;
    this.orbit.update();
    this.orbit.enableDamping = enableDamping;
  }

  #begin(): void {
    this.#steering = true;
    this.framed = false;
    this.#glide = null;
  }

  #end(): void {
    this.#steering = false;
    this.#events.moved();
  }

  #changed(): void {
    this.#restless = true;
    this.#events.moved();
  }

  #rest(): void {
    if (!this.#restless) return;
    this.#restless = false;
    this.#events.rested();
  }

  #glideOn({ from, to, start }: { from: Stand; to: Stand; start: number }, now: number): void {
    const t = Math.min(1, (now - start) / GLIDE_MS);
    const eased = 1 - (1 - t) ** 3;
    this.camera.position.lerpVectors(from.position, to.position, eased);
    this.orbit.target.lerpVectors(from.target, to.target, eased);
    if (t === 1) this.#glide = null;
    this.#changed();
  }

  /** Sets near and far planes by the distance, so that both the whole net and a single edge can be viewed. */
  #fitDepth(): void {
    const { camera, distance } = this;
    camera.near = Math.max(1e-3, 0.02 * distance);
    camera.far = distance + 8;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}

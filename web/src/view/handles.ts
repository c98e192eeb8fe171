/** The handles: spheres to drag, dark cubes for anchors. Both keep a handy size on the screen however near the camera is, and
 *  shine faintly through what covers them. */
import {
  BoxGeometry,
  type BufferGeometry,
  Color,
  GreaterDepth,
  Group,
  InstancedMesh,
  type Material,
  Matrix4,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type PerspectiveCamera,
  SphereGeometry,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { HandleData } from '../document/document';
import { nearestMark, project, type Projection, type ScreenPoint } from './picking';
import type { Space } from './space';
import type { Theme } from './theme';

/** Radius on the screen in pixels: grows with the edges of a coarse net, within these bounds. */
const SMALLEST = 9;
const LARGEST = 14;
const PER_EDGE = 0.3;
const CUBE = 0.7;

interface Mark {
  vertex: number;
  anchor: boolean;
  point: Vector3;
}

export class HandleMarks {
  readonly object = new Group();
  private marks: Mark[] = [];
  private radius = SMALLEST;
  private readonly spheres = new Shape(new SphereGeometry(1, 32, 20));
  private readonly cubes = new Shape(new BoxGeometry(1.5, 1.5, 1.5));

  constructor() {
    this.object.add(this.spheres.group, this.cubes.group);
  }

  /** `held`: the handle in a hand at the moment; it stays where the hand has it. */
  show(handles: readonly HandleData[], space: Space, held: number | null): void {
    const heldPoint = held === null ? undefined : this.point(held);
    this.marks = handles.map(({ vertex, target, anchor }) => {
      const point = new Vector3();
      if (vertex === held && heldPoint) point.copy(heldPoint);
      else space.toScene(point, target);
      return { vertex, anchor, point };
    });
  }

  point(vertex: number): Vector3 | undefined {
    return this.find(vertex)?.point;
  }

  isAnchor(vertex: number): boolean {
    return this.find(vertex)?.anchor ?? false;
  }

  /** The one a newcomer is to drag: the last that is no anchor. */
  get suggested(): number | null {
    return this.marks.filter((mark) => !mark.anchor).at(-1)?.vertex ?? null;
  }

  get screenRadius(): number {
    return this.radius;
  }

  /** The handle under a point of the canvas. */
  at(projection: Projection, x: number, y: number, slack: number): number | null {
    const marks = this.marks.map(({ point }) => ({ ...toScreen(projection, point), radius: this.radius }));
    const hit = nearestMark(marks, x, y, slack);
    return hit === null ? null : this.marks[hit]!.vertex;
  }

  setTheme(theme: Theme): void {
    this.spheres.setColour(new Color().setRGB(...theme.accent, SRGBColorSpace));
    this.cubes.setColour(new Color().setRGB(...theme.anchor, SRGBColorSpace));
  }

  beforeDraw(camera: PerspectiveCamera, canvasHeight: number, edgeLength: number, distance: number): void {
    // Scene length of a pixel, at a distance of one.
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / canvasHeight;
    this.radius = Math.min(LARGEST, Math.max(SMALLEST, (PER_EDGE * edgeLength) / (pixel * distance)));
    const size = this.radius * pixel;
    const points = (anchor: boolean) => this.marks.filter((mark) => mark.anchor === anchor).map((mark) => mark.point);
    this.spheres.place(points(false), camera, size);
    this.cubes.place(points(true), camera, CUBE * size);
  }

  dispose(): void {
    this.spheres.dispose();
    this.cubes.dispose();
  }

  private find(vertex: number): Mark | undefined {
    return this.marks.find((mark) => mark.vertex === vertex);
  }
}

export function toScreen(projection: Projection, { x, y, z }: Vector3): ScreenPoint {
  return project(projection, x, y, z);
}

/** Many copies of one solid, each drawn twice: plainly, and as a ghost where something is in front. */
class Shape {
  readonly group = new Group();
  private readonly solid = new MeshLambertMaterial();
  private readonly ghost = new MeshBasicMaterial({
    depthFunc: GreaterDepth,
    depthWrite: false,
    transparent: true,
    opacity: 0.35,
  });
  private meshes: InstancedMesh[] = [];
  private capacity = 0;
  private readonly matrix = new Matrix4();
  private readonly centre = new Vector3();

  constructor(private readonly geometry: BufferGeometry) {}

  setColour(colour: Color): void {
    this.solid.color.copy(colour);
    // Lit from one side only, a sphere on a dark page would look dull.
    this.solid.emissive.copy(colour).multiplyScalar(0.25);
    this.ghost.color.copy(colour);
  }

  /** `size` on the screen, as scene length at a distance of one. Each stands in front of its point by its own radius, on the
   *  line of sight: it looks the same, but no face cuts through it. */
  place(points: Vector3[], camera: PerspectiveCamera, size: number): void {
    if (points.length > this.capacity) this.grow(2 * points.length);
    points.forEach((point, i) => {
      const distance = depth(camera, point);
      const nearer = 1 - 1.2 * size;
      const s = size * distance * nearer;
      this.matrix.makeScale(s, s, s).setPosition(this.centre.lerpVectors(camera.position, point, nearer));
      for (const mesh of this.meshes) mesh.setMatrixAt(i, this.matrix);
    });
    for (const mesh of this.meshes) {
      mesh.count = points.length;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  dispose(): void {
    this.meshes.forEach((mesh) => mesh.dispose());
    for (const thing of [this.geometry, this.solid, this.ghost]) thing.dispose();
  }

  private grow(capacity: number): void {
    this.meshes.forEach((mesh) => mesh.dispose());
    this.group.clear();
    const mesh = (material: Material, order: number) => {
      const made = new InstancedMesh(this.geometry, material, capacity);
      made.frustumCulled = false;
      made.renderOrder = order;
      return made;
    };
    this.meshes = [mesh(this.solid, 1), mesh(this.ghost, 3)];
    this.group.add(...this.meshes);
    this.capacity = capacity;
  }
}

const forward = new Vector3();

function depth(camera: PerspectiveCamera, point: Vector3): number {
  return Math.max(camera.near, forward.copy(point).applyMatrix4(camera.matrixWorldInverse).z * -1);
}

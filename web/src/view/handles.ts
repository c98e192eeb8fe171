/** The handles: spheres to drag, hollow if they are soft, dark cubes if they are locked, a ring around those selected. Those
 *  that slide have a dark skid under them, flat in the plane or long on the line on which they do. Their
 *  size on the screen does not depend on the camera's distance, and they shine faintly through what covers them, those that
 *  can be dragged more. */
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
  OrthographicCamera,
  Quaternion,
  RingGeometry,
  SphereGeometry,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { HandleData } from '../document/document';
import type { Selection } from '../handles/selection';
import { type Eye, halfHeight } from './camera_rig';
import type { Place } from './overlay';
import { isInside, nearestMarker, project, type Projection, type ScreenPoint } from './picking';
import type { Space } from './space';
import type { Theme } from './theme';

/** Radius on the screen in pixels: grows with the edges of a coarse net, within these bounds. */
const SMALLEST = 9;
const LARGEST = 14;
const PER_EDGE = 0.3;
const CUBE = 0.7;
/** From this number on spheres are drawn coarser: thousands of fine ones would be millions of triangles. */
const MANY = 500;
/** A skid is a sphere of so many radii along the axes on which it slides, and across. */
const SKID = { along: 1.6, across: 0.15 };

interface Marker {
  vertex: number;
  locked: boolean;
  soft: boolean;
  hidden: boolean;
  selected: boolean;
  /** Of the scene's axes those along which it slides: three characters, 1 or 0. */
  slides: string;
  point: Vector3;
}

export class HandleMarkers {
  readonly object = new Group();
  #markers = new Map<number, Marker>();
  #radius = SMALLEST;
  // Few triangles: there may be hundreds of them, and some visitors have no graphics card.
  readonly #spheres = new Shape(new SphereGeometry(1, 20, 12));
  readonly #manySpheres = new Shape(new SphereGeometry(1, 8, 5));
  readonly #cubes = new Shape(new BoxGeometry(1.5, 1.5, 1.5), { behind: 0.25 });
  readonly #hollow = new Shape(new RingGeometry(0.5, 1, 28), { facing: true });
  readonly #rings = new Shape(new RingGeometry(1.3, 1.55, 32), { facing: true });
  /** By the axes. */
  readonly #skids = new Map<string, Shape>();
  #skidColour = new Color();
  #shares: ReadonlyMap<number, number> | null = null;
  /** Of a handle that moves, and of one that stays, while shares are shown. */
  readonly #moves = new Color();
  readonly #stays = new Color();

  constructor() {
    for (const { group } of this.#shapes) this.object.add(group);
  }

  /** `held`: the handles being dragged; they stay where the drag has put them. */
  update(handles: readonly HandleData[], space: Space, selection: Selection, held: readonly number[]): void {
    const inHand = new Map(held.map((vertex) => [vertex, this.point(vertex)]));
    const selected = new Set(selection);
    const marker = ({ vertex, target, anchor, weight, hidden, slides }: HandleData): Marker => {
      const point = new Vector3();
      space.toScene(point, target);
      const axes = space.axes.map((axis) => (slides?.includes(axis) ? '1' : '0')).join('');
      const taken = inHand.get(vertex);
      if (taken) point.copy(keepSlid(taken, point, axes));
      return {
        vertex,
        locked: anchor,
        soft: weight !== undefined,
        hidden: hidden === true,
        selected: selected.has(vertex),
        slides: axes,
        point,
      };
    };
    this.#markers = new Map(handles.map((handle) => [handle.vertex, marker(handle)]));
  }

  /** What share of a move each handle makes, to be seen as its colour; null: they are all of one colour. */
  setShares(shares: ReadonlyMap<number, number> | null): void {
    this.#shares = shares;
  }

  /** Whether it makes a share only of a move. */
  isLed(vertex: number): boolean {
    return (this.#shares?.get(vertex) ?? 1) < 1;
  }

  point(vertex: number): Vector3 | undefined {
    return this.#markers.get(vertex)?.point;
  }

  /** Takes a handle to a point, but along the axes on which it slides. */
  carry(vertex: number, to: Vector3): Vector3 {
    const marker = this.#markers.get(vertex);
    return marker ? marker.point.copy(keepSlid(to, marker.point, marker.slides)) : to;
  }

  isLocked(vertex: number): boolean {
    return this.#markers.get(vertex)?.locked ?? false;
  }

  isHidden(vertex: number): boolean {
    return this.#markers.get(vertex)?.hidden ?? false;
  }

  /** The handle that a newcomer is shown to drag: the last one that is not locked. */
  get suggested(): number | null {
    return this.#visible.filter(({ locked }) => !locked).at(-1)?.vertex ?? null;
  }

  get screenRadius(): number {
    return this.#radius;
  }

  /** The handle under a point of the canvas. */
  at(projection: Projection, x: number, y: number, slack: number): number | null {
    const visible = this.#visible;
    const markers = visible.map(({ point }) => ({ ...toScreen(projection, point), radius: this.#radius }));
    const hit = nearestMarker(markers, x, y, slack);
    return hit === null ? null : visible[hit]!.vertex;
  }

  /** The handles within an outline on the canvas. */
  inside(projection: Projection, outline: readonly Place[]): number[] {
    const hits = this.#visible.filter(({ point }) => {
      const { x, y, depth } = toScreen(projection, point);
      return depth > 0 && isInside(outline, x, y);
    });
    return hits.map(({ vertex }) => vertex);
  }

  setTheme(theme: Theme): void {
    for (const spheres of [this.#spheres, this.#manySpheres])
      spheres.setColour(new Color().setRGB(...theme.accent, SRGBColorSpace));
    this.#hollow.setColour(new Color().setRGB(...theme.accent, SRGBColorSpace));
    this.#moves.setRGB(...theme.accent, SRGBColorSpace);
    this.#stays.setRGB(...theme.grid, SRGBColorSpace);
    this.#cubes.setColour(new Color().setRGB(...theme.anchor, SRGBColorSpace));
    this.#rings.setColour(new Color().setRGB(...theme.ink, SRGBColorSpace));
    this.#skidColour.setRGB(...theme.anchor, SRGBColorSpace);
    for (const skid of this.#skids.values()) skid.setColour(this.#skidColour);
  }

  beforeDraw(camera: Eye, canvasHeight: number, edgeLength: number, distance: number): void {
    const pixel = (2 * halfHeight(camera, distance)) / canvasHeight;
    this.#radius = Math.min(LARGEST, Math.max(SMALLEST, (PER_EDGE * edgeLength) / pixel));
    const size = (2 * this.#radius) / canvasHeight;
    const points = (which: (marker: Marker) => boolean) => this.#visible.filter(which).map(({ point }) => point);
    const free = this.#visible.filter(({ locked }) => !locked);
    const plain = free.filter(({ soft }) => !soft);
    const place = (shape: Shape, markers: readonly Marker[]) =>
      shape.place(
        markers.map(({ point }) => point),
        camera,
        size,
        this.#tints(markers),
      );
    place(this.#spheres, plain.length > MANY ? [] : plain);
    place(this.#manySpheres, plain.length > MANY ? plain : []);
    place(
      this.#hollow,
      free.filter(({ soft }) => soft),
    );
    this.#cubes.place(
      points(({ locked }) => locked),
      camera,
      CUBE * size,
    );
    this.#rings.place(
      points(({ selected }) => selected),
      camera,
      size,
    );
    for (const { slides } of this.#visible) if (slides.includes('1')) this.#skid(slides);
    for (const [axes, skid] of this.#skids)
      skid.place(
        points(({ slides }) => slides === axes),
        camera,
        size,
      );
  }

  #tints(markers: readonly Marker[]): Color[] | null {
    const shares = this.#shares;
    return shares && markers.map(({ vertex }) => this.#stays.clone().lerp(this.#moves, shares.get(vertex) ?? 0));
  }

  #skid(axes: string): Shape {
    const known = this.#skids.get(axes);
    if (known) return known;
    const [x, y, z] = [...axes].map((each) => (each === '1' ? SKID.along : SKID.across));
    const skid = new Shape(new SphereGeometry(1, 20, 12).scale(x!, y!, z!));
    skid.setColour(this.#skidColour);
    this.#skids.set(axes, skid);
    this.object.add(skid.group);
    return skid;
  }

  dispose(): void {
    for (const shape of this.#shapes) shape.dispose();
  }

  get #shapes(): Shape[] {
    return [this.#spheres, this.#manySpheres, this.#cubes, this.#hollow, this.#rings, ...this.#skids.values()];
  }

  get #visible(): Marker[] {
    return [...this.#markers.values()].filter(({ hidden }) => !hidden);
  }
}

/** `to`, but along the axes on which it slides, where it is. */
function keepSlid(to: Vector3, at: Vector3, axes: string): Vector3 {
  const point = to.clone();
  for (const axis of [0, 1, 2]) if (axes[axis] === '1') point.setComponent(axis, at.getComponent(axis));
  return point;
}

export function toScreen(projection: Projection, { x, y, z }: Vector3): ScreenPoint {
  return project(projection, x, y, z);
}

const UPRIGHT = new Quaternion();

/** Instances of one solid, each drawn twice: opaque, and translucent where something is in front. */
class Shape {
  readonly group = new Group();
  readonly #solid = new MeshLambertMaterial();
  readonly #ghost = new MeshBasicMaterial({
    depthFunc: GreaterDepth,
    depthWrite: false,
    transparent: true,
  });
  #meshes: InstancedMesh[] = [];
  #capacity = 0;
  readonly #colour = new Color();
  readonly #matrix = new Matrix4();
  readonly #scale = new Vector3();
  readonly #centre = new Vector3();
  readonly #geometry: BufferGeometry;
  readonly #facing: boolean;

  /** `facing`: a flat shape that is turned to the camera. `behind`: how opaque it is where something is in front. */
  constructor(geometry: BufferGeometry, { facing = false, behind = 0.5 } = {}) {
    this.#geometry = geometry;
    this.#facing = facing;
    this.#ghost.opacity = behind;
  }

  setColour(colour: Color): void {
    this.#colour.copy(colour);
    this.#paint(null);
  }

  /** In one colour, or each instance in its own, which multiplies that of the material. */
  #paint(tints: readonly Color[] | null): void {
    for (const { color } of [this.#solid, this.#ghost]) color.copy(this.#colour);
    // Lit from one side only, a sphere on a dark page would look dull.
    this.#solid.emissive.copy(this.#colour).multiplyScalar(0.25);
    if (tints) for (const { color } of [this.#solid, this.#ghost]) color.setScalar(1);
    if (tints) this.#solid.emissive.setScalar(0);
    for (const mesh of this.#meshes) {
      tints?.forEach((tint, i) => mesh.setColorAt(i, tint));
      if (!tints) mesh.instanceColor = null;
      else if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** `size` on the screen, as a part of half its height. Each stands in front of its point by its own radius, on the line of
   *  sight: it looks the same, but no face cuts through it. */
  place(points: Vector3[], camera: Eye, size: number, tints: readonly Color[] | null = null): void {
    if (points.length > this.#capacity) this.#grow(2 * points.length);
    points.forEach((point, i) => {
      const radius = size * halfHeight(camera, depth(camera, point));
      towards(camera, point, this.#centre);
      const nearer = Math.min(1.2 * radius, 0.5 * this.#centre.length());
      this.#scale.setScalar(
        camera instanceof OrthographicCamera ? radius : radius * (1 - nearer / this.#centre.length()),
      );
      this.#centre.setLength(nearer).add(point);
      this.#matrix.compose(this.#centre, this.#facing ? camera.quaternion : UPRIGHT, this.#scale);
      for (const mesh of this.#meshes) mesh.setMatrixAt(i, this.#matrix);
    });
    this.#paint(tints);
    for (const mesh of this.#meshes) {
      mesh.count = points.length;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  dispose(): void {
    this.#meshes.forEach((mesh) => mesh.dispose());
    for (const thing of [this.#geometry, this.#solid, this.#ghost]) thing.dispose();
  }

  #grow(capacity: number): void {
    this.#meshes.forEach((mesh) => mesh.dispose());
    this.group.clear();
    const mesh = (material: Material, order: number) => {
      const made = new InstancedMesh(this.#geometry, material, capacity);
      made.frustumCulled = false;
      made.renderOrder = order;
      return made;
    };
    // Between faces and lines: the lines run over what is behind them.
    this.#meshes = [mesh(this.#solid, 1), mesh(this.#ghost, 1.5)];
    this.group.add(...this.#meshes);
    this.#capacity = capacity;
  }
}

const forward = new Vector3();

function depth(camera: Eye, point: Vector3): number {
  return Math.max(camera.near, forward.copy(point).applyMatrix4(camera.matrixWorldInverse).z * -1);
}

/** From a point to the camera. */
function towards(camera: Eye, point: Vector3, way: Vector3): Vector3 {
  if (camera instanceof OrthographicCamera) return way.setFromMatrixColumn(camera.matrixWorld, 2);
  return way.subVectors(camera.position, point);
}

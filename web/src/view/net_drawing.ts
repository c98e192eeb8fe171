/** What is drawn of the net: lines or rods, faces and a shadow, in the colours of a field and cut by the section plane; and
 *  the surface beside it. What draws rods and surfaces is loaded when it is first needed. */
import { Group, type Vector2, type WebGLRenderer } from 'three';
import type { Look } from '../document/document';
import type { Curve } from '../handles/curve';
import type { Part } from '../handles/part';
import type { Snapping } from '../handles/snapping';
import { fieldOf, scaleOf } from '../fields/fields';
import { lazy } from '../lazy';
import type { DrawnSurface, FrameData, OpenedNet } from '../worker/protocol';
import type { CameraRig } from './camera_rig';
import { Ground } from './ground';
import type { KeptCurve } from './kept_curve';
import { ColourTexture, NetData, netUniforms } from './net_data';
import { NetFaces } from './net_faces';
import { NetLines } from './net_lines';
import type { Rods } from './rods';
import { Space } from './space';
import type { SurfaceShade } from './surface_shade';
import type { Theme } from './theme';

export type Appearance = Omit<Look, 'camera'>;

interface NetDrawingEvents {
  /** The view must be redrawn. */
  changed(): void;
  /** Something could not be loaded. */
  failed(error: unknown): void;
}

/** Of a surface beside the net: the net is what one looks at. */
const GUIDE_OPACITY = 0.6;
/** In edge lengths: a net's faces are flat, and so lie a little within what bulges out. */
const BEHIND = 0.3;
/** How far from the middle the section plane goes, in the scene. */
const SECTION_RANGE = 1.1;
const surfaceShade = lazy(() => import('./surface_shade'));
const rods = lazy(() => import('./rods'));
const keptCurve = lazy(() => import('./kept_curve'));

export class NetDrawing {
  /** To be put into the scene. */
  readonly object = new Group();
  readonly #uniforms = netUniforms();
  readonly #colours = new ColourTexture();
  readonly #ground = new Ground(this.#uniforms);
  readonly #lines = new NetLines(this.#uniforms, this.#colours);
  readonly #faces = new NetFaces(this.#uniforms, this.#colours);
  readonly #events: NetDrawingEvents;
  #theme: Theme;
  #appearance: Appearance;
  #net: OpenedNet | null = null;
  #data: NetData | null = null;
  #latest: FrameData | null = null;
  #part: Part | undefined;
  #guide: DrawnSurface | null = null;
  #shade: SurfaceShade | null = null;
  #rods: Rods | null = null;
  #curve: Curve | null | undefined;
  #drawnCurve: KeptCurve | null = null;
  #hasMoved = false;
  #isDisposed = false;

  constructor(theme: Theme, appearance: Appearance, events: NetDrawingEvents) {
    this.#theme = theme;
    this.#appearance = appearance;
    this.#events = events;
    this.object.add(this.#ground.object, this.#lines.object, this.#faces.object);
    this.setTheme(theme);
  }

  /** Null before the first net. */
  get data(): NetData | null {
    return this.#data;
  }

  /** The section plane; see netUniforms. */
  get section() {
    return this.#uniforms.section.value;
  }

  setNet(net: OpenedNet): NetData {
    this.#data?.dispose();
    const data = new NetData(net, new Space(net.restPositions, this.#appearance.upAxis));
    this.#net = net;
    this.#data = data;
    this.#part = undefined;
    data.putInto(this.#uniforms);
    this.#lines.setNet(data, net.strips);
    this.#faces.setTriangles(net.triangles);
    this.#ground.setNet(data, this.#faces.object.geometry);
    this.#rods?.setNet(data, net.edges.length / 2);
    this.#cut();
    this.setGuide(this.#guide);
    this.#setCurve(this.#curve);
    return data;
  }

  setFrame(frame: FrameData): void {
    this.#latest = frame;
    this.#data?.setFrame(frame, fieldOf(this.#appearance.field));
    this.#hasMoved = true;
  }

  /** Shows a part of the net alone; undefined: all of it. */
  setPart(part: Part | undefined): void {
    if (part === this.#part || !this.#net || !this.#data) return;
    this.#part = part;
    this.#data.setHidden(part?.hidden);
    this.#faces.setTriangles((part ?? this.#net).triangles);
    this.#ground.setNet(this.#data, this.#faces.object.geometry);
    this.#hasMoved = true;
  }

  setSnapping(snapping: Snapping | null | undefined): void {
    if (this.#data) this.#ground.setGrid(snapping?.step, this.#data.space);
    if (snapping?.curve !== this.#curve) this.#setCurve(snapping?.curve);
  }

  #setCurve(curve: Curve | null | undefined): void {
    this.#curve = curve;
    this.#drawCurve().catch((error: unknown) => this.#events.failed(error));
  }

  setAppearance(appearance: Appearance): void {
    const before = this.#appearance;
    this.#appearance = appearance;
    const { field, showFaces } = appearance;
    const { place } = fieldOf(field);
    if (field !== before.field && this.#latest) this.#data?.setFrame(this.#latest, fieldOf(field));
    this.#drawRods().catch((error: unknown) => this.#events.failed(error));
    this.#cut();
    this.#colours.setScale(scaleOf(appearance, this.#theme), place);
    this.#faces.object.visible = showFaces;
    this.#lines.setOverColours(showFaces && place === 'vertex');
  }

  setGuide(surface: DrawnSurface | null): void {
    this.#guide = surface;
    this.#drawGuide().catch((error: unknown) => this.#events.failed(error));
  }

  setTheme(theme: Theme): void {
    this.#theme = theme;
    const optional = [this.#shade, this.#rods, this.#drawnCurve];
    for (const part of [this.#ground, this.#lines, this.#faces, ...optional]) part?.setTheme(theme);
    this.setAppearance(this.#appearance);
  }

  /** The graphics card has lost the shadow. */
  restore(): void {
    this.#hasMoved = true;
  }

  beforeDraw(renderer: WebGLRenderer, { eye, distance }: CameraRig, size: Vector2): void {
    this.#lines.beforeDraw(eye, size, renderer.getPixelRatio(), distance);
    // From below, the floor would hide the net.
    this.#ground.object.visible = eye.position.z > this.#ground.object.position.z;
    if (this.#hasMoved) this.#ground.drawShadow(renderer);
    this.#hasMoved = false;
  }

  dispose(): void {
    this.#isDisposed = true;
    const optional = [this.#shade, this.#rods, this.#drawnCurve, this.#data];
    for (const part of [this.#ground, this.#lines, this.#faces, this.#colours, ...optional]) part?.dispose();
    this.#data = null;
  }

  async #drawGuide(): Promise<void> {
    if (this.#guide === null && this.#shade === null) return;
    const { SurfaceShade } = await surfaceShade();
    if (this.#isDisposed) return;
    if (this.#shade === null) {
      this.#shade = new SurfaceShade(GUIDE_OPACITY, this.#uniforms.section);
      this.#shade.setTheme(this.#theme);
      this.object.add(this.#shade.object);
    }
    this.#shade.object.visible = this.#guide !== null;
    if (this.#guide && this.#data) {
      this.#shade.setSurface(this.#guide, this.#data.space);
      this.#shade.setBehind(BEHIND * this.#data.edgeLength);
    }
    this.#events.changed();
  }

  async #drawCurve(): Promise<void> {
    const curve = this.#curve;
    const loaded = curve && (await keptCurve());
    if (curve !== this.#curve) return;
    this.#drawnCurve?.dispose();
    this.#drawnCurve = loaded && this.#data ? new loaded.KeptCurve(curve, this.#data.space, this.#theme) : null;
    if (this.#drawnCurve) this.object.add(this.#drawnCurve.object);
    this.#events.changed();
  }

  /** Edges as lines, or as rods. */
  async #drawRods(): Promise<void> {
    if (this.#appearance.rods !== undefined && this.#rods === null) {
      const { Rods } = await rods();
      if (this.#isDisposed) return;
      this.#rods ??= this.#createRods(Rods);
    }
    const { rods: thickness } = this.#appearance;
    this.#lines.object.visible = this.#rods === null || thickness === undefined;
    if (this.#rods === null) return;
    this.#rods.object.visible = thickness !== undefined;
    if (thickness !== undefined) this.#rods.setThickness(thickness);
    this.#events.changed();
  }

  #createRods(Kind: typeof Rods): Rods {
    const made = new Kind(this.#uniforms, this.#colours);
    made.setTheme(this.#theme);
    if (this.#net && this.#data) made.setNet(this.#data, this.#net.edges.length / 2);
    this.object.add(made.object);
    return made;
  }

  /** Puts the section plane where it is to be. */
  #cut(): void {
    const plane = this.section.set(0, 0, 0, 0);
    const { section } = this.#appearance;
    if (section === undefined || !this.#data) return;
    const { axisY, signY } = this.#data.space;
    const axis = { x: 0, y: 1, z: 2 }[section.axis];
    if (axis === 0) plane.x = 1;
    else if (axis === axisY) plane.y = signY;
    else plane.z = 1;
    plane.w = (2 * section.at - 1) * SECTION_RANGE;
  }
}

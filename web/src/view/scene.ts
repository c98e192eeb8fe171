/** The 3D view: puts net, handles, ground and camera together, and draws when something has changed, never otherwise. */
import {
  DirectionalLight,
  HemisphereLight,
  Matrix4,
  PerspectiveCamera,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { ColourMap, Field, HandleData, Vec3 } from '../document/document';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { AxisArrows } from './axis_arrows';
import { fitCamera, type Margins, type Stand } from './camera_fit';
import { scaleOf } from './colour_map';
import { type DragEvents, DragReport } from './drag';
import { endFirstVisit, isFirstVisit } from './first_visit';
import { type Found, Gestures } from './gestures';
import { Ground } from './ground';
import { HandleMarks, toScreen } from './handles';
import { ColourTexture, NetData } from './net_data';
import { NetFaces } from './net_faces';
import { NetLines } from './net_lines';
import { createBlankView, createNotice, probeGraphics } from './notice';
import { Overlay, type Place, type Strain } from './overlay';
import type { Projection } from './picking';
import { Space } from './space';
import { onThemeChange, readTheme, type Theme } from './theme';
import type { View, ViewEvents } from './view';

type CameraPlace = { position: Vec3; target: Vec3 };
type Appearance = { field: Field; colourMap: ColourMap; showFaces: boolean };

const FIELD_OF_VIEW = 32;
const GLIDE_MS = 280;
/** Share of the camera's momentum that a sixtieth of a second takes. */
const DAMPING = 0.16;
/** After a longer pause than this it is the first frame of a motion. */
const LONG_FRAME_MS = 300;
/** More pixels than this cost much and show little. */
const LARGEST_PIXEL_RATIO = 2;
/** A label keeps so far from the edges of the canvas, in pixels. */
const LABEL_ROOM = { side: 140, top: 120, bottom: 120 };
/** So many unreachable pairs are drawn, the worst first. */
const SHOWN_STRAINS = 3;

export function createView(container: HTMLElement, events: ViewEvents): View {
  const graphics = probeGraphics();
  return graphics === 'none' ? createBlankView(container) : new SceneView(container, events, graphics === 'card');
}

/** What is drawn of one net. */
interface Shown {
  data: NetData;
  lines: NetLines;
  faces: NetFaces;
}

class SceneView implements View {
  private readonly scene = new Scene();
  private readonly camera3d = new PerspectiveCamera(FIELD_OF_VIEW);
  private readonly renderer: WebGLRenderer;
  private readonly orbit: OrbitControls;
  private readonly arrows: AxisArrows;
  private readonly marks = new HandleMarks();
  private readonly ground = new Ground();
  private readonly colours = new ColourTexture();
  private readonly overlay = new Overlay();
  private readonly report: DragReport;
  private readonly gestures: Gestures;
  private readonly notice: ReturnType<typeof createNotice>;
  private readonly resizing: ResizeObserver;
  private readonly stopThemes: () => void;
  private readonly size = new Vector2(1, 1);
  private readonly viewProjection = new Matrix4();
  private theme: Theme;
  private shown: Shown | null = null;
  private appearance: Appearance = { field: 'deviation', colourMap: 'paper', showFaces: false };
  private selected: number | null = null;
  private strains: FrameData['unreachable'] = [];
  private found: Found | null = null;
  private firstVisit = isFirstVisit();
  private frame = 0;
  private netMoved = false;
  /** The camera still stands where it was put to show the whole net: a new size of the page puts it there again. */
  private framed = true;
  private steering = false;
  private cameraMoved = false;
  private glide: { from: Stand; to: Stand; start: number } | null = null;
  private lastMove = 0;
  private drawTimes: number[] = [];

  constructor(
    private readonly container: HTMLElement,
    private readonly events: ViewEvents,
    antialias: boolean,
  ) {
    this.renderer = new WebGLRenderer({ antialias, alpha: true });
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute(
      'aria-label',
      'The net. Arrow keys turn the view or move the selected handle, plus and minus zoom, Home shows the whole net.',
    );
    container.append(canvas, this.overlay.element);
    this.notice = createNotice(container);
    this.camera3d.up.set(0, 0, 1);
    this.report = new DragReport(this.noteFirstDrag(events));
    this.orbit = this.createOrbit(canvas);
    this.arrows = new AxisArrows(this.camera3d, canvas, {
      start: () => this.report.begin(this.selected!),
      move: (point) => this.carry(point),
      end: () => this.report.end(false),
      changed: () => this.requestDraw(),
    });
    this.scene.add(this.ground.object, this.marks.object, ...this.arrows.objects, this.camera3d);
    this.addLights();
    this.gestures = this.createGestures(canvas);
    this.theme = readTheme(container);
    this.applyTheme();
    this.stopThemes = onThemeChange(() => this.readTheme());
    canvas.addEventListener('webglcontextlost', () => this.notice.show('The graphics card dropped the picture; waiting for it…'));
    canvas.addEventListener('webglcontextrestored', () => this.restored());
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(container);
    this.resize();
  }

  showNet(net: OpenedNet, frame: FrameData, camera: CameraPlace | null): void {
    this.removeNet();
    const data = new NetData(net, Space.of(net.restPositions));
    const lines = new NetLines(data, this.colours, net.edges);
    const faces = new NetFaces(data, this.colours, net.faceStart, net.faceVertices);
    this.shown = { data, lines, faces };
    this.scene.add(lines.object, faces.object);
    this.ground.showNet(data, faces.object.geometry);
    this.applyTheme();
    this.showFrame(frame);
    this.glide = null;
    this.framed = camera === null;
    this.standAt(camera ? this.toStand(camera) : this.wholeNet());
  }

  showFrame(frame: FrameData): void {
    if (!this.shown) return;
    this.shown.data.show(frame);
    this.strains = frame.unreachable;
    this.netMoved = true;
    this.requestDraw();
  }

  showHandles(handles: readonly HandleData[], selected: number | null): void {
    if (!this.shown) return;
    this.marks.show(handles, this.shown.data.space, this.report.vertex);
    this.selected = selected;
    if (this.found && !this.found.handle && this.marks.point(this.found.vertex)) this.found = null;
    this.requestDraw();
  }

  setAppearance(appearance: Appearance): void {
    this.appearance = appearance;
    const { field, colourMap, showFaces } = appearance;
    this.colours.show(scaleOf(field, colourMap, this.theme), field === 'angle');
    if (this.shown) {
      this.shown.faces.object.visible = showFaces;
      this.shown.lines.setOverColours(showFaces && field === 'angle');
    }
    this.requestDraw();
  }

  frameAll(): void {
    if (!this.shown) return;
    const to = this.wholeNet();
    this.framed = true;
    this.cameraMoved = true;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) this.standAt(to);
    else this.glide = { from: this.stand(), to, start: performance.now() };
    this.requestDraw();
  }

  camera(): CameraPlace {
    if (!this.shown) return { position: [0, 0, 0], target: [0, 0, 0] };
    const { space } = this.shown.data;
    return { position: space.toNet(this.camera3d.position), target: space.toNet(this.orbit.target) };
  }

  framesPerSecond(): number {
    const second = performance.now() - 1000;
    return this.drawTimes.filter((time) => time > second).length;
  }

  screenPosition(vertex: number): Place {
    const box = this.renderer.domElement.getBoundingClientRect();
    const { x, y } = this.place(this.marks.point(vertex) ?? this.vertexPoint(vertex));
    return { x: box.left + x, y: box.top + y };
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.resizing.disconnect();
    this.stopThemes();
    this.gestures.dispose();
    this.removeNet();
    for (const thing of [this.arrows, this.orbit, this.marks, this.ground, this.colours, this.renderer]) thing.dispose();
    this.renderer.domElement.remove();
    this.overlay.element.remove();
    this.notice.remove();
  }

  private createOrbit(canvas: HTMLCanvasElement): OrbitControls {
    const orbit = new OrbitControls(this.camera3d, canvas);
    orbit.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    orbit.zoomSpeed = 1.2;
    orbit.minDistance = 0.02;
    orbit.maxDistance = 30;
    orbit.addEventListener('start', () => {
      this.steering = true;
      this.framed = false;
      this.glide = null;
    });
    orbit.addEventListener('change', () => {
      this.cameraMoved = true;
      this.requestDraw();
    });
    orbit.addEventListener('end', () => {
      this.steering = false;
      this.requestDraw();
    });
    return orbit;
  }

  private createGestures(canvas: HTMLCanvasElement): Gestures {
    return new Gestures({
      canvas,
      camera: this.camera3d,
      orbit: this.orbit,
      arrows: this.arrows,
      marks: this.marks,
      report: this.report,
      events: this.events,
      data: () => this.shown?.data ?? null,
      selected: () => this.selected,
      projection: () => this.projection(),
      carry: (point) => this.carry(point),
      hovered: (found) => this.setFound(found),
      frameAll: () => this.frameAll(),
    });
  }

  /** Light comes along with the camera, so a handle looks the same from every side. */
  private addLights(): void {
    const lamp = new DirectionalLight(0xffffff, 2.2);
    lamp.position.set(-1, 2, 2);
    this.camera3d.add(lamp);
    this.scene.add(new HemisphereLight(0xffffff, 0xb0b8c8, 1.5));
  }

  private noteFirstDrag(events: ViewEvents): DragEvents {
    return {
      dragStart: (vertex) => {
        this.firstVisit = false;
        endFirstVisit();
        events.dragStart(vertex);
      },
      dragMove: (vertex, target) => events.dragMove(vertex, target),
      dragEnd: (vertex, cancelled) => events.dragEnd(vertex, cancelled),
    };
  }

  /** The handle in hand is drawn where the hand is, ahead of document and net. */
  private carry(point: Vector3): void {
    if (this.report.vertex === null || !this.shown) return;
    this.marks.point(this.report.vertex)?.copy(point);
    this.report.move(this.shown.data.space.toNet(point));
    this.requestDraw();
  }

  private setFound(found: Found | null): void {
    this.found = found;
    this.drawOverlay();
  }

  private removeNet(): void {
    if (!this.shown) return;
    const { data, lines, faces } = this.shown;
    this.scene.remove(lines.object, faces.object);
    for (const thing of [data, lines, faces]) thing.dispose();
    this.shown = null;
    this.found = null;
  }

  private readTheme(): void {
    this.theme = readTheme(this.container);
    this.applyTheme();
  }

  private applyTheme(): void {
    for (const part of [this.marks, this.ground, this.arrows]) part.setTheme(this.theme);
    this.shown?.lines.setTheme(this.theme);
    this.shown?.faces.setTheme(this.theme);
    this.setAppearance(this.appearance);
  }

  private restored(): void {
    this.notice.hide();
    this.netMoved = true;
    this.requestDraw();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.size.set(clientWidth, clientHeight);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, LARGEST_PIXEL_RATIO));
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera3d.aspect = clientWidth / clientHeight;
    this.camera3d.updateProjectionMatrix();
    if (this.framed && this.shown) this.standAt(this.wholeNet());
    // At once: setting the size has cleared the canvas.
    this.draw();
  }

  private requestDraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.report.flush();
    this.moveCamera();
    if (!this.shown) return;
    this.prepare(this.shown);
    if (this.netMoved) this.ground.drawShadow(this.renderer);
    this.netMoved = false;
    this.renderer.render(this.scene, this.camera3d);
    this.drawOverlay();
    this.countDraw();
  }

  private prepare({ data, lines }: Shown): void {
    const camera = this.camera3d;
    const distance = camera.position.distanceTo(this.orbit.target);
    camera.near = Math.max(1e-3, 0.02 * distance);
    camera.far = distance + 8;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    lines.beforeDraw(camera, this.size, this.renderer.getPixelRatio(), distance);
    this.marks.beforeDraw(camera, this.size.y, data.edgeLength, distance);
    this.arrows.show(this.selected === null ? null : (this.marks.point(this.selected) ?? null));
    // From below, the floor would hide the net.
    this.ground.object.visible = camera.position.z > this.ground.object.position.z;
  }

  private moveCamera(): void {
    const now = performance.now();
    // By time, not by frame: on a slow machine the camera would coast for seconds.
    const elapsed = now - this.lastMove;
    this.orbit.dampingFactor = 1 - (1 - DAMPING) ** (elapsed < LONG_FRAME_MS ? 0.06 * elapsed : 1);
    this.lastMove = now;
    if (this.glide) this.glideOn(this.glide);
    if (this.orbit.update() || this.glide || this.steering) return;
    if (!this.cameraMoved) return;
    this.cameraMoved = false;
    this.events.cameraChanged(this.camera());
  }

  private glideOn({ from, to, start }: { from: Stand; to: Stand; start: number }): void {
    const t = Math.min(1, (performance.now() - start) / GLIDE_MS);
    const eased = 1 - (1 - t) ** 3;
    this.camera3d.position.lerpVectors(from.position, to.position, eased);
    this.orbit.target.lerpVectors(from.target, to.target, eased);
    if (t === 1) this.glide = null;
    this.requestDraw();
  }

  private stand(): Stand {
    return { position: this.camera3d.position.clone(), target: this.orbit.target.clone() };
  }

  private standAt({ position, target }: Stand): void {
    this.camera3d.position.copy(position);
    this.orbit.target.copy(target);
    this.orbit.update();
    this.requestDraw();
  }

  private toStand({ position, target }: CameraPlace): Stand {
    const stand = { position: new Vector3(), target: new Vector3() };
    this.shown!.data.space.toScene(stand.position, position);
    this.shown!.data.space.toScene(stand.target, target);
    return stand;
  }

  private wholeNet(): Stand {
    const { points, vertexCount } = this.shown!.data;
    return fitCamera(points, vertexCount, this.camera3d, this.margins());
  }

  /** What title, tools and legend cover is up to the style sheet: pixels at top, right, bottom, left. */
  private margins(): Margins {
    const text = getComputedStyle(this.container).getPropertyValue('--view-margins');
    const [top = 0, right = 0, bottom = 0, left = 0] = text.trim().split(/\s+/).map(Number);
    const { x: width, y: height } = this.size;
    return { top: top / height, right: right / width, bottom: bottom / height, left: left / width };
  }

  private projection(): Projection {
    this.camera3d.updateMatrixWorld();
    this.viewProjection.multiplyMatrices(this.camera3d.projectionMatrix, this.camera3d.matrixWorldInverse);
    return { matrix: this.viewProjection.elements, width: this.size.x, height: this.size.y };
  }

  private vertexPoint(vertex: number): Vector3 {
    return new Vector3().fromArray(this.shown!.data.points, 4 * vertex);
  }

  private place(point: Vector3): Place {
    return toScreen(this.projection(), point);
  }

  private drawOverlay(): void {
    if (!this.shown) return;
    const radius = this.marks.screenRadius;
    this.drawHover(radius);
    const beckoning = this.firstVisit ? this.marks.suggested : null;
    this.overlay.setPulse(beckoning === null ? null : this.place(this.marks.point(beckoning)!), radius + 3);
    this.overlay.setTether(this.tether(radius));
    this.overlay.setStrains(this.drawnStrains());
  }

  private drawHover(radius: number): void {
    if (!this.found) {
      this.overlay.setHover(null, 0, false);
      return;
    }
    const { vertex, handle } = this.found;
    const point = (handle && this.marks.point(vertex)) || this.vertexPoint(vertex);
    this.overlay.setHover(this.place(point), handle ? radius + 4 : 8, !handle);
  }

  private tether(radius: number): { from: Place; to: Place } | null {
    const { vertex } = this.report;
    const point = vertex === null ? undefined : this.marks.point(vertex);
    if (vertex === null || !point) return null;
    const from = this.place(this.vertexPoint(vertex));
    const to = this.place(point);
    return Math.hypot(to.x - from.x, to.y - from.y) > 2 * radius ? { from, to } : null;
  }

  private drawnStrains(): Strain[] {
    return this.strains.slice(0, SHOWN_STRAINS).flatMap(({ vertexA, vertexB, distance, reach }, i) => {
      const [a, b] = [this.marks.point(vertexA), this.marks.point(vertexB)];
      if (!a || !b) return [];
      const [from, to] = [this.place(a), this.place(b)];
      const text = `${distance.toPrecision(3)} apart, the net reaches ${reach.toPrecision(3)}`;
      return [{ from, to, label: i === 0 ? { text, at: this.between(from, to) } : null }];
    });
  }

  /** The middle of two places, kept on the canvas so that a label there can be read. */
  private between(a: Place, b: Place): Place {
    const { top, bottom } = LABEL_ROOM;
    const clamp = (x: number, low: number, high: number) => Math.max(low, Math.min(high, x));
    return {
      x: clamp((a.x + b.x) / 2, LABEL_ROOM.side, this.size.x - LABEL_ROOM.side),
      y: clamp((a.y + b.y) / 2 - 8, top, this.size.y - bottom),
    };
  }

  private countDraw(): void {
    const now = performance.now();
    this.drawTimes.push(now);
    if (this.drawTimes.length > 240) this.drawTimes = this.drawTimes.filter((time) => time > now - 1000);
  }
}

/** The 3D view: puts net, handles, ground and camera together, and draws only when something has changed. */
import { type Matrix4, Vector3 } from 'three';
import type { CameraPlace, HandleData, Symmetry, ViewPlace } from '../document/document';
import { pointOf } from '../document/point_of';
import { words } from '../language/language';
import type { Along } from '../handles/along';
import { movedBetween } from '../handles/moved';
import type { Limit } from '../handles/reach';
import { lazy } from '../lazy';
import type { DrawnSurface, FrameData, OpenedNet } from '../worker/protocol';
import { Annotations } from './annotations';
import { directionFor, fitCamera, isBehind, type Margins, type Side, type Stand, standBack } from './camera_fit';
import type { CameraRig } from './camera_rig';
import type { AxisDrag } from './axis_drag';
import { type DragEvents, DragReport } from './drag';
import { endFirstVisit, isFirstVisit } from './first_visit';
import { type Found, Gestures } from './gestures';
import { Gizmo } from './gizmo';
import { Hand } from './hand';
import { HandleMarkers, toScreen } from './handles';
import type { NetData } from './net_data';
import { type Appearance, NetDrawing } from './net_drawing';
import { createBlankView, probeGraphics } from './notice';
import type { Place } from './overlay';
import type { ReachSurface } from './reach_surface';
import { Stage } from './stage';
import type { StepArrows } from './step_arrows';
import type { SymmetrySheet } from './symmetry_sheet';
import type { Film, Pen, PenEvents, View, ViewChoice, ViewEvents } from './view';
import './view.css';

const captures = lazy(() => import('./capture'));

/** Of a picture whose camera does not say. */
const USUAL_ASPECT = 1.2;
/** The share of its margins that title and tools do cover. */
const COVERED = 0.6;
/** Milliseconds within which a net usually follows the first move of a drag. A picture without it would keep it waiting. */
const NET_FOLLOWS = 100;
/** Of the camera, in parts of its distance: about a pixel. */
const SEEN_MOVE = 0.002;

/** @param reload loads the page again without a loss; without it that is not offered. */
export function createView(container: HTMLElement, events: ViewEvents, reload?: () => void): View {
  const graphics = probeGraphics();
  return graphics === 'none' ? createBlankView(container) : new SceneView(container, events, graphics, reload);
}

class SceneView implements View {
  readonly #stage: Stage;
  readonly #gizmo: Gizmo;
  readonly #markers = new HandleMarkers();
  readonly #drawing: NetDrawing;
  readonly #annotations: Annotations;
  readonly #report: DragReport;
  readonly #hand: Hand;
  readonly #gestures: Gestures;
  /** From where the whole net is seen. */
  #behind = false;
  #direction = directionFor();
  #net: OpenedNet | null = null;
  #latest: FrameData | null = null;
  #handles: readonly HandleData[] = [];
  #appearance: Appearance = { field: 'deviation', colourMap: 'paper', showFaces: false };
  #choice: ViewChoice = { selection: [], mode: 'translate', selecting: false };
  #symmetry: Symmetry | undefined;
  #regionShown = false;
  #preview: readonly number[] = [];
  #marks: readonly (readonly number[])[] = [];
  #readout = '';
  #found: Found | null = null;
  #axes: AxisDrag | null = null;
  #stepArrows: StepArrows | null = null;
  #sheet: SymmetrySheet | null = null;
  #reach: ReachSurface | null = null;
  #limits: readonly Limit[] | null = null;
  #firstVisit = isFirstVisit();
  /** The camera is being set to that of another view. */
  #following = false;
  /** When a handle is first taken hold of. */
  readonly #loadAxes = lazy(async () => {
    const { AxisDrag } = await import('./axis_drag');
    this.#axes = new AxisDrag(this.#annotations.overlay.element, {
      data: () => this.#netData!,
      place: (point) => this.#place(point),
    });
    return this.#axes;
  });
  readonly #loadStepArrows = lazy(async () => {
    const { StepArrows } = await import('./step_arrows');
    this.#stepArrows = new StepArrows();
    this.#stepArrows.setTheme(this.#stage.theme);
    this.#stage.scene.add(this.#stepArrows.object);
    return this.#stepArrows;
  });
  readonly #loadSheet = lazy(async () => {
    const { SymmetrySheet } = await import('./symmetry_sheet');
    this.#sheet = new SymmetrySheet();
    this.#sheet.setTheme(this.#stage.theme);
    this.#stage.scene.add(this.#sheet.object);
  });
  readonly #loadReach = lazy(async () => {
    const { ReachSurface } = await import('./reach_surface');
    this.#reach = new ReachSurface();
    this.#reach.setTheme(this.#stage.theme);
    this.#stage.scene.add(this.#reach.object);
  });
  readonly #loadPen = lazy(async () => ({ ...(await import('./pen')), ...(await import('./stroke')) }));
  #drawTimes: number[] = [];
  readonly #container: HTMLElement;
  readonly #events: ViewEvents;

  constructor(container: HTMLElement, events: ViewEvents, graphics: 'card' | 'software', reload?: () => void) {
    this.#container = container;
    this.#events = events;
    this.#stage = new Stage(container, words.view.net, graphics, {
      beforePicture: () => this.#report.flush(),
      draw: () => this.#draw(),
      frameAgain: () => this.#netData && this.#rig.standAt(this.#wholeNet()),
      themed: () => this.#applyTheme(),
      restored: () => this.#drawing.restore(),
      cameraMoved: () => this.#cameraMoved(),
      cameraRested: () => events.cameraChanged(this.camera()),
    });
    const { canvas, scene, size } = this.#stage;
    this.#drawing = new NetDrawing(this.#stage.theme, this.#appearance, {
      changed: () => this.#requestDraw(),
      failed: (error) => events.failed(error),
    });
    this.#annotations = new Annotations({
      size,
      markers: this.#markers,
      vertexPoint: (vertex) => this.#vertexPoint(vertex),
      place: (point) => this.#place(point),
    });
    canvas.after(this.#annotations.overlay.element);
    this.#report = new DragReport(this.#noteFirstDrag(events));
    this.#hand = new Hand(this.#markers, this.#report, () => this.#choice.selection);
    this.#gizmo = new Gizmo(this.#rig.camera, canvas, {
      start: () => this.#hand.grab(this.#hand.moving()),
      move: (motion) => this.#carry(motion),
      end: () => this.#report.end(false),
      changed: () => this.#requestDraw(),
      failed: (error) => events.failed(error),
    });
    for (const part of [this.#drawing, this.#markers, this.#gizmo]) scene.add(part.object);
    this.#gestures = this.#createGestures(canvas);
    this.#stage.begin(reload);
    // Drivers compile shaders while the first net is still to come; its first picture would wait for them.
    this.#stage.renderer.compile(scene, this.#rig.eye);
  }

  setNet(net: OpenedNet, frame: FrameData, { camera, behind }: ViewPlace): void {
    this.#forgetNet();
    this.#net = net;
    const { space } = this.#drawing.setNet(net);
    this.#sheet?.update(this.#symmetry, net.restPositions, space);
    this.setFrame(frame);
    this.#behind = behind ?? this.#beginsBehind(net);
    this.#lookFrom('free');
    this.#rig.framed = camera === null;
    this.#rig.standAt(camera ? this.#toStand(camera) : this.#wholeNet());
    if (camera) this.#standBack(camera);
  }

  setFrame(frame: FrameData): void {
    if (!this.#netData) return;
    this.#latest = frame;
    this.#drawing.setFrame(frame);
    this.#stepArrows?.update(frame, this.#netData.space, this.#netData.edgeLength);
    this.#stage.releasePicture();
    this.#requestDraw();
  }

  setHandles(handles: readonly HandleData[], choice: ViewChoice): void {
    if (!this.#netData) return;
    const shown = handles.map((each) => (choice.part?.hidden[each.vertex] ? { ...each, hidden: true } : each));
    const moved = this.#report.isUnderWay ? undefined : movedBetween(this.#handles, shown);
    this.#handles = handles;
    this.#choice = choice;
    this.#drawing.setPart(choice.part);
    this.#drawing.setSnapping(choice.snapping);
    this.#markers.update(
      shown,
      this.#netData.space,
      choice.selection,
      // With snapping they stand where that takes them, and not where the hand is.
      choice.snapping ? [] : this.#report.vertices,
    );
    this.#container.classList.toggle('selecting', choice.selecting);
    this.#gizmo.setMode(choice.mode);
    this.#gizmo.setPosition(this.#gizmoPlace());
    if (this.#found && !this.#found.handle && this.#markers.point(this.#found.vertex)) this.#found = null;
    if (moved !== undefined) this.#keepInReach(moved);
    this.#requestDraw();
  }

  setSymmetry(symmetry: Symmetry | undefined): void {
    if (symmetry === this.#symmetry) return;
    this.#symmetry = symmetry;
    if (symmetry === undefined) this.#showSymmetry();
    else
      this.#loadSheet()
        .then(() => this.#showSymmetry())
        .catch((error: unknown) => this.#events.failed(error));
  }

  setGuide(surface: DrawnSurface | null): void {
    this.#drawing.setGuide(surface);
  }

  setRegion(mobility: Float32Array | null): void {
    if (!this.#netData || (mobility === null && !this.#regionShown)) return;
    this.#regionShown = mobility !== null;
    this.#netData.setMobility(mobility);
    this.#requestDraw();
  }

  setShares(shares: ReadonlyMap<number, number> | null): void {
    this.#markers.setShares(shares);
    this.#requestDraw();
  }

  setReach(limits: readonly Limit[] | null): void {
    const isShown = this.#limits !== null;
    this.#limits = limits;
    if (limits === null && !isShown) return;
    if (limits === null) this.#showReach();
    else
      this.#loadReach()
        .then(() => this.#showReach())
        .catch((error: unknown) => this.#events.failed(error));
  }

  setReadout(text: string): void {
    this.#readout = text;
    this.#requestDraw();
  }

  setPreview(vertices: readonly number[]): void {
    this.#preview = vertices;
    this.#drawAnnotations();
  }

  async takePen(events: PenEvents): Promise<Pen> {
    const { Pen, Stroke } = await this.#loadPen();
    const { section } = this.#drawing;
    const begin = (at: Place) => {
      const [net, data] = [this.#net, this.#netData];
      return net && data && new Stroke({ ...net, data, section, projection: this.#stage.projection() }, at);
    };
    return new Pen(this.#stage.canvas, begin, events);
  }

  setMarks(cells: readonly (readonly number[])[]): void {
    this.#marks = cells;
    this.#drawAnnotations();
  }

  setAppearance(appearance: Appearance): void {
    const { upAxis = 'z' } = this.#appearance;
    this.#appearance = appearance;
    this.#drawing.setAppearance(appearance);
    if ((appearance.upAxis ?? 'z') !== upAxis) this.#turn();
    this.#setParallel(appearance.parallel ?? false);
    this.#requestDraw();
  }

  setStepArrows(shown: boolean): void {
    this.#loadStepArrows()
      .then((arrows) => {
        arrows.object.visible = shown;
        if (this.#latest) this.setFrame(this.#latest);
      })
      .catch((error: unknown) => this.#events.failed(error));
  }

  frameAll(from: Side = 'free'): void {
    if (!this.#netData) return;
    this.#lookFrom(from);
    this.#rig.framed = true;
    this.#rig.glideTo(this.#wholeNet());
  }

  get framed(): boolean {
    return this.#rig.framed;
  }

  get behind(): boolean {
    return this.#behind;
  }

  camera(): CameraPlace {
    return this.#netData ? this.#fromStand(this.#rig.stand) : { position: [0, 0, 0], target: [0, 0, 0] };
  }

  heading(): CameraPlace | null {
    const { heading } = this.#rig;
    return this.#netData && heading && this.#fromStand(heading);
  }

  unframed(): CameraPlace | null {
    if (!this.#netData) return null;
    const { stand, distance } = this.#rig;
    const whole = this.#wholeNet();
    const apart = Math.max(stand.position.distanceTo(whole.position), stand.target.distanceTo(whole.target));
    return apart > SEEN_MOVE * distance ? this.#fromStand(stand) : null;
  }

  async picture(magnification: number): Promise<Blob> {
    const { takePicture } = await captures();
    const { renderer, scene, size } = this.#stage;
    return takePicture(renderer, scene, size, magnification, () => this.#stage.draw());
  }

  async film(): Promise<Film> {
    const { takeFilm } = await captures();
    const { renderer, scene, theme } = this.#stage;
    return takeFilm(renderer, scene, theme, () => this.#requestDraw());
  }

  setCamera(camera: CameraPlace): void {
    if (!this.#netData) return;
    this.#rig.framed = false;
    this.#following = true;
    this.#rig.standAt(this.#toStand(camera));
    this.#following = false;
  }

  framesPerSecond(): number {
    const second = performance.now() - 1000;
    return this.#drawTimes.filter((time) => time > second).length;
  }

  screenPositions(vertices: readonly number[]): Place[] {
    const { left, top } = this.#stage.canvas.getBoundingClientRect();
    const projection = this.#stage.projection();
    return vertices.map((vertex) => {
      const { x, y } = toScreen(projection, this.#markers.point(vertex) ?? this.#vertexPoint(vertex));
      return { x: left + x, y: top + y };
    });
  }

  dispose(): void {
    for (const part of [this.#gestures, this.#gizmo, this.#markers, this.#drawing]) part.dispose();
    this.#stepArrows?.dispose();
    this.#sheet?.dispose();
    this.#reach?.dispose();
    this.#stage.dispose();
    this.#annotations.overlay.element.remove();
  }

  get #rig(): CameraRig {
    return this.#stage.rig;
  }

  /** What is drawn of the net; null before the first. */
  get #netData(): NetData | null {
    return this.#drawing.data;
  }

  #createGestures(canvas: HTMLCanvasElement): Gestures {
    return new Gestures({
      canvas,
      camera: () => this.#rig.eye,
      orbit: this.#rig.orbit,
      gizmo: this.#gizmo,
      markers: this.#markers,
      report: this.#report,
      events: this.#events,
      data: () => this.#netData,
      section: this.#drawing.section,
      selection: () => this.#choice.selection,
      selecting: () => this.#choice.selecting,
      moving: (handle) => this.#hand.moving(handle),
      grid: () => this.#choice.snapping?.step,
      projection: () => this.#stage.projection(),
      grab: (vertices) => this.#hand.grab(vertices),
      carry: (motion, along) => this.#carry(motion, along),
      axes: () => this.#loadAxes(),
      outline: (corners) => this.#annotations.overlay.setOutline(corners),
      hovered: (found) => this.#setFound(found),
      frameAll: () => this.frameAll(),
    });
  }

  #noteFirstDrag(events: ViewEvents): DragEvents {
    let leading: number | undefined;
    let isFirst = true;
    return {
      dragStart: () => {
        leading = this.#report.vertices[0];
        isFirst = true;
        this.#firstVisit = false;
        endFirstVisit();
        return events.dragStart();
      },
      dragMove: (targets, along) => {
        if (isFirst) this.#stage.holdPicture(NET_FOLLOWS);
        isFirst = false;
        events.dragMove(targets, along);
      },
      dragEnd: (cancelled) => {
        this.#stage.releasePicture();
        events.dragEnd(cancelled);
        if (!cancelled && leading !== undefined) this.#keepInReach(leading);
      },
    };
  }

  /** The view follows a handle that came under the title or the tools, where it could not be taken again: as it showed
   *  the whole net it goes on to, else it is moved along. */
  #keepInReach(vertex: number): void {
    const point = this.#markers.point(vertex);
    if (!point) return;
    const { x, y } = this.#place(point);
    const { x: width, y: height } = this.#stage.size;
    const { top, right, bottom, left } = this.#margins();
    const within = (at: number, low: number, high: number) => Math.max(low, Math.min(at, high));
    const isFree =
      x === within(x, COVERED * left * width, (1 - COVERED * right) * width) &&
      y === within(y, COVERED * top * height, (1 - COVERED * bottom) * height);
    if (isFree) return;
    if (this.#rig.framed) return this.#rig.glideTo(this.#wholeNet());
    this.#rig.glideBy(
      within(x, left * width, (1 - right) * width) - x,
      within(y, top * height, (1 - bottom) * height) - y,
      point,
      height,
    );
  }

  #carry(motion: Matrix4, along: Along | null = null): void {
    if (!this.#report.isUnderWay || !this.#netData) return;
    this.#hand.carry(motion, this.#netData.space, along);
    this.#requestDraw();
  }

  #setFound(found: Found | null): void {
    this.#found = found;
    this.#drawAnnotations();
  }

  /** What is in hand or shown is of the net before: the next may not have such vertices, or has them elsewhere. */
  #forgetNet(): void {
    this.#gestures.giveUp();
    this.#markers.setShares(null);
    this.#preview = [];
    this.#handles = [];
    this.#found = null;
    this.#marks = [];
    this.#regionShown = false;
    this.#limits = null;
    if (this.#reach) this.#reach.object.visible = false;
  }

  /** Another axis is up: all scene positions change. */
  #turn(): void {
    this.#gizmo.setTheme(this.#stage.theme, this.#appearance.upAxis ?? 'z');
    if (!this.#net || !this.#latest) return;
    const [handles, marks] = [this.#handles, this.#marks];
    this.setNet(this.#net, this.#latest, { camera: null });
    this.setHandles(handles, this.#choice);
    this.setMarks(marks);
  }

  #lookFrom(from: Side): void {
    this.#direction =
      from === 'here' ? this.#rig.camera.getWorldDirection(new Vector3()).negate() : directionFor(from, this.#behind);
  }

  /** The net at rest, which is the same whenever it is opened. */
  #beginsBehind({ suggestedHandles, restPositions }: OpenedNet): boolean {
    const first = suggestedHandles.at(-1);
    if (first === undefined) return false;
    const place = new Vector3();
    this.#netData!.space.toScene(place, pointOf(restPositions, first));
    return isBehind(place);
  }

  #setParallel(isParallel: boolean): void {
    if (isParallel === this.#rig.isParallel) return;
    this.#rig.isParallel = isParallel;
    this.#gizmo.setCamera(this.#rig.eye);
    if (this.#rig.framed && this.#netData) this.#rig.glideTo(this.#wholeNet());
  }

  #showSymmetry(): void {
    if (this.#net && this.#netData) this.#sheet?.update(this.#symmetry, this.#net.restPositions, this.#netData.space);
    this.#requestDraw();
  }

  #showReach(): void {
    if (this.#netData) this.#reach?.update(this.#limits, this.#netData.space);
    this.#requestDraw();
  }

  #applyTheme(): void {
    const { theme } = this.#stage;
    for (const part of [this.#drawing, this.#markers]) part.setTheme(theme);
    this.#stepArrows?.setTheme(theme);
    this.#sheet?.setTheme(theme);
    this.#reach?.setTheme(theme);
    this.#gizmo.setTheme(theme, this.#appearance.upAxis ?? 'z');
    this.#requestDraw();
  }

  #cameraMoved(): void {
    if (this.#netData && !this.#following) this.#events.cameraMoved(this.camera());
    this.#requestDraw();
  }

  #requestDraw(): void {
    this.#stage.requestDraw();
  }

  #draw(): void {
    if (!this.#netData) return;
    this.#prepare(this.#netData);
    const { renderer, scene } = this.#stage;
    renderer.render(scene, this.#rig.eye);
    this.#drawAnnotations();
    this.#countDraw();
  }

  #prepare({ edgeLength }: NetData): void {
    const { eye, distance } = this.#rig;
    const { renderer, size } = this.#stage;
    this.#drawing.beforeDraw(renderer, this.#rig, size);
    this.#stepArrows?.beforeDraw(size, renderer.getPixelRatio());
    this.#markers.beforeDraw(eye, size.y, edgeLength, distance);
    this.#gizmo.setPosition(this.#gizmoPlace());
  }

  /** Hidden while handles are being selected, so as not to cover them. */
  #gizmoPlace(): Vector3 | null {
    return this.#choice.selecting ? null : this.#hand.centre();
  }

  #toStand({ position, target }: CameraPlace): Stand {
    const stand = { position: new Vector3(), target: new Vector3() };
    this.#netData!.space.toScene(stand.position, position);
    this.#netData!.space.toScene(stand.target, target);
    return stand;
  }

  #fromStand({ position, target }: Stand): CameraPlace {
    const { space } = this.#netData!;
    const { aspect: width } = this.#rig.camera;
    // No wider than it is, or what is kept would move when it comes back.
    const aspect = Math.floor(100 * width) / 100 || width;
    return { position: space.toNet(position), target: space.toNet(target), aspect };
  }

  /** What was in a wider picture is in this one. */
  #standBack({ aspect = USUAL_ASPECT }: CameraPlace): void {
    const { points, vertexCount } = this.#netData!;
    const { camera, stand, isParallel } = this.#rig;
    if (aspect > camera.aspect) this.#rig.standAt(standBack(points, vertexCount, camera, stand, aspect, isParallel));
  }

  #wholeNet(): Stand {
    const { points, vertexCount } = this.#netData!;
    const { camera, isParallel } = this.#rig;
    return fitCamera(points, vertexCount, camera, this.#margins(), this.#direction, isParallel);
  }

  /** The pixels that title, tools and legend cover at top, right, bottom, left, from the style sheet. */
  #margins(): Margins {
    const text = getComputedStyle(this.#container).getPropertyValue('--view-margins');
    const [top = 0, right = 0, bottom = 0, left = 0] = text.trim().split(/\s+/).map(Number);
    const { x: width, y: height } = this.#stage.size;
    return { top: top / height, right: right / width, bottom: bottom / height, left: left / width };
  }

  #vertexPoint(vertex: number): Vector3 {
    return new Vector3().fromArray(this.#netData!.points, 4 * vertex);
  }

  #place(point: Vector3): Place {
    return toScreen(this.#stage.projection(), point);
  }

  #drawAnnotations(): void {
    if (!this.#netData) return;
    const [dragged] = this.#report.vertices;
    this.#axes?.draw(this.#markers.point(dragged ?? -1), this.#rig.eye, this.#rig.distance);
    this.#annotations.draw({
      found: this.#found,
      isFirstVisit: this.#firstVisit,
      dragged,
      preview: this.#preview,
      marks: this.#marks,
      readout: this.#readout,
      unreachable: this.#latest?.unreachable ?? [],
    });
  }

  #countDraw(): void {
    const now = performance.now();
    this.#drawTimes.push(now);
    if (this.#drawTimes.length > 240) this.#drawTimes = this.#drawTimes.filter((time) => time > now - 1000);
  }
}

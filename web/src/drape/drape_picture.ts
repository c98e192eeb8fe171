/** The picture of a surface and the net being laid on it. The sphere at the seed is dragged over the surface, the hollow
 *  one beside it around the seed; a drag elsewhere moves the camera. Arrow keys move the seed, too. */
import { DirectionalLight, HemisphereLight, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import type { Point, SurfacePlace } from '../../../wasm/chebnet';
import type { UpAxis } from '../document/document';
import { ARROW_KEYS } from '../elements/keys';
import { fieldOf, scaleOf } from '../fields/fields';
import { words } from '../language/language';
import { directionFor, fitCamera } from '../view/camera_fit';
import { CameraRig } from '../view/camera_rig';
import { HandleMarkers, toScreen } from '../view/handles';
import { ColourTexture, NetData, netUniforms } from '../view/net_data';
import { NetFaces } from '../view/net_faces';
import { NetLines } from '../view/net_lines';
import { createNotice, probeGraphics } from '../view/notice';
import type { Place } from '../view/overlay';
import { pointerKind, type Projection, projectionOf } from '../view/picking';
import { endRenderer, onPixelRatioChange, pixelRatio } from '../view/renderer';
import { Space } from '../view/space';
import { onThemeChange, readTheme } from '../view/theme';
import { CutLines } from './cut_lines';
import type { Cut, Ray, Seed, ShownNet, ShownSurface } from './drape_protocol';
import { combined, cross, dot } from './seed';
import { SeedRing } from './seed_ring';
import { SingularDots, type SingularMarks } from './singular_dots';
import { SurfaceShade, turn } from '../view/surface_shade';

export interface PictureEvents {
  /** The seed is wanted where a ray from the eye meets the surface. */
  seedMoved(ray: Ray): void;
  /** The first family is wanted along a direction. */
  turned(direction: Point): void;
  /** A drag was given up: back to where it began. */
  seedBack(seed: Seed): void;
  /** While a line is drawn: the next point, where a ray meets the surface, or the seed. */
  pointed(at: Ray | Point): void;
  cutEnded(): void;
  /** No more points, and no line through those that there are. */
  cutAbandoned(): void;
  cutUndone(): void;
  /** Its last point is wanted where a ray meets the surface: by keys, where there is no seed. */
  cutMoved(to: Ray): void;
  /** Of the marks one is chosen; null: none. */
  markChosen(mark: number | null): void;
  /** It begins to move. */
  markTaken(): void;
  /** It is wanted where a ray meets the surface. */
  markMoved(mark: number, at: Ray): void;
  /** The drag was given up: back to where it began. */
  markBack(): void;
  markRemoved(): void;
}

/** What is wanted of either view: with WebGL, or without any. */
export interface Picture {
  setSurface(surface: ShownSurface, upAxis: UpAxis): void;
  /** @param seed from which it has been laid; null: it has none. */
  setNet(shown: ShownNet, seed: Seed | null): void;
  removeNet(): void;
  /** Looks at a place from the front, unless the eye is within this angle of its normal already, degrees. */
  face(place: SurfacePlace, within: number): void;
  /** For the arrow keys. */
  focus(): void;
  /** Whether cells are coloured by their shear. */
  setShear(shown: boolean): void;
  /** Whether what is clicked on the surface is a point of a line. Begun by a key on a button, the picture has the keys until it
   *  ends, and the button after that. */
  setCutting(cutting: boolean): void;
  /** @param points of the cut that is being drawn. */
  setCuts(cuts: readonly Cut[], points: readonly Point[]): void;
  /** For the arms or as creases. @param points of the one that is being drawn. */
  setCurves(curves: readonly Cut[], points: readonly Point[]): void;
  setMarks(marks: SingularMarks): void;
  dispose(): void;
}

export function createPicture(container: HTMLElement, label: string, events: PictureEvents): Picture {
  const graphics = probeGraphics();
  if (graphics !== 'none') return new DrapePicture(container, label, events, graphics);
  const notice = createNotice(container);
  notice.show(words.view.noGraphics);
  return {
    setSurface() {},
    setNet() {},
    removeNet() {},
    face() {},
    focus() {},
    setShear() {},
    setCutting() {},
    setCuts() {},
    setCurves() {},
    setMarks() {},
    dispose: () => notice.remove(),
  };
}

/** By their numbers as markers. */
const [SEED, KNOB] = [0, 1];
/** From the seed to the knob, pixels. */
const RING = 58;
/** Of one arrow key, in pixels; keys within so many milliseconds of each other make one way. */
const STEP = { small: 6, big: 30, together: 1000 };
const SLACK = { mouse: 5, touch: 16 };
/** Of an edge, how far the surface is drawn behind. */
const BEHIND = 0.5;
const DEGREE = Math.PI / 180;
/** A pointer that moves no farther than that between down and up has clicked, pixels. */
const STILL = { mouse: 5, touch: 8 };
interface Grip {
  pointer: number;
  /** To where a ray goes, through a place of the canvas. */
  moved(to: Ray, place: Place): void;
  /** It was given up. */
  back(): void;
}
const MARGIN = { top: 0.06, right: 0.06, bottom: 0.06, left: 0.06 };

class DrapePicture implements Picture {
  readonly #scene = new Scene();
  readonly #renderer: WebGLRenderer;
  readonly #rig: CameraRig;
  readonly #shade = new SurfaceShade();
  readonly #uniforms = netUniforms();
  readonly #colours = new ColourTexture();
  readonly #lines = new NetLines(this.#uniforms, this.#colours);
  readonly #faces = new NetFaces(this.#uniforms, this.#colours);
  readonly #markers = new HandleMarkers();
  readonly #ring = new SeedRing();
  readonly #cuts = new CutLines();
  readonly #curves = new CutLines();
  readonly #dots = new SingularDots();
  readonly #size = new Vector2(1, 1);
  readonly #listeners = new AbortController();
  readonly #resizing: ResizeObserver;
  readonly #stopThemes: () => void;
  readonly #stopRatios: () => void;
  readonly #container: HTMLElement;
  readonly #graphics: 'card' | 'software';
  readonly #events: PictureEvents;
  #space: Space | null = null;
  #netData: NetData | null = null;
  #seed: Seed | null = null;
  /** Where arrow keys have led what they move, which is drawn there later. */
  #aim: { mark: number | null; at: Place; time: number } | null = null;
  #showsShear = true;
  /** From where the whole surface is seen. */
  readonly #direction = directionFor().clone();
  /** What is in hand, and by which pointer. */
  #grip: Grip | null = null;
  #frame = 0;
  #isCutting = false;
  #cutPoints: readonly Point[] = [];
  #curvePoints: readonly Point[] = [];
  /** The button whose key began what is being drawn. */
  #keysFrom: HTMLButtonElement | null = null;
  /** Where a pointer went down that may be a click. */
  #pressed: Place | null = null;

  constructor(container: HTMLElement, label: string, events: PictureEvents, graphics: 'card' | 'software') {
    this.#container = container;
    this.#graphics = graphics;
    this.#events = events;
    this.#renderer = new WebGLRenderer({ antialias: graphics === 'card', alpha: true });
    const canvas = this.#renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute('aria-label', label);
    container.append(canvas, this.#ring.element, this.#dots.element);
    this.#rig = new CameraRig(canvas, { moved: () => this.#requestDraw(), rested: () => {} });
    for (const part of [this.#shade, this.#faces, this.#lines, this.#cuts, this.#curves, this.#markers])
      this.#scene.add(part.object);
    this.#addLights();
    this.#listen(canvas);
    this.#readTheme();
    this.#stopThemes = onThemeChange(() => this.#readTheme());
    this.#resizing = new ResizeObserver(() => this.#resize());
    this.#resizing.observe(container);
    this.#stopRatios = onPixelRatioChange(() => this.#resize());
    this.#resize();
  }

  setSurface(surface: ShownSurface, upAxis: UpAxis): void {
    this.#space = new Space(surface.positions, upAxis);
    this.#forgetNet();
    this.#shade.setSurface(surface, this.#space);
    this.#direction.copy(directionFor());
    this.#rig.framed = true;
    this.#frameAll();
  }

  setNet({ net, fields }: ShownNet, seed: Seed | null): void {
    if (!this.#space) return;
    this.#forgetNet();
    this.#seed = seed;
    this.#netData = new NetData(net, this.#space);
    this.#netData.putInto(this.#uniforms);
    this.#netData.setFrame({ positions: net.restPositions, lengthScale: 1, fields }, fieldOf('shear'));
    this.#lines.setNet(this.#netData, net.strips);
    this.#faces.setTriangles(net.triangles);
    this.#shade.setBehind(BEHIND * this.#netData.edgeLength);
    this.#requestDraw();
  }

  removeNet(): void {
    this.#forgetNet();
    this.#requestDraw();
  }

  face({ position, normal }: SurfacePlace, within: number): void {
    const eye = this.#space!.toNet(this.#rig.camera.position);
    const towards = combined(1, eye, -1, position);
    if (dot(towards, normal) > Math.cos(within * DEGREE) * Math.hypot(...towards)) return;
    turn(this.#direction, normal, this.#space!);
    this.#direction.addScaledVector(directionFor(), 0.7).normalize();
    this.#rig.framed = true;
    this.#frameAll();
  }

  focus(): void {
    this.#renderer.domElement.focus();
  }

  setShear(shown: boolean): void {
    this.#showsShear = shown;
    this.#faces.object.visible = shown;
    this.#lines.setOverColours(true);
    this.#requestDraw();
  }

  setCutting(cutting: boolean): void {
    this.#isCutting = cutting;
    this.#renderer.domElement.style.cursor = cutting ? 'crosshair' : '';
    if (cutting) return this.#takeKeys();
    this.#pressed = null;
    this.#giveKeysBack();
  }

  setCuts(cuts: readonly Cut[], points: readonly Point[]): void {
    if (!this.#space) return;
    this.#cutPoints = points;
    const paths = cuts.map(({ path }) => path);
    this.#cuts.set(paths, this.#space);
    this.#requestDraw();
  }

  setCurves(curves: readonly Cut[], points: readonly Point[]): void {
    if (!this.#space) return;
    this.#curvePoints = points;
    const paths = curves.map(({ path }) => path);
    this.#curves.set(paths, this.#space);
    this.#requestDraw();
  }

  setMarks(marks: SingularMarks): void {
    // Undone, or with another one chosen, the way of a mark by keys is at its end.
    if (marks.selected !== this.#dots.marks.selected) this.#aim = null;
    this.#dots.set(marks);
    this.#requestDraw();
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#listeners.abort();
    this.#resizing.disconnect();
    this.#stopThemes();
    this.#stopRatios();
    this.#forgetNet();
    const net = [this.#lines, this.#faces, this.#colours];
    const parts = [this.#rig, this.#shade, ...net, this.#cuts, this.#curves, this.#markers];
    for (const part of parts) part.dispose();
    endRenderer(this.#renderer);
    this.#renderer.domElement.remove();
    this.#ring.element.remove();
    this.#dots.element.remove();
  }

  // ----------------------------------------------------------------------------------------------------------- gestures

  #listen(canvas: HTMLCanvasElement): void {
    const { signal } = this.#listeners;
    // In the capture phase of the parent: before the listeners of the camera.
    const above = { signal, capture: true };
    this.#container.addEventListener('pointerdown', (event) => this.#down(event), above);
    this.#container.addEventListener('pointermove', (event) => this.#move(event), above);
    this.#container.addEventListener('pointerup', (event) => this.#letGo(event), above);
    this.#container.addEventListener('pointercancel', (event) => this.#letGo(event), above);
    canvas.addEventListener('keydown', (event) => this.#key(event), { signal });
    window.addEventListener('keydown', (event) => this.#escape(event), { signal, capture: true });
  }

  #down(event: PointerEvent): void {
    this.#aim = null;
    if (this.#grip !== null) return event.stopPropagation();
    // A second finger turns or enlarges, also if the first one has stood still.
    if (!event.isPrimary) this.#pressed = null;
    if (event.button !== 0 || !event.isPrimary) return;
    this.#pressed = this.#isCutting ? this.#place(event) : null;
    this.#grip = this.#gripOfMark(event) ?? this.#gripOfSeed(event);
    if (this.#grip === null) return;
    this.#pressed = null;
    event.stopPropagation();
    const canvas = this.#renderer.domElement;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    canvas.style.cursor = 'grabbing';
  }

  #gripOfSeed(event: PointerEvent): Grip | null {
    const marker = this.#markerAt(event);
    const before = this.#seed;
    if (marker === null || before === null) return null;
    return {
      pointer: event.pointerId,
      moved: (ray) => {
        if (marker === SEED) this.#events.seedMoved(ray);
        else if (this.#seed !== null) this.#turnTo(ray, this.#seed);
      },
      back: () => this.#events.seedBack(before),
    };
  }

  /** A mark that is only pressed is chosen, and stays where it is. */
  #gripOfMark(event: PointerEvent): Grip | null {
    const start = this.#place(event);
    const mark = this.#markAt(event);
    const still = STILL[pointerKind(event)];
    if (mark === null) return null;
    this.#events.markChosen(mark);
    let hasMoved = false;
    return {
      pointer: event.pointerId,
      moved: (ray, { x, y }) => {
        if (!hasMoved && Math.hypot(x - start.x, y - start.y) <= still) return;
        if (!hasMoved) this.#events.markTaken();
        hasMoved = true;
        this.#events.markMoved(mark, ray);
      },
      back: () => {
        if (hasMoved) this.#events.markBack();
      },
    };
  }

  #move(event: PointerEvent): void {
    if (this.#grip === null) {
      if (event.buttons === 0) this.#hover(event);
      return;
    }
    event.stopPropagation();
    if (event.pointerId !== this.#grip.pointer) return;
    const place = this.#place(event);
    this.#grip.moved(this.#rayThrough(place), place);
  }

  /** Along the line from the seed to where the ray meets the plane that touches the surface there. */
  #turnTo({ origin, direction }: Ray, { position, normal }: Seed): void {
    const towards = combined(1, origin, -1, position);
    const slope = dot(direction, normal);
    if (Math.abs(slope) < 1e-3 * Math.hypot(...direction)) return;
    const arm = combined(1, towards, -dot(towards, normal) / slope, direction);
    if (Math.hypot(...arm) > 0) this.#events.turned(arm);
  }

  #letGo(event: PointerEvent): void {
    this.#click(event);
    if (event.pointerId !== this.#grip?.pointer) return;
    event.stopPropagation();
    this.#grip = null;
    this.#renderer.domElement.style.cursor = '';
  }

  /** Sets a point of a cut, unless the camera has been moved. */
  #click(event: PointerEvent): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    if (pressed === null || event.type !== 'pointerup' || !event.isPrimary) return;
    const place = this.#place(event);
    if (Math.hypot(place.x - pressed.x, place.y - pressed.y) > STILL[pointerKind(event)]) return;
    this.#renderer.domElement.focus();
    this.#events.pointed(this.#rayThrough(place));
  }

  #hover(event: PointerEvent): void {
    const idle = this.#isCutting ? 'crosshair' : '';
    const isFree = this.#markerAt(event) === null && this.#markAt(event) === null;
    this.#renderer.domElement.style.cursor = isFree ? idle : 'grab';
  }

  /** Keys of a cut; whether this was one. */
  #cutKey(event: KeyboardEvent): boolean {
    if (!this.#isCutting) return false;
    const last = this.#seed?.position ?? this.#curvePoints.at(-1);
    const arrow = this.#seed === null ? ARROW_KEYS[event.key] : undefined;
    if (event.key === ' ') this.#events.pointed(last ?? this.#rayThrough(this.#middle()));
    else if (arrow && last) this.#events.cutMoved(this.#beside(null, last, arrow, event));
    else if (event.key === 'Enter') this.#events.cutEnded();
    else if (event.key === 'Backspace') this.#events.cutUndone();
    else return false;
    event.preventDefault();
    return true;
  }

  /** Not from a list, whose arrow keys may be going on. */
  #takeKeys(): void {
    const button = document.activeElement;
    if (!button?.matches('button:focus-visible')) return;
    this.#keysFrom = button as HTMLButtonElement;
    this.focus();
  }

  /** Unless they are elsewhere by now. */
  #giveKeysBack(): void {
    if (document.activeElement === this.#renderer.domElement) this.#keysFrom?.focus();
    this.#keysFrom = null;
  }

  #key(event: KeyboardEvent): void {
    if (this.#markKey(event) || this.#cutKey(event)) return;
    const arrow = ARROW_KEYS[event.key];
    if (!arrow || this.#seed === null) return;
    event.preventDefault();
    this.#events.seedMoved(this.#beside(null, this.#seed.position, arrow, event));
  }

  /** Keys of the mark that is chosen; whether this was one. */
  #markKey(event: KeyboardEvent): boolean {
    const { dots, discs, selected } = this.#dots.marks;
    const mark = selected === null ? undefined : [...dots, ...discs][selected];
    if (selected === null || !mark) return false;
    const arrow = ARROW_KEYS[event.key];
    if (event.key === 'Delete' || event.key === 'Backspace') this.#events.markRemoved();
    else if (arrow) {
      if (!this.#goesOn(selected, event)) this.#events.markTaken();
      this.#events.markMoved(selected, this.#beside(selected, mark.place.position, arrow, event));
    } else return false;
    event.preventDefault();
    return true;
  }

  /** A step of an arrow key away: from where the key before led, if it was pressed just now, for the mark may not be there yet. */
  #beside(mark: number | null, position: Point, arrow: readonly [number, number], event: KeyboardEvent): Ray {
    const step = event.shiftKey ? STEP.big : STEP.small;
    const { x, y } = this.#goesOn(mark, event)?.at ?? toScreen(this.#projection(), this.#scenePoint(position));
    const at = { x: x + step * arrow[0], y: y + step * arrow[1] };
    this.#aim = { mark, at, time: event.timeStamp };
    return this.#rayThrough(at);
  }

  /** Where the key before led, if this one leads the same mark on; null: it begins a way of its own. */
  #goesOn(mark: number | null, { timeStamp }: KeyboardEvent): { at: Place } | null {
    const before = this.#aim;
    return before !== null && before.mark === mark && timeStamp - before.time < STEP.together ? before : null;
  }

  #middle(): Place {
    return { x: this.#size.x / 2, y: this.#size.y / 2 };
  }

  /** Wherever the focus is; browsers do not always ask before they close a dialog. */
  #escape(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || (this.#grip === null && !this.#isCutting)) return;
    event.preventDefault();
    event.stopPropagation();
    if (this.#grip === null) return this.#events.cutAbandoned();
    const { back } = this.#grip;
    this.#grip = null;
    back();
  }

  #markAt(event: PointerEvent): number | null {
    return this.#dots.at(this.#place(event), SLACK[pointerKind(event)]);
  }

  #markerAt(event: PointerEvent): number | null {
    const { x, y } = this.#place(event);
    const slack = SLACK[pointerKind(event)];
    const marker = this.#markers.at(this.#projection(), x, y, slack);
    return marker === SEED || marker === KNOB ? marker : null;
  }

  #place(event: PointerEvent): Place {
    const { left, top } = this.#renderer.domElement.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  #rayThrough({ x, y }: Place): Ray {
    const { camera } = this.#rig;
    const space = this.#space!;
    camera.updateMatrixWorld();
    const through = new Vector3((2 * x) / this.#size.x - 1, 1 - (2 * y) / this.#size.y, 0.5).unproject(camera);
    const origin = space.toNet(camera.position);
    return { origin, direction: combined(1, space.toNet(through), -1, origin) };
  }

  // ------------------------------------------------------------------------------------------------------------ drawing

  #forgetNet(): void {
    this.#netData?.dispose();
    this.#netData = null;
    this.#seed = null;
  }

  /** Light moves with the camera. */
  #addLights(): void {
    const lamp = new DirectionalLight(0xffffff, 2.2);
    lamp.position.set(-1, 2, 2);
    this.#rig.camera.add(lamp);
    this.#scene.add(new HemisphereLight(0xffffff, 0xb0b8c8, 1.5), this.#rig.camera);
  }

  #readTheme(): void {
    const theme = readTheme(this.#container);
    for (const part of [this.#shade, this.#lines, this.#faces, this.#markers]) part.setTheme(theme);
    this.#cuts.setColour(theme.anchor);
    this.#curves.setColour(theme.accent);
    this.#colours.setScale(scaleOf({ field: 'shear', colourMap: 'paper' }, theme), 'vertex');
    this.setShear(this.#showsShear);
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#size.set(clientWidth, clientHeight);
    this.#renderer.setPixelRatio(pixelRatio(this.#graphics));
    this.#renderer.setSize(clientWidth, clientHeight);
    this.#rig.resize(clientWidth, clientHeight);
    if (this.#rig.framed) this.#frameAll();
    this.#draw();
  }

  #frameAll(): void {
    if (!this.#space) return;
    const { places } = this.#shade;
    const count = places.length / 3;
    const points = new Float32Array(4 * count);
    for (let i = 0; i < count; i++) {
      points[4 * i] = places[3 * i]!;
      points[4 * i + 1] = places[3 * i + 1]!;
      points[4 * i + 2] = places[3 * i + 2]!;
    }
    this.#rig.standAt(fitCamera(points, count, this.#rig.camera, MARGIN, this.#direction));
  }

  #requestDraw(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#rig.update();
    const { camera, distance } = this.#rig;
    this.#placeSeed();
    this.#placeMarks();
    if (this.#netData) this.#lines.beforeDraw(camera, this.#size, this.#renderer.getPixelRatio(), distance);
    this.#markers.beforeDraw(camera, this.#size.y, this.#netData?.edgeLength ?? 0, distance);
    this.#lines.object.visible = this.#netData !== null;
    this.#faces.object.visible = this.#netData !== null && this.#showsShear;
    this.#renderer.render(this.#scene, camera);
  }

  /** The knob keeps its distance from the seed on the screen. */
  #placeSeed(): void {
    this.#markers.object.visible = this.#seed !== null;
    if (this.#seed === null || !this.#space) return this.#ring.hide();
    const { position, normal, direction } = this.#seed;
    const seed = this.#scenePoint(position);
    const { camera } = this.#rig;
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360) * camera.position.distanceTo(seed)) / this.#size.y;
    const radius = (RING * pixel) / this.#space.scale;
    const knob = combined(1, position, radius, direction);
    const marker = (vertex: number, target: Point) => ({ vertex, target, anchor: false });
    const ends = [...this.#cutPoints, ...this.#curvePoints].map((point, i) => ({
      ...marker(KNOB + 1 + i, point),
      anchor: true,
    }));
    this.#markers.update([marker(SEED, position), { ...marker(KNOB, knob), weight: 1 }, ...ends], this.#space, [], []);
    const across = cross(normal, direction);
    const projection = this.#projection();
    this.#ring.draw((angle) => {
      const arm = combined(Math.cos(angle), direction, Math.sin(angle), across);
      return toScreen(projection, this.#scenePoint(combined(1, position, radius, arm)));
    });
  }

  #placeMarks(): void {
    if (!this.#space) return;
    const projection = this.#projection();
    const at = (point: Point) => toScreen(projection, this.#scenePoint(point));
    this.#dots.draw(at, this.#space.toNet(this.#rig.camera.position));
  }

  #scenePoint(place: Readonly<Point>): Vector3 {
    const point = new Vector3();
    this.#space!.toScene(point, place);
    return point;
  }

  #projection(): Projection {
    return projectionOf(this.#rig.camera, this.#size.x, this.#size.y);
  }
}

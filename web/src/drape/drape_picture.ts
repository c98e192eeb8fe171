/** The picture of a surface and the net being laid on it; gestures in it are a matter of picture_gestures.ts. */
import { Vector3 } from 'three';
import type { Point, SurfacePlace } from '../../../wasm/chebnet';
import type { UpAxis } from '../document/document';
import { fieldOf, scaleOf } from '../fields/fields';
import { words } from '../language/language';
import { directionFor, fitCamera, type Stand } from '../view/camera_fit';
import type { CameraRig } from '../view/camera_rig';
import { HandleMarkers, toScreen } from '../view/handles';
import { ColourTexture, NetData, netUniforms } from '../view/net_data';
import { NetFaces } from '../view/net_faces';
import { NetLines } from '../view/net_lines';
import { createNotice, probeGraphics } from '../view/notice';
import type { Place } from '../view/overlay';
import { Space } from '../view/space';
import { Stage } from '../view/stage';
import { CutLines } from './cut_lines';
import type { Cut, Ray, Seed, ShownNet, ShownSurface } from './drape_protocol';
import { type PictureEvents, PictureGestures } from './picture_gestures';
import { combined, cross, dot } from './seed';
import { SeedRing } from './seed_ring';
import { directionsTowards, isClear, isHidden } from './seen_from';
import { SingularDots, type SingularMarks } from './singular_dots';
import { SurfaceShade, turn } from '../view/surface_shade';

/** What is wanted of either view: with WebGL, or without any. */
export interface Picture {
  setSurface(surface: ShownSurface, upAxis: UpAxis): void;
  /** @param seed from which it has been laid; null: it has none. */
  setNet(shown: ShownNet, seed: Seed | null): void;
  removeNet(): void;
  /** Looks at a place from the front, or else from where no other part of the surface hides it, unless the eye sees it within
   *  this angle of its normal already, degrees. */
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
/** Of an edge, how far the surface is drawn behind. */
const BEHIND = 0.5;
const DEGREE = Math.PI / 180;
const MARGIN = { top: 0.06, right: 0.06, bottom: 0.06, left: 0.06 };

class DrapePicture implements Picture {
  readonly #stage: Stage;
  readonly #gestures: PictureGestures;
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
  #space: Space | null = null;
  #netData: NetData | null = null;
  #seed: Seed | null = null;
  #showsShear = true;
  /** From where the whole surface is seen. */
  readonly #direction = directionFor().clone();
  #cutPoints: readonly Point[] = [];
  #curvePoints: readonly Point[] = [];

  constructor(container: HTMLElement, label: string, events: PictureEvents, graphics: 'card' | 'software') {
    this.#stage = new Stage(container, label, graphics, {
      draw: () => this.#draw(),
      frameAgain: () => this.#frameAll(),
      themed: () => this.#applyTheme(),
      cameraMoved: () => this.#requestDraw(),
    });
    const { canvas, scene } = this.#stage;
    canvas.after(this.#ring.element, this.#dots.element);
    for (const part of [this.#shade, this.#faces, this.#lines, this.#cuts, this.#curves, this.#markers])
      scene.add(part.object);
    this.#gestures = new PictureGestures({
      canvas,
      events,
      seed: () => this.#seed,
      curveEnd: () => this.#curvePoints.at(-1),
      marks: () => this.#dots.marks,
      markAt: (place, slack) => this.#dots.at(place, slack),
      markerAt: (place, slack) => this.#markerAt(place, slack),
      placeOf: (position) => toScreen(this.#stage.projection(), this.#scenePoint(position)),
      rayThrough: (place) => this.#rayThrough(place),
      middle: () => this.#stage.size.clone().divideScalar(2),
    });
    this.#stage.begin();
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
    const place = this.#scenePoint(position);
    const isWithin = dot(towards, normal) > Math.cos(within * DEGREE) * Math.hypot(...towards);
    const { places, triangles } = this.#shade;
    if (isWithin && !isHidden(place, this.#rig.camera.position, places, triangles)) return;
    const upright = new Vector3();
    turn(upright, normal, this.#space!);
    const front = upright.clone().addScaledVector(directionFor(), 0.7).normalize();
    // Where a place is seen from nowhere, one looks at it from the front all the same.
    const stands = directionsTowards(upright, front).map((direction) => ({
      direction,
      eye: this.#stand(direction).position,
    }));
    const seen =
      stands.find(({ eye }) => isClear(place, eye, places, triangles)) ??
      stands.find(({ eye }) => !isHidden(place, eye, places, triangles));
    this.#direction.copy(seen?.direction ?? front);
    this.#rig.framed = true;
    this.#frameAll();
  }

  focus(): void {
    this.#stage.canvas.focus();
  }

  setShear(shown: boolean): void {
    this.#showsShear = shown;
    this.#faces.object.visible = shown;
    this.#lines.setOverColours(true);
    this.#requestDraw();
  }

  setCutting(cutting: boolean): void {
    this.#gestures.setCutting(cutting);
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
    if (marks.selected !== this.#dots.marks.selected) this.#gestures.endWay();
    this.#dots.set(marks);
    this.#requestDraw();
  }

  dispose(): void {
    this.#gestures.dispose();
    this.#forgetNet();
    const net = [this.#lines, this.#faces, this.#colours];
    const parts = [this.#shade, ...net, this.#cuts, this.#curves, this.#markers];
    for (const part of parts) part.dispose();
    this.#stage.dispose();
    this.#ring.element.remove();
    this.#dots.element.remove();
  }

  get #rig(): CameraRig {
    return this.#stage.rig;
  }

  // ------------------------------------------------------------------------------------------------------------ drawing

  #forgetNet(): void {
    this.#netData?.dispose();
    this.#netData = null;
    this.#seed = null;
  }

  #applyTheme(): void {
    const { theme } = this.#stage;
    for (const part of [this.#shade, this.#lines, this.#faces, this.#markers]) part.setTheme(theme);
    this.#cuts.setColour(theme.anchor);
    this.#curves.setColour(theme.accent);
    this.#colours.setScale(scaleOf({ field: 'shear', colourMap: 'paper' }, theme), 'vertex');
    this.setShear(this.#showsShear);
  }

  #frameAll(): void {
    if (this.#space) this.#rig.standAt(this.#stand(this.#direction));
  }

  /** To see the whole surface. */
  #stand(direction: Vector3): Stand {
    const { places } = this.#shade;
    const count = places.length / 3;
    const points = new Float32Array(4 * count);
    for (let i = 0; i < count; i++) {
      points[4 * i] = places[3 * i]!;
      points[4 * i + 1] = places[3 * i + 1]!;
      points[4 * i + 2] = places[3 * i + 2]!;
    }
    return fitCamera(points, count, this.#rig.camera, MARGIN, direction);
  }

  #requestDraw(): void {
    this.#stage.requestDraw();
  }

  #draw(): void {
    const { renderer, scene, size } = this.#stage;
    const { camera, distance } = this.#rig;
    this.#placeSeed();
    this.#placeMarks();
    if (this.#netData) this.#lines.beforeDraw(camera, size, renderer.getPixelRatio(), distance);
    this.#markers.beforeDraw(camera, size.y, this.#netData?.edgeLength ?? 0, distance);
    this.#lines.object.visible = this.#netData !== null;
    this.#faces.object.visible = this.#netData !== null && this.#showsShear;
    renderer.render(scene, camera);
  }

  /** The knob keeps its distance from the seed on the screen. */
  #placeSeed(): void {
    this.#markers.object.visible = this.#seed !== null;
    if (this.#seed === null || !this.#space) return this.#ring.hide();
    const { position, normal, direction } = this.#seed;
    const seed = this.#scenePoint(position);
    const { camera } = this.#rig;
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360) * camera.position.distanceTo(seed)) / this.#stage.size.y;
    const radius = (RING * pixel) / this.#space.scale;
    const knob = combined(1, position, radius, direction);
    const marker = (vertex: number, target: Point) => ({ vertex, target, anchor: false });
    const ends = [...this.#cutPoints, ...this.#curvePoints].map((point, i) => ({
      ...marker(KNOB + 1 + i, point),
      anchor: true,
    }));
    this.#markers.update([marker(SEED, position), { ...marker(KNOB, knob), weight: 1 }, ...ends], this.#space, [], []);
    const across = cross(normal, direction);
    const projection = this.#stage.projection();
    this.#ring.draw((angle) => {
      const arm = combined(Math.cos(angle), direction, Math.sin(angle), across);
      return toScreen(projection, this.#scenePoint(combined(1, position, radius, arm)));
    });
  }

  #placeMarks(): void {
    if (!this.#space) return;
    const projection = this.#stage.projection();
    const at = (point: Point) => toScreen(projection, this.#scenePoint(point));
    this.#dots.draw(at, this.#space.toNet(this.#rig.camera.position));
  }

  #scenePoint(place: Readonly<Point>): Vector3 {
    const point = new Vector3();
    this.#space!.toScene(point, place);
    return point;
  }

  #markerAt({ x, y }: Place, slack: number): 'seed' | 'knob' | null {
    const marker = this.#markers.at(this.#stage.projection(), x, y, slack);
    return marker === SEED ? 'seed' : marker === KNOB ? 'knob' : null;
  }

  #rayThrough({ x, y }: Place): Ray {
    const { camera } = this.#rig;
    const { size } = this.#stage;
    const space = this.#space!;
    camera.updateMatrixWorld();
    const through = new Vector3((2 * x) / size.x - 1, 1 - (2 * y) / size.y, 0.5).unproject(camera);
    const origin = space.toNet(camera.position);
    return { origin, direction: combined(1, space.toNet(through), -1, origin) };
  }
}

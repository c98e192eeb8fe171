/** What a picture in 3D stands on, that of the net as that of a surface: its canvas and renderer, a camera and its light. It is as
 *  large as its container and in the theme of the page, and is drawn when that has been asked for. */
import { DirectionalLight, HemisphereLight, Scene, Vector2, WebGLRenderer } from 'three';
import { words } from '../language/language';
import { CameraRig } from './camera_rig';
import { createNotice } from './notice';
import { type Projection, projectionOf } from './picking';
import { endRenderer, forgetUploads, onPixelRatioChange, pixelRatio } from './renderer';
import { onThemeChange, readTheme, type Theme } from './theme';

interface StageEvents {
  /** Does what has waited for the next picture, before the camera goes on. */
  beforePicture?(): void;
  /** Puts what is seen in its place, and renders it. */
  draw(): void;
  /** The whole was to be seen, and the picture is of another size. */
  frameAgain(): void;
  themed(): void;
  /** The graphics card has lost everything, and may be told it anew. */
  restored?(): void;
  cameraMoved(): void;
  cameraRested?(): void;
}

export class Stage {
  readonly scene = new Scene();
  readonly renderer: WebGLRenderer;
  readonly rig: CameraRig;
  /** Of the picture, in CSS pixels. */
  readonly size = new Vector2(1, 1);
  readonly #notice: ReturnType<typeof createNotice>;
  readonly #listeners = new AbortController();
  readonly #resizing = new ResizeObserver(() => this.#resize());
  readonly #container: HTMLElement;
  readonly #graphics: 'card' | 'software';
  readonly #events: StageEvents;
  #theme: Theme;
  #stopThemes = (): void => {};
  #stopRatios = (): void => {};
  #frame = 0;
  /** Ends the wait of holdPicture(); undefined: nothing waits. */
  #holding: ReturnType<typeof setTimeout> | undefined;

  /** @param label what the canvas is called. */
  constructor(container: HTMLElement, label: string, graphics: 'card' | 'software', events: StageEvents) {
    this.#container = container;
    this.#graphics = graphics;
    this.#events = events;
    this.#theme = readTheme(container);
    this.renderer = new WebGLRenderer({ antialias: graphics === 'card', alpha: true });
    // What a driver says of shaders takes a while to come, and they are the same everywhere.
    this.renderer.debug.checkShaderErrors = false;
    const { canvas } = this;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute('aria-label', label);
    container.append(canvas);
    this.#notice = createNotice(container);
    this.rig = new CameraRig(canvas, { moved: () => events.cameraMoved(), rested: () => events.cameraRested?.() });
    this.#addLights();
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get theme(): Theme {
    return this.#theme;
  }

  /** Once everything is there that is drawn. @param reload loads the page again without a loss; without it that is not offered. */
  begin(reload?: () => void): void {
    const { signal } = this.#listeners;
    this.#events.themed();
    this.#stopThemes = onThemeChange(() => {
      this.#theme = readTheme(this.#container);
      this.#events.themed();
    });
    this.canvas.addEventListener('webglcontextlost', () => this.#lost(reload), { signal });
    this.canvas.addEventListener('webglcontextrestored', () => this.#restored(), { signal });
    this.#resizing.observe(this.#container);
    this.#stopRatios = onPixelRatioChange(() => this.#resize());
    this.#resize();
  }

  projection(): Projection {
    return projectionOf(this.rig.eye, this.size.x, this.size.y);
  }

  requestDraw(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#drawNext());
  }

  /** Pictures that are asked for wait for releasePicture(), at most so many milliseconds. */
  holdPicture(milliseconds: number): void {
    this.#holding ??= setTimeout(() => this.releasePicture(), milliseconds);
  }

  releasePicture(): void {
    if (this.#holding === undefined) return;
    clearTimeout(this.#holding);
    this.#holding = undefined;
    this.requestDraw();
  }

  /** At once. */
  draw(): void {
    this.#beforePicture();
    this.#drawPicture();
  }

  #drawNext(): void {
    this.#beforePicture();
    if (this.#holding === undefined) this.#drawPicture();
  }

  #drawPicture(): void {
    this.rig.update();
    this.#events.draw();
  }

  #beforePicture(): void {
    try {
      this.#events.beforePicture?.();
    } finally {
      // If that asks for a picture, it is this one; where it fails, the next is asked for anew.
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    }
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#holding);
    this.#listeners.abort();
    this.#resizing.disconnect();
    this.#stopThemes();
    this.#stopRatios();
    this.rig.dispose();
    endRenderer(this.renderer);
    this.canvas.remove();
    this.#notice.remove();
  }

  /** Light moves with the camera, so what is seen looks the same from every side. */
  #addLights(): void {
    const lamp = new DirectionalLight(0xffffff, 2.2);
    lamp.position.set(-1, 2, 2);
    this.rig.camera.add(lamp);
    this.scene.add(new HemisphereLight(0xffffff, 0xb0b8c8, 1.5), this.rig.camera);
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.size.set(clientWidth, clientHeight);
    this.renderer.setPixelRatio(pixelRatio(this.#graphics));
    this.renderer.setSize(clientWidth, clientHeight);
    this.rig.resize(clientWidth, clientHeight);
    if (this.rig.framed) this.#events.frameAgain();
    // At once: setting the size has cleared the canvas.
    this.draw();
  }

  /** Browsers restore a lost context, but not always. */
  #lost(reload: (() => void) | undefined): void {
    forgetUploads(this.scene);
    this.#notice.show(words.view.pictureLost, reload && { label: words.offline.reload, run: reload });
  }

  #restored(): void {
    this.#notice.hide();
    this.#events.restored?.();
    this.requestDraw();
  }
}

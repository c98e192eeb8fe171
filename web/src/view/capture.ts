/** Pictures and videos of what a renderer draws. */
import { Color, type Scene, SRGBColorSpace, type Vector2, type WebGLRenderer } from 'three';
import { panelWords } from '../language/panels';
import type { Theme } from './theme';
import type { Film } from './view';
import { Failure } from '../failure';

/** Pictures a second in a film. */
const FILM_RATE = 30;

/** As PNG without a background, also while a video has one, with so many times the pixels of the screen, or as many as the
 *  graphics card can. */
export function takePicture(
  renderer: WebGLRenderer,
  scene: Scene,
  size: Vector2,
  magnification: number,
  draw: () => void,
): Promise<Blob> {
  const { background } = scene;
  const ratio = renderer.getPixelRatio();
  const largest = renderer.capabilities.maxTextureSize / Math.max(size.x, size.y);
  renderer.setPixelRatio(Math.min(magnification * ratio, largest));
  scene.background = null;
  // The canvas can be read only in the task that has drawn it; and the screen shows only what the task leaves on it.
  draw();
  const picture = new Promise<Blob>((resolve, reject) => {
    const take = (blob: Blob | null): void =>
      blob ? resolve(blob) : reject(new Failure('no_picture', panelWords.picture.failed));
    renderer.domElement.toBlob(take, 'image/png');
  });
  renderer.setPixelRatio(ratio);
  scene.background = background;
  draw();
  return picture;
}

/** A video on a plain background. */
export function takeFilm(renderer: WebGLRenderer, scene: Scene, theme: Theme, requestDraw: () => void): Film {
  const stream = renderer.domElement.captureStream(FILM_RATE);
  scene.background = new Color().setRGB(...theme.fade, SRGBColorSpace);
  requestDraw();
  const end = (): void => {
    for (const track of stream.getTracks()) track.stop();
    scene.background = null;
    requestDraw();
  };
  return { stream, end };
}

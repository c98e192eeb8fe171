/** Pictures, with a renderer that only notes what it is told. */
import { Color, Scene, Vector2, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { takePicture } from '../../web/src/view/capture';

test('a picture that is taken while a video is recorded has no background, which the video keeps', async () => {
  const scene = new Scene();
  const background = (scene.background = new Color(1, 0, 0));
  const drawn: unknown[] = [];
  const renderer = {
    getPixelRatio: () => 1,
    setPixelRatio: () => {},
    capabilities: { maxTextureSize: 4096 },
    domElement: { toBlob: (take: (blob: Blob) => void) => take(new Blob()) },
  };
  const draw = () => void drawn.push(scene.background);
  await takePicture(renderer as unknown as WebGLRenderer, scene, new Vector2(100, 100), 2, draw);
  expect(drawn).toEqual([null, background]);
});

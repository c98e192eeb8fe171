/** Pictures of shapes that the core for a first net leaves out. */
import type { ThumbnailNet } from './thumbnail_net';

const FIRST_INPUTS = ['pointermove', 'pointerdown', 'keydown', 'wheel'];

/** From the time when this module is loaded; of clicks and keys before that the browser knows. */
const inputSeen = new Promise<unknown>((resolve) => {
  if (navigator.userActivation?.hasBeenActive) resolve(null);
  for (const input of FIRST_INPUTS) addEventListener(input, resolve, { passive: true, once: true });
});

/** What the next picture waits for: the first input of the visitor, as the first net has priority over downloads for
 *  thumbnails, and then the picture before it. */
let turn: Promise<unknown> = inputSeen;

export function lateThumbnail(recipe: string): Promise<ThumbnailNet> {
  const picture = turn.then(() => makeThumbnail(recipe));
  turn = picture.catch(() => undefined);
  return picture;
}

async function makeThumbnail(recipe: string): Promise<ThumbnailNet> {
  const worker = new Worker(new URL('./thumbnail_worker.ts', import.meta.url), { type: 'module' });
  try {
    return await new Promise((resolve, reject) => {
      const fail = () => reject(new Error(`There is no picture of ${recipe}.`));
      worker.onmessage = ({ data }: MessageEvent<ThumbnailNet | null>) => (data ? resolve(data) : fail());
      worker.onerror = fail;
      worker.postMessage(recipe);
    });
  } finally {
    worker.terminate();
  }
}

/** Pictures of shapes that the core for a first net leaves out. */
import type { ThumbnailNet } from './thumbnail_net';

const SIGNS_OF_A_HAND = ['pointermove', 'pointerdown', 'keydown', 'wheel'];

/** From when this module is wanted on. */
const handSeen = new Promise<unknown>((resolve) => {
  for (const sign of SIGNS_OF_A_HAND) addEventListener(sign, resolve, { passive: true, once: true });
});

/** Nothing is fetched for them before the visitor does something: what is seen first comes first. */
export async function lateThumbnail(recipe: string): Promise<ThumbnailNet> {
  await handSeen;
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

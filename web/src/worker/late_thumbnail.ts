/** Pictures of shapes that the core for a first net leaves out. */
import type { ThumbnailNet } from './thumbnail_net';

const SIGNS_OF_A_HAND = ['pointermove', 'pointerdown', 'keydown', 'wheel'];

/** Nothing is fetched for them before the visitor has begun to do something: what is seen first comes first. */
export async function lateThumbnail(recipe: string): Promise<ThumbnailNet> {
  await handSeen();
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

function handSeen(): Promise<void> {
  return new Promise((resolve) => {
    const seen = new AbortController();
    const listen = (sign: string) => addEventListener(sign, () => (seen.abort(), resolve()), { passive: true, signal: seen.signal });
    SIGNS_OF_A_HAND.forEach(listen);
  });
}

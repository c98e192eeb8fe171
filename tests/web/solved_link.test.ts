/** Whether a link does without positions: the trial of that. */
import { expect, test, vi } from 'vitest';
import { freshScene } from '../../web/src/document/defaults';
import { solvedHash } from '../../web/src/projects/solved_link';
import type { WorkerLike } from '../../web/src/worker/client';
import { load } from '../wasm/load';
import { openPage } from './page_without_pictures';

test('a trial that nobody waits for any more ends, and its worker with it', async () => {
  const page = await openPage(await load());
  await page.app.openScene(freshScene({ recipe: 'dome:vertices=100' }));
  await page.solve();
  const worker = { onmessage: null, onerror: null, onmessageerror: null, postMessage: vi.fn(), terminate: vi.fn() };
  const closed = new AbortController();
  const trial = solvedHash(page.app, () => worker satisfies WorkerLike, closed.signal);
  expect(worker.postMessage).toHaveBeenCalled();
  closed.abort();
  expect(worker.terminate).toHaveBeenCalled();
  expect(await trial).toBeNull();
});

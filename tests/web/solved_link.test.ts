/** Whether a link does without positions: the trial of that. */
import { expect, test, vi } from 'vitest';
import { freshScene } from '../../web/src/document/defaults';
import { longestMove } from '../../web/src/document/longest_move';
import { decodeScene } from '../../web/src/document/share';
import { solvedLink } from '../../web/src/projects/solved_link';
import type { WorkerLike } from '../../web/src/worker/client';
import type { Request, Response } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';
import { FakeWorker } from './fake_worker';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

const core = await load();
const waits = (): AbortSignal => new AbortController().signal;

async function openSolved(recipe: string): Promise<Page> {
  const page = await openPage(core);
  await page.app.openScene(freshScene({ recipe }));
  await page.solve();
  return page;
}

/** Of the last handle, which is held back where no net leads. */
async function drag({ app, solve }: Page, [dx, dy, dz]: [number, number, number]): Promise<void> {
  const { vertex, target } = app.opening!.document.handles.at(-1)!;
  const [x, y, z] = target;
  await app.handles.move([{ vertex, target: [x + dx, y + dy, z + dz] }], null, true);
  await solve();
}

/** Every net comes to rest `aside` along x from where it stands. */
class Elsewhere implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror = null;
  onmessageerror = null;
  readonly #page: Page;
  readonly #aside: number;

  constructor(page: Page, aside: number) {
    this.#page = page;
    this.#aside = aside;
  }

  postMessage({ id, type }: Request): void {
    if (type !== 'open') return;
    const { net, frame } = this.#page.app.opening!;
    const positions = frame.positions.map((x, i) => (i % 3 === 0 ? x + this.#aside : x));
    for (const answer of [{ type: 'opened', net }, { type: 'settled' }])
      queueMicrotask(() =>
        this.onmessage?.({ data: { id, frame: { ...frame, positions }, ...answer } } as MessageEvent<Response>),
      );
  }

  terminate(): void {}
}

test('a trial that nobody waits for any more ends, and its worker with it', async () => {
  const page = await openSolved('dome:vertices=100');
  const worker = { onmessage: null, onerror: null, onmessageerror: null, postMessage: vi.fn(), terminate: vi.fn() };
  const closed = new AbortController();
  const trial = solvedLink(page.app, () => worker satisfies WorkerLike, closed.signal);
  expect(worker.postMessage).toHaveBeenCalled();
  closed.abort();
  expect(worker.terminate).toHaveBeenCalled();
  expect(await trial).toBeNull();
});

test('a net that came to rest without being held back is solved again', async () => {
  const page = await openSolved('dome:vertices=100');
  await drag(page, [0.1, 0.2, 0.3]);
  const link = await solvedLink(page.app, () => new FakeWorker(core), waits());
  expect(link).toMatchObject({ isSame: true });
  expect(decodeScene(link!.hash)).toMatchObject({ positions: null });
  expect(decodeScene(link!.hash).replay).toBeUndefined();
});

test('where the hand went too far its drag is made again, also from the net that opened so', async () => {
  const page = await openSolved('wave:vertices=120');
  await drag(page, [0, 0, 9]);
  const { document, net } = page.app.opening!;
  const stands = document.handles.at(-1)!.target;
  const link = await solvedLink(page.app, () => new FakeWorker(core), waits());
  expect(link).toMatchObject({ isSame: true });
  const scene = decodeScene(link!.hash);
  expect(scene).toMatchObject({ positions: null, replay: expect.any(Array) });
  const asked = (scene.handles as { target: number[] | null }[]).at(-1)!.target!;
  expect(asked[2]).toBeGreaterThan(stands[2] + 1);

  const visitor = await openPage(core);
  await visitor.app.openScene(scene);
  await visitor.solve();
  const opened = visitor.app.opening!.document;
  expect(opened).not.toHaveProperty('replay', scene.replay);
  expect(longestMove(opened.positions!, document.positions!)).toBeLessThan(5e-3 * net.info.meanLength);
  expect(await solvedLink(visitor.app, () => new FakeWorker(core), waits())).toEqual({
    ...link,
    aside: expect.any(Number),
  });
});

test('undone and done again, the drag is known', async () => {
  const page = await openSolved('wave:vertices=120');
  await drag(page, [0, 0, 9]);
  page.app.undo();
  await page.solve();
  page.app.redo();
  await page.solve();
  const link = await solvedLink(page.app, () => new FakeWorker(core), waits());
  expect(link).toMatchObject({ isSame: true });
  expect(decodeScene(link!.hash).replay).toBeDefined();
});

test('of ways that all lead elsewhere the nearest is offered, for what it is', async () => {
  const page = await openSolved('dome:vertices=100');
  const length = page.app.opening!.net.info.meanLength;
  const aside = [0.7, 0.2, 0.4, 0.3].map((part) => part * length);
  let trials = 0;
  const nearest = await solvedLink(page.app, () => new Elsewhere(page, aside[trials++]!), waits());
  expect(trials).toBe(aside.length);
  expect(nearest).toMatchObject({ isSame: false, aside: expect.closeTo(0.2, 6) });
  expect(decodeScene(nearest!.hash).replay).toEqual([10, 3]);
});

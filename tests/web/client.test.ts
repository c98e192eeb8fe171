/** The client before a worker that does only what the test says. */
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { freshScene } from '../../web/src/document/defaults';
import { Client } from '../../web/src/worker/client';
import type { Scene } from '../../web/src/document/document';
import type { WorkerLike } from '../../web/src/worker/client';
import type { FrameData, OpenedNet, Request, Response } from '../../web/src/worker/protocol';

class FakeWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  sent: Request[] = [];
  seen = 0;
  terminated = false;

  postMessage(request: Request): void {
    if (request.type === 'seen') ++this.seen;
    else this.sent.push(request);
  }

  terminate(): void {
    this.terminated = true;
  }

  say(response: Response): void {
    this.onmessage?.({ data: response } as MessageEvent<Response>);
  }

  /** Takes the oldest request that waits. */
  take(): Request {
    const request = this.sent.shift();
    if (request === undefined) throw new Error('nothing was asked');
    return request;
  }

  /** Answers the oldest request with `done` and says what it was. */
  async do(): Promise<Request> {
    const request = this.take();
    this.say({ id: request.id, type: 'done' });
    await tick();
    return request;
  }

  async open(x = 0): Promise<Request> {
    const request = this.take();
    this.say({ id: request.id, type: 'opened', net: {} as OpenedNet, frame: frame(x) });
    await tick();
    return request;
  }
}

function frame(x: number): FrameData {
  return { positions: Float64Array.of(x, x, x), handles: [{ vertex: 0, target: [x, x, x] }] } as FrameData;
}

/** Lets what waits on promises go on. */
async function tick(): Promise<void> {
  for (let i = 0; i < 10; ++i) await Promise.resolve();
}

const scene = freshScene({ recipe: 'vault' });
let workers: FakeWorker[];
let news: [number, boolean][];
let restarts: [string, boolean][];
let document: Scene | null;
let givenUp: string[];
/** What the page does at news, beside taking them down. */
let atNews: () => void;
let client: Client;

const worker = (): FakeWorker => workers.at(-1) ?? expect.fail('no worker');

beforeEach(() => {
  vi.useFakeTimers();
  workers = [];
  news = [];
  restarts = [];
  document = null;
  givenUp = [];
  atNews = () => {};
  client = new Client(
    () => workers[workers.push(new FakeWorker()) - 1]!,
    {
      document: () => document,
      frame: ({ positions }, settled) => {
        news.push([positions[0] ?? NaN, settled]);
        atNews();
      },
      restarted: (why, isBack) => restarts.push([why.message, isBack]),
      gaveUp: ({ code }) => givenUp.push(code),
    },
    1000,
  );
});

afterEach(() => void vi.useRealTimers());

async function opened(): Promise<void> {
  const opening = client.open(scene);
  const { id } = await worker().open();
  await opening;
  document = scene;
  worker().say({ id, type: 'settled', frame: frame(0) });
  news = [];
}

describe('dragging', () => {
  beforeEach(opened);

  test('keeps one target under way, and of those that come meanwhile the newest', async () => {
    const taken: number[] = [];
    for (let x = 1; x <= 5; ++x) void client.drag([{ vertex: 7, target: [x, 0, 0] }]).then(() => taken.push(x));
    expect(worker().sent).toMatchObject([{ type: 'drag', inHand: false, targets: [{ vertex: 7, target: [1, 0, 0] }] }]);
    await worker().do();
    expect(taken).toEqual([1]);
    expect(worker().sent).toMatchObject([{ type: 'drag', inHand: false, targets: [{ vertex: 7, target: [5, 0, 0] }] }]);
    await worker().do();
    expect(taken).toEqual([1, 2, 3, 4, 5]);
    expect(worker().sent).toEqual([]);
  });

  test('does not lose the target of one handle to that of another', async () => {
    for (const [vertex, x] of [
      [7, 1],
      [7, 2],
      [8, 3],
      [7, 4],
      [8, 5],
    ] as const)
      void client.drag([{ vertex, target: [x, 0, 0] }]);
    expect([await worker().do(), await worker().do()]).toMatchObject([
      { targets: [{ vertex: 7, target: [1, 0, 0] }] },
      {
        targets: [
          { vertex: 7, target: [4, 0, 0] },
          { vertex: 8, target: [5, 0, 0] },
        ],
      },
    ]);
    expect(worker().sent).toEqual([]);
  });

  test('is not overtaken by what is asked afterwards', async () => {
    void client.drag([{ vertex: 7, target: [1, 0, 0] }]);
    void client.drag([{ vertex: 7, target: [2, 0, 0] }]);
    void client.setHandles([]);
    expect(worker().sent.map(({ type }) => type)).toEqual(['drag', 'drag', 'handles']);
    await worker().do();
    await worker().do();
    await worker().do();
    void client.drag([{ vertex: 7, target: [3, 0, 0] }]);
    expect(worker().sent).toHaveLength(1);
  });

  test('goes on after a target that was refused', async () => {
    const first = client.drag([{ vertex: 7, target: [NaN, 0, 0] }]);
    const second = client.drag([{ vertex: 7, target: [1, 0, 0] }]);
    worker().say({ id: worker().take().id, type: 'error', code: 'non_finite', message: 'not finite' });
    await expect(first).rejects.toMatchObject({ code: 'non_finite', message: 'not finite' });
    await worker().do();
    await second;
  });
});

describe('news', () => {
  beforeEach(opened);

  test('is settled only when the last request is', async () => {
    void client.solve();
    const first = await worker().do();
    void client.step();
    const second = worker().take();
    worker().say({ id: first.id, type: 'settled', frame: frame(1) });
    worker().say({ id: second.id, type: 'done' });
    expect(client.solving).toBe(true);
    worker().say({ id: second.id, type: 'frame', frame: frame(2) });
    worker().say({ id: second.id, type: 'settled', frame: frame(3) });
    expect(news.at(-1)).toEqual([3, true]);
    expect(client.busy).toBe(false);
  });

  test('of a target is none of rest for a newer one, unless that is refused', async () => {
    void client.drag([{ vertex: 7, target: [1, 0, 0] }]);
    const { id } = await worker().do();
    const newer = client.drag([{ vertex: 7, target: [NaN, 0, 0] }]);
    worker().say({ id, type: 'settled', frame: frame(1) });
    expect(news).toEqual([[1, false]]);
    worker().say({ id: worker().take().id, type: 'error', code: 'non_finite', message: 'not finite' });
    await expect(newer).rejects.toMatchObject({ code: 'non_finite' });
    expect(news.at(-1)).toEqual([1, true]);
  });

  test('of the time before a restore does not come', async () => {
    void client.solve();
    const { id } = await worker().do();
    const restoring = client.restore({ ...scene, handles: [], positions: Float64Array.of(9, 9, 9) });
    worker().say({ id, type: 'frame', frame: frame(1) });
    worker().say({ id, type: 'settled', frame: frame(2) });
    expect(news).toEqual([]);
    const restore = await worker().do();
    await restoring;
    worker().say({ id: restore.id, type: 'settled', frame: frame(9) });
    expect(news).toEqual([[9, true]]);
  });

  test('goes on after an opening that failed', async () => {
    void client.solve();
    const { id } = await worker().do();
    const opening = client.open(scene);
    worker().say({ id: worker().take().id, type: 'error', code: 'bad_syntax', message: 'no' });
    await expect(opening).rejects.toMatchObject({ code: 'bad_syntax' });
    worker().say({ id, type: 'settled', frame: frame(4) });
    expect(news).toEqual([[4, true]]);
  });

  test('is not to be expected of a question that leaves the net as it is', async () => {
    void client.flatPattern();
    expect([client.busy, client.changing]).toEqual([true, false]);
    void client.setHandles([]);
    expect(client.changing).toBe(true);
  });

  test('is idle while a question is under way', async () => {
    let idle = false;
    void client.flatPattern();
    void client.idle().then(() => (idle = true));
    await tick();
    expect([client.busy, idle]).toEqual([true, true]);
  });

  test('at which the page fails is seen all the same, and idle is waited for no longer', async () => {
    let idle = false;
    void client.solve();
    const { id } = await worker().do();
    void client.idle().then(() => (idle = true));
    const { seen } = worker();
    atNews = () => {
      throw new Error('in the page');
    };
    expect(() => worker().say({ id, type: 'settled', frame: frame(1) })).toThrow('in the page');
    await tick();
    expect([worker().seen, idle]).toEqual([seen + 1, true]);
  });

  test('is waited for by idle', async () => {
    let idle = false;
    void client.solve();
    void client.idle().then(() => (idle = true));
    const { id } = await worker().do();
    worker().say({ id, type: 'frame', frame: frame(1) });
    await tick();
    expect(idle).toBe(false);
    worker().say({ id, type: 'settled', frame: frame(2) });
    await tick();
    expect(idle).toBe(true);
  });
});

describe('a worker that is lost', () => {
  beforeEach(opened);

  const crash = (how: string) => {
    if (how === 'error') worker().onerror?.({ message: 'broken' } as ErrorEvent);
    if (how === 'trap') worker().say({ id: 1, type: 'error', code: 'crashed', message: 'broken' });
    if (how === 'silence') vi.advanceTimersByTime(1001);
  };

  test.each(['error', 'trap', 'silence'])(
    'by %s is replaced, and the document comes back as it now is',
    async (how) => {
      document = { ...scene, method: 'other', positions: Float64Array.of(5, 5, 5), settled: false };
      const solving = client.solve();
      crash(how);
      await expect(solving).rejects.toMatchObject({ code: 'worker_lost' });
      expect(workers).toHaveLength(2);
      expect(workers[0]?.terminated).toBe(true);
      expect(await worker().open(5)).toMatchObject({ type: 'open', scene: { ...document, settled: true } });
      expect(restarts).toEqual([[expect.any(String), true]]);
    },
  );

  test('in mid-drag takes with it what waits of the drag: there is no net yet to drag where it comes back', async () => {
    const drags = [1, 2].map((x) => client.drag([{ vertex: 7, target: [x, 0, 0] }]));
    crash('error');
    for (const drag of drags) await expect(drag).rejects.toMatchObject({ code: 'worker_lost' });
    expect(worker().sent.map(({ type }) => type)).toEqual(['open']);
    await worker().open();
    expect(worker().sent).toEqual([]);
  });

  test('is not listened to any more', async () => {
    const lost = worker();
    crash('error');
    await worker().open();
    news = [];
    lost.say({ id: 99, type: 'settled', frame: frame(77) });
    lost.onerror?.({ message: 'again' } as ErrorEvent);
    expect(news).toEqual([]);
    expect(workers).toHaveLength(2);
  });

  test('before it has done anything is not replaced again', async () => {
    crash('error');
    crash('error');
    await tick();
    expect(workers).toHaveLength(2);
    expect(restarts).toEqual([['broken', false]]);
    const opening = client.open(scene);
    await worker().open(3);
    await expect(opening).resolves.toMatchObject({ frame: frame(3) });
    expect(workers).toHaveLength(3);
  });

  test('lets nobody wait', async () => {
    void client.solve().catch(() => {});
    const idle = client.idle();
    crash('silence');
    await worker().open();
    worker().say({ id: 4, type: 'settled', frame: frame(0) });
    await idle;
    expect(client.busy).toBe(false);
  });

  test('is none that was suspended together with the page, whose timer comes before what it says', () => {
    void client.solve().catch(() => {});
    // The page was away for longer than that; its clock, for the test, was not.
    vi.advanceTimersToNextTimer();
    expect(workers).toHaveLength(1);
  });

  test('is not missed while nothing is asked of it', () => {
    vi.advanceTimersByTime(60_000);
    expect(workers).toHaveLength(1);
  });
});

describe('an opening that is given up', () => {
  beforeEach(opened);

  const other = { ...scene, net: { recipe: 'dome' } };

  test('leaves the net of before, in another worker, and it is solved on', async () => {
    void client.solve();
    const { id } = await worker().do();
    worker().say({ id, type: 'frame', frame: frame(5) });
    const opening = client.open(other);
    client.cancelOpening();
    await expect(opening).rejects.toMatchObject({ code: 'cancelled' });
    expect(workers.map(({ terminated }) => terminated)).toEqual([true, false]);
    const request = await worker().open(5);
    expect(request).toMatchObject({ type: 'open', scene: { ...scene, settled: false } });
    expect(restarts).toEqual([[expect.any(String), true]]);
    expect(client.solving).toBe(true);
    worker().say({ id: request.id, type: 'settled', frame: frame(6) });
    expect(news.at(-1)).toEqual([6, true]);
  });

  test('before the net of before is back leaves it all the same', async () => {
    for (let i = 0; i < 3; ++i) {
      const opening = client.open(other);
      client.cancelOpening();
      await expect(opening).rejects.toMatchObject({ code: 'cancelled' });
    }
    expect(workers).toHaveLength(4);
    expect(restarts).toEqual([]);
    const request = await worker().open();
    expect(request).toMatchObject({ scene: { net: scene.net, settled: true } });
    expect(restarts).toHaveLength(1);
    expect(worker().sent).toEqual([]);
  });

  test('is none if nothing is being opened', () => {
    void client.solve();
    client.cancelOpening();
    expect(workers).toHaveLength(1);
  });
});

test('a solver that cannot be loaded is an error, and no more workers are started', async () => {
  const hello = client.hello();
  worker().say({ id: 0, type: 'error', code: 'crashed', message: 'no WebAssembly' });
  await expect(hello).rejects.toMatchObject({ code: 'worker_lost', message: 'no WebAssembly' });
  expect(workers).toHaveLength(1);
});

test('a solve that is given up is told once, and the worker stays', async () => {
  await opened();
  const drag = client.drag([{ vertex: 0, target: [1, 1, 1] }]);
  const { id } = await worker().do();
  await drag;
  worker().say({ id, type: 'settled', frame: frame(1) });
  worker().say({ id, type: 'error', code: 'too_large', message: 'too many' });
  expect(givenUp).toEqual(['too_large']);
  expect(client.busy).toBe(false);
  expect(restarts).toEqual([]);
  expect(workers).toHaveLength(1);
});

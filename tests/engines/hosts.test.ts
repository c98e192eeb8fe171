/** Pages of others that embed the editor, in each engine: it answers the one that holds it, and hears no other. */
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Stats } from '../../web/src/scripting';
import type { LaidReport, WholeReport } from '../../web/src/surface_script';
import { largestDeviation } from '../browser/geometry';
import type { Answer, CallName, HostCall, News } from '../../web/src/embed/protocol';
import type { Visitor } from './visitor';
import { visitors } from './visitor';

/** What a page of the other site tells the one that is visited. */
type Told = { by: 'beside' | 'host'; heard: unknown } | { by: 'beside' | 'host'; asked: string };

declare global {
  interface Window {
    /** What the page that is visited was sent. */
    mail: (Answer | News | Told)[];
  }
}

const { address, open } = visitors();

/** Another site: its pages by their names, '' being the one that is visited. */
let pages: Record<string, string> = {};
const elsewhere = createServer(({ url = '/' }, response) => {
  response.writeHead(200, { 'content-type': 'text/html' }).end(pages[url.slice(1)]);
});
beforeAll(() => new Promise<void>((done) => elsewhere.listen(0, '127.0.0.1', done)));
afterAll(() => {
  elsewhere.closeAllConnections();
  elsewhere.close();
});

const editor = (attributes = '') => `<iframe ${attributes} src="${address()}?embed"></iframe>`;
const visited = (html: string) =>
  `<script>window.mail = []; addEventListener('message', ({ data }) => mail.push(data));</script>${html}`;

/** A page that asks an editor what the page that is visited wants asked, and tells it what it hears. */
function puppet(by: 'beside' | 'host', path: string, html = ''): string {
  const obey = `({ data }) => {
    if (data.ask) ${path}.postMessage(data.ask, '*');
    top.postMessage({ by: '${by}', ...(data.ask ? { asked: data.ask.id } : { heard: data }) }, '*');
  }`;
  return `<script>addEventListener('message', ${obey});</script>${html}`;
}

function visitHost(html: string, others: Record<string, string> = {}): Promise<Visitor> {
  pages = { '': visited(html), ...others };
  return open(`http://127.0.0.1:${(elsewhere.address() as AddressInfo).port}/`);
}

const mailOf = (visitor: Visitor) => visitor.run(() => window.mail);
const gets = (visitor: Visitor, message: object) => expect.poll(() => mailOf(visitor)).toContainEqual(message);

function call(id: string, name: CallName, ...args: unknown[]): HostCall {
  return { chebnet: 1, id, call: name, args };
}

/** Posts a message to a frame of the page that is visited. */
function post(visitor: Visitor, path: number[], message: HostCall | { ask: HostCall }): Promise<void> {
  return visitor.run(
    (frames, data) => frames.reduce((frame: Window, i) => frame.frames[i]!, window).postMessage(data, '*'),
    path,
    message,
  );
}

test('a page of another site gets answers, also when its frame has a sandbox with an origin', async () => {
  for (const sandbox of ['', 'sandbox="allow-scripts allow-same-origin"']) {
    const visitor = await visitHost(editor(sandbox));
    await gets(visitor, { chebnet: 1, event: 'ready' });
    await post(visitor, [0], call('first', 'stats'));
    await gets(visitor, expect.objectContaining({ id: 'first', result: expect.not.objectContaining({ vertices: 0 }) }));
    await post(visitor, [0], call('mine', 'settled'));
    await post(visitor, [0], call('handles', 'handles'));
    await gets(visitor, expect.objectContaining({ id: 'mine' }));
    await gets(visitor, expect.objectContaining({ id: 'handles' }));
  }
});

/** Asks the editor in the page that is visited; fails with the code of a refusal. */
function asker(visitor: Visitor) {
  let count = 0;
  return async <T>(name: CallName, ...args: unknown[]): Promise<T> => {
    const id = `asked ${++count}`;
    await post(visitor, [0], call(id, name, ...args));
    await gets(visitor, expect.objectContaining({ id }));
    const answer = await visitor.run((wanted) => {
      const found = window.mail.find((each): each is Answer => 'id' in each && each.id === wanted)!;
      // Not every engine's driver hands on typed arrays.
      return 'result' in found && ArrayBuffer.isView(found.result)
        ? { ...found, result: Array.from(found.result as Float64Array | Int32Array) }
        : found;
    }, id);
    if ('error' in answer) throw new Error(answer.error.code);
    return answer.result as T;
  };
}

/** A saddle over [−1, 1]², as a host has it. */
function saddle(n = 12) {
  const at = (i: number) => (2 * i) / n - 1;
  const numbers = Array.from({ length: n + 1 }, (_, i) => i);
  const corner = (i: number, j: number) => i * (n + 1) + j;
  return {
    name: 'saddle',
    vertices: numbers.flatMap((i) => numbers.map((j) => [at(i), at(j), (at(i) * at(j)) / 3])),
    faces: numbers
      .slice(1)
      .flatMap((i) =>
        numbers.slice(1).map((j) => [corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)]),
      ),
  };
}

test('a host has surfaces described, nets laid on them and over the whole of them, and is told how they lie', async () => {
  const visitor = await visitHost(editor());
  await gets(visitor, { chebnet: 1, event: 'ready' });
  const ask = asker(visitor);
  expect(await ask('describe', saddle())).toMatchObject({ prospect: 'one_piece', genus: 0, boundaryLoops: 1 });

  const settings = { seed: [0, 0, 0], direction: [1, 1, 0], cells: 150 };
  const laid = await ask<LaidReport>('drape', saddle(), { ...settings, border: 'inside' });
  expect(laid).toMatchObject({ locked: 0, pieces: 1, bare: 0 });
  expect(laid.coverage).toBeGreaterThan(0.8);
  expect(laid.maxDeviation).toBeLessThan(1e-9);
  expect(laid.smallestAngle).toBeGreaterThanOrEqual(Math.PI / 6);
  const { meanDistance, rods } = await ask<LaidReport>('report');
  expect(meanDistance).toBeCloseTo(laid.meanDistance, 6);
  expect(rods).toBe(laid.rods);
  const edges = Int32Array.from(await ask<number[]>('edges'));
  const positions = Float64Array.from(await ask<number[]>('positions'));
  expect(largestDeviation(positions, edges, laid.length)).toBeLessThan(1e-9);

  // With a surface cut open, the net beside it as strongly as is wanted, and no surface any more.
  const cuts = [[saddle().vertices[6], saddle().vertices[12 * 13 + 6]]];
  expect(await ask('drape', saddle(), { ...settings, cuts })).toMatchObject({ pieces: 2, bare: 0 });
  await ask('setOptions', { method: 'equilibrium', guide_weight: 5 });
  await ask('settled');
  await ask('setGuide', null);
  await expect(ask('report')).rejects.toThrow('bad_option');

  const whole = await ask<WholeReport>('remesh', { own: 'pebble' }, { cells: 150 });
  expect(whole.singularVertices).toEqual([{ valence: 3, count: 8 }]);
  expect(whole.maxDeviation).toBeLessThan(1e-9);
  expect((await ask<Stats>('stats')).faces).toBeGreaterThan(100);

  await expect(ask('remesh', { own: 'pebble' }, { cells: 3 })).rejects.toThrow('bad_option');
  await expect(ask('drape', saddle(), { border: 'round' })).rejects.toThrow('bad_arguments');
  await expect(ask('describe', { ...saddle(), faces: [[0, 1, 999]] })).rejects.toThrow('index_out_of_range');
});

test('without an origin it cannot start, and says so to visitor and host', async () => {
  const visitor = await visitHost('<iframe width="600" height="400"></iframe>');
  // As PNG.
  const sizeOfPicture = async () => (await visitor.driver.screenshot()).length;
  const empty = await sizeOfPicture();
  // Of files that a site gives to its own pages only.
  visitor.expected = /CORS|[Cc]ross-[Oo]rigin|net::ERR_FAILED|NS_ERROR_DOM_BAD_URI/;
  await visitor.run(
    (html) => void (document.querySelector('iframe')!.outerHTML = html),
    editor('sandbox="allow-scripts" width="600" height="400"'),
  );
  await gets(visitor, {
    chebnet: 1,
    event: 'error',
    error: { code: 'no_origin', message: expect.stringContaining('allow-same-origin') },
  });
  expect(await mailOf(visitor)).toHaveLength(1);
  await expect.poll(sizeOfPicture).toBeGreaterThan(1.5 * empty);
  await visitor.picture('no-origin');
});

test('a frame beside it is not heard', async () => {
  const visitor = await visitHost(`${editor()}<iframe src="beside"></iframe>`, {
    beside: puppet('beside', 'parent.frames[0]'),
  });
  await gets(visitor, { chebnet: 1, event: 'ready' });
  await post(visitor, [0], call('opened', 'open', { recipe: 'vault:vertices=200' }));
  await gets(visitor, expect.objectContaining({ id: 'opened' }));
  await post(visitor, [1], { ask: call('beside', 'setHandles', []) });
  await gets(visitor, { by: 'beside', asked: 'beside' });
  await post(visitor, [0], call('mine', 'handles'));
  await gets(visitor, {
    chebnet: 1,
    id: 'mine',
    result: expect.arrayContaining([expect.objectContaining({ anchor: true })]),
  });
  const all = await mailOf(visitor);
  expect(all.filter((each) => 'id' in each).map(({ id }) => id)).toEqual(['opened', 'mine']);
  expect(all.filter((each) => 'by' in each)).toEqual([{ by: 'beside', asked: 'beside' }]);
});

test('a page that holds its host is not heard', async () => {
  const visitor = await visitHost('<iframe src="host"></iframe>', { host: puppet('host', 'frames[0]', editor()) });
  await gets(visitor, { by: 'host', heard: { chebnet: 1, event: 'ready' } });
  await post(visitor, [0, 0], call('above', 'stats'));
  await post(visitor, [0], { ask: call('mine', 'stats') });
  await gets(visitor, { by: 'host', heard: expect.objectContaining({ id: 'mine' }) });
  const all = await mailOf(visitor);
  expect(all.filter((each) => !('by' in each))).toEqual([]);
  expect(all).not.toContainEqual({ by: 'host', heard: expect.objectContaining({ id: 'above' }) });
});

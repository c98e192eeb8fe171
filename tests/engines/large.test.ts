/** More of everything than anybody would want, in each engine. */
import { expect, test } from 'vitest';
import { distance, fan, fanOfQuads, largestError } from '../browser/geometry';
import { hashWithZeros } from '../web/hash_with_zeros';
import { ENGINE } from './engines';
import { visitors } from './visitor';

const { arrive, share } = visitors();

test('a link with three thousand handles opens', async () => {
  const count = 3000;
  const first = await arrive();
  await first.openNet({ recipe: 'vault:vertices=5000' });
  await first.run((n) => window.chebnet.setHandles(Array.from({ length: n }, (_, vertex) => ({ vertex }))), count);
  await first.settled();
  const second = await arrive(await first.run(() => window.chebnet.link()));
  expect(await second.stats()).toMatchObject({ handles: count, status: 'converged' });
  expect(await second.handles()).toEqual(await first.handles());
  expect(largestError(await second.positions(), await first.positions())).toBeLessThan(1e-3);
});

test('twenty thousand triangles around one vertex open, and are solved', async () => {
  const count = 20_000;
  const visitor = await arrive();
  await visitor.openNet({ obj: fan(count) });
  await visitor.run(
    (rim) => window.chebnet.setHandles([{ vertex: 1 }, { vertex: rim / 2 }, { vertex: 0, target: [0, 0, 0.01] }]),
    count,
  );
  await visitor.settled();
  expect(await visitor.stats()).toMatchObject({ vertices: count + 1, handles: 3 });
  expect((await visitor.positions()).every(Number.isFinite)).toBe(true);
});

// Few and many are solved in different ways, which is the core's business: the largest shows what an engine can take.
test.each(ENGINE === 'chromium' ? [300, 2000, 12_000] : [12_000])(
  '%i quads around one vertex open from a file, and are solved before patience ends',
  async (count) => {
    const visitor = await share();
    await visitor.dropFile('fan.obj', fanOfQuads(count));
    await visitor.read(`of valence ${count}`, 'dialog');
    await visitor.clickOn('Open');
    await expect.poll(() => visitor.stats()).toMatchObject({ vertices: 2 * count + 1 });
    await visitor.settled();
    const targets: [number, number, number][] = [
      [1.2, 0, 0.3],
      [-0.5, 1, 0.5],
      [-0.3, -1, 0],
    ];
    const handles = targets.map((target, i) => ({ vertex: 1 + Math.round((i * count) / 3), target }));
    await visitor.run((all) => window.chebnet.setHandles(all), handles);
    await visitor.settled();
    const positions = await visitor.positions();
    expect(positions.every(Number.isFinite)).toBe(true);
    for (const { vertex, target } of handles)
      expect(distance(positions.subarray(3 * vertex, 3 * vertex + 3), target)).toBeLessThan(1e-9);
  },
);

test('a link with twenty thousand handles on a smaller net is refused, and the net stays', async () => {
  const visitor = await share();
  const before = await visitor.positions();
  const handles = Array.from({ length: 20_000 }, (_, vertex) => [vertex, 0]);
  const view = { camera: null, field: 'deviation', colourMap: 'paper', showFaces: true };
  const net = { recipe: 'vault:vertices=1000' };
  const link = hashWithZeros({ net, handles, method: 'li2022', options: {}, view, settled: false }, 0);
  await visitor.run((hash) => void (location.hash = hash), link);
  await visitor.read('A handle names vertex 999, but vertices go from 0 to 998', '[role=alert]');
  expect(largestError(await visitor.positions(), before)).toBe(0);
  await visitor.drag((await visitor.handles()).at(-1)!, [-60, -40]);
  expect(largestError(await visitor.positions(), before)).toBeGreaterThan(0.01);
});

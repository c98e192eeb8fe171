/** More of everything than anybody would want, in each engine. */
import { expect, test } from 'vitest';
import { fan, largestError } from '../browser/geometry';
import { visitors } from './visitor';

const { arrive } = visitors();

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

/** Where a drag may go, and what moves with it. */
import { describe, expect, test, vi } from 'vitest';
import type { Ball } from '../../wasm/chebnet';
import type { Vec3 } from '../../web/src/document/document';
import { DragGuide, mobilityOf } from '../../web/src/handles/drag_guide';
import { isNearBorder, nearestInAll } from '../../web/src/handles/reach';
import type { Client } from '../../web/src/worker/client';
import { random } from './random';

const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const inAll = (balls: Ball[], point: Vec3): boolean => balls.every(({ centre, radius }) => distance(centre, point) <= radius);

describe('the nearest point in all balls', () => {
  test('is in all of them, and none of many others is nearer', () => {
    const number = random(7);
    const point = (size: number): Vec3 => [0, 1, 2].map(() => size * (2 * number() - 1)) as Vec3;
    for (let count = 1; count <= 5; count++) {
      const balls = Array.from({ length: count }, () => {
        const centre = point(3);
        return { centre, radius: Math.hypot(...centre) + 0.3 + number() };
      });
      const wish = point(10);
      const nearest = nearestInAll(balls, wish);
      expect(inAll(balls.map(({ centre, radius }) => ({ centre, radius: radius * (1 + 1e-7) })), nearest)).toBe(true);
      for (let i = 0; i < 3000; i++) {
        const [x, y, z] = point(0.1);
        const other: Vec3 = i % 2 === 0 ? point(4) : [nearest[0] + x, nearest[1] + y, nearest[2] + z];
        if (inAll(balls, other)) expect(distance(other, wish)).toBeGreaterThan(distance(nearest, wish) - 1e-6);
      }
    }
  });

  test('is the point itself if it lies in all', () => {
    const balls: Ball[] = [{ centre: [0, 0, 0], radius: 2 }];
    expect(nearestInAll(balls, [1, 1, 1])).toEqual([1, 1, 1]);
    expect(isNearBorder(balls, [1, 0, 0])).toBe(false);
    expect(isNearBorder(balls, [1.95, 0, 0])).toBe(true);
    expect(nearestInAll([], [9, 9, 9])).toEqual([9, 9, 9]);
  });

  test('is finite and between the balls where they do not meet', () => {
    const balls: Ball[] = [-3, 3].map((x) => ({ centre: [x, 0, 0], radius: 1 }));
    const [x, y, z] = nearestInAll(balls, [0, 5, 0]);
    expect(Math.abs(x)).toBeLessThan(2.001);
    expect([y, z].every(Number.isFinite)).toBe(true);
  });
});

test('the mobility falls from 1 in the inner half of the region to 0 at its border', () => {
  const mobility = mobilityOf(Float64Array.of(0, 1, 2, 3, 4, Infinity), { radius: 8, edgeLength: 0.5 });
  expect([...mobility]).toEqual([1, 1, 1, 0.5, 0, 0]);
});

describe('a drag', () => {
  const shown = { setRegion: vi.fn(), setReach: vi.fn() };
  const client = {
    setLocality: vi.fn(() => Promise.resolve()),
    reach: vi.fn(() => Promise.resolve([{ centre: [0, 0, 0], radius: 1 }])),
    distances: vi.fn(() => Promise.resolve(Float64Array.of(0, 1, 9))),
  };
  const guide = new DragGuide(client as unknown as Client, shown);

  test('stops at the reach of its handle, which is shown there', async () => {
    await guide.begin([4], null);
    expect(client.setLocality).not.toHaveBeenCalled();
    expect(guide.within([{ vertex: 4, target: [0.2, 0, 0] }])).toEqual([{ vertex: 4, target: [0.2, 0, 0] }]);
    expect(shown.setReach).toHaveBeenLastCalledWith(null);
    expect(guide.within([{ vertex: 4, target: [5, 0, 0] }])).toEqual([{ vertex: 4, target: [1, 0, 0] }]);
    expect(shown.setReach).toHaveBeenLastCalledWith([{ centre: [0, 0, 0], radius: 1 }]);
    guide.keepsWithin = false;
    expect(guide.within([{ vertex: 4, target: [5, 0, 0] }])).toEqual([{ vertex: 4, target: [5, 0, 0] }]);
    guide.keepsWithin = true;
    guide.end();
    expect(shown.setReach).toHaveBeenLastCalledWith(null);
    expect(guide.within([{ vertex: 4, target: [5, 0, 0] }])).toEqual([{ vertex: 4, target: [5, 0, 0] }]);
  });

  test('tells the solver its locality and shades what stays; the next without one frees everything', async () => {
    await guide.begin([4], { radius: 3, edgeLength: 1 });
    expect(client.setLocality).toHaveBeenLastCalledWith(3, [4]);
    expect(shown.setRegion.mock.lastCall?.[0]).toEqual(Float32Array.of(1, 1, 0));
    guide.end();
    expect(shown.setRegion).toHaveBeenLastCalledWith(null);
    await guide.begin([4], null);
    expect(client.setLocality).toHaveBeenLastCalledWith(null, [4]);
    guide.end();
  });

  test('of several handles is not held: they limit each other anew with every move', async () => {
    await guide.begin([4, 5], null);
    expect(guide.within([{ vertex: 4, target: [5, 0, 0] }])).toEqual([{ vertex: 4, target: [5, 0, 0] }]);
    guide.end();
  });
});

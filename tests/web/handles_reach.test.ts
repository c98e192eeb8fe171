/** Where a drag may go, and what moves with it. */
import { describe, expect, test, vi } from 'vitest';
import type { Ball, Handle } from '../../wasm/chebnet';
import type { Vec3 } from '../../web/src/document/document';
import { Along } from '../../web/src/handles/along';
import { DragGuide } from '../../web/src/handles/drag_guide';
import { SurfacePoints } from '../../web/src/handles/surface_points';
import { borderOfNet, borderOfSurface, throughHandles } from '../../web/src/handles/curve';
import {
  type InHand,
  isNearBorder,
  type Limit,
  limitsOf,
  nearestInAll,
  translated,
  translationTo,
} from '../../web/src/handles/reach';
import { Snapping } from '../../web/src/handles/snapping';
import type { Client } from '../../web/src/worker/client';
import type { OpenedNet } from '../../web/src/worker/protocol';
import { random } from './random';

const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const ball = (centre: Vec3, radius: number): Limit => ({ centre, radius, counts: [1, 1, 1] });
/** Handles 1, 2, … in hand. */
const inHand = (...all: [Vec3, Vec3][]): InHand[] =>
  all.map(([base, follows], i) => ({ vertex: i + 1, base, follows }));
const BOTH_SIDES = inHand(
  [
    [1, 0, 0],
    [1, 1, 1],
  ],
  [
    [-1, 0, 0],
    [-1, 1, 1],
  ],
  [
    [0, 0, 1],
    [0, 1, 1],
  ],
);

function isWithin(limits: readonly Limit[], point: Vec3, slack = 0): boolean {
  const off = (counts: Vec3, centre: Vec3) =>
    Math.hypot(...counts.map((each, axis) => each * (point[axis]! - centre[axis]!)));
  return limits.every(({ centre, radius, counts }) => off(counts, centre) <= (1 + slack) * radius);
}

describe('the nearest point within all limits', () => {
  test('is within all of them, and none of many others is nearer', () => {
    const number = random(7);
    const point = (size: number): Vec3 => [0, 1, 2].map(() => size * (2 * number() - 1)) as Vec3;
    const counts: Vec3[] = [
      [1, 1, 1],
      [1, 1, 1],
      [0, 1, 1],
      [1, 0, 0],
      [1, 1, 1],
    ];
    for (let count = 1; count <= 5; count++) {
      const limits = Array.from({ length: count }, (_, i): Limit => {
        const centre = point(3);
        return { centre, radius: Math.hypot(...centre) + 0.3 + number(), counts: counts[i]! };
      });
      const asked = point(10);
      const nearest = nearestInAll(limits, asked);
      expect(isWithin(limits, nearest, 1e-7)).toBe(true);
      for (let i = 0; i < 3000; i++) {
        const [x, y, z] = point(0.1);
        const other: Vec3 = i % 2 === 0 ? point(4) : [nearest[0] + x, nearest[1] + y, nearest[2] + z];
        if (isWithin(limits, other)) expect(distance(other, asked)).toBeGreaterThan(distance(nearest, asked) - 1e-6);
      }
    }
  });

  test('is the point itself if it lies within all', () => {
    const limits = [ball([0, 0, 0], 2)];
    expect(nearestInAll(limits, [1, 1, 1])).toEqual([1, 1, 1]);
    expect(isNearBorder(limits, [1, 0, 0])).toBe(false);
    expect(isNearBorder(limits, [1.95, 0, 0])).toBe(true);
    expect(nearestInAll([], [9, 9, 9])).toEqual([9, 9, 9]);
  });

  test('is finite and between balls that do not meet', () => {
    const [x, y, z] = nearestInAll(
      [-3, 3].map((each) => ball([each, 0, 0], 1)),
      [0, 5, 0],
    );
    expect(Math.abs(x)).toBeLessThan(2.001);
    expect([y, z].every(Number.isFinite)).toBe(true);
  });
});

describe('the limits of a translation', () => {
  test('are of bounded number, and of thousands the nearest are among them', () => {
    const number = random(5);
    const held = Array.from({ length: 5000 }, (_, i): Ball => {
      const angle = 2 * Math.PI * number();
      const slack = i === 4321 ? 0.1 : 3 + number();
      return {
        vertex: 100 + i,
        centre: i === 4321 ? [10, 0, 0] : [10 * Math.cos(angle), 10 * Math.sin(angle), 0],
        radius: 10 + slack,
      };
    });
    const limits = limitsOf(
      inHand([
        [0, 0, 0],
        [1, 1, 1],
      ]),
      [held],
    );
    expect(limits.length).toBeLessThanOrEqual(1000);
    expect(nearestInAll(limits, [-2, 0, 0])).toEqual([expect.closeTo(-0.1, 9), 0, 0]);
  });

  test('hold it exactly where the net is long enough between what is in hand, what is mirrored and what is held', () => {
    const number = random(3);
    const held: Ball[] = [
      { vertex: 8, centre: [0.5, 1, 1], radius: 2.5 },
      { vertex: 9, centre: [-0.5, -2, 0], radius: 3.5 },
    ];
    const mutual = 3;
    const reaches = BOTH_SIDES.map(({ vertex }) => [
      ...held,
      ...BOTH_SIDES.filter((other) => other.vertex !== vertex).map(({ vertex: other, base }) => ({
        vertex: other,
        centre: base,
        radius: mutual,
      })),
    ]);
    const limits = limitsOf(BOTH_SIDES, reaches);
    let within = 0;
    for (let i = 0; i < 4000; i++) {
      const by = [0, 1, 2].map(() => 6 * number() - 3) as Vec3;
      const places = BOTH_SIDES.map((each) => translated(each, by));
      const [a, b, c] = places as [Vec3, Vec3, Vec3];
      const isLongEnough =
        places.every((place) => held.every(({ centre, radius }) => distance(place, centre) <= radius)) &&
        [distance(a, b), distance(b, c), distance(a, c)].every((each) => each <= mutual);
      expect(isWithin(limits, by)).toBe(isLongEnough);
      within += isLongEnough ? 1 : 0;
    }
    expect(within).toBeGreaterThan(20);
  });

  test('are few: handles in hand do not limit each other, nor a ball what lies within it', () => {
    const two = inHand(
      [
        [1, 1, 1],
        [1, 1, 1],
      ],
      [
        [2, 1, 1],
        [1, 1, 1],
      ],
    );
    const [near, far] = [
      { vertex: 8, centre: [5, 5, 5] as Vec3, radius: 9 },
      { vertex: 9, centre: [5, 5, 6] as Vec3, radius: 12 },
    ];
    const each = (other: number): Ball[] => [near, far, { vertex: other, centre: [0, 0, 0], radius: 1 }];
    expect(limitsOf(two, [each(2), each(1)])).toEqual([ball([4, 4, 4], 9), ball([3, 4, 4], 9)]);
  });

  test('are those of a translation, which a turn is not', () => {
    const by: Vec3 = [0.1, 0.2, 0.3];
    const moved = BOTH_SIDES.map((each) => ({ vertex: each.vertex, target: translated(each, by) }));
    expect(distance(translationTo(moved, BOTH_SIDES)!, by)).toBeLessThan(1e-12);
    const turned = moved.map(({ vertex, target: [x, y, z] }): { vertex: number; target: Vec3 } => ({
      vertex,
      target: [y, -x, z],
    }));
    expect(translationTo(turned, BOTH_SIDES)).toBeNull();
    // Those that have gone since are not asked about.
    expect(distance(translationTo(moved.slice(1), BOTH_SIDES)!, by)).toBeLessThan(1e-12);
  });
});

describe('a drag', () => {
  const shown = { setRegion: vi.fn(), setShares: vi.fn(), setReach: vi.fn(), setReadout: vi.fn() };
  const client = {
    setLocality: vi.fn(() => Promise.resolve()),
    reach: vi.fn((vertices: number[]) =>
      Promise.resolve(vertices.map((): Ball[] => [{ vertex: 9, centre: [0, 0, 0], radius: 1 }])),
    ),
    mobility: vi.fn(() => Promise.resolve(Float32Array.of(1, 1, 0))),
  };
  const guide = new DragGuide(client as unknown as Client, shown);
  const one = inHand([
    [0.5, 0, 0],
    [1, 1, 1],
  ]);

  test('stops at the reach of its handle, which is shown there', async () => {
    await guide.begin(one, null);
    expect(client.setLocality).not.toHaveBeenCalled();
    expect(guide.within([{ vertex: 1, target: [0.2, 0, 0] }])).toEqual([{ vertex: 1, target: [0.2, 0, 0] }]);
    expect(shown.setReach).toHaveBeenLastCalledWith(null);
    expect(guide.within([{ vertex: 1, target: [5, 0, 0] }])).toEqual([{ vertex: 1, target: [1, 0, 0] }]);
    expect(shown.setReach).toHaveBeenLastCalledWith([{ centre: [0, 0, 0], radius: 1, counts: [1, 1, 1] }]);
    guide.keepsWithin = false;
    expect(guide.within([{ vertex: 1, target: [5, 0, 0] }])).toEqual([{ vertex: 1, target: [5, 0, 0] }]);
    guide.keepsWithin = true;
    guide.end();
    expect(shown.setReach).toHaveBeenLastCalledWith(null);
    expect(guide.within([{ vertex: 1, target: [5, 0, 0] }])).toEqual([{ vertex: 1, target: [5, 0, 0] }]);
  });

  test('that snaps stops at the reach all the same, and what is said is where it stopped', async () => {
    await guide.begin(one, null);
    guide.snapping = new Snapping(0.8, false, 1);
    const near = guide.snapped([{ vertex: 1, target: [0.7, 0, 0] }], []);
    expect(near).toEqual([{ vertex: 1, target: [0.8, 0, 0] }]);
    expect(guide.within(near)).toEqual(near);
    const far = guide.within(guide.snapped([{ vertex: 1, target: [1.7, 0, 0] }], []));
    expect(far).toEqual([{ vertex: 1, target: [1, 0, 0] }]);
    guide.describe(far, []);
    expect(shown.setReadout).toHaveBeenLastCalledWith('x 1 · y 0 · z 0');
    guide.snapping = null;
    guide.end();
    expect(shown.setReadout).toHaveBeenLastCalledWith('');
  });

  test('that snaps to a surface is on it, within reach, and not where it keeps to an axis', async () => {
    await guide.begin(one, null);
    // A slanted square, of two triangles.
    const surface = new SurfacePoints({
      positions: Float64Array.from([-1, -1, 0, 1, -1, 1, 1, 1, 1, -1, 1, 0]),
      triangles: Int32Array.from([0, 1, 2, 0, 2, 3]),
    });
    guide.snapping = new Snapping(null, false, 1, surface);
    const at = (target: Vec3): Vec3 => guide.snapped([{ vertex: 1, target }], [])[0]!.target;
    const [x, y, z] = at([0.1, 0.2, 0.9]);
    expect(z).toBeCloseTo((x + 1) / 2);
    expect(y).toBeCloseTo(0.2);
    expect(at([3, 0.5, 1])).toEqual([1, 0.5, 1].map((each) => expect.closeTo(each)));
    guide.keepTo(new Along('x', 1));
    expect(at([0.4, 0, 0])).toEqual([0.4, 0, 0].map((each) => expect.closeTo(each)));
    guide.keepTo(null);
    guide.snapping = null;
    guide.end();
  });

  test('kept to a curve is on it, and goes along it as far as it can be reached', async () => {
    await guide.begin(one, null);
    const ell = [
      [0, -1, 0],
      [0, 0.5, 0],
      [9, 0.5, 0],
    ] as const;
    guide.snapping = new Snapping(null, false, 1, throughHandles(ell.map(([...target]) => ({ target }))));
    const go = (target: Vec3): Vec3 => guide.within(guide.snapped([{ vertex: 1, target }], []))[0]!.target;
    const isAt = (...place: Vec3) => place.map((x) => expect.closeTo(x, 12));
    expect(go([-0.4, 0.2, 0.7])).toEqual(isAt(0, 0.2, 0));
    expect(go([0.4, 3, -2])).toEqual(isAt(0.4, 0.5, 0));
    // What is out of reach is answered with the end of the reach on the curve, not with a place beside it.
    const stop = go([5, 0, 0]);
    expect(stop).toEqual([expect.closeTo(Math.sqrt(0.75), 8), expect.closeTo(0.5, 12), 0]);
    expect(Math.hypot(...stop)).toBeLessThanOrEqual(1 + 1e-9);
    guide.keepsWithin = false;
    expect(go([5, 0, 0])).toEqual(isAt(5, 0.5, 0));
    guide.keepsWithin = true;
    guide.snapping = null;
    guide.end();
  });

  test('kept to an axis is on it to the last bit, snaps and stops on it, and freed it goes anywhere again', async () => {
    const base: Vec3 = [0.1 + 0.2, 1 / 3, -0.7];
    await guide.begin(inHand([base, [1, 1, 1]]), null);
    guide.keepTo(new Along('x', 1));
    const asked = (x: number): Handle[] => [{ vertex: 1, target: [x, base[1] * (1 + 1e-15), base[2] - 1e-17] }];
    const go = (x: number): Vec3 => guide.within(guide.snapped(asked(x), []))[0]!.target;
    expect(go(0.4)).toEqual([expect.closeTo(0.4, 12), base[1], base[2]]);
    // Where the line leaves the ball, not the point of the ball that is nearest.
    const stop = Math.sqrt(1 - base[1] ** 2 - base[2] ** 2);
    expect(go(9)).toEqual([expect.closeTo(stop, 9), base[1], base[2]]);
    guide.snapping = new Snapping(0.25, false, 1);
    expect(go(0.45)).toEqual([expect.closeTo(0.5, 12), base[1], base[2]]);
    guide.describe([{ vertex: 1, target: go(0.45) }], []);
    expect(shown.setReadout).toHaveBeenLastCalledWith('Along x · x 0.5 · y 0.333 · z -0.7');
    guide.snapping = null;
    guide.keepTo(null);
    const [free] = guide.within([{ vertex: 1, target: [0, 0, 9] }]);
    expect(distance(free!.target, [0, 0, 1])).toBeLessThan(1e-9);
    guide.end();
  });

  test('is not held back by handles that follow it, which it takes along by their share', async () => {
    client.reach.mockResolvedValueOnce([
      [
        { vertex: 9, centre: [0, 0, 0], radius: 3 },
        { vertex: 2, centre: [1, 0, 0], radius: 1 },
      ],
    ]);
    const [hand, led] = inHand(
      [
        [0, 0, 0],
        [1, 1, 1],
      ],
      [
        [1, 0, 0],
        [0.25, 0.25, 0.25],
      ],
    );
    await guide.begin([hand!, { ...led!, isLed: true }], null);
    expect(client.reach).toHaveBeenLastCalledWith([1]);
    const far = guide.within([
      { vertex: 1, target: [0, 0, 8] },
      { vertex: 2, target: [1, 0, 2] },
    ]);
    expect(far).toEqual([
      { vertex: 1, target: [0, 0, 3] },
      { vertex: 2, target: [1, 0, 0.75] },
    ]);
    guide.end();
  });

  test('that begins at the border stays there along every axis', async () => {
    await guide.begin(
      inHand([
        [0.6, 0.8, 0],
        [1, 1, 1],
      ]),
      null,
    );
    guide.keepTo(new Along('z', 1));
    const [held] = guide.within(guide.snapped([{ vertex: 1, target: [0.6, 0.8, 2] }], []));
    expect(Math.hypot(...held!.target)).toBeLessThan(1 + 1e-8);
    guide.keepTo(new Along('xy', 1));
    const [slid] = guide.within(guide.snapped([{ vertex: 1, target: [2, 0, 0] }], []));
    expect(distance(slid!.target, [1, 0, 0])).toBeLessThan(1e-8);
    guide.end();
  });

  test('of handles that slide moves each in the coordinates that it holds', async () => {
    const [crown, foot] = inHand(
      [
        [0.5, 0, 0],
        [1, 1, 1],
      ],
      [
        [-0.3, 0.1, 0],
        [0, 0, 1],
      ],
    );
    await guide.begin([crown!, foot!], null);
    guide.snapping = new Snapping(0.25, false, 1);
    const both = guide.snapped(
      [
        { vertex: 1, target: [0.7, 0, 0.2] },
        // Where the net has taken it meanwhile.
        { vertex: 2, target: [-0.31, 0.12, 0.2] },
      ],
      [],
    );
    expect(both[0]!.target).toEqual([0.75, 0, 0.25]);
    expect(both[1]!.target[2]).toBe(0.25);
    guide.snapping = null;
    guide.end();
  });

  test('of several stops them all together; turned, they are not held', async () => {
    await guide.begin(
      inHand(
        [
          [0, 0, 0],
          [1, 1, 1],
        ],
        [
          [0, 0.5, 0],
          [1, 1, 1],
        ],
      ),
      null,
    );
    const at = (a: Vec3, b: Vec3) => [
      { vertex: 1, target: a },
      { vertex: 2, target: b },
    ];
    const [first, second] = guide.within(at([0, 3, 0], [0, 3.5, 0]));
    expect(distance(first!.target, [0, 0.5, 0])).toBeLessThan(1e-9);
    expect(distance(second!.target, [0, 1, 0])).toBeLessThan(1e-9);
    expect(guide.within(at([0, 3, 0], [0.5, 3, 0]))).toEqual(at([0, 3, 0], [0.5, 3, 0]));
    guide.end();
  });

  test('tells the solver its locality and shades what stays; the next without one frees everything', async () => {
    await guide.begin(one, 3);
    expect(client.setLocality).toHaveBeenLastCalledWith(3, [1]);
    expect(client.mobility).toHaveBeenLastCalledWith(3, [1]);
    expect(shown.setRegion.mock.lastCall?.[0]).toEqual(Float32Array.of(1, 1, 0));
    guide.end();
    expect(shown.setRegion).toHaveBeenLastCalledWith(null);
    await guide.begin(one, null);
    expect(client.setLocality).toHaveBeenLastCalledWith(null, [1]);
    guide.end();
  });
});

describe('a curve to keep to', () => {
  // A square with a square hole, of eight triangles.
  const ring = {
    positions: Float64Array.from([0, 0, 0, 3, 0, 0, 3, 3, 0, 0, 3, 0, 1, 1, 0, 2, 1, 0, 2, 2, 0, 1, 2, 0]),
    triangles: Int32Array.from([0, 1, 4, 1, 5, 4, 1, 2, 5, 2, 6, 5, 2, 3, 6, 3, 7, 6, 3, 0, 7, 0, 4, 7]),
  };

  test('is the border of a surface, all of it', () => {
    const { lines } = borderOfSurface(ring)!;
    expect(lines.map(({ length }) => length)).toEqual([5, 5]);
    for (const line of lines) {
      expect(line[0]).toEqual(line[4]);
      for (let i = 1; i < 5; i++) expect(distance(line[i - 1]!, line[i]!)).toBeOneOf([1, 3]);
    }
    const border = borderOfSurface(ring)!;
    expect(border.nearest([1.5, 0.4, 1])).toEqual([1.5, 0, 0]);
    expect(border.nearest([1.5, 0.6, 1])).toEqual([1.5, 1, 0]);
    expect(borderOfSurface({ ...ring, triangles: Int32Array.from([0, 1, 2, 2, 1, 0]) })).toBeNull();
  });

  test('is the border of a net where it lies, and a closed one has none', () => {
    const net = { loopStart: Int32Array.from([0, 3]), loopVertices: Int32Array.from([4, 5, 6]) } as OpenedNet;
    expect(borderOfNet(net, ring.positions)!.lines).toEqual([
      [
        [1, 1, 0],
        [2, 1, 0],
        [2, 2, 0],
        [1, 1, 0],
      ],
    ]);
    expect(borderOfNet({ ...net, loopStart: Int32Array.from([0]) }, ring.positions)).toBeNull();
  });

  test('goes through two handles at least', () => {
    expect(throughHandles([{ target: [0, 0, 0] }])).toBeNull();
    expect(throughHandles([{ target: [0, 0, 0] }, { target: [2, 0, 0] }])!.nearest([1, 5, 0])).toEqual([1, 0, 0]);
  });
});

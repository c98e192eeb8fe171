/** How much of a move handles nearby make. */
import { expect, test } from 'vitest';
import type { HandleData, Vec3 } from '../../web/src/document/document';
import { followersOf, following, shareAt, sharesAround } from '../../web/src/handles/influence';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import { load } from '../wasm/load';
import { grid } from './nets';

const core = await load();
const open = (mesh: { restPositions: Float64Array; faceStart: Int32Array; faceVertices: Int32Array }) =>
  describeNet(core.openMesh({ ...mesh, positions: mesh.restPositions }));
const [COLUMNS, ROWS] = [21, 15];
const net = open(grid(COLUMNS, ROWS));
const MIDDLE = 7 * COLUMNS + 10;
const handle = (vertex: number, rest: Partial<HandleData> = {}): HandleData => ({
  vertex,
  target: [...net.restPositions.subarray(3 * vertex, 3 * vertex + 3)] as Vec3,
  anchor: false,
  ...rest,
});

test('the share is 1 in the hand, 0 from the radius on, falls all the way, and is smooth at both ends', () => {
  expect([shareAt(0), shareAt(0.5), shareAt(1), shareAt(7)]).toEqual([1, 0.5, 0, 0]);
  const step = 1e-3;
  for (let part = 0; part < 1; part += step) expect(shareAt(part + step)).toBeLessThan(shareAt(part));
  const slope = (part: number) => (shareAt(part + step) - shareAt(part - step)) / (2 * step);
  for (const end of [0, 1]) expect(Math.abs(slope(end))).toBeLessThan(2 * step);
  for (let part = step; part < 1 - step; part += step) expect(slope(part)).toBeGreaterThan(-1.5001);
});

test('over the net it is by the distance along it, in edge lengths', () => {
  const shares = sharesAround(net, [MIDDLE], 5);
  expect(shares[MIDDLE]).toBe(1);
  for (let k = 1; k <= 6; k++) {
    expect(shares[MIDDLE + k]).toBeCloseTo(shareAt(k / 5), 6);
    expect(shares[MIDDLE - k * COLUMNS]).toBeCloseTo(shareAt(k / 5), 6);
    expect(shares[MIDDLE + k * (COLUMNS + 1)]).toBeCloseTo(shareAt((k * Math.SQRT2) / 5), 6);
  }
});

test('what is near in space alone does not follow', () => {
  // A strip bent to a hairpin: its ends are side by side.
  const width = 9;
  const strip = grid(2 * width, 2);
  const bent = strip.restPositions.map((x, i) => {
    const column = Math.floor(i / 3) % (2 * width);
    if (i % 3 === 0) return column < width ? column : 2 * width - 1 - column;
    return i % 3 === 2 && column >= width ? 1 : x;
  });
  const hairpin = open({ ...strip, restPositions: bent });
  const [hand, beside, along] = [0, 2 * width - 1, 2];
  const found = followersOf(
    hairpin,
    [hand, beside, along].map((vertex) => handle(vertex)),
    [hand],
    4,
  );
  expect(found.map(({ vertex }) => vertex)).toEqual([along]);
});

test('neither locked handles nor those in hand follow, nor those at the radius; others the nearest in hand', () => {
  const [left, right] = [MIDDLE - 3, MIDDLE + 4];
  const handles = [
    handle(left),
    handle(right),
    handle(MIDDLE),
    handle(MIDDLE + 1),
    handle(MIDDLE - 2, { anchor: true }),
    handle(left - 4),
  ];
  const followers = followersOf(net, handles, [left, right], 4);
  expect(followers.map(({ vertex, leader, share }) => [vertex, leader, share])).toEqual([
    [MIDDLE, left, shareAt(3 / 4)],
    [MIDDLE + 1, right, shareAt(3 / 4)],
  ]);
  const by = (leader: number): Vec3 => (leader === left ? [1, 0, 0] : [0, 0, 2]);
  const from = (vertex: number): Vec3 => handle(vertex).target;
  const hand = [left, right].map((vertex) => ({
    vertex,
    target: from(vertex).map((x, i) => x + by(vertex)[i]!) as Vec3,
  }));
  const share = shareAt(3 / 4);
  expect(following(followers, hand, from)).toEqual([
    { vertex: MIDDLE, target: [10 + share, 7, 0] },
    { vertex: MIDDLE + 1, target: [11, 7, 2 * share] },
  ]);
});

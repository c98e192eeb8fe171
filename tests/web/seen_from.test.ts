/** From where a place on a surface is seen, past other parts of it. */
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { directionsTowards, isClear, isHidden } from '../../web/src/drape/seen_from';

/** A strip along y, of two triangles between one corner of its outline and the next. */
function strip(outline: [x: number, z: number][], [from, to]: [number, number]) {
  const corners = Float32Array.from(outline.flatMap(([x, z]) => [x, from, z, x, to, z]));
  const triangles = outline.slice(1).flatMap((_, i) => [0, 2, 1, 1, 2, 3].map((corner) => corner + 2 * i));
  return { corners, triangles };
}

const FRONT = new Vector3(0.55, -1, 0.62).normalize();
const towards = (normal: Vector3) => normal.clone().addScaledVector(FRONT, 0.7).normalize();

/** The first direction from which an eye so far away sees the place. */
function seenFrom(place: Vector3, normal: Vector3, { corners, triangles }: ReturnType<typeof strip>, away = 4) {
  const all = directionsTowards(normal, towards(normal));
  const at = all.findIndex((each) => !isHidden(place, place.clone().addScaledVector(each, away), corners, triangles));
  return { at, direction: all[at] };
}

const CHANNEL: [number, number][] = [
  [-0.25, 0.5],
  [-0.25, -0.5],
  [0.25, -0.5],
  [0.25, 0.5],
];

test('the direction that is wanted stays where nothing stands between', () => {
  const flat = strip(
    [
      [-1, 0],
      [1, 0],
    ],
    [-1, 1],
  );
  expect(seenFrom(new Vector3(0.2, 0.1, 0), new Vector3(0, 0, 1), flat).at).toBe(0);
  expect(seenFrom(new Vector3(0, 0, 0), new Vector3(0, 0, -1), flat).at).toBe(0);
});

test('on the wall of a channel a place is seen past the other wall', () => {
  const channel = strip(CHANNEL, [-1, 1]);
  for (const [x, inwards] of [
    [-0.25, 1],
    [0.25, -1],
  ] as const) {
    const [place, normal] = [new Vector3(x, 0, 0.1), new Vector3(inwards, 0, 0)];
    const eye = place.clone().addScaledVector(towards(normal), 4);
    const { at, direction } = seenFrom(place, normal, channel);
    expect(isHidden(place, eye, channel.corners, channel.triangles)).toBe(at > 0);
    expect(direction!.dot(normal)).toBeGreaterThan(0.3);
  }
  const left = seenFrom(new Vector3(-0.25, 0, 0.1), new Vector3(1, 0, 0), channel);
  expect(left.at).toBeGreaterThan(0);
});

test('deep inside, it is seen from behind, unless the body is closed', () => {
  const deep = CHANNEL.map(([x, z]): [number, number] => [0.2 * x, z]);
  const [place, normal] = [new Vector3(-0.05, 0, -0.3), new Vector3(1, 0, 0)];
  expect(seenFrom(place, normal, strip(deep, [-1, 1])).direction!.dot(normal)).toBeLessThan(0);
  const shell: [number, number][] = [...deep.map(([x, z]): [number, number] => [1.5 * x, 1.1 * z]), [-0.075, 0.55]];
  const inner = strip(deep, [-1, 1]);
  const outer = strip(shell, [-2, 2]);
  const both = {
    corners: Float32Array.from([...inner.corners, ...outer.corners]),
    triangles: [...inner.triangles, ...outer.triangles.map((corner) => corner + inner.corners.length / 3)],
  };
  expect(seenFrom(place, normal, both).at).toBe(-1);
});

test('what lies beyond the eye hides nothing, nor do the triangles that meet at the place', () => {
  const channel = strip(CHANNEL, [-1, 1]);
  const [corner, within] = [new Vector3(-0.25, 0, -0.5), new Vector3(0, 0, 0)];
  expect(isHidden(corner, within, channel.corners, channel.triangles)).toBe(false);
  expect(isHidden(corner, new Vector3(1, 0, 0), channel.corners, channel.triangles)).toBe(true);
});

test('past the edge of a wall it is seen, but not clearly', () => {
  const channel = strip(CHANNEL, [-1, 1]);
  const place = new Vector3(-0.25, 0, 0.1);
  const seen = (z: number, asks: typeof isClear) =>
    asks(place, new Vector3(5, 0, z), channel.corners, channel.triangles);
  // The other wall ends at 0.4 above the place, half as wide beside it.
  expect([1, 4.5, 9].map((z) => seen(z, (...given) => !isHidden(...given)))).toEqual([false, true, true]);
  expect([1, 4.5, 9].map((z) => seen(z, isClear))).toEqual([false, false, true]);
});

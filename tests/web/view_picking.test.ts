import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { halfHeight } from '../../web/src/view/camera_rig';
import { directionFor, fitCamera, isBehind, standBack } from '../../web/src/view/camera_fit';
import { fanTriangles } from '../../web/src/worker/triangles';
import { isInside, nearestMarker, nearestVertex, project, projectionOf } from '../../web/src/view/picking';
import { Space } from '../../web/src/view/space';
import { random } from './random';

/** Four numbers a vertex, as the view keeps them. */
function pack(...points: [number, number, number][]): Float32Array {
  return Float32Array.from(points.flatMap((point) => [...point, 0]));
}

/** On the x axis at −10, looking along it, z up. */
function lookAlongX(): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, 2, 0.1, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(-10, 0, 0);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

const projection = projectionOf(lookAlongX(), 800, 400);

describe('from the scene to the canvas', () => {
  test('what is looked at is in the middle', () => {
    const { x, y, depth } = project(projection, 0, 0, 0);
    expect(x).toBeCloseTo(400);
    expect(y).toBeCloseTo(200);
    expect(depth).toBeCloseTo(9.9); // beyond the near plane
  });
  test('up is up, left is left', () => {
    expect(project(projection, 0, 0, 1).y).toBeLessThan(200);
    expect(project(projection, 0, 1, 0).x).toBeLessThan(400);
  });
});

describe('the vertex under the pointer', () => {
  const pick = (points: Float32Array, x = 400, y = 200) =>
    nearestVertex(points, points.length / 4, projection, x, y, 12, 0.5);

  test('is the nearest of the front layer', () => {
    const points = pack([0, 0.1, 0], [0.2, 0.02, 0], [5, 0, 0]);
    expect(pick(points)).toBe(1);
  });
  test('is not one behind, even if that is nearer on the screen', () => {
    expect(pick(pack([5, 0, 0], [0, 0.2, 0]))).toBe(1);
  });
  test('is none beyond the radius', () => {
    expect(pick(pack([0, 1, 0], [0, 0, 1]))).toBeNull();
    expect(pick(pack())).toBeNull();
  });
  test('is none that is hidden', () => {
    const points = pack([0, 0.1, 0], [0.2, 0.02, 0]);
    points[4 * 1 + 3] = 1;
    expect(pick(points)).toBe(0);
  });
  test('is none behind the camera', () => {
    expect(pick(pack([-20, 0, 0]))).toBeNull();
  });
  test('is the one that a plain search finds', () => {
    const next = random(7);
    const points = pack(
      ...Array.from({ length: 2000 }, (): [number, number, number] => [0, 8 * next() - 4, 4 * next() - 2]),
    );
    for (let k = 0; k < 50; k++) {
      const [x, y] = [800 * next(), 400 * next()];
      const distances = Array.from({ length: 2000 }, (_, i) => {
        const p = project(projection, points[4 * i]!, points[4 * i + 1]!, points[4 * i + 2]!);
        return Math.hypot(p.x - x, p.y - y);
      });
      const best = distances.indexOf(Math.min(...distances));
      expect(pick(points, x, y)).toBe(distances[best]! <= 12 ? best : null);
    }
  });
});

test('of two handles under the pointer the one in front is meant', () => {
  const marker = (x: number, depth: number) => ({ x, y: 0, depth, radius: 8 });
  expect(nearestMarker([marker(0, 5), marker(3, 4), marker(100, 1)], 0, 0, 4)).toBe(1);
  expect(nearestMarker([marker(20, 5)], 0, 0, 4)).toBeNull();
  expect(nearestMarker([marker(0, -1)], 0, 0, 4)).toBeNull();
});

describe('the whole net in sight', () => {
  const next = random(3);
  const cloud = pack(
    ...Array.from({ length: 400 }, (): [number, number, number] => [next(), 3 * next(), 0.5 * next()]),
  );

  test.each([
    [2, false, { top: 0.1, right: 0.05, bottom: 0.2, left: 0.1 }],
    [0.5, false, { top: 0.2, right: 0.1, bottom: 0.1, left: 0 }],
    [2, true, { top: 0.1, right: 0.05, bottom: 0.2, left: 0.1 }],
  ])(
    'aspect %d, parallel %s: every vertex is within the margins, and two sides are touched',
    (aspect, isParallel, margins) => {
      const camera = new PerspectiveCamera(32, aspect, 0.01, 100);
      camera.up.set(0, 0, 1);
      const { position, target } = fitCamera(cloud, 400, camera, margins, undefined, isParallel);
      camera.position.copy(position);
      camera.lookAt(target);
      const top = halfHeight(camera, position.distanceTo(target));
      const parallel = new OrthographicCamera(-top * aspect, top * aspect, top, -top);
      parallel.position.copy(camera.position);
      parallel.quaternion.copy(camera.quaternion);
      const flat = projectionOf(isParallel ? parallel : camera, 1, 1);
      const seen = Array.from({ length: 400 }, (_, i) =>
        project(flat, cloud[4 * i]!, cloud[4 * i + 1]!, cloud[4 * i + 2]!),
      );
      const gaps = {
        left: Math.min(...seen.map(({ x }) => x)) - margins.left,
        right: 1 - Math.max(...seen.map(({ x }) => x)) - margins.right,
        top: Math.min(...seen.map(({ y }) => y)) - margins.top,
        bottom: 1 - Math.max(...seen.map(({ y }) => y)) - margins.bottom,
      };
      for (const gap of Object.values(gaps)) expect(gap).toBeGreaterThan(-1e-6);
      expect(Math.min(gaps.left + gaps.right, gaps.top + gaps.bottom)).toBeLessThan(1e-5);
    },
  );
});

test.each([false, true])('what a wide picture shows is within a narrow one, parallel %s', (isParallel) => {
  const cloud = pack([0, 0, 0], [2.6, 0, 0], [-2, -1, 0.5], [3.6, 0, 0], [0, 0, 3]);
  const camera = new PerspectiveCamera(32, 0.5, 0.01, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(0, -8, 0);
  camera.lookAt(0, 0, 0);
  const from = { position: camera.position.clone(), target: new Vector3() };
  const { position, target } = standBack(cloud, 5, camera, from, 1.25, isParallel);
  expect(target).toEqual(from.target);
  expect(
    position
      .clone()
      .normalize()
      .distanceTo(new Vector3(0, -1, 0)),
  ).toBeLessThan(1e-9);
  const halfWidth = (depth: number) => 0.5 * depth * Math.tan((16 * Math.PI) / 180);
  const away = position.length();
  expect(halfWidth(away)).toBeGreaterThan(2.6);
  expect(halfWidth(away)).toBeLessThan(2.9); // What was beyond the wide picture does not count.
  expect(standBack(cloud, 5, camera, from, 0.5, isParallel).position).toEqual(from.position);
});

test('the handle to begin with is in front', () => {
  const [front, behind] = [new Vector3(0.3, -0.8, 0), new Vector3(-0.2, 0.9, 0.4)];
  for (const first of [front, behind])
    expect(directionFor('free', isBehind(first)).dot(first.clone().setZ(0))).toBeGreaterThan(0);
  expect(isBehind(new Vector3(0, 0, 1))).toBe(false);
});

test('the scene is centred and of one size, wherever the net is', () => {
  const space = new Space(Float64Array.from([1000, 2000, 3000, 1006, 2008, 3000]));
  const point = { x: 0, y: 0, z: 0 };
  space.toScene(point, [1006, 2008, 3000]);
  expect(Math.hypot(point.x, point.y, point.z)).toBeCloseTo(1);
  expect(space.toNet(point)).toEqual([1006, 2008, 3000]);
  expect(space.floor).toBeCloseTo(0);
  expect(new Space(Float64Array.from([1, 1, 1])).scale).toBe(1);
});

test('a net whose y is up stands upright in the scene, right-handed as before', () => {
  const space = new Space(Float64Array.from([-3, -2, -6, 3, 2, 6]), 'y');
  const point = { x: 0, y: 0, z: 0 };
  space.toScene(point, [3, 2, 6]);
  expect([point.x, point.y, point.z].map((x) => 7 * x)).toEqual([3, -6, 2].map((x) => expect.closeTo(x)));
  expect(space.toNet(point)).toEqual([3, 2, 6].map((x) => expect.closeTo(x)));
  expect(7 * space.floor).toBeCloseTo(-2);
});

test('faces of any arity become fans', () => {
  const triangles = fanTriangles(Int32Array.from([0, 3, 7, 12]), Int32Array.from([0, 1, 2, 2, 3, 4, 5, 5, 6, 7, 8, 9]));
  expect([...triangles]).toEqual([0, 1, 2, 2, 3, 4, 2, 4, 5, 5, 6, 7, 5, 7, 8, 5, 8, 9]);
});

describe('an outline', () => {
  const places = (...all: [number, number][]) => all.map(([x, y]) => ({ x, y }));

  test('holds what lies within it, whichever way round it was drawn, and nothing in its bays', () => {
    const bay = places([0, 0], [10, 0], [10, 10], [5, 2], [0, 10]);
    for (const outline of [bay, [...bay].reverse()]) {
      expect(isInside(outline, 1, 3)).toBe(true);
      expect(isInside(outline, 9, 3)).toBe(true);
      expect(isInside(outline, 5, 6)).toBe(false);
      expect(isInside(outline, 11, 1)).toBe(false);
    }
  });

  test('that goes round twice holds what it went round twice', () => {
    const twice = places([0, 0], [10, 0], [10, 10], [0, 10], [2, 2], [8, 2], [8, 8], [2, 8]);
    expect(isInside(twice, 5, 5)).toBe(true);
    expect(isInside(twice, 5, 12)).toBe(false);
  });

  test('of a point or a line holds nothing', () => {
    expect(isInside(places([1, 1]), 1, 1)).toBe(false);
    expect(isInside(places([0, 0], [2, 2]), 1, 0.5)).toBe(false);
  });
});

import { OrthographicCamera, PerspectiveCamera, Vector2, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { inPlane, onAxis } from '../../web/src/view/axis_drag';
import { DragReport, ViewPlane } from '../../web/src/view/drag';
import { random } from './random';

function record(mayBegin = true) {
  const said: string[] = [];
  const report = new DragReport({
    dragStart: () => said.push('start') > 0 && mayBegin,
    dragMove: (targets) =>
      void said.push(`move ${targets.map(({ vertex, target }) => `${vertex} to ${target}`).join(' and ')}`),
    dragEnd: (cancelled) => void said.push(cancelled ? 'cancel' : 'end'),
  });
  return { said, report };
}

const both = (target: [number, number, number]) => [7, 8].map((vertex) => ({ vertex, target }));

describe('a drag of two handles', () => {
  test('reports the first move at once, then the last of the moves of a frame, and no frame without one', () => {
    const { said, report } = record();
    for (const drag of [1, 2]) {
      report.begin([7, 8]);
      report.move(both([1, 0, 0]));
      expect(said.splice(0), `drag ${drag}`).toEqual(['start', 'move 7 to 1,0,0 and 8 to 1,0,0']);
      report.move(both([2, 0, 0]));
      report.move(both([3, 0, 0]));
      expect(said).toEqual([]);
      report.flush();
      report.flush();
      expect(said.splice(0)).toEqual(['move 7 to 3,0,0 and 8 to 3,0,0']);
      report.end(false);
      expect(said.splice(0)).toEqual(['end']);
    }
  });
  test('ends where the hand was last', () => {
    const { said, report } = record();
    report.begin([7, 8]);
    report.move(both([1, 0, 0]));
    report.move(both([3, 0, 0]));
    report.end(false);
    expect(said.slice(2)).toEqual(['move 7 to 3,0,0 and 8 to 3,0,0', 'end']);
    expect(report.isUnderWay).toBe(false);
  });
  test('ends though its last move fails', () => {
    const ended: boolean[] = [];
    const dragMove = (): void => {
      throw new Error('no');
    };
    const report = new DragReport({ dragStart: () => true, dragMove, dragEnd: (cancelled) => ended.push(cancelled) });
    report.begin([7]);
    expect(() => report.move(both([1, 0, 0]))).toThrow('no');
    report.move(both([2, 0, 0]));
    expect(() => report.end(false)).toThrow('no');
    expect([report.isUnderWay, ended]).toEqual([false, [false]]);
  });
  test('cancelled, moves no more', () => {
    const { said, report } = record();
    report.begin([7, 8]);
    report.move(both([1, 0, 0]));
    report.move(both([3, 0, 0]));
    report.end(true);
    report.flush();
    report.end(false);
    expect(said.slice(2)).toEqual(['cancel']);
  });
});

test('a drag that may not begin, as while another net is being opened, moves nothing', () => {
  const { said, report } = record(false);
  report.begin([7, 8]);
  expect(report.isUnderWay).toBe(false);
  report.end(false);
  expect(said).toEqual(['start']);
});

test('a point is carried in the plane that faces the camera, from where it was gripped', () => {
  const camera = new PerspectiveCamera(40, 1, 0.1, 100);
  camera.position.set(3, 1, 8);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const point = new Vector3(0.5, -0.2, 1);
  const middle = point.clone().project(camera);
  const grip = new Vector2(middle.x + 0.02, middle.y - 0.01);
  const plane = new ViewPlane();
  plane.grab(camera, point, grip);

  expect(plane.carry(camera, grip)!.distanceTo(point)).toBeLessThan(1e-12);
  const carried = plane.carry(camera, grip.clone().add(new Vector2(0.3, 0.2)))!;
  const along = camera.getWorldDirection(new Vector3());
  expect(carried.clone().sub(point).dot(along)).toBeCloseTo(0, 12);
  const seen = carried.project(camera);
  expect(seen.x).toBeCloseTo(middle.x + 0.3, 10);
  expect(seen.y).toBeCloseTo(middle.y + 0.2, 10);
});

const SEED = 11;

describe.each([
  ['in perspective', new PerspectiveCamera(40, 1, 0.1, 100)],
  ['in parallel projection', new OrthographicCamera(-2, 2, 2, -2, 0.1, 100)],
])('a drag kept to an axis or a plane, %s', (_, camera) => {
  const number = random(SEED);
  const point = (size: number): Vector3 => new Vector3().fromArray([0, 1, 2].map(() => size * (2 * number() - 1)));
  const axisOf = (i: number): Vector3 => new Vector3().setComponent(i % 3, 1);
  function lookFrom(place: Vector3): void {
    camera.position.copy(place);
    camera.up.set(0, 0, 1);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
  }
  const seen = (place: Vector3): Vector2 => new Vector2().copy(place.clone().project(camera));
  /** Where the pointer would take the handle in the plane that faces the camera. */
  const aimed = (from: Vector3, pointer: Vector2): Vector3 => {
    const plane = new ViewPlane();
    plane.grab(camera, from, seen(from));
    return plane.carry(camera, pointer)!;
  };

  test(`follows the pointer along the axis, and stays where it is seen in the plane (seed ${SEED})`, () => {
    for (let i = 0; i < 300; i++) {
      lookFrom(point(1).normalize().multiplyScalar(8));
      const [from, axis] = [point(0.5), axisOf(i)];
      const sight = camera.getWorldDirection(new Vector3());
      if (Math.abs(axis.dot(sight)) < 0.9) {
        const wanted = from.clone().addScaledVector(axis, 0.6 * (2 * number() - 1));
        expect(onAxis(camera, from, aimed(from, seen(wanted)), axis).distanceTo(wanted)).toBeLessThan(1e-9);
      }
      if (Math.abs(axis.dot(sight)) > 0.4) {
        const wanted = from.clone().add(point(0.5).setComponent(i % 3, 0));
        expect(inPlane(camera, from, aimed(from, seen(wanted)), axis).distanceTo(wanted)).toBeLessThan(1e-9);
      }
    }
  });

  test(`keeps exactly to the axis, begins at its handle, and is bounded however it is seen (seed ${SEED})`, () => {
    let steep = 0;
    for (let i = 0; i < 2000; i++) {
      const axis = axisOf(i);
      // Mostly along the axis, or along the plane.
      const from = point(0.5);
      const tilt = 10 ** (-6 * number());
      const towards = i % 2 === 0 ? axis.clone() : axisOf(i + 1);
      lookFrom(towards.multiplyScalar(8 * Math.sign(number() - 0.5)).add(point(8 * tilt)));
      const aim = aimed(from, new Vector2(2 * number() - 1, 2 * number() - 1));
      const most = 8.001 * aim.distanceTo(from);
      const along = onAxis(camera, from, aim, axis).sub(from);
      expect(along.length()).toBeLessThanOrEqual(most);
      for (const other of [1, 2]) expect(along.getComponent((i + other) % 3)).toBe(0);
      const planar = inPlane(camera, from, aim, axis).sub(from);
      expect(planar.length()).toBeLessThanOrEqual(most);
      expect(Math.abs(planar.dot(axis))).toBeLessThan(1e-12);
      expect(onAxis(camera, from, from, axis).distanceTo(from)).toBe(0);
      expect(inPlane(camera, from, from, axis).distanceTo(from)).toBeLessThan(1e-12);
      if (along.length() > 0.99 * most) steep += 1;
    }
    // The bound is reached only by what would go farther.
    expect(steep).toBeLessThan(1000);
  });

  test('along an axis that points at the eye goes up with the pointer: z upwards, others away', () => {
    const origin = new Vector3();
    const up = new Vector2(0, 0.3);
    lookFrom(new Vector3(0, -8, 0));
    expect(onAxis(camera, origin, aimed(origin, up), axisOf(1)).y).toBeGreaterThan(0.1);
    lookFrom(new Vector3(0, 8, 0));
    expect(onAxis(camera, origin, aimed(origin, up), axisOf(1)).y).toBeLessThan(-0.1);
    lookFrom(new Vector3(0, -1e-3, 8));
    expect(onAxis(camera, origin, aimed(origin, up), axisOf(2)).z).toBeGreaterThan(0.1);
  });
});

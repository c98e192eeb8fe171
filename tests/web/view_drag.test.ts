import { PerspectiveCamera, Vector2, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { DragReport, ViewPlane } from '../../web/src/view/drag';

function record() {
  const said: string[] = [];
  const report = new DragReport({
    dragStart: () => void said.push('start'),
    dragMove: (targets) =>
      void said.push(`move ${targets.map(({ vertex, target }) => `${vertex} to ${target}`).join(' and ')}`),
    dragEnd: (cancelled) => void said.push(cancelled ? 'cancel' : 'end'),
  });
  return { said, report };
}

const both = (target: [number, number, number]) => [7, 8].map((vertex) => ({ vertex, target }));

describe('a drag of two handles', () => {
  test('reports the last of the moves of a frame, and no frame without one', () => {
    const { said, report } = record();
    report.begin([7, 8]);
    report.move(both([1, 0, 0]));
    report.move(both([2, 0, 0]));
    report.flush();
    report.flush();
    expect(said).toEqual(['start', 'move 7 to 2,0,0 and 8 to 2,0,0']);
  });
  test('ends where the hand was last', () => {
    const { said, report } = record();
    report.begin([7, 8]);
    report.move(both([3, 0, 0]));
    report.end(false);
    expect(said).toEqual(['start', 'move 7 to 3,0,0 and 8 to 3,0,0', 'end']);
    expect(report.isUnderWay).toBe(false);
  });
  test('cancelled, moves no more', () => {
    const { said, report } = record();
    report.begin([7, 8]);
    report.move(both([3, 0, 0]));
    report.end(true);
    report.flush();
    report.end(false);
    expect(said).toEqual(['start', 'cancel']);
  });
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

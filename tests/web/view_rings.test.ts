/** The rings by which handles are turned. */
import { Group, Mesh, TorusGeometry } from 'three';
import { expect, test } from 'vitest';
import { thickenRings } from '../../web/src/view/rings';

test('rings are thick enough to be seen, all round', () => {
  // As three makes them: half a ring, turned about an axis.
  const ring = new Mesh(new TorusGeometry(0.5, 0.0075, 3, 64, Math.PI).rotateY(Math.PI / 2));
  thickenRings(new Group().add(ring));
  const { position } = ring.geometry.attributes;
  for (let i = 0; i < position!.count; i++) {
    const [x, around] = [position!.getX(i), Math.hypot(position!.getY(i), position!.getZ(i))];
    expect(Math.hypot(x, around - 0.5)).toBeCloseTo(0.0165, 5);
  }
});

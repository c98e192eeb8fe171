/** The controls at selected handles and, loaded with them, how their rings are drawn. */
import { Mesh, type Object3D } from 'three';

export { TransformControls, TransformControlsGizmo } from 'three/addons/controls/TransformControls.js';

/** How far the surface of a ring is moved outwards, beside its radius of a half: to some four pixels across. */
const THICKER = 0.009;

/** three draws the rings as thin as hairs, of which a hand does not see that they can be taken. */
export function thickenRings(parts: Object3D): void {
  for (const part of parts.children) {
    if (!(part instanceof Mesh)) continue;
    const { position, normal } = (part as Mesh).geometry.attributes;
    for (let i = 0; i < position!.count; i++) {
      const [x, y, z] = ([0, 1, 2] as const).map(
        (axis) => position!.getComponent(i, axis) + THICKER * normal!.getComponent(i, axis),
      );
      position!.setXYZ(i, x!, y!, z!);
    }
  }
}

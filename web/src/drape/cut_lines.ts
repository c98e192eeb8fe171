/** Cuts on a surface, as lines of one width. */
import { Group, SRGBColorSpace, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Rgb } from '../fields/colour_map';
import type { Space } from '../view/space';

/** Pixels. */
const WIDTH = 4;

export class CutLines {
  readonly object = new Group();
  readonly #material = new LineMaterial({ linewidth: WIDTH });

  setColour([red, green, blue]: Rgb): void {
    this.#material.color.setRGB(red, green, blue, SRGBColorSpace);
  }

  /** @param paths 3 numbers a point. */
  set(paths: readonly Float64Array[], space: Space): void {
    this.#clear();
    for (const path of paths) {
      if (path.length < 6) continue;
      const geometry = new LineSegmentsGeometry().setPositions(segmentsOf(path, space));
      this.object.add(new LineSegments2(geometry, this.#material));
    }
  }

  dispose(): void {
    this.#clear();
    this.#material.dispose();
  }

  #clear(): void {
    for (const line of this.object.children) (line as LineSegments2).geometry.dispose();
    this.object.clear();
  }
}

/** Both ends of each. */
function segmentsOf(path: Float64Array, space: Space): number[] {
  const point = new Vector3();
  const corners: number[][] = [];
  for (let i = 0; i < path.length; i += 3) {
    space.toScene(point, [path[i]!, path[i + 1]!, path[i + 2]!]);
    corners.push(point.toArray());
  }
  return corners.slice(1).flatMap((corner, i) => [...corners[i]!, ...corner]);
}

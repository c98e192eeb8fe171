/** The plane of symmetry, as a faint sheet through the net. */
import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { Symmetry, Vec3 } from '../document/document';
import { offsetOf } from '../handles/symmetry';
import { AXES } from '../handles/transform';
import type { Space } from './space';
import type { Theme } from './theme';

/** Margin beyond the net, as a fraction of the net's half diagonal. */
const MARGIN = 0.12;

export class SymmetrySheet {
  readonly object = new Group();
  readonly #area = new BufferGeometry();
  readonly #outline = new BufferGeometry();
  readonly #sheet = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.1,
    side: DoubleSide,
    depthWrite: false,
  });
  readonly #rim = new LineBasicMaterial({ transparent: true, opacity: 0.6 });

  constructor() {
    this.#area.setIndex([0, 1, 2, 0, 2, 3]);
    const sheet = new Mesh(this.#area, this.#sheet);
    sheet.renderOrder = 2;
    this.object.add(sheet, new LineLoop(this.#outline, this.#rim));
    this.object.visible = false;
  }

  update(symmetry: Symmetry | undefined, restPositions: Float64Array, space: Space): void {
    this.object.visible = symmetry !== undefined;
    if (!symmetry) return;
    const place = new Vector3();
    const corners = cornersOf(symmetry, restPositions, MARGIN / space.scale).flatMap((corner) => {
      space.toScene(place, corner);
      return place.toArray();
    });
    for (const geometry of [this.#area, this.#outline]) {
      geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
      geometry.computeBoundingSphere();
    }
  }

  setTheme({ good }: Theme): void {
    const colour = new Color().setRGB(...good, SRGBColorSpace);
    this.#sheet.color.copy(colour);
    this.#rim.color.copy(colour);
  }

  dispose(): void {
    for (const thing of [this.#area, this.#outline, this.#sheet, this.#rim]) thing.dispose();
  }
}

function cornersOf(symmetry: Symmetry, positions: Float64Array, margin: number): Vec3[] {
  const across = AXES.indexOf(symmetry.axis);
  const [u, v] = [(across + 1) % 3, (across + 2) % 3] as const;
  const [low, high] = [[0, 1, 2].map(() => Infinity), [0, 1, 2].map(() => -Infinity)];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3]!, x - margin);
    high[i % 3] = Math.max(high[i % 3]!, x + margin);
  });
  const corner = (atU: number[], atV: number[]): Vec3 => {
    const place: Vec3 = [0, 0, 0];
    place[across] = offsetOf(symmetry, positions);
    place[u] = atU[u]!;
    place[v] = atV[v]!;
    return place;
  };
  return [corner(low, low), corner(high, low), corner(high, high), corner(low, high)];
}

/** The curve to which drags keep, as a thin rod that is seen through the net. */
import {
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { Curve, Polyline } from '../handles/curve';
import type { Space } from './space';
import type { Theme } from './theme';

/** In the scene, where the rest net's half diagonal is 1. */
const RADIUS = 0.006;
/** A line of more points is drawn from some of them to others. */
const MOST_POINTS = 2000;
const UP = new Vector3(0, 1, 0);

export class KeptCurve {
  readonly object: InstancedMesh<CylinderGeometry, MeshBasicMaterial>;

  constructor({ lines }: Curve, space: Space, theme: Theme) {
    const pieces = lines.flatMap((line) => piecesOf(line, space));
    const material = new MeshBasicMaterial({ transparent: true, opacity: 0.75, depthTest: false });
    this.object = new InstancedMesh(new CylinderGeometry(RADIUS, RADIUS, 1, 6, 1, true), material, pieces.length);
    pieces.forEach((piece, i) => this.object.setMatrixAt(i, piece));
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
    this.setTheme(theme);
  }

  setTheme({ accent }: Theme): void {
    this.object.material.color.setRGB(...accent, SRGBColorSpace);
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.geometry.dispose();
    this.object.material.dispose();
    this.object.dispose();
  }
}

/** Where a cylinder of length 1 along y is to lie for each piece. */
function piecesOf(line: Polyline, space: Space): Matrix4[] {
  const stride = Math.ceil(line.length / MOST_POINTS);
  const places = line
    .filter((_, i) => i % stride === 0 || i === line.length - 1)
    .map((point) => {
      const place = new Vector3();
      space.toScene(place, point);
      return place;
    });
  return places.slice(1).map((to, i) => {
    const along = to.clone().sub(places[i]!);
    const turn = new Quaternion().setFromUnitVectors(UP, along.clone().normalize());
    const middle = places[i]!.clone().addScaledVector(along, 0.5);
    return new Matrix4().compose(middle, turn, new Vector3(1, along.length(), 1));
  });
}

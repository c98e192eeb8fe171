/** The scene's own coordinates: the rest net's box centred at the origin, its half diagonal 1 long. Nets of any size and place
 *  then look alike to camera, ground and markers, and single precision on the graphics card is enough. The scene's z is up;
 *  a net whose y is up is turned about x. */
import type { UpAxis, Vec3 } from '../document/document';

type Point = { x: number; y: number; z: number };

export class Space {
  /** Which of the net's axes are the scene's y and z; y turned round by `signY`. */
  readonly axisY: 1 | 2;
  readonly axisZ: 1 | 2;
  readonly signY: 1 | -1;
  /** Height of the lowest point of the rest net, in the scene. */
  readonly floor: number;

  readonly centre: Vec3;
  /** Scene length of one unit of the net. */
  readonly scale: number;

  constructor(positions: Float64Array, up: UpAxis = 'z') {
    const low: Vec3 = [Infinity, Infinity, Infinity];
    const high: Vec3 = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < positions.length; i++) {
      const axis = (i % 3) as 0 | 1 | 2;
      const x = positions[i]!;
      if (x < low[axis]) low[axis] = x;
      if (x > high[axis]) high[axis] = x;
    }
    const [width, y, z] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
    this.centre = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
    this.scale = 1 / (Math.hypot(width, y, z) / 2 || 1);
    [this.axisY, this.axisZ, this.signY] = up === 'z' ? [1, 2, 1] : [2, 1, -1];
    this.floor = (-{ y, z }[up] * this.scale) / 2;
  }

  /** The net's, in the order of the scene's. */
  get axes(): readonly string[] {
    return ['x', 'xyz'[this.axisY]!, 'xyz'[this.axisZ]!];
  }

  toScene(p: Point, place: readonly [number, number, number]): void {
    const { centre, scale, axisY, axisZ, signY } = this;
    p.x = (place[0] - centre[0]) * scale;
    p.y = (place[axisY] - centre[axisY]) * scale * signY;
    p.z = (place[axisZ] - centre[axisZ]) * scale;
  }

  toNet(p: Point): Vec3 {
    const { centre, scale, axisY, axisZ, signY } = this;
    const place: Vec3 = [...centre];
    place[0] += p.x / scale;
    place[axisY] += (signY * p.y) / scale;
    place[axisZ] += p.z / scale;
    return place;
  }
}

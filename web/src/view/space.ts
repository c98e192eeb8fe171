/** The scene's own coordinates: the rest net's box centred at the origin, its half diagonal 1 long. Nets of any size and place
 *  then look alike to camera, ground and markers, and single precision on the graphics card is enough. */
import type { Vec3 } from '../document/document';

export class Space {
  private constructor(
    readonly centre: Vec3,
    /** Scene length of one unit of the net. */
    readonly scale: number,
    /** Height of the lowest point of the rest net, in the scene. */
    readonly floor: number,
  ) {}

  static of(positions: Float64Array): Space {
    const low: Vec3 = [Infinity, Infinity, Infinity];
    const high: Vec3 = [-Infinity, -Infinity, -Infinity];
    positions.forEach((x, i) => {
      const axis = (i % 3) as 0 | 1 | 2;
      if (x < low[axis]) low[axis] = x;
      if (x > high[axis]) high[axis] = x;
    });
    const half = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1;
    const centre: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
    return new Space(centre, 1 / half, (low[2] - centre[2]) / half);
  }

  toScene(p: { x: number; y: number; z: number }, [x, y, z]: readonly [number, number, number]): void {
    p.x = (x - this.centre[0]) * this.scale;
    p.y = (y - this.centre[1]) * this.scale;
    p.z = (z - this.centre[2]) * this.scale;
  }

  toNet(p: { x: number; y: number; z: number }): Vec3 {
    return [
      p.x / this.scale + this.centre[0],
      p.y / this.scale + this.centre[1],
      p.z / this.scale + this.centre[2],
    ];
  }
}

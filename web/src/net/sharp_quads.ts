/** The quads of a net that are sheared too far: with a corner below a limit. */
import type { Faces } from './fold';

type Corners = Pick<Faces, 'faceStart' | 'faceVertices'>;

const DEGREES = 180 / Math.PI;

/** @param limit in degrees. */
export function sharpQuads(net: Corners, positions: Float64Array, limit: number): Set<number> {
  const sharp = new Set<number>();
  for (let face = 0; face + 1 < net.faceStart.length; face++)
    if (isSharpQuad(net, positions, limit, face)) sharp.add(face);
  return sharp;
}

export function isSharpQuad(net: Corners, positions: Float64Array, limit: number, face: number): boolean {
  const { faceStart, faceVertices } = net;
  const from = faceStart[face]!;
  if (faceStart[face + 1]! - from !== 4) return false;
  const most = Math.cos(limit / DEGREES);
  for (let k = 0; k < 4; k++) {
    const [next, last] = [(k + 1) % 4, (k + 3) % 4];
    const cosine = cornerCosine(
      positions,
      faceVertices[from + k]!,
      faceVertices[from + next]!,
      faceVertices[from + last]!,
    );
    // A side without length has no angle: the quad is closed.
    if (!(cosine <= most)) return true;
  }
  return false;
}

/** Of the angle at a vertex between two others. */
function cornerCosine(positions: Float64Array, corner: number, next: number, last: number): number {
  let [along, u, v] = [0, 0, 0];
  for (let k = 0; k < 3; k++) {
    const from = positions[3 * corner + k]!;
    const a = positions[3 * next + k]! - from;
    const b = positions[3 * last + k]! - from;
    along += a * b;
    u += a * a;
    v += b * b;
  }
  return along / Math.sqrt(u * v);
}

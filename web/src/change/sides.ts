/** What of a net lies on the sides of a line. */
import { type Faces, facePairs } from '../net/fold';
import { setsOf } from '../net/pieces';

/** The parts of the net that meet at a line of edges once these are cut, each by its faces, the largest first; of equal ones
 *  that with the first face, as in core/change/delete_faces.cpp. Fewer than two: the line does not part the net. */
export function sidesOf(net: Faces, line: readonly number[]): number[][] {
  const pairs = facePairs(net);
  const isCut = new Set(line);
  const part = setsOf(net.faceStart.length - 1, (join) => {
    for (let edge = 0; 2 * edge < pairs.length; edge++)
      if (!isCut.has(edge) && pairs[2 * edge + 1]! >= 0) join(pairs[2 * edge]!, pairs[2 * edge + 1]!);
  });
  const sides = new Map<number, number[]>();
  for (const edge of line)
    for (const face of pairs.subarray(2 * edge, 2 * edge + 2)) if (face >= 0) sides.set(part[face]!, []);
  part.forEach((each, face) => sides.get(each)?.push(face));
  return [...sides.values()].sort((a, b) => b.length - a.length || a[0]! - b[0]!);
}

/** By vertex, 0 where it goes with these faces, 1 where it stays. */
export function stayingWithout({ faceStart, faceVertices }: Faces, faces: readonly number[]): Float32Array {
  const goes = new Set(faces);
  const stays = new Float32Array(faceVertices.reduce((most, vertex) => Math.max(most, vertex), 0) + 1);
  for (let face = 0; face + 1 < faceStart.length; face++)
    if (!goes.has(face)) for (const v of faceVertices.subarray(faceStart[face], faceStart[face + 1])) stays[v] = 1;
  return stays;
}

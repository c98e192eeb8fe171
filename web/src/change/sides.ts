/** What of a net lies on the sides of a line. */
import { edgeFinder } from '../net/families';
import type { Faces } from '../net/fold';
import { setsOf } from '../net/pieces';

/** The parts of the net that meet at a line of edges once these are cut, each by its faces, the largest first; of equal ones
 *  that with the first face, as in core/change/delete_faces.cpp. Fewer than two: the line does not part the net. */
export function sidesOf(net: Faces, line: readonly number[]): number[][] {
  const facesOf = facesOfEdges(net);
  const isCut = new Set(line);
  const part = setsOf(net.faceStart.length - 1, (join) =>
    facesOf.forEach((faces, edge) => {
      if (!isCut.has(edge)) faces.forEach((face) => join(faces[0]!, face));
    }),
  );
  const sides = new Map<number, number[]>();
  for (const edge of line) for (const face of facesOf[edge]!) sides.set(part[face]!, []);
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

function facesOfEdges({ edges, faceStart, faceVertices }: Faces): number[][] {
  const edgeBetween = edgeFinder(edges);
  const faces: number[][] = Array.from({ length: edges.length / 2 }, () => []);
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const corners = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    corners.forEach((vertex, k) => faces[edgeBetween(corners.at(k - 1)!, vertex)]!.push(face));
  }
  return faces;
}

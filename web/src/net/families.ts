/** Warp and weft: the two families of net lines, as core/net/families.h has them. */
import type { Faces } from './fold';

/** Whether there are two: all faces are quads, and no edge would have to be of the family of one that it meets in a quad. */
export function hasTwoFamilies({ edges, faceStart, faceVertices }: Faces): boolean {
  const edgeBetween = edgeFinder(edges);
  // Of each edge what is so if it is warp, and what if it is weft.
  const joined = Int32Array.from(edges, (_, place) => place);
  const root = (place: number): number => {
    while (joined[place] !== place) place = joined[place] = joined[joined[place]!]!;
    return place;
  };
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const start = faceStart[face]!;
    if (faceStart[face + 1]! - start !== 4) return false;
    const corner = (k: number) => faceVertices[start + (k % 4)]!;
    for (let k = 0; k < 4; k++) {
      const [a, b] = [edgeBetween(corner(k), corner(k + 1)), edgeBetween(corner(k + 1), corner(k + 2))];
      joined[root(2 * a)] = root(2 * b + 1);
      joined[root(2 * a + 1)] = root(2 * b);
    }
  }
  return edges.every((_, place) => root(place) !== root(place ^ 1));
}

/** The number of the edge between two vertices. */
function edgeFinder(edges: Int32Array): (a: number, b: number) => number {
  const vertices = 1 + edges.reduce((most, vertex) => Math.max(most, vertex), 0);
  const key = (a: number, b: number) => vertices * Math.min(a, b) + Math.max(a, b);
  const numbers = new Map<number, number>();
  for (let e = 0; 2 * e < edges.length; e++) numbers.set(key(edges[2 * e]!, edges[2 * e + 1]!), e);
  return (a, b) => numbers.get(key(a, b))!;
}

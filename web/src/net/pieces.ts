/** What hangs together. */
import type { Faces } from './fold';

type FaceCorners = Pick<Faces, 'faceStart' | 'faceVertices'>;

/** The pieces of a net, which share no vertex, each by its faces; in the order of their first faces, as files number them. */
export function facesOfPieces(net: FaceCorners): number[][] {
  const { faceStart, faceVertices } = net;
  const set = piecesOfVertices(net);
  const pieces = new Map<number, number[]>();
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const piece = set[faceVertices[faceStart[face]!]!]!;
    const faces = pieces.get(piece);
    if (faces) faces.push(face);
    else pieces.set(piece, [face]);
  }
  return [...pieces.values()];
}

/** Of each vertex the first one of its piece. */
export function piecesOfVertices({ faceStart, faceVertices }: FaceCorners): Int32Array {
  const vertices = faceVertices.reduce((most, vertex) => Math.max(most, vertex), -1) + 1;
  return setsOf(vertices, (join) => {
    for (let face = 0; face + 1 < faceStart.length; face++)
      for (const vertex of faceVertices.subarray(faceStart[face], faceStart[face + 1]))
        join(faceVertices[faceStart[face]!]!, vertex);
  });
}

/** Of each thing the first that it is joined with. */
export function setsOf(count: number, joinAll: (join: (a: number, b: number) => void) => void): Int32Array {
  const joined = Int32Array.from({ length: count }, (_, thing) => thing);
  const root = (thing: number): number => {
    while (joined[thing] !== thing) thing = joined[thing] = joined[joined[thing]!]!;
    return thing;
  };
  joinAll((a, b) => {
    const [first, second] = [root(a), root(b)];
    joined[Math.max(first, second)] = Math.min(first, second);
  });
  return joined.map((thing) => root(thing));
}

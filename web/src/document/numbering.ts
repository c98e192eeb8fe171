/**
 * How a net is numbered. Positions, handles and history belong to vertices and edges by their number, which follows from the
 * text of a file or a recipe by way of the core. What is kept says therefore how the net was numbered; a net that comes out
 * numbered otherwise is refused, for everything would belong to wrong vertices.
 */

/** The part of an opened net that its numbering shows in. */
interface NumberedNet {
  edges: Int32Array;
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

/** 32 bits that differ if the numbering does: FNV-1a, of 32-bit words. */
export function numberingOf({ edges, faceStart, faceVertices }: NumberedNet): number {
  let hash = 0x811c9dc5;
  for (const numbers of [edges, faceStart, faceVertices]) {
    for (let i = 0; i < numbers.length; ++i) hash = Math.imul(hash ^ numbers[i]!, 0x01000193);
  }
  return hash >>> 0;
}

/** Triangles that the page draws, three vertices each; computed in the worker so as not to block the page. */

/** Fans from the first vertex of each face. */
export function fanTriangles(faceStart: Int32Array, faceVertices: Int32Array): Uint32Array<ArrayBuffer> {
  const faces = faceStart.length - 1;
  const triangles = new Uint32Array(3 * (faceVertices.length - 2 * faces));
  let to = 0;
  for (let face = 0; face < faces; face++) {
    const first = faceStart[face]!;
    const end = faceStart[face + 1]!;
    for (let corner = first + 1; corner + 1 < end; corner++) {
      triangles[to++] = faceVertices[first]!;
      triangles[to++] = faceVertices[corner]!;
      triangles[to++] = faceVertices[corner + 1]!;
    }
  }
  return triangles;
}

/** An edge is drawn as a strip of four vertices: two triangles for each of `count` edges. */
export function stripTriangles(count: number): Uint32Array<ArrayBuffer> {
  const triangles = new Uint32Array(6 * count);
  for (let at = 0, first = 0; at < triangles.length; at += 6, first += 4) {
    triangles[at] = first;
    triangles[at + 1] = triangles[at + 4] = first + 1;
    triangles[at + 2] = triangles[at + 3] = first + 2;
    triangles[at + 5] = first + 3;
  }
  return triangles;
}

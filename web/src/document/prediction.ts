/** Whole coordinates of a net predicted one after another, so that only how far that is off has to be written. */

/** Both who writes and who reads must have the same, numbered alike (numbering.ts). */
export interface Connectivity {
  vertices: number;
  edges: Int32Array;
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

/** Every vertex after some of its neighbours, and what of the net is known by then. */
interface Walk {
  order: number[];
  /** For each vertex, of the quads that it completes: the opposite corner and the two others, one quad after another. */
  corners: number[][];
  /** For each vertex, the neighbours known before it. */
  neighbours: number[][];
}

/**
 * Calls `code` for every coordinate, axis by axis, with its prediction; `code` returns the true value. A vertex that completes
 * a quad is expected to complete a parallelogram, up to what the parallelograms beside it missed.
 */
export function forEachPrediction(net: Connectivity, code: (i: number, prediction: number) => number): void {
  const { order, corners, neighbours } = makeWalk(net);
  for (let axis = 0; axis < 3; ++axis) {
    const value = new Float64Array(order.length);
    const missed = new Float64Array(order.length);
    for (const vertex of order) {
      const quads = corners[vertex] ?? [];
      const plain = quads.length > 0 ? completed(quads, value) : mean(neighbours[vertex] ?? [], value);
      const prediction = Math.round(plain + (quads.length > 0 ? besides(quads, missed) : 0));
      const actual = code(3 * vertex + axis, prediction);
      value[vertex] = actual;
      if (quads.length > 0) missed[vertex] = actual - plain;
    }
  }
}

function completed(corners: readonly number[], value: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < corners.length; k += 3) {
    sum += at(value, corners[k + 1]) + at(value, corners[k + 2]) - at(value, corners[k]);
  }
  return (3 * sum) / corners.length;
}

function besides(corners: readonly number[], missed: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < corners.length; k += 3) sum += at(missed, corners[k + 1]) + at(missed, corners[k + 2]);
  return (1.5 * sum) / corners.length;
}

function mean(vertices: readonly number[], value: Float64Array): number {
  const sum = vertices.reduce((total, vertex) => total + at(value, vertex), 0);
  return vertices.length > 0 ? sum / vertices.length : 0;
}

function at(values: Float64Array, index: number | undefined): number {
  return (index === undefined ? undefined : values[index]) ?? 0;
}

/** Breadth first along edges, component by component. */
function makeWalk(net: Connectivity): Walk {
  const count = net.vertices;
  const adjacent = neighboursOf(net, count);
  const rank = new Int32Array(count).fill(-1);
  const order: number[] = [];
  for (let seed = 0, next = 0; seed < count; ++seed) {
    if (rank[seed] === -1) rank[seed] = order.push(seed) - 1;
    for (; next < order.length; ++next) {
      for (const vertex of adjacent[order[next] ?? 0] ?? []) {
        if (rank[vertex] === -1) rank[vertex] = order.push(vertex) - 1;
      }
    }
  }
  const rankOf = (vertex: number): number => rank[vertex] ?? 0;
  const neighbours = adjacent.map((near, vertex) => near.filter((other) => rankOf(other) < rankOf(vertex)));
  return { order, corners: cornersOf(net, rankOf, count), neighbours };
}

function neighboursOf({ edges }: Connectivity, count: number): number[][] {
  const adjacent: number[][] = Array.from({ length: count }, () => []);
  for (let e = 0; e < edges.length; e += 2) {
    const a = edges[e] ?? 0;
    const b = edges[e + 1] ?? 0;
    adjacent[a]?.push(b);
    adjacent[b]?.push(a);
  }
  return adjacent;
}

function cornersOf(
  { faceStart, faceVertices }: Connectivity,
  rankOf: (vertex: number) => number,
  count: number,
): number[][] {
  const corners: number[][] = Array.from({ length: count }, () => []);
  for (let face = 0; face + 1 < faceStart.length; ++face) {
    const quad = faceVertices.subarray(faceStart[face], faceStart[face + 1]);
    if (quad.length !== 4) continue;
    const last = quad.reduce((latest, vertex, k) => (rankOf(vertex) > rankOf(quad[latest] ?? 0) ? k : latest), 0);
    const corner = (turn: number): number => quad[(last + turn) % 4] ?? 0;
    corners[corner(0)]?.push(corner(2), corner(1), corner(3));
  }
  return corners;
}

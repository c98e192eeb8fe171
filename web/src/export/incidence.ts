/** Who meets whom in a net. */
import type { OpenedNet } from '../worker/protocol';

export type NetMesh = Pick<OpenedNet, 'edges' | 'faceStart' | 'faceVertices'>;

export interface Incidence {
  /** The edges at each vertex. */
  vertexEdges: number[][];
  /** Both faces at each edge; the second is -1 on the boundary. */
  edgeFaces: Int32Array;
  /** In the order of `faceVertices`: the edge from each corner to the next one of its face. */
  cornerEdges: Int32Array;
}

export function incidenceOf({ edges, faceStart, faceVertices }: NetMesh): Incidence {
  const vertexEdges: number[][] = [];
  for (let i = 0; i < edges.length; i++) (vertexEdges[edges[i]!] ??= []).push(i >> 1);
  const edgeFaces = new Int32Array(edges.length).fill(-1);
  const cornerEdges = new Int32Array(faceVertices.length);
  for (let face = 0; face + 1 < faceStart.length; face++) {
    const [start, end] = [faceStart[face]!, faceStart[face + 1]!];
    for (let corner = start; corner < end; corner++) {
      const next = corner + 1 < end ? corner + 1 : start;
      const edge = edgeBetween(faceVertices[corner]!, faceVertices[next]!, edges, vertexEdges);
      cornerEdges[corner] = edge;
      edgeFaces[edgeFaces[2 * edge] === -1 ? 2 * edge : 2 * edge + 1] = face;
    }
  }
  return { vertexEdges, edgeFaces, cornerEdges };
}

/** Whether the edge between two neighbours has one face only. */
export function onBoundary(a: number, b: number, { edges }: NetMesh, { vertexEdges, edgeFaces }: Incidence): boolean {
  return edgeFaces[2 * edgeBetween(a, b, edges, vertexEdges) + 1] === -1;
}

function edgeBetween(a: number, b: number, edges: Int32Array, vertexEdges: number[][]): number {
  return vertexEdges[a]!.find((edge) => edges[2 * edge] === b || edges[2 * edge + 1] === b)!;
}

/** A net laid flat: where no vertex is singular, a Chebyshev net is a piece of the square grid. */
import type { Incidence, NetMesh } from './incidence';

export type LengthNet = NetMesh & { restLengths: Float64Array };

/** Why a net has no flat pattern. */
export type PatternFault =
  | { reason: 'not_quads'; face: number }
  | { reason: 'unequal' }
  | { reason: 'singular'; vertex: number; valence: number }
  /** Two ways to the vertex lead to two places. */
  | { reason: 'closed'; vertex: number }
  /** The face would lie upon another one. */
  | { reason: 'overlap'; face: number }
  | { reason: 'pieces' };

export interface FlatPattern {
  /** Column and row of each vertex, from 0; rows count upwards, and the first face is seen from its front. */
  places: Int32Array;
  columns: number;
  rows: number;
}

/** Rest lengths that differ by less than this share are one length. */
const EQUAL = 1e-6;

export function flatten(net: LengthNet, incidence: Incidence): FlatPattern | PatternFault {
  return unfit(net, incidence) ?? new Layout(net, incidence).spread();
}

function unfit({ faceStart, restLengths }: LengthNet, incidence: Incidence): PatternFault | null {
  const face = faceStart.findIndex((start, f) => f + 1 < faceStart.length && faceStart[f + 1]! - start !== 4);
  if (face !== -1) return { reason: 'not_quads', face };
  const [first = NaN] = restLengths;
  if (!restLengths.every((length) => Math.abs(length - first) <= EQUAL * first)) return { reason: 'unequal' };
  return singularVertex(incidence);
}

function singularVertex({ vertexEdges, edgeFaces }: Incidence): PatternFault | null {
  for (const [vertex, around] of vertexEdges.entries()) {
    const inside = around.every((edge) => edgeFaces[2 * edge + 1] !== -1);
    if (inside && around.length !== 4) return { reason: 'singular', vertex, valence: around.length };
  }
  return null;
}

/** A step across an edge: column and row. */
type Step = readonly [number, number];

/** Faces as squares in the plane, each laid beside the one before. Corner `k` of a face counts round and round. */
class Layout {
  private readonly places: Int32Array;
  private readonly isPlaced: Uint8Array;
  /** Where there is a face: twice the middle of its square. */
  private readonly cells = new Set<string>();
  private readonly isLaid: Uint8Array;

  constructor(
    private readonly net: NetMesh,
    private readonly incidence: Incidence,
  ) {
    this.places = new Int32Array(2 * incidence.vertexEdges.length);
    this.isPlaced = new Uint8Array(incidence.vertexEdges.length);
    this.isLaid = new Uint8Array(net.faceStart.length - 1);
  }

  spread(): FlatPattern | PatternFault {
    this.put(this.vertex(0, 0), 0, 0);
    this.put(this.vertex(0, 1), 1, 0);
    const faces = [0];
    let fault = this.lay(0, 0, [0, 1]);
    for (const face of faces) {
      for (const k of [0, 1, 2, 3]) {
        const edge = this.edge(face, k);
        const next = this.beyond(edge, face);
        if (next === -1 || this.isLaid[next]) continue;
        fault ??= this.lay(next, this.cornerAt(next, edge), this.outwards(face, k));
        faces.push(next);
      }
      if (fault) return fault;
    }
    return faces.length < this.isLaid.length ? { reason: 'pieces' } : fromZero(this.places);
  }

  /** Lays a face so that it reaches by `step` from the edge at corner `k`, which has its place. */
  private lay(face: number, k: number, step: Step): PatternFault | null {
    const [a, b, c, d] = [0, 1, 2, 3].map((i) => this.vertex(face, k + i)) as [number, number, number, number];
    for (const [vertex, below] of [
      [d, a],
      [c, b],
    ] as const) {
      const [x, y] = this.place(below);
      if (!this.put(vertex, x + step[0], y + step[1])) return { reason: 'closed', vertex };
    }
    const [[x, y], [oppositeX, oppositeY]] = [this.place(a), this.place(c)];
    const middle = `${x + oppositeX},${y + oppositeY}`;
    if (this.cells.has(middle)) return { reason: 'overlap', face };
    this.cells.add(middle);
    this.isLaid[face] = 1;
    return null;
  }

  /** False if the vertex has another place. */
  private put(vertex: number, x: number, y: number): boolean {
    if (this.isPlaced[vertex]) return this.places[2 * vertex] === x && this.places[2 * vertex + 1] === y;
    this.isPlaced[vertex] = 1;
    this.places.set([x, y], 2 * vertex);
    return true;
  }

  private place(vertex: number): Step {
    return [this.places[2 * vertex]!, this.places[2 * vertex + 1]!];
  }

  private vertex(face: number, k: number): number {
    return this.net.faceVertices[4 * face + (k % 4)]!;
  }

  /** From corner `k` to the next one. */
  private edge(face: number, k: number): number {
    return this.incidence.cornerEdges[4 * face + (k % 4)]!;
  }

  private cornerAt(face: number, edge: number): number {
    return [0, 1, 2, 3].find((k) => this.edge(face, k) === edge)!;
  }

  /** The other face at an edge, -1 on the boundary. */
  private beyond(edge: number, face: number): number {
    const { edgeFaces } = this.incidence;
    return edgeFaces[2 * edge] === face ? edgeFaces[2 * edge + 1]! : edgeFaces[2 * edge]!;
  }

  /** The step out of a face across its edge at corner `k`. */
  private outwards(face: number, k: number): Step {
    const [[x, y], [fromX, fromY]] = [this.place(this.vertex(face, k)), this.place(this.vertex(face, k + 3))];
    return [x - fromX, y - fromY];
  }
}

function fromZero(places: Int32Array): FlatPattern {
  const low: [number, number] = [Infinity, Infinity];
  const high: [number, number] = [-Infinity, -Infinity];
  places.forEach((place, i) => {
    const axis = (i % 2) as 0 | 1;
    low[axis] = Math.min(low[axis], place);
    high[axis] = Math.max(high[axis], place);
  });
  return { places: places.map((place, i) => place - low[i % 2]!), columns: high[0] - low[0], rows: high[1] - low[1] };
}

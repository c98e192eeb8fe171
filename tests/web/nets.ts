/** Nets and scenes to try things on. */
import type { Mesh } from '../../wasm/chebnet';
import { DEFAULT_VIEW } from '../../web/src/document/defaults';
import type { ChebnetDocument } from '../../web/src/document/document';
import type { PackingNet } from '../../web/src/document/packing';
import { edgeLengths } from '../../web/src/net/edge_lengths';

/** A flat grid of unit squares, some of them cut into triangles. */
export function grid(columns: number, rows: number, isCut: () => boolean = () => false): PackingNet {
  const restPositions = Float64Array.from({ length: 3 * columns * rows }, (_, i) => {
    const vertex = Math.floor(i / 3);
    return [vertex % columns, Math.floor(vertex / columns), 0][i % 3] ?? 0;
  });
  const faces: number[][] = [];
  for (let row = 0; row + 1 < rows; ++row) {
    for (let column = 0; column + 1 < columns; ++column) {
      const a = row * columns + column;
      const [b, c, d] = [a + 1, a + 1 + columns, a + columns];
      faces.push(
        ...(isCut()
          ? [
              [a, b, c],
              [a, c, d],
            ]
          : [[a, b, c, d]]),
      );
    }
  }
  const found = incidence(faces);
  return { restPositions, restLengths: edgeLengths(restPositions, found.edges), ...found };
}

function incidence(faces: number[][]): Omit<PackingNet, 'restPositions' | 'restLengths'> {
  const edges = new Map<string, number[]>();
  for (const face of faces) {
    face.forEach((a, k) => {
      const edge = [a, face[(k + 1) % face.length] ?? a].sort((x, y) => x - y);
      edges.set(edge.join(), edge);
    });
  }
  const starts = [0];
  for (const face of faces) starts.push((starts.at(-1) ?? 0) + face.length);
  return {
    edges: Int32Array.from([...edges.values()].flat()),
    faceStart: Int32Array.from(starts),
    faceVertices: Int32Array.from(faces.flat()),
  };
}

/** A document of a net that stands at `positions`. */
export function documentAt(positions: Float64Array | null): ChebnetDocument {
  return {
    net: { recipe: 'vault:vertices=1000' },
    handles: [],
    method: 'li2022',
    initialisation: 'naive',
    options: {},
    view: DEFAULT_VIEW,
    positions,
    settled: true,
  };
}

/** OBJ text of a bent sheet of quads whose edges differ in length. */
export function uneven(columns: number, rows: number): string {
  const lines: string[] = [];
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const [x, y] = [i + 0.25 * Math.sin(3 * i + 2 * j), j + 0.25 * Math.cos(2 * i - 3 * j)];
      lines.push(`v ${x} ${y} ${Math.sin(x / 3) * Math.cos(y / 4)}`);
    }
  }
  for (let j = 0; j + 1 < rows; ++j) {
    for (let i = 0; i + 1 < columns; ++i) {
      const a = j * columns + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + 1 + columns} ${a + columns}`);
    }
  }
  return [...lines, ''].join('\n');
}

/** A mesh of a thousand by a thousand vertices. */
export function million(): Mesh {
  const side = 1000;
  const corners = Array.from({ length: side - 1 }, (_, row) =>
    Array.from({ length: side - 1 }, (_, column) => {
      const a = row * side + column;
      return [a, a + 1, a + 1 + side, a + side];
    }),
  ).flat();
  return {
    positions: Float64Array.from({ length: 3 * side * side }, (_, i) => Math.sin(i)),
    faceStart: Int32Array.from({ length: corners.length + 1 }, (_, i) => 4 * i),
    faceVertices: Int32Array.from(corners.flat()),
  };
}

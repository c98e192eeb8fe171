/** The edges of a net as a table for other programs: numbers in full precision, vertices from 0, one header line. */
import { edgeLengths } from './edge_lengths';

interface Edges {
  /** 2 vertices an edge. */
  edges: Int32Array;
  /** The length each edge is to keep. */
  restLengths: Float64Array;
}

/** One line an edge. `deviation` is dL, see core/net/measures.h. */
export function edgesCsv({ edges, restLengths }: Edges, positions: Float64Array): string {
  const lines = Array.from(edgeLengths(positions, edges), (length, e) => {
    const ratio = length / (restLengths[e] ?? NaN);
    return [e, edges[2 * e], edges[2 * e + 1], length, restLengths[e], (ratio - 1) ** 2 / ratio].join(',');
  });
  return ['edge,vertex_a,vertex_b,length,rest_length,deviation', ...lines, ''].join('\n');
}

/** A part of the net that is shown alone. */
import type { OpenedNet } from '../worker/protocol';
import { fanTriangles } from '../worker/triangles';
import { verticesAround } from './around';
import { listsOf } from './lines';

export interface Part {
  /** By vertex, 1 where it is hidden. */
  hidden: Uint8Array;
  /** What is drawn of its faces; see OpenedNet. */
  triangles: Uint32Array<ArrayBuffer>;
}

/** The faces that touch what is around the origins within one edge less than the radius: so far they reach themselves. */
export function partAround(net: OpenedNet, origins: readonly number[], radius: number): Part {
  const touched = new Set(verticesAround(net, origins, radius - 1));
  const faces = listsOf({ start: net.faceStart, vertices: net.faceVertices });
  const shown = faces.filter((face) => face.some((vertex) => touched.has(vertex)));
  const corners = shown.flatMap((face) => [...face]);
  const hidden = new Uint8Array(net.info.vertices).fill(1);
  for (const vertex of [...origins, ...corners]) hidden[vertex] = 0;
  const starts = [0];
  for (const { length } of shown) starts.push(starts.at(-1)! + length);
  return { hidden, triangles: fanTriangles(Int32Array.from(starts), Int32Array.from(corners)) };
}

/** Blends of two shapes of a net, as frames for a view. */
import type { CoreFields } from '../../../wasm/chebnet';
import { deviation, edgeLengths } from '../net/edge_lengths';
import type { FrameData, OpenedNet } from '../worker/protocol';

/** Positions, and the length against which edges are coloured. */
export interface Shape {
  positions: Float64Array;
  length: number;
}

/** `share` 0 is the first shape, 1 the second. */
export function between(first: Shape, second: Shape, share: number): Shape {
  const mix = (a: number, b: number): number => (1 - share) * a + share * b;
  if (share === 0) return first;
  if (share === 1) return second;
  return {
    positions: first.positions.map((x, i) => mix(x, second.positions[i] ?? x)),
    length: mix(first.length, second.length),
  };
}

export function meanLength(positions: Float64Array, { edges }: Pick<OpenedNet, 'edges'>): number {
  const lengths = edgeLengths(positions, edges);
  return lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
}

/** A frame that is not from the solver, to be coloured by its deviations. */
export function stillFrame({ positions, length }: Shape, { edges }: Pick<OpenedNet, 'edges'>): FrameData {
  const deviations = Float32Array.from(edgeLengths(positions, edges), (each) => deviation(each / length));
  return {
    positions,
    lengthScale: 1,
    fields: { deviation: deviations } as CoreFields,
    maxDeviation: deviations.reduce((most, dL) => Math.max(most, dL), 0),
    handles: [],
    holdsBack: false,
    fellShort: false,
    status: 'running',
    iterations: 0,
    milliseconds: 0,
    stage: 0,
    method: '',
    trace: [],
    toRest: null,
    stepFrom: null,
    unreachable: [],
    memory: 0,
  };
}

/** Packed positions: what is packed comes back nearly; anything else is positions that are numbers, or a Failure. */
import fc from 'fast-check';
import { expect } from 'vitest';
import { packPositions, unpackPositions } from '../../../web/src/document/packing';
import { Failure } from '../../../web/src/failure';
import type { PackingNet } from '../../../web/src/document/packing';
import { grid } from '../../web/nets';
import { attack, attacks } from './attack';

const anyNet: fc.Arbitrary<PackingNet> = fc
  .tuple(fc.integer({ min: 2, max: 6 }), fc.integer({ min: 2, max: 6 }), fc.array(fc.boolean(), { maxLength: 25 }))
  .map(([columns, rows, cuts]) => grid(columns, rows, () => cuts.pop() ?? false));

function unpacked(packed: Uint8Array, net: PackingNet): Float64Array | null {
  try {
    return unpackPositions(packed, net);
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return null;
  }
}

function checkUnpacked(packed: Uint8Array, net: PackingNet): void {
  expect(unpacked(packed, net)?.every(Number.isFinite) ?? true).toBe(true);
}

function withStep(step: number, bytes: Uint8Array): Uint8Array {
  const start = new DataView(new ArrayBuffer(8));
  start.setFloat64(0, step, true);
  return Uint8Array.of(...new Uint8Array(start.buffer), ...bytes);
}

const moves = fc.array(fc.double({ min: -1000, max: 1000, noNaN: true }), { minLength: 108, maxLength: 108 });
/** Integers of one byte for every coordinate of the largest net. */
const small = fc.uint8Array({ minLength: 108, maxLength: 108, max: 127 });
const bytes = fc.uint8Array({ maxLength: 200 });

attacks('packed positions', {
  'positions come back': attack(fc.tuple(anyNet, moves), ([net, by]) => {
    const positions = net.restPositions.map((x, i) => x + (by[i] ?? 0));
    const again = unpackPositions(packPositions(positions, net, 1e-6), net);
    expect(Math.max(...again.map((x, i) => Math.abs(x - (positions[i] ?? NaN))))).toBeLessThan(1e-4);
  }),
  'any bytes': attack(fc.tuple(anyNet, bytes), ([net, packed]) => checkUnpacked(packed, net)),
  'a step of any size': attack(fc.tuple(anyNet, fc.double(), bytes), ([net, step, rest]) =>
    checkUnpacked(withStep(step, rest), net),
  ),
  'a step of any size and as many integers as coordinates': attack(
    fc.tuple(anyNet, fc.double(), small),
    ([net, step, rest]) => {
      checkUnpacked(withStep(step, rest.subarray(0, net.restPositions.length)), net);
    },
  ),
});

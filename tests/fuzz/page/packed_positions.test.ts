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

/** Columns, rows and which squares are cut in six bytes; behind them what is said to be its positions. */
const NET_BYTES = 6;

function netOf([columns = 0, rows = 0, ...cuts]: Uint8Array): PackingNet {
  let square = 0;
  const isCut = () => ((cuts[square >> 3] ?? 0) & (1 << (square++ & 7))) !== 0;
  return grid(2 + (columns % 5), 2 + (rows % 5), isCut);
}

function checkUnpacked(file: Uint8Array): void {
  try {
    expect(unpackPositions(file.subarray(NET_BYTES), netOf(file.subarray(0, NET_BYTES))).every(Number.isFinite)).toBe(
      true,
    );
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
  }
}

const netBytes = fc.uint8Array({ minLength: NET_BYTES, maxLength: NET_BYTES });

/** @param most integers, as many as the net has coordinates if there are enough. */
function withStep(net: Uint8Array, step: number, most: Uint8Array): Uint8Array {
  const start = new DataView(new ArrayBuffer(8));
  start.setFloat64(0, step, true);
  return Uint8Array.of(...net, ...new Uint8Array(start.buffer), ...most);
}

const moves = fc.array(fc.double({ min: -1000, max: 1000, noNaN: true }), { minLength: 108, maxLength: 108 });
/** Integers of one byte for every coordinate of the largest net. */
const small = fc.uint8Array({ minLength: 108, maxLength: 108, max: 127 });
const bytes = fc.uint8Array({ maxLength: 200 });

attacks(
  'packed positions',
  { folder: 'packed_positions', holds: checkUnpacked },
  {
    'positions come back': attack(fc.tuple(anyNet, moves), ([net, by]) => {
      const positions = net.restPositions.map((x, i) => x + (by[i] ?? 0));
      const again = unpackPositions(packPositions(positions, net, 1e-6), net);
      expect(Math.max(...again.map((x, i) => Math.abs(x - (positions[i] ?? NaN))))).toBeLessThan(1e-4);
    }),
    'any bytes': attack(bytes, checkUnpacked),
    'a step of any size': attack(
      fc.tuple(netBytes, fc.double(), bytes).map(([net, step, rest]) => withStep(net, step, rest)),
      checkUnpacked,
    ),
    'a step of any size and as many integers as coordinates': attack(
      fc
        .tuple(netBytes, fc.double(), small)
        .map(([net, step, rest]) => withStep(net, step, rest.subarray(0, netOf(net).restPositions.length))),
      checkUnpacked,
    ),
  },
);

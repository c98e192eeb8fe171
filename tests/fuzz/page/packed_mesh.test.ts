/** Packed meshes: what is packed comes back nearly; anything else is a mesh of numbers, or a Failure. */
import fc from 'fast-check';
import { expect } from 'vitest';
import { packMesh, unpackMesh } from '../../../web/src/document/packed_mesh';
import { Failure } from '../../../web/src/failure';
import { grid } from '../../web/nets';
import { attack, attacks } from './attack';
import { mesh } from './scenes';

function checkUnpacked(file: Uint8Array): void {
  try {
    const { positions, faceVertices } = unpackMesh(file);
    expect(positions.every(Number.isFinite)).toBe(true);
    expect(faceVertices.every((vertex) => vertex < positions.length / 3)).toBe(true);
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
  }
}

const sound = fc
  .tuple(
    fc.tuple(fc.integer({ min: 2, max: 6 }), fc.integer({ min: 2, max: 6 }), fc.array(fc.boolean(), { maxLength: 25 })),
    fc.array(fc.double({ min: -0.4, max: 0.4, noNaN: true }), { minLength: 108, maxLength: 108 }),
    fc.constantFrom(1e-7, 1e-4),
  )
  .map(([[columns, rows, cuts], moves, precision]) => {
    const { restPositions, faceStart, faceVertices } = grid(columns, rows, () => cuts.pop() ?? false);
    const positions = restPositions.map((x, i) => x + (moves[i] ?? 0));
    return { mesh: { positions, faceStart, faceVertices }, precision };
  });

const packed = sound.map(({ mesh: given, precision }) => packMesh(given, precision) ?? new Uint8Array());
const hit = fc.record({ at: fc.nat(), byte: fc.nat(255) });

attacks(
  'packed meshes',
  { folder: 'packed_mesh', holds: checkUnpacked },
  {
    'a mesh comes back': attack(sound, ({ mesh: given, precision }) => {
      const bytes = packMesh(given, precision);
      // Two vertices may have come too near to each other.
      if (bytes === null) return;
      const again = unpackMesh(bytes);
      expect(again).toMatchObject({ faceStart: given.faceStart, faceVertices: given.faceVertices });
      const apart = again.positions.map((x, i) => Math.abs(x - (given.positions[i] ?? NaN)));
      expect(Math.max(...apart)).toBeLessThan(2 * precision);
    }),
    'any mesh': attack(mesh, (given) => {
      const bytes = packMesh(given, 1e-4);
      if (bytes) checkUnpacked(bytes);
    }),
    'any bytes': attack(fc.uint8Array({ maxLength: 200 }), checkUnpacked),
    'damaged bytes': attack(fc.tuple(packed, fc.array(hit, { minLength: 1, maxLength: 3 })), ([bytes, hits]) => {
      const damaged = Uint8Array.from(bytes);
      for (const { at, byte } of hits) damaged[at % damaged.length] = byte;
      checkUnpacked(damaged);
    }),
  },
);

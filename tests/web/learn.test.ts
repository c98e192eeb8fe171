import { expect, test } from 'vitest';
import { energy, worstRatio } from '../../web/src/net/energy';
import type { FrameData, OpenedNet } from '../../web/src/worker/protocol';

test('the energy of an edge is least where its length is right, and steeper with a larger exponent', () => {
  expect(energy(1, 2)).toBe(2);
  expect(energy(2, 2)).toBe(4.25);
  expect(energy(0.5, 2)).toBe(4.25);
  expect(energy(1.02, 50)).toBeGreaterThan(energy(1.02, 2));
});

test('the worst edge is found, too long or too short', () => {
  const net = { edges: Int32Array.of(0, 1, 1, 2), restLengths: Float64Array.of(1, 2) } as unknown as OpenedNet;
  const frame = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 0, 1),
    lengthScale: 1,
    fields: { deviation: Float32Array.of(0, 0.5) },
  } as unknown as FrameData;
  expect(worstRatio(net, frame)).toBe(0.5);
  expect(worstRatio(net, { ...frame, lengthScale: 2 })).toBe(0.25);
});

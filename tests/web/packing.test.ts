/** Packed positions come back, nearly. */
import { describe, expect, test } from 'vitest';
import { packPositions, unpackPositions } from '../../web/src/document/packing';
import type { PackingNet } from '../../web/src/document/packing';
import { largestDistance, load } from '../wasm/load';
import { grid } from './nets';
import { printedSeed, random } from './random';

const chebnet = await load();

function solved(recipe: string, threshold: number) {
  const editor = chebnet.openRecipe(recipe);
  const handles = Array.from(
    editor.suggestedHandles,
    (vertex): { vertex: number; target: [number, number, number] } => {
      const [x = 0, y = 0, z = 0] = editor.restPositions.subarray(3 * vertex, 3 * vertex + 3);
      return { vertex, target: [x, y, z] };
    },
  );
  const last = handles.at(-1);
  if (last) last.target = [last.target[0] + 0.3, last.target[1] - 0.2, last.target[2] - 0.8];
  editor.setHandles(handles);
  editor.setOption('threshold', threshold);
  const { status } = editor.solve();
  return { editor, status, positions: editor.positions() };
}

describe('a solved net', () => {
  test.each(chebnet.shapes().map(({ name }) => name))('%s comes back within 1e-4 of an edge, and converged', (name) => {
    const threshold = 1e-6;
    const { editor, status, positions } = solved(`${name}:vertices=800`, threshold);
    const packed = packPositions(positions, editor, threshold);
    const unpacked = unpackPositions(packed, editor);
    console.log(`${name}: ${editor.info.vertices} vertices, ${status}, ${packed.length} bytes`);
    expect(largestDistance(unpacked, positions)).toBeLessThan(1e-4 * editor.info.meanLength);
    editor.setPositions(unpacked);
    if (status === 'converged') expect(Math.max(...editor.fields().deviation)).toBeLessThan(threshold);
    editor.dispose();
  });

  test('stays converged below a threshold far tighter than the usual', () => {
    const { editor, status, positions } = solved('vault:vertices=300', 1e-9);
    expect(status).toBe('converged');
    editor.setPositions(unpackPositions(packPositions(positions, editor, 1e-9), editor));
    expect(Math.max(...editor.fields().deviation)).toBeLessThan(1e-9);
    editor.dispose();
  });
});

test('any positions on any net come back within 1e-4 of an edge', () => {
  const next = random(printedSeed('random nets'));
  for (let round = 0; round < 40; ++round) {
    const net = grid(2 + Math.floor(12 * next()), 2 + Math.floor(12 * next()), () => next() < 0.3);
    const size = 10 ** (8 * next() - 4);
    scale(net, size);
    const wild = 10 ** (6 * next() - 3);
    const positions = net.restPositions.map((x) => x + size * wild * (next() - 0.5));
    const unpacked = unpackPositions(packPositions(positions, net, 1e-6), net);
    expect(largestDistance(unpacked, positions)).toBeLessThan(1e-4 * size);
  }
});

test('several components and vertices in any order', () => {
  const left = grid(3, 4);
  const right = grid(4, 3);
  const shift = left.restPositions.length / 3;
  const starts = Array.from(right.faceStart.subarray(1), (start) => start + left.faceVertices.length);
  const net: PackingNet = {
    restPositions: Float64Array.from([...left.restPositions, ...right.restPositions]),
    restLengths: Float64Array.from([...left.restLengths, ...right.restLengths]),
    edges: Int32Array.from([...left.edges, ...right.edges.map((v) => v + shift)]),
    faceStart: Int32Array.from([...left.faceStart, ...starts]),
    faceVertices: Int32Array.from([...left.faceVertices, ...right.faceVertices.map((v) => v + shift)]),
  };
  const positions = net.restPositions.map((x, i) => x + Math.sin(i));
  expect(largestDistance(unpackPositions(packPositions(positions, net, 1e-6), net), positions)).toBeLessThan(1e-4);
});

describe('damage is refused', () => {
  const net = grid(5, 5);
  const packed = packPositions(
    net.restPositions.map((x, i) => x + Math.cos(i)),
    net,
    1e-6,
  );
  const withStep = (step: number) => {
    const bytes = Uint8Array.from(packed);
    new DataView(bytes.buffer).setFloat64(0, step, true);
    return bytes;
  };
  test.each([
    ['nothing', new Uint8Array()],
    ['half a step', packed.subarray(0, 4)],
    ['the end missing', packed.subarray(0, -1)],
    ['something added', Uint8Array.from([...packed, 0])],
    ['a step that is no number', withStep(NaN)],
    ['a step without end', withStep(Infinity)],
    ['a step so long that positions would be infinite', withStep(1e308)],
    ['a step of nothing', withStep(0)],
    ['a step backwards', withStep(-1)],
    ['a number without end', Uint8Array.from([...packed.subarray(0, 8), ...Array(75).fill(255)])],
    [
      'numbers that grow without bound',
      Uint8Array.from([...packed.subarray(0, 8), ...Array(75).fill([254, 255, 255, 255, 255, 255, 127]).flat()]),
    ],
    ['positions of another net', packPositions(grid(5, 6).restPositions, grid(5, 6), 1e-6)],
  ])('%s', (_what, bytes) => {
    expect(() => unpackPositions(bytes, net)).toThrow(expect.objectContaining({ code: 'bad_link' }));
  });
});

function scale(net: PackingNet, factor: number): void {
  for (const numbers of [net.restPositions, net.restLengths]) numbers.forEach((x, i) => (numbers[i] = factor * x));
}

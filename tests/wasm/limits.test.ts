/** What is too large for WebAssembly, which has less memory than native programs. */
import { expect, test } from 'vitest';
import type { Mesh } from '../../wasm/chebnet';
import { failure, load } from './load';

const chebnet = await load();

test('a net too large for a method is refused before its factor is made, and another method may do', () => {
  const size = 400;
  const editor = chebnet.openMesh(grid(size));
  editor.setHandles([
    { vertex: 0, target: [0, 0, 0] },
    { vertex: size * size - 1, target: [size - 1, size - 1, 1] },
  ]);
  const before = editor.positions();
  editor.setMethod('li2022');
  const error = failure(() => editor.solve());
  expect(error.code).toBe('too_large');
  expect(error.message).toMatch(/160000 vertices .* li2022: .* 512 MB; projection needs less/);
  expect(editor.positions()).toEqual(before);
  editor.setMethod('projection');
  expect(editor.solve({ iterations: 1 })).toMatchObject({ status: 'running', iterations: 1 });
});

/** Unit squares with size × size vertices. */
function grid(size: number): Mesh {
  const rows = size - 1;
  const corners = [0, 1, size + 1, size];
  const cornerOf = (f: number, k: number) => Math.floor(f / rows) * size + (f % rows) + corners[k]!;
  const placeOf = (v: number) => [Math.floor(v / size), v % size, 0];
  return {
    positions: new Float64Array(3 * size * size).map((_, i) => placeOf(Math.floor(i / 3))[i % 3]!),
    faceStart: new Int32Array(rows * rows + 1).map((_, f) => 4 * f),
    faceVertices: new Int32Array(4 * rows * rows).map((_, i) => cornerOf(i >> 2, i & 3)),
  };
}

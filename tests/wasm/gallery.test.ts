/** What a visitor does first with a net of the gallery leaves it one that could be woven. */
import { expect, test } from 'vitest';
import type { Editor } from '../../wasm/chebnet';
import { writeFolds } from '../../web/src/net/fold';
import { sharpQuads } from '../../web/src/net/sharp_quads';
import { load } from './load';

const chebnet = await load();

const LIMIT = 30;
/** What a frame of a drag may lack of the limit, and a net at rest; degrees. */
const [IN_A_DRAG, AT_REST] = [0.5, 0.05];
const FRAMES = 20;

/** By parts of the net's size. */
const GESTURES: Record<string, [number, number, number]> = {
  'drawn up': [0, 0, 0.12],
  'drawn aside': [0.12, 0.05, 0],
  'pushed down': [0, 0, -0.12],
};

/** How far faces may be folded at an edge, degrees; bodies more, at their cones, where three quads meet. */
const NETS: Record<string, number> = {
  dome: 60,
  saddle: 60,
  canopy: 60,
  vault: 60,
  wave: 60,
  sheet: 60,
  scroll: 60,
  tube: 60,
  vase: 60,
  shirt: 60,
  teddy: 80,
  rabbit: 80,
  jug: 90,
};
const offered = new Map(chebnet.shapes().map((shape) => [shape.name, shape.offered]));

const cases = Object.entries(NETS).flatMap(([shape, mostFolded]) =>
  Object.entries(GESTURES).map(([gesture, by]) => ({ shape, mostFolded, gesture, by })),
);

test.each(cases)('$shape $gesture: no corner under the limit, no sharp fold', ({ shape, mostFolded, by }) => {
  const editor = chebnet.openRecipe(offered.get(shape)!);
  const rest = editor.positions();
  const vertices = [...editor.suggestedHandles];
  editor.setHandles(vertices.map((vertex) => ({ vertex, target: place(rest, vertex) })));
  const dragged = vertices.at(-1)!;
  const [from, size] = [place(rest, dragged), sizeOf(rest)];
  for (let frame = 1; frame <= FRAMES; ++frame) {
    const at = (k: 0 | 1 | 2) => from[k] + (by[k] * size * frame) / FRAMES;
    editor.dragHandle(dragged, [at(0), at(1), at(2)]);
    editor.solve({ iterations: 1 });
    expect(sharpQuads(editor, editor.positions(), LIMIT - IN_A_DRAG).size).toBe(0);
    expect(largestFold(editor)).toBeLessThan(mostFolded);
  }
  editor.releaseHandles();
  expect(['converged', 'exact']).toContain(editor.solve({ iterations: 2000 }).status);
  expect(sharpQuads(editor, editor.positions(), LIMIT - AT_REST).size).toBe(0);
  expect(largestFold(editor)).toBeLessThan(mostFolded);
  editor.dispose();
});

function place(positions: Float64Array, vertex: number): [number, number, number] {
  const [x, y, z] = positions.subarray(3 * vertex, 3 * vertex + 3);
  return [x!, y!, z!];
}

function sizeOf(positions: Float64Array): number {
  const extent = (axis: number) => {
    const along = positions.filter((_, i) => i % 3 === axis);
    return Math.max(...along) - Math.min(...along);
  };
  return Math.hypot(extent(0), extent(1), extent(2));
}

function largestFold(editor: Editor): number {
  const folds = new Float32Array(editor.info.edges);
  writeFolds(folds, editor.positions(), editor);
  return folds.reduce((largest, fold) => Math.max(largest, fold), 0);
}

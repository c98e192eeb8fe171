/** Fold angles, curvature and sharp corners, as the page reckons them. */
import { expect, test } from 'vitest';
import { writeCurvatures, writeFolds } from '../../web/src/net/fold';
import { sharpQuads } from '../../web/src/net/sharp_quads';
import { load } from '../wasm/load';

const chebnet = await load();

function fieldsOf(recipe: string) {
  const net = chebnet.openRecipe(recipe);
  const positions = net.positions();
  const [folds, curvatures] = [new Float32Array(net.info.edges), new Float32Array(net.info.vertices)];
  writeFolds(folds, positions, net);
  writeCurvatures(curvatures, positions, net);
  return { folds: [...folds], curvatures: [...curvatures], middle: net.suggestedHandles.at(-1)! };
}

test('a sheet is flat', () => {
  const { folds, curvatures } = fieldsOf('sheet:vertices=121');
  expect(Math.max(...folds)).toBeLessThan(1e-6);
  expect(Math.max(...curvatures.map(Math.abs))).toBeLessThan(1e-3);
});

test('blocks are folded by right angles, and turn by 720° in all', () => {
  const { folds, curvatures } = fieldsOf('jack:vertices=300');
  expect(new Set(folds.map((angle) => Math.round(angle)))).toEqual(new Set([0, 90]));
  const total = curvatures.reduce((sum, each) => sum + each, 0) / curvatures.length;
  expect(total).toBeCloseTo(720, 2);
});

test('a dome is curved one way, a saddle the other, whatever their edges', () => {
  for (const vertices of [225, 961]) {
    const [dome, saddle] = [fieldsOf(`dome:vertices=${vertices}`), fieldsOf(`saddle:vertices=${vertices}`)];
    expect(dome.curvatures[dome.middle]).toBeGreaterThan(100);
    expect(dome.curvatures[dome.middle]).toBeLessThan(400);
    expect(saddle.curvatures[saddle.middle]).toBeLessThan(-50);
  }
});

test('the quads of a sheet are as sharp as right angles, and so are those of blocks', () => {
  for (const recipe of ['sheet:vertices=121', 'jack:vertices=300']) {
    const net = chebnet.openRecipe(recipe);
    expect(sharpQuads(net, net.positions(), 89.9).size).toBe(0);
    expect(sharpQuads(net, net.positions(), 90.1).size).toBe(net.info.faces);
  }
});

test('a quad with a side of no length is sharp', () => {
  const net = chebnet.openRecipe('sheet:vertices=121');
  const positions = net.positions();
  const [one, next] = net.faceVertices;
  positions.copyWithin(3 * next!, 3 * one!, 3 * one! + 3);
  expect(sharpQuads(net, positions, 30)).toContain(0);
});

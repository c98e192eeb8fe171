/** Warp and weft, as the page finds them. */
import { expect, test } from 'vitest';
import { hasTwoFamilies } from '../../web/src/net/families';
import { load } from '../wasm/load';

const chebnet = await load();

test.each([
  ['sheet:vertices=121', true],
  ['torus:vertices=120', true],
  ['tube:vertices=120', true],
  ['jack:vertices=300', false], // three edges meet at the corners of its blocks
])('the net lines of %s are of two families: %s', (recipe, are) => {
  expect(hasTwoFamilies(chebnet.openRecipe(recipe))).toBe(are);
});

test('a net with a triangle has no two families', () => {
  const triangle = { positions: new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), faceStart: Int32Array.of(0, 3) };
  expect(hasTwoFamilies(chebnet.openMesh({ ...triangle, faceVertices: Int32Array.of(0, 1, 2) }))).toBe(false);
});

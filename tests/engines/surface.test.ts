/** A net on a surface, in each engine: dropped, laid by hand in a worker of its own, opened. */
import { expect, test } from 'vitest';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { load } from '../wasm/load';
import { PATIENCE, visitors } from './visitor';

const chebnet = await load();
const { arrive } = visitors();

/** A hypar as STL: loose triangles. */
function hypar(): Uint8Array<ArrayBuffer> {
  const surface = chebnet.ownSurface('hypar');
  const faceStart = Int32Array.from({ length: surface.triangles.length / 3 + 1 }, (_, face) => 3 * face);
  const editor = chebnet.openMesh({ positions: surface.positions, faceStart, faceVertices: surface.triangles });
  const bytes = editor.toFile('stl');
  editor.dispose();
  surface.dispose();
  return bytes;
}

test('a surface is dropped, a net laid on it where the hand wants it, and opened with exact lengths', async () => {
  const visitor = await arrive();
  const { vertices: first } = await visitor.stats();
  await visitor.dropFile('hypar.stl', hypar());
  await visitor.read('One uncut piece will cover it.', 'dialog');
  await visitor.clickOn('Make a net on it…');
  await visitor.read(/Covered\s*100 %/, 'dialog.drape');

  const seed = () =>
    visitor.run(() => {
      const ring = document.querySelector('.seed-ring')!.getBoundingClientRect();
      return { x: ring.x + ring.width / 2, y: ring.y + ring.height / 2 };
    });
  const { x, y } = await seed();
  await visitor.driver.movePointer(x, y);
  await visitor.driver.pressButton();
  for (const step of [10, 25, 40]) await visitor.driver.movePointer(x + step, y + step / 2);
  await visitor.driver.releaseButton();
  await expect.poll(async () => (await seed()).x - x, PATIENCE).toBeGreaterThan(25);
  await visitor.picture('surface');

  await visitor.clickOn('Open this net');
  await expect.poll(async () => (await visitor.stats()).vertices, PATIENCE).not.toBe(first);
  await visitor.settled();
  const edges = Int32Array.from(await visitor.run(() => Array.from(window.chebnet.edges())));
  const lengths = edgeLengths(await visitor.positions(), edges);
  expect(edges.length / 2).toBeGreaterThan(2500);
  for (const length of lengths) expect(length / lengths[0]!).toBeCloseTo(1, 9);
});

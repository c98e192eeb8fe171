/** What comes in and goes out, in each engine: files, projects, links. */
import rhino3dm from 'rhino3dm';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import { expect, test } from 'vitest';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { distance, largestError } from '../browser/geometry';
import { load } from '../wasm/load';
import { glbParts } from '../web/glb_parts';
import type { Visitor } from './visitor';
import { visitors } from './visitor';

const chebnet = await load();
const reference = chebnet.openRecipe('vault:vertices=300');
const { edges, faceStart, faceVertices, info, suggestedHandles } = reference;

const { arrive, share } = visitors();
let visitor: Visitor;

async function save(kind: string): Promise<Uint8Array<ArrayBuffer>> {
  const { name, bytes } = await visitor.saved(async () => {
    await visitor.clickOn('Export');
    await visitor.clickOn(kind);
  });
  expect(name).toMatch(new RegExp(`^\\w+\\.${kind}$`, 'i'));
  return bytes;
}

const textOf = (bytes: Uint8Array) => new TextDecoder().decode(bytes);

test('the first net is saved by the core that has left files out until then', async () => {
  visitor = await arrive();
  const positions = await visitor.positions();
  for (const kind of ['OBJ', 'STL']) {
    const bytes = await save(kind);
    if (kind === 'OBJ') expect(largestError(chebnet.readMesh(bytes, 'net.obj').positions, positions)).toBe(0);
    else expect(bytes.length).toBeGreaterThan(positions.length);
  }
  expect(await visitor.stats()).toMatchObject({ status: 'converged' });
});

test('a PLY is dropped, opened, dragged, and saved in every format', async () => {
  visitor = await share();
  await visitor.dropFile('vault.ply', reference.toFile('ply'));
  await visitor.read('Mean length', 'dialog');
  await visitor.clickOn('Open');
  await expect.poll(async () => (await visitor.stats()).vertices).toBe(info.vertices);
  await visitor.run(
    (vertices) => window.chebnet.setHandles(vertices.map((vertex) => ({ vertex, anchor: false }))),
    [...suggestedHandles],
  );
  const vertex = suggestedHandles.at(-1)!;
  await visitor.drag(vertex, [-50, -40]);
  const positions = await visitor.positions();
  expect(distance(positions.subarray(3 * vertex), reference.restPositions.subarray(3 * vertex))).toBeGreaterThan(
    0.5 * info.meanLength,
  );

  for (const kind of ['OBJ', 'PLY', 'OFF']) {
    const mesh = chebnet.readMesh(await save(kind), `vault.${kind.toLowerCase()}`);
    expect([mesh.faceStart, mesh.faceVertices]).toEqual([faceStart, faceVertices]);
    expect(largestError(mesh.positions, positions)).toBe(0);
  }

  const triangles = new STLLoader().parse((await save('STL')).buffer);
  expect(triangles.getAttribute('position').count).toBe(3 * 2 * info.faces);

  const rhino = await rhino3dm();
  const model = await save('3DM');
  const mesh = rhino.File3dm.fromByteArray(model).objects().get(0).geometry() as InstanceType<typeof rhino.Mesh>;
  const places = Float64Array.from(
    Array.from({ length: info.vertices }, (_, v) => mesh.vertices().point3dAt(v)).flat(),
  );
  expect(largestError(places, positions)).toBe(0);

  const glb = await save('GLB');
  const { faces, lines } = glbParts(glb);
  expect(faces.positions).toEqual(Float32Array.from(positions));
  expect([...lines.indices]).toEqual([...edges]);

  expect(textOf(await save('SVG'))).toMatch(/^<svg .*width="\d+mm"[\s\S]*<\/svg>\s*$/);

  const rows = textOf(await save('CSV'))
    .trim()
    .split('\n')
    .slice(1)
    .map((line) => line.split(',').map(Number));
  const lengths = edgeLengths(positions, edges);
  expect(rows.flatMap(([, a, b]) => [a, b])).toEqual([...edges]);
  rows.forEach(([, , , length], e) => expect(length).toBeCloseTo(lengths[e]!, 12));

  const png = await save('PNG');
  const canvas = await visitor.run(() => document.querySelector<HTMLCanvasElement>('#view canvas')!.width);
  expect(new DataView(png.buffer).getUint32(16)).toBe(canvas);

  // By the page's own readers, in its worker.
  await visitor.dropFile('back.3dm', model);
  await visitor.read(`${info.faces} quads`, 'dialog');
  await visitor.clickOn('Cancel');
  await visitor.dropFile('back.glb', glb);
  await visitor.read('A surface to make a net on', 'dialog');
});

test('a drag is saved as a video, or the menu says that this browser cannot', async () => {
  visitor = await share();
  await visitor.openNet({ recipe: 'vault:vertices=300' });
  await visitor.clickOn('Export');
  const can = await visitor.run(() => {
    const item = [...document.querySelectorAll('button')].find(
      (each) => each.querySelector('strong')?.textContent === 'Video',
    );
    return item?.disabled === false;
  });
  if (!can) {
    await visitor.read('this browser records no video', '.menu');
    return;
  }
  await visitor.clickOn('Video');
  await visitor.drag(suggestedHandles.at(-1)!, [-50, -40]);
  await visitor.read(/0:(0[1-9]|[1-5]\d) \/ 1:00/);
  const { name, bytes } = await visitor.saved(() => visitor.clickOn('Stop and save'));
  expect(name).toMatch(/^vault\.(webm|mp4)$/);
  expect(bytes.length).toBeGreaterThan(2000);
});

/** How many states the browser keeps of this tab. */
function kept(): Promise<number> {
  return visitor.run(async () => {
    const done = <T>(request: IDBRequest<T>) =>
      new Promise<T>((resolve, reject) => {
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
      });
    const database = await done(indexedDB.open('chebnet'));
    const store = database.transaction('projects').objectStore('projects');
    const project = (await done(store.get(sessionStorage.getItem('chebnet.tab') ?? ''))) as
      | { states: unknown[] }
      | undefined;
    database.close();
    return project?.states.length ?? 0;
  });
}

test('a project keeps the net over a reload and in a file', async () => {
  visitor = await arrive();
  await visitor.openNet({ recipe: 'vault:vertices=300' });
  await visitor.drag(suggestedHandles.at(-1)!, [-50, -40]);
  const positions = await visitor.positions();
  const { name, bytes } = await visitor.saved(() => visitor.press('Control+s'));
  expect(name).toBe('vault.chebnet.json');

  await expect.poll(kept).toBe(3);
  await visitor.driver.reload();
  await visitor.waitForNet();
  await visitor.read(/as you left it/);
  expect(await visitor.positions()).toEqual(positions);

  await visitor.openNet({ recipe: 'dome:vertices=300' });
  await visitor.dropFile(name, bytes);
  await visitor.read(/project is open/);
  await visitor.settled();
  expect(await visitor.positions()).toEqual(positions);
});

test('a link shows another visitor the same net', async () => {
  visitor = await share();
  await visitor.openNet({ recipe: 'vault:vertices=300' });
  await visitor.drag(suggestedHandles.at(-1)!, [-50, -40]);
  const link = await visitor.run(() => window.chebnet.link());
  await visitor.clickOn('Share');
  // Where the clipboard is closed to it, the page says where the link is to be had.
  await visitor.read(/The link is (copied|made)/, 'dialog');
  await visitor.picture('share');
  const receiver = await arrive(link);
  expect(largestError(await receiver.positions(), await visitor.positions())).toBeLessThan(1e-4 * info.meanLength);
  expect(await receiver.handles()).toEqual([...suggestedHandles]);
});

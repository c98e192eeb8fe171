/** What becomes of a document whose net gets other faces. */
import { expect, test } from 'vitest';
import type { Chebnet } from '../../wasm/chebnet';
import { changeNet } from '../../web/src/change/change_net';
import type { ChangeRequest, ChangeResponse } from '../../web/src/change/change_protocol';
import { changedScene, resizedGuide } from '../../web/src/change/subject';
import type { ChebnetDocument, HandleSeed } from '../../web/src/document/document';

/** Five vertices in a line, and of these the first, third and fifth: no faces are looked at. */
const line = (count: number, step: number) => ({
  positions: Float64Array.from({ length: 3 * count }, (_, i) => (i % 3 === 0 ? (step * i) / 3 : 0)),
  faceStart: Int32Array.of(0),
  faceVertices: new Int32Array(),
});
const changed = { mesh: line(3, 2), origins: Int32Array.of(0, 2, 4), pieces: 1, sharp: false };
const documentWith = (...vertices: number[]) =>
  ({
    net: { recipe: 'vault' },
    handles: vertices.map((vertex) => ({ vertex, target: null })),
    options: {},
    method: 'equilibrium',
  }) as unknown as ChebnetDocument;
function verticesAfter(way: 'coarsen' | 'delete_faces', ...vertices: number[]): number[] {
  const { handles } = changedScene(documentWith(...vertices), { way, mesh: line(5, 1) }, changed, []);
  return (handles as HandleSeed[]).map(({ vertex }) => vertex);
}

test('handles stay at their vertices; where these are gone, they go', () => {
  expect(verticesAfter('delete_faces', 0, 1, 4)).toEqual([0, 2]);
});

test('in a coarser net they go to the nearest vertex that no other has', () => {
  expect(verticesAfter('coarsen', 0, 3)).toEqual([0, 1]);
  expect(verticesAfter('coarsen', 0, 2, 4, 1)).toEqual([0, 1, 2]);
});

test('a changed net is as long as it was made, and not how the one before came to its end', () => {
  const before = { ...documentWith(), options: { length_scale: 1.1, threshold: 1e-8 }, ending: 'stalled' as const };
  const scene = changedScene(before, { way: 'refine', mesh: line(5, 1) }, changed, []);
  expect(scene.options).toEqual({ threshold: 1e-8 });
  expect(scene.ending).toBeUndefined();
});

test('in another size its surface has that size, too, about the same centre', () => {
  const guide = resizedGuide(
    { own: 'shell' },
    {
      positions: Float64Array.of(1, 0, 0, 3, 0, 0, 2, 1, 0),
      normals: new Float64Array(9),
      triangles: Int32Array.of(0, 1, 2),
    },
    { mesh: line(5, 1), factor: 2 },
  );
  expect(guide).toEqual({
    name: 'Free-form shell',
    mesh: {
      positions: Float64Array.of(0, 0, 0, 4, 0, 0, 2, 2, 0),
      faceStart: Int32Array.of(0, 3),
      faceVertices: Int32Array.of(0, 1, 2),
    },
  });
});

/** What the page hears of a change that the core makes exact so. */
function endOf(status: string): ChangeResponse {
  const { mesh, origins } = changed;
  const core = {
    change: () => ({ mesh, origins, lengthFactor: 1, keepsEdges: false }),
    exactChange: () => ({ solve: () => ({ status, iterations: 1 }), positions: () => mesh.positions, dispose() {} }),
    openMesh: () => ({ info: { components: 1 }, dispose() {} }),
  } as unknown as Chebnet;
  const said: ChangeResponse[] = [];
  changeNet(core, { mesh, way: 'refine', length: 1, held: [] } as unknown as ChangeRequest, (it) => said.push(it));
  return said.at(-1)!;
}

test('a net whose edges have their length is taken also where corners are sharper than the limit, and that is known', () => {
  expect(endOf('converged')).toMatchObject({ type: 'ended', changed: { sharp: false } });
  expect(endOf('exact')).toMatchObject({ type: 'ended', changed: { sharp: true } });
  expect(endOf('stalled')).toEqual({ type: 'ended', changed: null });
});

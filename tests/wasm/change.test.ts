/** Nets with other faces here are those of the native program, and the page's changes end exact, handles and all. */
import { describe, expect, test } from 'vitest';
import type { NetChange } from '../../wasm/chebnet';
import type { ChangedNet, ChangeRequest, ChangeResponse } from '../../web/src/change/change_protocol';
import { changeNet } from '../../web/src/change/change_net';
import { sidesOf, stayingWithout } from '../../web/src/change/sides';
import { failure, load } from './load';

const chebnet = await load();

function requestFor(recipe: string, change: Partial<ChangeRequest>): ChangeRequest {
  const { restPositions, restLengths, faceStart, faceVertices } = chebnet.openRecipe(recipe);
  return {
    mesh: { positions: restPositions, faceStart, faceVertices },
    way: 'refine',
    place: {},
    factor: 1,
    length: restLengths[0]!,
    held: [],
    shearLimit: Math.PI / 6,
    ...change,
  };
}

function lastOf(request: ChangeRequest): ChangeResponse {
  const said: ChangeResponse[] = [];
  changeNet(chebnet, request, (response) => said.push(response));
  return said.at(-1)!;
}

function changed(request: ChangeRequest): ChangedNet {
  const last = lastOf(request);
  if (last.type !== 'ended' || last.changed === null) throw new Error(JSON.stringify(last));
  return last.changed;
}

/** The largest dL against this length. */
function deviation({ mesh }: ChangedNet, length: number): number {
  const editor = chebnet.openMesh(mesh, 'own');
  return Math.max(...editor.restLengths.map((each) => (each / length - 1) ** 2 / (each / length)));
}

describe('a net that is changed', () => {
  const recipe = 'dome:vertices=300';
  const { restLengths, restPositions } = chebnet.openRecipe(recipe);
  const length = restLengths[0]!;
  const corner = 0;

  test('is finer, with the handles where they were', () => {
    const fine = changed(requestFor(recipe, { held: [corner, 150] }));
    expect(deviation(fine, length / 2)).toBeLessThan(1e-9);
    for (const vertex of [corner, 150]) {
      expect(fine.origins[vertex]).toBe(vertex);
      const here = [3 * vertex, 3 * vertex + 3] as const;
      expect(fine.mesh.positions.subarray(...here)).toEqual(restPositions.subarray(...here));
    }
    const coarse = changed({ ...requestFor(recipe, { way: 'coarsen', length: length / 2 }), mesh: fine.mesh });
    expect(coarse.mesh.faceVertices.length).toBe(requestFor(recipe, {}).mesh.faceVertices.length);
    expect(deviation(coarse, length)).toBeLessThan(1e-9);
  });

  test('is of another size', () => {
    const larger = changed(requestFor(recipe, { way: 'resize', factor: 3 }));
    expect(deviation(larger, 3 * length)).toBeLessThan(1e-9);
    expect([...larger.origins.keys()]).toEqual([...larger.origins]);
  });

  test('keeps its shape to lost digits where faces are only taken away', () => {
    const request = requestFor(recipe, { way: 'delete_faces', place: { vertices: [corner] } });
    const { mesh, origins } = changed(request);
    expect(origins.includes(corner)).toBe(false);
    origins.forEach((old, vertex) => {
      for (let axis = 0; axis < 3; ++axis)
        expect(mesh.positions[3 * vertex + axis]).toBeCloseTo(restPositions[3 * old + axis]!, 9);
    });
  });

  test('keeps lengths that differ', () => {
    const request = requestFor(recipe, { length: null });
    const positions = request.mesh.positions.map((x, i) => (i % 3 === 0 ? 2 * x : x));
    const fine = changed({ ...request, mesh: { ...request.mesh, positions } });
    expect(fine.mesh.positions.subarray(0, positions.length)).toEqual(positions);
  });

  test('gets a row inside of it, and loses it', () => {
    const sheet = 'sheet:vertices=100';
    const net = chebnet.openRecipe(sheet);
    const { edges } = net;
    const { start, vertices } = net.netLines();
    const lines = Array.from(start.subarray(1), (end, k) => vertices.subarray(start[k], end));
    const inner = lines.find((line) => line.every((vertex) => vertex !== 0))!;
    const on = new Set(inner);
    const along = Array.from({ length: edges.length / 2 }, (_, e) => e).filter(
      (e) => on.has(edges[2 * e]!) && on.has(edges[2 * e + 1]!),
    );
    const request = requestFor(sheet, { way: 'insert_row', place: { edges: along } });
    const wider = changed(request);
    expect(deviation(wider, request.length!)).toBeLessThan(1e-9);
    expect(wider.origins).toHaveLength(100 + inner.length);
    expect(changed({ ...request, way: 'remove_line' }).origins).toHaveLength(100 - inner.length);
  });

  test('comes in as many pieces as it is cut into', () => {
    const sheet = 'sheet:vertices=100';
    const { info } = chebnet.openRecipe(sheet);
    const everyEdge = Array.from({ length: info.edges }, (_, edge) => edge);
    const request = requestFor(sheet, { way: 'cut', place: { edges: everyEdge } });
    expect(changed(request).pieces).toBe(info.faces);
  });

  // Of two sides as large as each other too, which both have to take for the same.
  test.each([3, 5])('loses the side that the page fades, at line %i of ten', (line) => {
    const sheet = 'sheet:vertices=121';
    const net = chebnet.openRecipe(sheet);
    const x = (vertex: number) => net.restPositions[3 * vertex]!;
    const columns = [...new Set(Array.from({ length: 121 }, (_, v) => x(v).toFixed(6)))].map(Number);
    const wanted = columns.sort((a, b) => a - b)[line]!;
    const edges = Array.from({ length: net.info.edges }, (_, e) => e).filter((e) =>
      [0, 1].every((end) => Math.abs(x(net.edges[2 * e + end]!) - wanted) < 1e-3),
    );
    const [larger, ...others] = sidesOf(net, edges);
    for (const [way, goes] of [
      ['keep_larger', others.flat()],
      ['keep_smaller', larger!],
    ] as const) {
      const stays = stayingWithout(net, goes);
      const { origins } = changed(requestFor(sheet, { way, place: { edges } }));
      expect([...origins]).toEqual([...stays.keys()].filter((vertex) => stays[vertex] === 1));
    }
  });

  test('stays, with a reason, where it cannot be changed', () => {
    expect(lastOf(requestFor('torus:vertices=300', { way: 'add_row', place: { edges: [0] } }))).toMatchObject({
      type: 'error',
      code: 'impossible_change',
      message: expect.stringContaining('border'),
    });
  });
});

describe('what makes no sense is refused', () => {
  const { mesh } = requestFor('sheet:vertices=100', {});
  const wrong: [string, string, () => unknown][] = [
    ['another change', 'bad_option', () => chebnet.change(mesh, 'melt' as NetChange)],
    ['no name', 'bad_option', () => chebnet.change(mesh, 3 as never)],
    ['an edge too far', 'index_out_of_range', () => chebnet.change(mesh, 'cut', { edges: [99_999] })],
    ['half a vertex', 'index_out_of_range', () => chebnet.change(mesh, 'delete_faces', { vertices: [0.5] })],
    ['vertices that are none', 'bad_option', () => chebnet.change(mesh, 'delete_faces', { vertices: 3 as never })],
    ['no mesh', 'bad_syntax', () => chebnet.change({} as never, 'refine')],
    ['no changed mesh', 'bad_syntax', () => chebnet.exactChange({ mesh } as never, { length: 1 })],
    ['no length', 'bad_option', () => chebnet.exactChange(chebnet.change(mesh, 'refine'), { length: 'long' as never })],
  ];
  test.each(wrong)('%s', (_, code, action) => {
    expect(failure(action).code).toBe(code);
  });
});

/** Handles to begin with, on nets that come without any. */
import { describe, expect, test } from 'vitest';
import { distancesAround } from '../../web/src/handles/around';
import { proposedHandles } from '../../web/src/handles/proposal';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import type { OpenedNet } from '../../web/src/worker/protocol';
import { load } from '../wasm/load';
import { grid } from './nets';

const core = await load();
const shape = (recipe: string): OpenedNet => describeNet(core.openRecipe(recipe));
const mesh = (given: Parameters<typeof core.openMesh>[0]): OpenedNet => describeNet(core.openMesh(given));

/** In edges of the net, from each of these to the nearest of the others. */
function gaps(net: OpenedNet, from: readonly number[], to: readonly number[]): number[] {
  const away = distancesAround(net, to, Infinity);
  return from.map((vertex) => away.get(vertex)!.distance / net.info.meanLength);
}

function inSpace({ restPositions: at }: OpenedNet, a: number, b: number): number {
  return Math.hypot(at[3 * a]! - at[3 * b]!, at[3 * a + 1]! - at[3 * b + 1]!, at[3 * a + 2]! - at[3 * b + 2]!);
}

describe('one is free, the last, and the others hold', () => {
  test.each(['sheet', 'tube', 'torus', 'teddy', 'dome'])('%s', (name) => {
    const net = shape(`${name}:vertices=900`);
    const handles = proposedHandles(net);
    expect(handles.length).toBeGreaterThanOrEqual(4);
    expect(handles.length).toBeLessThanOrEqual(8);
    expect(handles.map(({ anchor }) => anchor)).toEqual(handles.map((_, i) => i + 1 < handles.length));
    expect(handles.every(({ target }) => target === null)).toBe(true);
    const vertices = handles.map(({ vertex }) => vertex);
    for (const vertex of vertices)
      expect(
        Math.min(
          ...gaps(
            net,
            vertices.filter((other) => other !== vertex),
            [vertex],
          ),
        ),
      ).toBeGreaterThan(5);
  });
});

test('on an open net they are the corners of its border', () => {
  const flat = grid(21, 15);
  const vertices = proposedHandles(mesh({ ...flat, positions: flat.restPositions })).map(({ vertex }) => vertex);
  expect(vertices.sort((a, b) => a - b)).toEqual([0, 20, 14 * 21, 15 * 21 - 1]);
});

test('a notch in its border is none of them', () => {
  // A square without its quarter, of cells of one length: an L.
  const side = 21;
  const { restPositions, faceStart, faceVertices } = grid(side, side);
  const isKept = (face: number): boolean => face % (side - 1) < 10 || face < 10 * (side - 1);
  const kept = [...faceStart.keys()].slice(0, -1).filter(isKept);
  const corners = kept.flatMap((face) => [...faceVertices.subarray(faceStart[face], faceStart[face + 1])]);
  const used = [...new Set(corners)].sort((a, b) => a - b);
  const net = mesh({
    positions: Float64Array.from(used.flatMap((vertex) => [...restPositions.subarray(3 * vertex, 3 * vertex + 3)])),
    faceStart: Int32Array.from({ length: kept.length + 1 }, (_, i) => 4 * i),
    faceVertices: Int32Array.from(corners, (vertex) => used.indexOf(vertex)),
  });
  const vertices = proposedHandles(net).map(({ vertex }) => used[vertex]!);
  const inner = 10 * side + 10;
  expect(vertices).toHaveLength(5);
  expect(vertices).not.toContain(inner);
});

describe('a cell that sticks out of the border is left alone', () => {
  /** Unit squares, by column and row. */
  const squares = (size: number, isKept: (column: number, row: number) => boolean): OpenedNet => {
    const { restPositions, faceStart, faceVertices } = grid(size + 1, size + 1);
    const kept = [...faceStart.keys()].slice(0, -1).filter((face) => isKept(face % size, Math.floor(face / size)));
    const corners = kept.flatMap((face) => [...faceVertices.subarray(faceStart[face], faceStart[face + 1])]);
    const used = [...new Set(corners)].sort((a, b) => a - b);
    return mesh({
      positions: Float64Array.from(used.flatMap((vertex) => [...restPositions.subarray(3 * vertex, 3 * vertex + 3)])),
      faceStart: Int32Array.from({ length: kept.length + 1 }, (_, i) => 4 * i),
      faceVertices: Int32Array.from(corners, (vertex) => used.indexOf(vertex)),
    });
  };
  const places = (net: OpenedNet) =>
    proposedHandles(net).map(({ vertex }) => [...net.restPositions.subarray(3 * vertex, 3 * vertex + 2)]);

  test('at a corner', () => {
    const net = squares(21, (column, row) => row < 20 || column === 0);
    expect(places(net).sort(([a = 0, b = 0], [c = 0, d = 0]) => a - c || b - d)).toEqual([
      [0, 0],
      [0, 20],
      [21, 0],
      [21, 20],
    ]);
  });

  test('on a round border', () => {
    const isInside = (column: number, row: number) => Math.hypot(column - 15, row - 15) < 12.5;
    const net = squares(31, (column, row) => isInside(column, row) || (column === 28 && row === 15));
    const found = places(net);
    expect(found).toHaveLength(4);
    expect(Math.max(...found.map(([x = 0]) => x))).toBeLessThanOrEqual(28);
  });

  test('but not the end of a strip of one cell', () => {
    const net = squares(21, (_, row) => row === 0);
    expect(places(net).map(([x]) => x)).toEqual(expect.arrayContaining([0, 21]));
  });
});

test.each([
  ['', 0],
  [' around an opening in its middle', 0.4],
])('on a shell%s whose border is round they are its feet, however many', (_, opening) => {
  for (const feet of [3, 4, 5]) {
    const net = mesh(shellOnFeet(feet, 60 * feet, 24, opening));
    const vertices = proposedHandles(net).map(({ vertex }) => vertex);
    const ofFeet = Array.from({ length: feet }, (_, i) => 23 * 60 * feet + 60 * i);
    expect(vertices).toHaveLength(feet);
    for (const foot of ofFeet) expect(Math.min(...vertices.map((vertex) => Math.abs(vertex - foot)))).toBeLessThan(3);
  }
});

/** Of rings of quads around a hole, to which this part of the way is left open: the outermost goes out and down at each foot, and up
 *  between two. */
function shellOnFeet(
  feet: number,
  around: number,
  rings: number,
  opening: number,
): Parameters<typeof core.openMesh>[0] {
  const positions: number[] = [];
  const corners: number[] = [];
  for (let ring = 0; ring < rings; ring++)
    for (let i = 0; i < around; i++) {
      const radius = opening + ((1 - opening) * (ring + 1)) / rings;
      const angle = (2 * Math.PI * i) / around;
      const bulge = radius ** 3 * Math.cos(feet * angle);
      const out = radius * (1 + 0.15 * bulge);
      positions.push(6 * out * Math.cos(angle), 6 * out * Math.sin(angle), 3 * (1 - radius ** 2) - bulge);
      const [a, b] = [ring * around + i, ring * around + ((i + 1) % around)];
      if (ring + 1 < rings) corners.push(a, b, b + around, a + around);
    }
  return {
    positions: Float64Array.from(positions),
    faceStart: Int32Array.from({ length: corners.length / 4 + 1 }, (_, i) => 4 * i),
    faceVertices: Int32Array.from(corners),
  };
}

test('a foot that ends in two tips has one handle', () => {
  const [around, rings] = [48, 9];
  const shell = shellOnFeet(3, around, rings, 0);
  const foot = (rings - 1) * around;
  // Its vertex in the middle, most of the way to the ring before: what is beside it are the tips.
  for (let i = 0; i < 3; i++)
    shell.positions[3 * foot + i]! +=
      0.7 * (shell.positions[3 * (foot - around) + i]! - shell.positions[3 * foot + i]!);
  const places = proposedHandles(mesh(shell)).map(({ vertex }) => vertex - foot);
  expect(places).toHaveLength(3);
  expect(places.filter((place) => place === 1 || place === around - 1)).toHaveLength(1);
});

describe('a ring that was laid in one piece', () => {
  const [around, across] = [60, 8];
  const seamEnds = [0, around, across * (around + 1), across * (around + 1) + around];
  const flat = grid(around + 1, across + 1);
  /** @param gap between its two ends, in degrees; without one their vertices stand in the same places. */
  const ring = (gap: number): OpenedNet =>
    mesh({
      ...flat,
      positions: Float64Array.from(flat.restPositions, (_, i) => {
        const vertex = Math.floor(i / 3);
        const angle = (Math.PI / 180) * (gap / 2 + ((360 - gap) * (vertex % (around + 1))) / around);
        const radius = 5 + (6 * Math.floor(vertex / (around + 1))) / across;
        return [radius * Math.cos(angle), radius * Math.sin(angle), 0][i % 3]!;
      }),
    });

  test('is held on the far side, too, not only by the corners of its ends', () => {
    const net = ring(45);
    const vertices = proposedHandles(net).map(({ vertex }) => vertex);
    expect(vertices).toEqual(expect.arrayContaining(seamEnds));
    expect(Math.min(...vertices.map((vertex) => net.restPositions[3 * vertex]!))).toBeLessThan(-10);
  });

  test.each([5, 10, 20, 30])('of an opening of %i degrees neither side is dragged away from the other', (gap) => {
    const net = ring(gap);
    const proposed = proposedHandles(net);
    const { vertex } = proposed.at(-1)!;
    const along = distancesAround(net, [vertex], Infinity);
    for (const other of proposed.slice(0, -1))
      expect(inSpace(net, vertex, other.vertex)).toBeGreaterThan(along.get(other.vertex)!.distance / 4);
  });

  test('has handles on both sides of its seam, neither of which is the free one: the other would hold it', () => {
    const vertices = proposedHandles(ring(0)).map(({ vertex }) => vertex);
    expect(vertices).toEqual(expect.arrayContaining(seamEnds.slice(2)));
    expect(seamEnds).not.toContain(vertices.at(-1));
  });
});

test('on a pebble that is wrapped in one piece, the free one is none of those that meet at its seam', () => {
  const surface = core.ownSurface('pebble');
  const { length } = surface.suggest(500);
  const [{ seed, direction } = expect.fail()] = surface.propose({ length });
  const net = mesh(surface.drape({ length, seed, direction }).mesh);
  const vertices = proposedHandles(net).map(({ vertex }) => vertex);
  const free = vertices.at(-1)!;
  expect(vertices).toHaveLength(5);
  for (const other of vertices.slice(0, -1)) expect(inSpace(net, free, other)).toBeGreaterThan(5 * length);
});

test('where a cut parts two pieces, a free one does not stand beside a handle of the other piece', () => {
  const surface = core.ownSurface('shell');
  const { length } = surface.suggest(400);
  const [{ seed, direction } = expect.fail()] = surface.propose({ length });
  const halved = surface.cut([[-9, 0, 9].map((y) => surface.nearest([0.1 * y, y, 1]).position)]);
  const net = mesh(halved.drapePieces({ length, seed, direction }).mesh);
  const proposed = proposedHandles(net);
  const free = proposed.filter(({ anchor }) => !anchor);
  expect(free).toHaveLength(2);
  for (const { vertex } of free)
    for (const other of proposed)
      if (other.vertex !== vertex) expect(inSpace(net, vertex, other.vertex)).toBeGreaterThan(2 * length);
});

test('on a net of one cell one of its corners is free', () => {
  const flat = grid(2, 2);
  const proposed = proposedHandles(mesh({ ...flat, positions: flat.restPositions }));
  expect(proposed.map(({ anchor }) => anchor)).toEqual([true, true, false]);
});

test('on a tube, whose borders have no corners, there are some at each end', () => {
  const net = shape('tube:vertices=900');
  const vertices = proposedHandles(net).map(({ vertex }) => vertex);
  const ends = [0, 1].map((loop) => [...net.loopVertices.subarray(net.loopStart[loop], net.loopStart[loop + 1])]);
  for (const end of ends) expect(Math.min(...gaps(net, vertices, end))).toBeLessThan(2);
});

test('on a closed body they are its limbs', () => {
  const net = shape('jack:vertices=1500,smooth=1');
  const proposed = proposedHandles(net).map(({ vertex }) => vertex);
  expect(proposed).toHaveLength(6);
  // The shape's own are the tips of its six arms.
  for (const gap of gaps(net, [...net.suggestedHandles], proposed)) expect(gap).toBeLessThan(4);
});

test('each piece has its own, the largest the last, and of hundreds only a few', () => {
  const pieces = [9, 13, 5, 5, 5, 5].map((size) => grid(size, size));
  const positions = pieces.flatMap(({ restPositions }, i) =>
    [...restPositions].map((x, at) => x + (at % 3 === 2 ? 5 * i : 0)),
  );
  const starts = [0];
  const corners: number[] = [];
  let first = 0;
  for (const { faceStart, faceVertices, restPositions } of pieces) {
    for (let face = 0; face + 1 < faceStart.length; face++) {
      corners.push(...[...faceVertices.subarray(faceStart[face], faceStart[face + 1])].map((vertex) => vertex + first));
      starts.push(corners.length);
    }
    first += restPositions.length / 3;
  }
  const net = mesh({
    positions: Float64Array.from(positions),
    faceStart: Int32Array.from(starts),
    faceVertices: Int32Array.from(corners),
  });
  const handles = proposedHandles(net);
  expect(handles).toHaveLength(16);
  expect(handles.filter(({ anchor }) => !anchor)).toHaveLength(4);
  const height = (vertex: number) => net.restPositions[3 * vertex + 2]! / 5;
  expect(handles.slice(-4).map(({ vertex }) => height(vertex))).toEqual([1, 1, 1, 1]);
});

test('a large sheet has them at its corners, too', () => {
  const net = shape('sheet:vertices=50000');
  const degrees = new Int32Array(net.info.vertices);
  for (const vertex of net.edges) degrees[vertex]! += 1;
  const corners = Array.from(degrees.keys()).filter((vertex) => degrees[vertex] === 2);
  const handles = proposedHandles(net).map(({ vertex }) => vertex);
  expect(handles.sort((a, b) => a - b)).toEqual(corners);
});

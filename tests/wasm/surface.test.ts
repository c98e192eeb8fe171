/** Surfaces and draping across the border: what JavaScript is told of a surface, and the net that the native program lays. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, test } from 'vitest';
import type { Mesh, Point, RemeshOptions, Surface } from '../../wasm/chebnet';
import { objText } from '../../web/src/document/obj_text';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { ROOT, failure, largestDistance, load } from './load';

const PROGRAM = fileURLToPath(new URL('build/native/chebnet', ROOT));
const chebnet = await load();
const folder = mkdtempSync(join(tmpdir(), 'chebnet-'));
afterAll(() => rmSync(folder, { recursive: true }));

function withSurface<T>(surface: Surface, look: (surface: Surface) => T): T {
  try {
    return look(surface);
  } finally {
    surface.dispose();
  }
}

/** Two triangles of the unit square. */
const SQUARE: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
  faceStart: Int32Array.of(0, 3, 6),
  faceVertices: Int32Array.of(0, 1, 2, 0, 2, 3),
};

/** Of segment k of a chain of points. */
function fromSegment(point: Float64Array, chain: Float64Array, k: number): number {
  const [a, b] = [chain.subarray(3 * k, 3 * k + 3), chain.subarray(3 * k + 3, 3 * k + 6)];
  const along = b.map((x, i) => x - a[i]!);
  const length = along.reduce((sum, x) => sum + x * x, 0);
  const part = along.reduce((sum, x, i) => sum + x * (point[i]! - a[i]!), 0) / length;
  const clamped = length > 0 ? Math.min(1, Math.max(0, part)) : 0;
  return Math.hypot(...point.map((x, i) => x - a[i]! - clamped * along[i]!));
}

const triangles = ({ positions, triangles: faceVertices }: Surface): Mesh => ({
  positions,
  faceStart: Int32Array.from({ length: faceVertices.length / 3 + 1 }, (_, f) => 3 * f),
  faceVertices,
});

describe('a surface', () => {
  test('measures a net of cut cells by the length of its whole edges, if that is given', () => {
    const { positions, faceStart, faceVertices } = SQUARE;
    const net = { positions: positions.map((x, i) => (i % 3 === 1 ? 0.5 * x : x)), faceStart, faceVertices };
    withSurface(chebnet.openSurface(SQUARE), (square) => {
      expect(square.measure(net)).toMatchObject({ wholeCells: 0 });
      expect(square.measure(net, 3)).toMatchObject({ length: 3, wholeCells: 0 });
      for (const length of [0, -1, Number.NaN])
        expect(() => square.measure(net, length)).toThrow('the length of whole edges must be a number above 0');
    });
    withSurface(chebnet.ownSurface('hemisphere'), (hemisphere) => {
      const { length, ...begun } = hemisphere.suggest(10);
      const { mesh } = hemisphere.drape({ ...begun, length, border: 'cut' });
      const report = hemisphere.measure(mesh, length);
      expect(report.length).toBe(length);
      expect(report.wholeCells).toBeGreaterThan(0);
      expect(report.smallestAngle).toBeLessThan(Math.PI / 2);
    });
  });

  test('is described', () => {
    withSurface(chebnet.openSurface(SQUARE), (square) => {
      expect(square.describe()).toMatchObject({
        vertices: 4,
        triangles: 2,
        components: 1,
        boundaryLoops: 1,
        genus: 0,
        area: 1,
        prospect: 'one_piece',
        sentence: 'One uncut piece will cover it.',
      });
      expect(square.normals).toEqual(Float64Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1));
    });
  });

  test('finds what is nearest, and what a ray meets', () => {
    withSurface(chebnet.openSurface(SQUARE), (square) => {
      expect(square.nearest([0.25, -3, 1])).toEqual({ position: [0.25, 0, 0], normal: [0, 0, 1] });
      expect(square.hit([0.5, 0.25, 5], [0, 0, -1])?.position).toEqual([0.5, 0.25, 0]);
      expect(square.hit([0.5, 0.25, 5], [0, 0, 1])).toBeNull();
    });
  });

  test('of our own is made by its name; each says what it is', () => {
    const all = chebnet.ownSurfaces();
    expect(all.map(({ name }) => name)).toContain('hypar');
    for (const { name, title, sentence } of all) {
      expect([title, sentence].every((words) => words.length > 3)).toBe(true);
      withSurface(chebnet.ownSurface(name), (surface) => expect(surface.describe().triangles).toBeGreaterThan(1000));
    }
  });
});

describe('a net on it', () => {
  test.each(chebnet.ownSurfaces().map(({ name }) => name))('is the one of the native program: %s', (name) => {
    withSurface(chebnet.ownSurface(name), (surface) => {
      const suggested = surface.suggest(600);
      const { mesh, places } = surface.drape(suggested);
      const report = surface.measure(mesh);

      const [file, out] = [join(folder, `${name}.obj`), join(folder, `${name}-net.obj`)];
      writeFileSync(file, objText(triangles(surface)));
      const settings = ['--seed', ...suggested.seed, '--direction', ...suggested.direction, '--edge', suggested.length];
      const { net } = JSON.parse(
        execFileSync(PROGRAM, ['drape', file, '-o', out, ...settings.map(String)], { encoding: 'utf8' }),
      );
      const native = chebnet.readMesh(readFileSync(out), 'net.obj');
      expect(native.faceVertices).toEqual(mesh.faceVertices);
      expect(largestDistance(native.positions, mesh.positions)).toBeLessThan(1e-9);
      expect(report.coverage).toBeCloseTo(net.coverage, 6);
      expect(report.rods).toBe(net.rods);
      expect(report.muchSheared).toBeCloseTo(net.part_of_cells_sheared_over_30_degrees, 6);

      expect(places).toHaveLength((2 * mesh.positions.length) / 3);
      const editor = chebnet.openMesh(mesh);
      for (const length of edgeLengths(mesh.positions, editor.edges)) expect(length).toBeCloseTo(suggested.length, 9);
      expect(editor.info.isChebyshev).toBe(true);
      editor.dispose();
      expect(report.maxDeviation).toBeLessThan(1e-12);
      expect(report.smallestAngle).toBeGreaterThan(Math.PI / 6 - 1e-9);
    });
  });

  test('has arms that bend to shear least, or follow a curve', () => {
    withSurface(chebnet.ownSurface('shell'), (shell) => {
      const options = { ...shell.suggest(1500), seed: [1.5, -0.8, 1] as Point };
      const [straight, bent] = [shell.drape(options), shell.drape({ ...options, arms: 'least_shear' })];
      expect([straight.arms, bent.arms]).toEqual(['geodesic', 'least_shear']);
      const [before, now] = [shell.measure(straight.mesh), shell.measure(bent.mesh)];
      expect(now.sheared).toBeLessThan(before.sheared / 2);
      expect(now.smallestAngle).toBeGreaterThan(before.smallestAngle);
      expect(now.maxDeviation).toBeLessThan(1e-12);

      const ends: Point[] = [
        [-1.5, -0.5, 1],
        [1.5, 0.5, 1],
      ];
      const along = ends.map((end) => shell.nearest(end).position);
      const drawn = shell.drape({ ...options, arms: 'curve', along });
      expect(drawn.arms).toBe('curve');
      expect(shell.measure(drawn.mesh).maxDeviation).toBeLessThan(1e-12);
      const path = shell.cutPath(along);
      const begin = drawn.places.findIndex((_, k, all) => k % 2 === 0 && all[k] === 0 && all[k + 1] === 0) / 2;
      const seed = drawn.mesh.positions.subarray(3 * begin, 3 * begin + 3);
      const distances = Array.from({ length: path.length / 3 - 1 }, (_, k) => fromSegment(seed, path, k));
      expect(Math.min(...distances)).toBeLessThan(1e-9);
      expect(shell.drapePieces({ ...options, arms: 'curve', along }).arms).toBe('curve');

      const refused = (change: object) => failure(() => shell.drape({ ...options, arms: 'curve', along, ...change }));
      expect(refused({ arms: 'bent' })).toMatchObject({ code: 'bad_option' });
      expect(refused({ along: [] })).toMatchObject({ code: 'bad_option' });
      expect(refused({ along: 5 })).toMatchObject({ code: 'bad_option' });
      expect(refused({ along: [[0, 0]] }).message).toContain('a point of the curve');
    });
  });

  test('is proposed at the best of several beginnings first', () => {
    withSurface(chebnet.ownSurface('torso'), (torso) => {
      const { length } = torso.suggest(500);
      const proposals = torso.propose({ length });
      expect(proposals.length).toBeGreaterThan(3);
      const worth = proposals.map(({ covered, muchSheared }) => covered - 0.05 * muchSheared);
      expect(worth).toEqual([...worth].sort((a, b) => b - a));
      expect(torso.drape({ ...proposals[0]!, length }).mesh.faceStart.length).toBeGreaterThan(400);
      const upright = torso.propose({ length, direction: [0, 0, 1] });
      expect(new Set(upright.map(({ direction }) => direction.join()))).toEqual(new Set(['0,0,1']));
    });
  });

  test('is one for each piece of a surface that is cut, as the native program has them', () => {
    withSurface(chebnet.ownSurface('shell'), (shell) => {
      const suggested = shell.suggest(300);
      const [from, to] = [shell.nearest([-50, 0.3, 0]).position, shell.nearest([50, 0.2, 0]).position];
      const path = shell.cutPath([from, to]);
      expect([...path.slice(0, 2), ...path.slice(-3, -1)].every(Number.isFinite)).toBe(true);
      withSurface(shell.cut([[from, to]]), (halves) => {
        expect([halves.describe().components, halves.describe().boundaryLoops]).toEqual([2, 2]);
        expect(halves.describe().area).toBeCloseTo(shell.describe().area, 9);
        const { mesh, places, pieces, bare } = halves.drapePieces(suggested);
        expect([pieces, bare]).toEqual([2, 0]);
        expect(places).toHaveLength((2 * mesh.positions.length) / 3);
        expect([places[0], shell.measure(mesh).coverage > 0.98]).toEqual([0, true]);
        const cut = [from, to].map((point) => point.join(',')).join(' ');
        const command = ['drape', '--surface', 'shell', '--edge', `${suggested.length}`, '--cut-along', cut];
        const report = JSON.parse(execFileSync(PROGRAM, command, { encoding: 'utf8' }));
        expect(report.pieces).toHaveLength(2);
        expect(report.described.area).toBeCloseTo(halves.describe().area, 9);
      });
      expect(() => shell.cut([[from]])).toThrow('cut 1 needs at least two points');
    });
  });

  test('is cut the shortest way to its border, and between borders until it has one', () => {
    withSurface(chebnet.ownSurface('torso'), (torso) => {
      const between = torso.shortestCut(null);
      withSurface(torso.cut([between]), (open) => {
        expect(open.describe().boundaryLoops).toBe(1);
        const [from, to] = open.shortestCut([0, 0, 0]);
        expect(torso.nearest([0, 0, 0]).position).toEqual(from);
        expect(open.cutPath([from!, to!]).length).toBeGreaterThan(3);
        expect(failure(() => open.shortestCut(null)).message).toContain('no two borders');
      });
      expect(failure(() => torso.shortestCut([0, NaN, 0]))).toMatchObject({ code: 'non_finite' });
    });
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      expect(failure(() => pebble.shortestCut([0, 0, 0]))).toMatchObject({ code: 'bad_option' });
    });
  });

  test('covers more with the cuts that are proposed', () => {
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      const suggested = pebble.suggest(300);
      const { cuts, coverage } = pebble.proposeCuts(suggested, 1);
      expect(cuts).toHaveLength(1);
      expect(coverage[1]).toBeGreaterThan(coverage[0]! + 0.005);
    });
  }, 60_000);

  test('is cut at the border as the native program does', () => {
    withSurface(chebnet.ownSurface('shell'), (shell) => {
      const suggested = shell.suggest(300);
      const { mesh, cutEnds } = shell.drape({ ...suggested, border: 'cut' });
      const report = shell.measure(mesh);
      const settings = ['--seed', ...suggested.seed, '--direction', ...suggested.direction, '--edge', suggested.length];
      const command = ['drape', '--surface', 'shell', '--cut', ...settings.map(String)];
      const { net } = JSON.parse(execFileSync(PROGRAM, command, { encoding: 'utf8' }));
      expect([cutEnds, mesh.positions.length / 3]).toEqual([net.rod_ends_cut_at_the_border, net.vertices]);
      expect(cutEnds).toBeGreaterThan(40);
      expect(report.length).toBeCloseTo(suggested.length, 9);
      expect(report.rodLength).toBeCloseTo(net.rod_length, 6);
      expect(report).toMatchObject({ maxDeviation: 0, coverage: expect.closeTo(1, 3) });
    });
  });

  test('leaves the surface where it would lock, no farther than is asked for', () => {
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      const suggested = pebble.suggest(250);
      const covered = (leave: number) => pebble.measure(pebble.drape({ ...suggested, leave }).mesh).coverage;
      expect(covered(1)).toBeGreaterThan(covered(0));
      const { mesh } = pebble.drape({ ...suggested, leave: 0.25 });
      const heights = Array.from({ length: mesh.positions.length / 3 }, (_, v) => {
        const [x, y, z] = mesh.positions.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
        const [p, q, r] = pebble.nearest([x, y, z]).position;
        return Math.hypot(x - p, y - q, z - r);
      });
      expect(Math.max(...heights)).toBeLessThanOrEqual(0.25 * suggested.length);
      expect(failure(() => pebble.drape({ ...suggested, leave: 11 }))).toMatchObject({ code: 'bad_option' });
    });
  });

  test('keeps to what is asked for', () => {
    withSurface(chebnet.openSurface(SQUARE), (square) => {
      const settings = { seed: [0.5, 0.5, 0], direction: [1, 0, 0], length: 0.1 } as const;
      const cells = (options: object) => square.drape({ ...settings, ...options }).mesh.faceStart.length - 1;
      expect(cells({ reach: 2 })).toBe(16);
      expect(cells({ border: 'inside' })).toBeLessThan(cells({}));
      expect(square.measure(square.drape({ ...settings, angle: Math.PI / 3 }).mesh)).toMatchObject({ sheared: 1 });
    });
  });
});

describe('a net over a whole surface', () => {
  test('is of quads whose edges have one length, as the native program makes it', () => {
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      const told = new Set<string>();
      const { mesh, singularVertices, milliseconds } = pebble.remesh({ cells: 200, fewest: true }, (phase) =>
        told.add(phase),
      );
      expect(['border', ...told]).toEqual(Object.keys(milliseconds));
      expect(milliseconds.border).toBe(0); // it has none
      expect(singularVertices).toEqual([{ valence: 3, count: 8 }]);
      const { maxDeviation, smallestAngle, coverage } = pebble.measure(mesh);
      expect(maxDeviation).toBeLessThan(1e-9);
      expect(smallestAngle).toBeGreaterThan(Math.PI / 6 - 1e-9);
      expect(coverage).toBeGreaterThan(0.95);

      const { net } = JSON.parse(
        execFileSync(PROGRAM, ['remesh', '--surface', 'pebble', '--cells', '200', '--fewest'], { encoding: 'utf8' }),
      );
      expect(net.cells).toBe(mesh.faceStart.length - 1);
      expect(net.singular_vertices_by_valence).toEqual({ 3: 8 });
    });
  });

  test('has singular vertices where they are wanted, and none where they are not', () => {
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      const first = pebble.remesh({ cells: 300 });
      expect(first.singular.map(({ valence }) => valence)).toEqual(Array(8).fill(3));
      expect(first.sharpQuads).toBe(0);
      expect(first.kept).toEqual({
        vertices: [],
        distances: [],
        intruders: [],
        others: 0,
        markedCreases: [],
        sentences: [],
      });
      const { length } = pebble.measure(first.mesh);
      let intruded = 0;
      first.singular.forEach(({ position: centre }, i) => {
        const point = first.singular[(i + 1) % 8]!.position;
        const made = pebble.remesh({
          cells: 300,
          singular: [{ point, valence: 3 }],
          forbidden: [{ centre, radius: 3 * length }],
        });
        const away = (to: Point) =>
          Math.min(...made.singular.map(({ position }) => Math.hypot(...position.map((x, k) => x - to[k]!))));
        expect(made.kept.vertices).toEqual([true]);
        expect(made.kept.distances[0]).toBeLessThan(1.5);
        expect(away(point)).toBeLessThan(1.5 * length);
        expect(made.kept.sentences).toHaveLength(made.kept.intruders[0]!);
        expect(away(centre) > 3 * length).toBe(made.kept.intruders[0] === 0);
        intruded += made.kept.intruders[0]!;
      });
      expect(intruded).toBe(0);
    });
  });

  test('has net lines along creases that are marked, and says how near they are', () => {
    withSurface(chebnet.ownSurface('hemisphere'), (hemisphere) => {
      const over: Point[] = [0, 1, 2, 3, 4].map((k) => {
        const angle = (k * Math.PI) / 4;
        return [-3 * Math.cos(angle), 1.2 * Math.sin(angle), 2.7 * Math.sin(angle)];
      });
      const { kept, mesh } = hemisphere.remesh({ cells: 500, markedCreases: [over] });
      expect(kept.markedCreases).toEqual([{ followed: true, distance: expect.any(Number) }]);
      expect(kept.markedCreases[0]!.distance).toBeLessThan(0.15);
      expect(kept.sentences).toEqual([]);
      expect(hemisphere.measure(mesh).maxDeviation).toBeLessThan(1e-9);
      const message = (markedCreases: unknown) =>
        failure(() => hemisphere.remesh({ markedCreases: markedCreases as Point[][] })).message;
      expect(message([over, [[0, 0, 3]]])).toContain('marked crease 2 needs at least two points');
      expect(message([[[0, 0]]])).toContain('a point of a marked crease');
      expect(message('all')).toContain('marked creases must be an array');
    });
  });

  test('says what is missing to singular vertices alone, and refuses what is none', () => {
    withSurface(chebnet.ownSurface('pebble'), (pebble) => {
      const at: Point = [0, 0, 1];
      const message = (options: RemeshOptions) => failure(() => pebble.remesh(options)).message;
      expect(message({ only: true })).toContain('8 more of valence 3 are missing');
      expect(message({ singular: [{ point: at, valence: 4 as 3 }] })).toContain('must be 3, 5 or 6');
      expect(message({ singular: [{ point: [0, 0] as never, valence: 3 }] })).toContain(
        'the place of a singular vertex',
      );
      expect(message({ forbidden: [{ centre: at, radius: 0 }] })).toContain('radius');
      expect(message({ crease: 9 })).toContain('angle of creases');
      expect(message({ border: 'often' as never })).toContain('often');
      expect(message({ forbidden: 'all' as never })).toContain('must be an array');
    });
  });

  test('ends the net in a net line where the surface ends if that is asked for', () => {
    withSurface(chebnet.ownSurface('shell'), (shell) => {
      const corners = (options: RemeshOptions) => {
        const { mesh } = shell.remesh({ cells: 300, ...options });
        const editor = chebnet.openMesh(mesh);
        const degrees = new Map<number, number>();
        for (const vertex of editor.edges) degrees.set(vertex, (degrees.get(vertex) ?? 0) + 1);
        editor.dispose();
        return [...degrees.values()].filter((degree) => degree === 2).length;
      };
      expect(corners({ border: 'always' })).toBe(4);
      expect(corners({ border: 'never' })).toBeGreaterThan(4);
      expect(corners({ border: 'across' })).toBeGreaterThan(corners({ border: 'never' }));
      expect(corners({})).toBe(corners({ border: 'fitting' }));
    });
  });

  test('keeps to the length, and says why there is none', () => {
    withSurface(chebnet.ownSurface('hypar'), (hypar) => {
      const { mesh } = hypar.remesh({ length: 0.5 });
      const editor = chebnet.openMesh(mesh);
      for (const length of edgeLengths(mesh.positions, editor.edges)) expect(length).toBeCloseTo(0.5, 9);
      editor.dispose();
      expect(failure(() => hypar.remesh({ length: 50 }))).toMatchObject({ code: 'bad_option' });
      expect(failure(() => hypar.remesh({ cells: 1e7 }))).toMatchObject({ code: 'too_large' });
      expect(failure(() => hypar.remesh({ smoothing: NaN }))).toMatchObject({ code: 'non_finite' });
    });
  });
});

test('what makes no sense is refused with a code, and a disposed surface is of no use', () => {
  const square = chebnet.openSurface(SQUARE);
  const settings = { seed: [0, 0, 0] as Point, direction: [1, 0, 0] as Point, length: 0.1 };
  expect(failure(() => square.drape({ ...settings, length: 0 }))).toMatchObject({ code: 'bad_option' });
  expect(failure(() => square.drape({ ...settings, direction: [0, 0, 1] }))).toMatchObject({ code: 'bad_option' });
  expect(failure(() => square.drape({ ...settings, seed: [NaN, 0, 0] }))).toMatchObject({ code: 'non_finite' });
  expect(failure(() => square.drape({ ...settings, reach: 0.5 }))).toMatchObject({ code: 'bad_option' });
  expect(failure(() => square.drape({ ...settings, border: 'nowhere' as 'inside' }))).toMatchObject({
    code: 'bad_option',
  });
  expect(failure(() => square.nearest([0, 0] as unknown as Point))).toMatchObject({ code: 'non_finite' });
  expect(failure(() => square.hit([0, 0, Infinity], [0, 0, 1]))).toMatchObject({ code: 'non_finite' });
  expect(failure(() => chebnet.ownSurface('plain'))).toMatchObject({ code: 'bad_option' });
  const twisted = { ...SQUARE, faceVertices: Int32Array.of(0, 1, 2, 0, 3, 2) };
  expect(failure(() => chebnet.openSurface(twisted))).toMatchObject({ code: 'non_manifold_edge' });
  square.dispose();
  expect(failure(() => square.describe())).toMatchObject({ code: 'disposed' });
});

describe('as a guide', () => {
  const edited = () => {
    const surface = chebnet.ownSurface('hypar');
    const { mesh } = surface.drape({ ...surface.suggest(200) });
    const editor = chebnet.openMesh(mesh);
    const last = editor.info.vertices - 1;
    const at = (v: number, lift: number): [number, number, number] => [
      mesh.positions[3 * v]!,
      mesh.positions[3 * v + 1]!,
      mesh.positions[3 * v + 2]! + lift,
    ];
    editor.setHandles([
      { vertex: 0, target: at(0, 0) },
      { vertex: last, target: at(last, 0.3) },
    ]);
    return { surface, editor };
  };
  const height = (heights: Float32Array) => Math.hypot(...heights);

  test('it keeps a net near, through other states, until it is taken away', () => {
    const { surface, editor } = edited();
    expect(editor.fields().height.every((each) => each === 0)).toBe(true);
    editor.setGuide(surface);
    surface.dispose();
    editor.setOption('guide_mode', 0);
    editor.solve();
    const far = height(editor.fields().height);
    editor.setState({ ...editor.state(), options: { guide_mode: 1 } });
    editor.solve();
    expect(height(editor.fields().height)).toBeLessThan(far);
    editor.setGuide(null);
    expect(height(editor.fields().height)).toBe(0);
    editor.dispose();
  });

  test('what is no surface is refused', () => {
    const { surface, editor } = edited();
    surface.dispose();
    expect(failure(() => editor.setGuide(surface)).code).toBe('disposed');
    expect(failure(() => editor.setGuide({} as never)).code).toBe('bad_option');
    editor.dispose();
  });
});

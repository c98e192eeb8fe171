/** Equalising here is what the native program does, in slices as in a piece; what makes no sense is refused. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, test } from 'vitest';
import type { EqualizeOptions, EqualizeReport, Mesh } from '../../wasm/chebnet';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { objText } from '../../web/src/document/obj_text';
import { ROOT, failure, largestDistance, load } from './load';

const PROGRAM = fileURLToPath(new URL('build/native/chebnet', ROOT));
const chebnet = await load();
const folder = mkdtempSync(join(tmpdir(), 'chebnet-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** A gallery shape, stretched and bent. */
function unevenMesh(recipe: string): Mesh {
  const editor = chebnet.openRecipe(recipe);
  const { restPositions, faceStart, faceVertices, info } = editor;
  const wave = 5 * info.meanLength;
  const positions = restPositions.map(
    (x, i) => x * (1 + 0.1 * (i % 3)) + 0.15 * info.meanLength * Math.sin(i + x / wave),
  );
  editor.dispose();
  return { positions, faceStart, faceVertices };
}

/** All ten pairs of five vertices joined: space has no five points at one distance from each other. */
const FIVE: Mesh = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1),
  faceStart: Int32Array.of(0, 3, 6, 9, 12, 15),
  faceVertices: Int32Array.of(0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1),
};

function equalizeHere(mesh: Mesh, options: EqualizeOptions = {}): { report: EqualizeReport; positions: Float64Array } {
  const equalizer = chebnet.equalizer(mesh, options);
  const report = equalizer.solve();
  const positions = equalizer.positions();
  equalizer.dispose();
  return { report, positions };
}

function equalizeNatively(
  mesh: Mesh,
  ...options: string[]
): { report: Record<string, unknown>; positions: Float64Array } {
  const [file, out] = [join(folder, 'mesh.obj'), join(folder, 'out.obj')];
  writeFileSync(file, objText(mesh));
  // Exit status 1 says "did not converge", which is a result like others; 2 says that something is wrong.
  const command = ['-c', '"$@" || [ $? -eq 1 ]', 'sh', PROGRAM, 'equalize', file, '-o', out, ...options];
  const report = JSON.parse(execFileSync('sh', command, { encoding: 'utf8' })) as Record<string, unknown>;
  const { positions } = chebnet.readMesh(readFileSync(out), 'out.obj');
  return { report, positions };
}

function lengthsOf({ faceStart, faceVertices }: Mesh, positions: Float64Array): Float64Array {
  const editor = chebnet.openMesh({ positions, faceStart, faceVertices });
  const lengths = edgeLengths(positions, editor.edges);
  editor.dispose();
  return lengths;
}

const cases: [string, string, EqualizeOptions, string[]][] = [
  ['the mean length', 'dome:vertices=600', {}, []],
  ['lengths alone', 'dome:vertices=600', { method: 'projection' }, ['--method', 'projection']],
  [
    'the fitting length',
    'torus:vertices=600',
    { length: 'fitting', method: 'projection' },
    ['--length', 'fit', '--method', 'projection'],
  ],
  [
    'a length that is given, and handles',
    'vault:vertices=600',
    { length: 1.1, handles: [0, 7], method: 'projection' },
    ['--length', '1.1', '--hold', '0', '7', '--method', 'projection'],
  ],
];

describe.each(cases)('with %s', (_, recipe, options, native) => {
  const mesh = unevenMesh(recipe);
  const { report, positions } = equalizeHere(mesh, options);

  test('all edges of a mesh become equal', () => {
    expect(report.status).toBe('converged');
    expect(report.maxDeviation).toBeLessThan(1e-9);
    for (const length of lengthsOf(mesh, positions)) expect((length / report.length - 1) ** 2).toBeLessThan(1.1e-9);
    for (const v of options.handles ?? [])
      expect(positions.subarray(3 * v, 3 * v + 3)).toEqual(mesh.positions.subarray(3 * v, 3 * v + 3));
    expect(report.worstEdges).toEqual([]);
  });

  test('it is the net of the native program', () => {
    const { report: expected, positions: there } = equalizeNatively(mesh, ...native);
    expect(expected.status).toBe('converged');
    expect(Math.abs(report.iterations - Number(expected.iterations))).toBeLessThanOrEqual(1);
    if (report.iterations !== expected.iterations) return;
    expect(report.length).toBeCloseTo(Number(expected.length), 9);
    expect(report.fittingLength).toBeCloseTo(Number(expected.fitting_length), 6);
    expect(report.method).toBe(expected.method);
    expect(report.distance?.mean).toBeCloseTo(Number(expected.mean_distance_in_lengths), 5);
    expect(report.maxMove).toBeCloseTo(Number(expected.max_move_in_lengths), 5);
    expect(largestDistance(positions, there)).toBeLessThan(1e-6 * report.length);
  });

  test('slices come to the same bits', () => {
    const equalizer = chebnet.equalizer(mesh, options);
    let slice: EqualizeReport;
    let count = 0;
    do {
      slice = equalizer.solve({ iterations: 1 });
      expect(slice.iterations).toBe(++count);
    } while (slice.status === 'running');
    expect({ ...slice, milliseconds: 0 }).toEqual({ ...report, milliseconds: 0 });
    expect(equalizer.positions()).toEqual(positions);
    equalizer.dispose();
  });
});

test('with a guide it comes near that, and the guide may be disposed of', () => {
  const mesh = unevenMesh('vault:vertices=600');
  const positions = mesh.positions.map((x, i) => (i % 3 === 2 ? 0.9 * x + 0.4 : x));
  const guide = chebnet.openSurface({ ...mesh, positions });
  const own = equalizeHere(mesh);
  const equalizer = chebnet.equalizer(mesh, { guide });
  const far = guide.measure({ ...mesh, positions: own.positions }).meanDistance;
  guide.dispose();
  const report = equalizer.solve();
  expect(report).toMatchObject({ status: 'converged', method: 'equilibrium' });
  expect(report.maxDeviation).toBeLessThan(1e-9);
  expect(report.distance!.mean * report.length).toBeLessThan(far / 2);
  expect(equalizer.surfacePositions()).toBeNull();
  equalizer.dispose();
  expect(failure(() => chebnet.equalizer(mesh, { guide })).code).toBe('disposed');
});

describe('what cannot be is refused', () => {
  test('with the best that was found, as natively', () => {
    const { report } = equalizeHere(FIVE);
    const { report: expected } = equalizeNatively(FIVE);
    expect(report.status).toBe(expected.status);
    expect(['stalled', 'max_iterations']).toContain(report.status);
    expect(report.worstEdges.length).toBeGreaterThan(0);
    expect(report.worstEdges[0]).toEqual({
      vertexA: expect.any(Number),
      vertexB: expect.any(Number),
      length: expect.any(Number),
    });
  });

  test('with the handles that are too far apart', () => {
    const mesh = unevenMesh('vault:vertices=600');
    const last = mesh.positions.length / 3 - 1;
    const { report } = equalizeHere(mesh, { length: 0.01, handles: [0, last] });
    expect(report.status).toBe('unreachable');
    expect(report.unreachablePairs).toMatchObject([{ vertexA: 0, vertexB: last }]);
  });

  const wrong: [string, string, () => unknown][] = [
    ['an unknown length', 'bad_option', () => chebnet.equalizer(FIVE, { length: 'median' as never })],
    ['a length that is no number', 'bad_option', () => chebnet.equalizer(FIVE, { length: {} as never })],
    ['no length at all', 'bad_option', () => chebnet.equalizer(FIVE, { length: 0 })],
    ['NaN', 'bad_option', () => chebnet.equalizer(FIVE, { length: NaN })],
    ['a fitting length with handles', 'bad_option', () => chebnet.equalizer(FIVE, { length: 'fitting', handles: [1] })],
    ['half a handle', 'index_out_of_range', () => chebnet.equalizer(FIVE, { handles: [0.5] })],
    ['another method', 'bad_option', () => chebnet.equalizer(FIVE, { method: 'arap' as never })],
    ['a limit that is none', 'bad_option', () => chebnet.equalizer(FIVE, { shearLimit: 2 })],
    ['a guide that is none', 'bad_option', () => chebnet.equalizer(FIVE, { guide: 'hypar' as never })],
    ['a handle too far', 'index_out_of_range', () => chebnet.equalizer(FIVE, { handles: [5] })],
    ['a handle twice', 'repeated_vertex', () => chebnet.equalizer(FIVE, { handles: [1, 1] })],
    ['handles that are none', 'bad_option', () => chebnet.equalizer(FIVE, { handles: 3 as never })],
    ['no mesh', 'bad_syntax', () => chebnet.equalizer({} as never)],
    ['a budget that is none', 'bad_option', () => chebnet.equalizer(FIVE).solve({ iterations: -1 })],
  ];
  test.each(wrong)('%s', (_, code, action) => {
    expect(failure(action).code).toBe(code);
  });

  test('an equalizer after its end', () => {
    const equalizer = chebnet.equalizer(FIVE);
    equalizer.dispose();
    equalizer.dispose();
    expect(failure(() => equalizer.solve()).code).toBe('disposed');
  });
});

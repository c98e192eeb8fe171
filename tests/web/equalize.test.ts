/** Equalising without a page: what the worker answers, what the net in the picture is, what becomes of the scene. */
import { describe, expect, test } from 'vitest';
import type { EqualizeOptions, Mesh } from '../../wasm/chebnet';
import { between, meanLength, stillFrame } from '../../web/src/equalize/before_after';
import type { EqualizeRequest, EqualizeResponse } from '../../web/src/equalize/equalize_protocol';
import { equalize } from '../../web/src/equalize/equalize';
import { Equalizing } from '../../web/src/equalize/equalizing';
import { equalizedScene, subjectOfNet } from '../../web/src/equalize/subject';
import { freshScene } from '../../web/src/document/defaults';
import { load } from '../wasm/load';
import { uneven } from './nets';

const core = await load();
/** A Möbius strip of five vertices. */
const FIVE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n';

function answersTo(mesh: Mesh, options: EqualizeOptions = {}, guide?: EqualizeRequest['guide']): EqualizeResponse[] {
  const answers: EqualizeResponse[] = [];
  equalize(core, { mesh, options, guide }, (answer) => answers.push(answer));
  return answers;
}

describe('the worker', () => {
  test('gives the net', () => {
    const mesh = core.readMesh(new TextEncoder().encode(uneven(8, 6)), 'uneven.obj');
    const end = answersTo(mesh).at(-1)!;
    if (end.type !== 'ended') return expect.fail(`it ended with ${JSON.stringify(end)}`);
    expect(end.report).toMatchObject({ status: 'converged' });
    const editor = core.openMesh({ ...mesh, positions: end.positions });
    expect(editor.info.isChebyshev).toBe(true);
    editor.dispose();
  });

  test('gives the surface that the net is near, as large as the net, if there is one', () => {
    const surfaceOf = (text: string, options: EqualizeOptions = {}): Float64Array | null => {
      const end = answersTo(core.readMesh(new TextEncoder().encode(text), 'a.obj'), options).at(-1)!;
      return end.type === 'ended' ? end.surfacePositions : expect.fail(`it ended with ${JSON.stringify(end)}`);
    };
    const { positions } = core.readMesh(new TextEncoder().encode(uneven(8, 6)), 'uneven.obj');
    expect(surfaceOf(uneven(8, 6))).toEqual(positions);
    const width = (x: Float64Array): number => x[21]! - x[0]!;
    const mean = answersTo(core.readMesh(new TextEncoder().encode(uneven(8, 6)), 'uneven.obj')).at(-1)!;
    if (mean.type !== 'ended') return expect.fail('it did not end');
    const twice = surfaceOf(uneven(8, 6), { length: 2 * mean.report.length })!;
    expect(width(twice) / width(positions)).toBeCloseTo(2, 9);
    expect(surfaceOf(FIVE)).toBeNull();
  });

  test('brings the net near a guide', () => {
    const mesh = core.readMesh(new TextEncoder().encode(uneven(8, 6)), 'uneven.obj');
    const guide = {
      name: 'lifted',
      mesh: { ...mesh, positions: mesh.positions.map((x, i) => (i % 3 === 2 ? x + 1 : x)) },
    };
    const surface = core.openSurface(guide.mesh);
    const meanDistance = (to: EqualizeRequest['guide']) => {
      const end = answersTo(mesh, {}, to).at(-1)!;
      if (end.type !== 'ended') return expect.fail(`it ended with ${JSON.stringify(end)}`);
      expect(end.report.status).toBe('converged');
      expect(end.surfacePositions === null).toBe(to !== undefined);
      return surface.measure({ ...mesh, positions: end.positions }).meanDistance;
    };
    expect(meanDistance(guide)).toBeLessThan(meanDistance(undefined) / 2);
    surface.dispose();
    expect(answersTo(mesh, {}, { own: 'nothing' })).toMatchObject([{ type: 'error', code: 'bad_option' }]);
  });

  test('says so if they did not become equal', () => {
    expect(answersTo(core.readMesh(new TextEncoder().encode(FIVE), 'five.obj')).at(-1)).toMatchObject({
      type: 'ended',
      report: { status: expect.not.stringMatching('converged') },
    });
  });

  test('passes on what the core refuses', () => {
    const mesh = core.readMesh(new TextEncoder().encode(uneven(3, 3)), 'uneven.obj');
    expect(answersTo(mesh, { length: -1 })).toMatchObject([
      { type: 'error', code: 'bad_option', message: expect.stringMatching(/length/) },
    ]);
  });

  test('is ended with the end, and says nothing after it was given up', async () => {
    const worker = {
      onmessage: null as ((event: MessageEvent<EqualizeResponse>) => void) | null,
      onerror: null,
      ends: 0,
      postMessage() {},
      terminate: () => void ++worker.ends,
    };
    const equalizing = new Equalizing(() => worker);
    const run = equalizing.run({ mesh: {} as Mesh, options: {} }, () => {});
    worker.onmessage?.({
      data: { type: 'error', code: 'bad_option', message: 'no' },
    } as MessageEvent<EqualizeResponse>);
    await expect(run).rejects.toThrow('no');
    expect(worker.ends).toBe(1);
    expect(worker.onmessage).toBeNull();
  });
});

describe('the picture', () => {
  const net = { edges: Int32Array.of(0, 1, 1, 2) };
  const first = { positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 3, 0), length: 2 };
  const second = { positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0), length: 1 };

  test('goes from one shape to the other', () => {
    expect(between(first, second, 0)).toBe(first);
    expect(between(first, second, 1)).toBe(second);
    expect(between(first, second, 0.5)).toEqual({ positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 2, 0), length: 1.5 });
  });

  test('is coloured against the length of the moment', () => {
    expect(meanLength(first.positions, net)).toBe(2);
    expect(stillFrame(second, net)).toMatchObject({ fields: { deviation: Float32Array.of(0, 0) }, maxDeviation: 0 });
    expect(stillFrame({ ...first, length: 1 }, net)).toMatchObject({
      maxDeviation: expect.closeTo(3 + 1 / 3 - 2, 6),
    });
  });
});

test('handles of the net that was open stay at their vertices', () => {
  const net = { recipe: 'dome:vertices=500' };
  const mesh = { positions: new Float64Array(9), faceStart: Int32Array.of(0, 3), faceVertices: Int32Array.of(0, 1, 2) };
  const handles = [{ vertex: 4, target: [1, 2, 3] as [number, number, number], anchor: true }];
  const document = {
    ...freshScene(net),
    net,
    handles,
    positions: Float64Array.of(1, 2, 3),
    settled: true,
    options: { p: 4 },
  };
  expect(subjectOfNet({ ...document, guide: { own: 'hypar' } }, {} as never, []).guide).toEqual({ own: 'hypar' });
  expect(subjectOfNet(document, {} as never, [])).toMatchObject({
    name: 'dome.obj',
    positions: document.positions,
    handles: [4],
  });
  expect(equalizedScene(document, { mesh, surface: null, isResized: false }, [])).toMatchObject({
    net: { mesh, name: 'dome.obj' },
    handles: [{ vertex: 4, target: null, anchor: true }],
    options: { p: 4 },
    positions: null,
    settled: true,
  });
});

test('the surface it came from is beside the net, or the one that was there, as long as it fits', () => {
  const net = { recipe: 'dome:vertices=500' };
  const mesh = { positions: new Float64Array(9), faceStart: Int32Array.of(0, 3), faceVertices: Int32Array.of(0, 1, 2) };
  const surface = { ...mesh, positions: new Float64Array(9).fill(1) };
  const before = { ...freshScene(net), net, handles: [], positions: null, settled: true };
  const guided = { ...before, guide: { own: 'hypar' } };
  const guideOf = (document: typeof before, isResized: boolean, own: Mesh | null = surface) =>
    equalizedScene(document, { mesh, surface: own, isResized }, []).guide;
  expect(guideOf(before, false)).toEqual({ mesh: surface, name: 'dome.obj' });
  expect(guideOf(before, false, null)).toBeUndefined();
  expect(guideOf(guided, false)).toEqual({ own: 'hypar' });
  expect(guideOf(guided, true)).toEqual({ mesh: surface, name: 'dome.obj' });
});

test('what is taken is as long as it was made, and not how the net of before came to its end', () => {
  const mesh = { positions: new Float64Array(9), faceStart: Int32Array.of(0, 3), faceVertices: Int32Array.of(0, 1, 2) };
  const net = { recipe: 'dome:vertices=500' };
  const options = { length_scale: 1.1, threshold: 1e-8 };
  const ending = 'stalled' as const;
  const before = { ...freshScene(net), net, handles: [], positions: null, settled: true, options, ending };
  const taken = equalizedScene(before, { mesh, surface: null, isResized: false }, []);
  expect(taken.options).toEqual({ threshold: 1e-8 });
  expect(taken.ending).toBeUndefined();
});

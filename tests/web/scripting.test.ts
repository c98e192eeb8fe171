/** What scripts may give to `window.chebnet`: anything else is refused, with what and where. */
import { afterEach, expect, test, vi } from 'vitest';
import { readProject, writeProject } from '../../web/src/document/project';
import { createScripting } from '../../web/src/scripting';
import type { Scripting } from '../../web/src/scripting';
import { load } from '../wasm/load';
import { uneven } from './nets';
import { openPage } from './page_without_pictures';
import type { Page } from './page_without_pictures';

const core = await load();

afterEach(() => vi.unstubAllGlobals());

/** A script that nobody checks types for. */
type Loose = { [Name in keyof Scripting]: (...given: unknown[]) => unknown };

async function pageWithDome(): Promise<Page & { script: Loose }> {
  const page = await openPage(core);
  const script = createScripting(page.app, Promise.resolve());
  await script.open({ recipe: 'dome:vertices=100' });
  await page.solve();
  return { ...page, script: script as Loose };
}

async function refusal(doing: () => unknown): Promise<unknown> {
  try {
    await doing();
  } catch (error) {
    return error;
  }
  return expect.fail('it was not refused');
}

test('a recipe may call a shape as its button says', async () => {
  const { app, script } = await pageWithDome();
  for (const { name, title } of core.shapes()) {
    await script.open({ recipe: `${title}:vertices=200` });
    expect(app.opening?.document.net).toEqual({ recipe: `${name}:vertices=200` });
  }
});

test.each<[call: keyof Scripting, given: unknown[], said: string]>([
  ['open', [], 'net must be a record with named fields'],
  ['open', ['dome'], 'net must be a record with named fields'],
  ['open', [{}], 'net must be a record with "recipe" or "obj"'],
  ['open', [{ shape: 'dome' }], 'unknown field net.shape; known are recipe, obj, name'],
  ['open', [{ recipe: 5 }], 'net.recipe must be a text, not too long'],
  ['open', [{ recipe: null }], 'net.recipe must be a text, not too long'],
  ['open', [{ recipe: ['dome'] }], 'net.recipe must be a text, not too long'],
  ['open', [{ obj: new Uint8Array(3) }], 'net.obj must be a text, not too long'],
  ['open', [{ obj: '', name: 7 }], 'net.name must be a text, not too long'],
  ['setHandles', [], 'handles must be a list'],
  ['setHandles', [{ vertex: 0 }], 'handles must be a list'],
  ['setHandles', [[0]], 'handles[0] must be a record with named fields'],
  ['setHandles', [[{ vertex: 0 }, {}]], 'handles[1].vertex must be a number'],
  ['setHandles', [[{ vertex: 0.5 }]], 'handles[0].vertex must be a whole number from 0 to 2147483647'],
  ['setHandles', [[{ vertex: 0, target: [0, 0] }]], 'handles[0].target must be a point: three numbers'],
  ['setHandles', [[{ vertex: 0, target: [0, 0, '1'] }]], 'handles[0].target[2] must be a number'],
  ['setHandles', [[{ vertex: 0, anchor: 1 }]], 'handles[0].anchor must be true or false'],
  ['setHandles', [[{ vertex: 0, name: {} }]], 'handles[0].name must be a text, not too long'],
  ['setHandles', [[{ vertex: 0, hidden: 'no' }]], 'handles[0].hidden must be true or false'],
  ['setHandles', [[{ vertex: 0, weight: 0 }]], 'handles[0].weight must be a number above 0'],
  ['setHandles', [[{ vertex: 0, weight: Infinity }]], 'handles[0].weight must be a number'],
  [
    'setHandles',
    [[{ vertex: 0 }, { vertex: 1, wieght: 2 }]],
    'unknown field handles[1].wieght; known are vertex, target, anchor, name, hidden, weight, slides',
  ],
  ['move', ['0', [0, 0, 0]], 'vertex must be a number'],
  ['move', [0], 'target must be a list'],
  ['move', [0, [0, 0, NaN]], 'target[2] must be a number'],
  ['setLocality', ['far'], 'radius must be a number'],
  ['setLocality', [-1], 'radius must be a number above 0'],
  ['setGuide', [{ own: 5 }], 'surface.own must be a text, not too long'],
  ['setGuide', [{ vertices: [[0, 0]], faces: [] }], 'surface.vertices[0] must be a point: three numbers'],
  ['setGuide', [{ vertices: [], faces: [[-1]] }], 'surface.faces[0][0] must be a whole number from 0 to 2147483647'],
  ['setGuide', [{}], 'surface must be a record with "own", or with "vertices" and "faces"'],
  ['setGuide', [{ own: 'shell', radius: 2 }], 'unknown field surface.radius; known are own, vertices, faces, name'],
  ['describe', [null], 'surface must be a record with named fields'],
  ['drape', [{ own: 'hypar' }, { seed: [0, 0] }], 'options.seed must be a point: three numbers'],
  ['drape', [{ own: 'hypar' }, { border: 'fitting' }], 'options.border must be one of inside, beyond, cut'],
  ['drape', [{ own: 'hypar' }, { arms: 'bent' }], 'options.arms must be one of geodesic, least_shear, curve'],
  ['drape', [{ own: 'hypar' }, { along: [[0, 0]] }], 'options.along[0] must be a point: three numbers'],
  ['drape', [{ own: 'hypar' }, { cuts: 'drawn' }], 'options.cuts must be a list'],
  ['drape', [{ own: 'hypar' }, { length: 0 }], 'options.length must be a number above 0'],
  ['remesh', [{ own: 'hypar' }, { cells: 1.5 }], 'options.cells must be a whole number from 0 to 2147483647'],
  ['remesh', [{ own: 'hypar' }, { markedCreases: [3] }], 'options.markedCreases[0] must be a list'],
  ['remesh', [{ own: 'hypar' }, { singular: [{ valence: 3 }] }], 'options.singular[0].point must be a list'],
  ['setOptions', [null], 'options must be a record with named fields'],
  ['setOptions', [{ method: 5 }], 'options.method must be a text, not too long'],
  ['setOptions', [{ threshold: '1e-8' }], 'options.threshold must be a number'],
  ['on', ['click', () => {}], 'event must be one of frame, settled, error'],
  ['on', ['frame'], 'listener must be a function'],
  ['screenPosition', [-1], 'vertex must be a whole number from 0 to 2147483647'],
])('%s(%j) is refused: %s', async (call, given, said) => {
  const { script, app } = await pageWithDome();
  const before = app.opening;
  expect(await refusal(() => script[call](...given))).toMatchObject({ code: 'bad_arguments', message: said });
  expect(app.opening).toBe(before);
});

/** One list many times: it takes no room until somebody reads it. */
const times = (count: number, each: unknown) => Array(count).fill(each) as unknown[];

test.each<[what: string, call: 'drape' | 'remesh', options: object, said: string]>([
  ['a line of many points', 'drape', { along: times(1e6, [0, 0, 0]) }, 'options.along must be a list'],
  ['many cuts', 'drape', { cuts: times(1e5, times(1000, [0, 0, 0])) }, 'options.cuts must be a list'],
  ['many creases', 'remesh', { markedCreases: times(1e5, []) }, 'options.markedCreases must be a list'],
  ['many marks', 'remesh', { singular: times(1e6, { valence: 3 }) }, 'options.singular must be a list'],
  ['many regions', 'remesh', { forbidden: times(1e6, { radius: 3 }) }, 'options.forbidden must be a list'],
])('%s on a surface is refused', async (_, call, options, message) => {
  const { script } = await pageWithDome();
  const refused = await refusal(() =>
    (script[call] as (...given: unknown[]) => Promise<unknown>)({ own: 'hypar' }, options),
  );
  expect(refused).toMatchObject({ code: 'bad_arguments', message: expect.stringContaining(`${message} of at most`) });
});

test.each<[call: keyof Scripting, given: unknown[], code: string]>([
  ['open', [{ recipe: 'no such shape' }], 'bad_option'],
  ['open', [{ obj: 'v 0 0 0\nf 1 2 3\n' }], 'index_out_of_range'],
  ['setHandles', [[{ vertex: 1e6 }]], 'index_out_of_range'],
  ['move', [1e6, [0, 0, 0]], 'index_out_of_range'],
  ['setGuide', [{ own: 'moon' }], 'bad_option'],
  [
    'setGuide',
    [
      {
        vertices: [
          [0, 0, 0],
          [1, 0, 0],
        ],
        faces: [[0, 1, 2]],
      },
    ],
    'index_out_of_range',
  ],
  ['setOptions', [{ no_such_option: 1 }], 'bad_option'],
  ['move', [0, [0, 0, 1e308]], 'bad_scale'],
])('what only the core can judge it refuses: %s(%j)', async (call, given, code) => {
  const { script } = await pageWithDome();
  expect(await refusal(() => script[call](...given))).toMatchObject({ code });
});

test('a net with a name as long as no file has it is kept under the beginning of that, which is read again', async () => {
  const { script, app } = await pageWithDome();
  await script.open({ obj: uneven(4, 4), name: 'x'.repeat(600) });
  expect(app.opening!.document.net).toMatchObject({ name: 'x'.repeat(255) });
  const { entries } = readProject(writeProject(app.project()!, Infinity));
  expect(entries.at(-1)!.name).toEqual(['open', 'x'.repeat(255)]);
});

test('a vertex that the net has not got is seen nowhere', async () => {
  const { script, app } = await pageWithDome();
  const { vertices } = app.opening!.net.info;
  expect(script.screenPosition(vertices - 1)).toEqual({ x: 0, y: 0 }); // there is no picture here
  expect(await refusal(() => script.screenPosition(vertices))).toMatchObject({
    code: 'index_out_of_range',
    message: `vertex must be a whole number from 0 to ${vertices - 1}`,
  });
});

test('points may be typed arrays', async () => {
  const { script, solve } = await pageWithDome();
  await script.setHandles([{ vertex: 3, target: Float64Array.of(1, 2, 3) }]);
  await solve();
  await script.move(3, Float32Array.of(4, 5, 6));
  expect(script.handles()).toMatchObject([{ vertex: 3, target: [4, 5, 6] }]);
  const refused = await refusal(() => script.move(3, new Float64Array(1e6)));
  expect(refused).toMatchObject({ code: 'bad_arguments', message: 'target must be a point: three numbers' });
});

test('what is left out, or given as undefined, is as if nobody had spoken of it', async () => {
  const { script, app, solve } = await pageWithDome();
  await script.open({ obj: uneven(4, 4) });
  await solve();
  expect(app.opening!.document.net).toMatchObject({ name: 'net.obj' });
  await script.setHandles([{ vertex: 0 }, { vertex: 5, name: undefined, anchor: undefined, weight: undefined }]);
  const { positions } = app.opening!.frame;
  expect(script.handles()).toEqual([
    { vertex: 0, target: [...positions.subarray(0, 3)], anchor: true },
    { vertex: 5, target: [...positions.subarray(15, 18)], anchor: true },
  ]);
  await script.setOptions({ method: undefined, threshold: undefined, max_iterations: 7 });
  expect(app.opening!.document).toMatchObject({ method: 'equilibrium', options: { max_iterations: 7 } });
  await script.setLocality(3);
  await script.setLocality(null);
  expect(app.opening!.document.locality).toBeUndefined();
});

test('a locality is refused where no net is open, and the one that is set already is no change', async () => {
  const { app } = await openPage(core);
  const early = createScripting(app, Promise.resolve());
  expect(await refusal(() => early.setLocality(3))).toMatchObject({ code: 'no_net' });

  const { script, app: open } = await pageWithDome();
  await script.setLocality(3);
  await open.undo();
  await script.setLocality(null);
  expect(open.history.canRedo).toBe(true);
});

test('surfaces that are only looked at are so one at a time: each takes a core', async () => {
  let [open, most] = [0, 0];
  class WorkerHere {
    onmessage: ((event: object) => void) | null = null;
    constructor() {
      open += 1;
      most = Math.max(most, open);
    }
    postMessage(): void {
      setTimeout(() => this.onmessage?.({ data: { type: 'opened', surface: { report: { area: 1 } } } }));
    }
    terminate(): void {
      open -= 1;
    }
  }
  vi.stubGlobal('Worker', WorkerHere);
  const { script } = await pageWithDome();
  const reports = await Promise.all([1, 2, 3].map(() => script.describe({ own: 'hypar' })));
  expect(reports).toEqual([{ area: 1 }, { area: 1 }, { area: 1 }]);
  expect([open, most]).toEqual([0, 1]);
});

test('calls that are sent together are carried out in this order, whatever each has to load first', async () => {
  const { script, solve } = await pageWithDome();
  const { vertex } = (script.handles() as { vertex: number }[]).at(-1)!;
  const moved = [script.setHandles([{ vertex: 0, anchor: true }, { vertex }]), script.move(vertex, [1, 2, 3])];
  await moved[0];
  await solve();
  await moved[1];
  expect(script.handles()).toMatchObject([{ vertex: 0 }, { vertex, target: [1, 2, 3] }]);

  const refused = refusal(() => script.setHandles([{ vertex: 1e6 }]));
  await Promise.all([script.open({ recipe: 'vault:vertices=100' }), script.setHandles([{ vertex: 3 }])]);
  expect(await refused).toMatchObject({ code: 'index_out_of_range' });
  expect(script.handles()).toMatchObject([{ vertex: 3 }]);
});

test('a listener that fails is reported, and keeps neither another nor the net from going on', async () => {
  const faults = vi.fn();
  vi.stubGlobal('reportError', faults);
  const { script, solve } = await pageWithDome();
  const heard: unknown[] = [];
  script.on('frame', () => {
    throw new Error('of the script');
  });
  for (const event of ['frame', 'settled']) script.on(event, () => heard.push(event));
  const { vertex } = (script.handles() as { vertex: number }[]).at(-1)!;
  await script.move(vertex, [0, 0, 1]);
  await solve();
  await script.settled();
  expect(heard).toContain('frame');
  expect(heard.at(-1)).toBe('settled');
  expect(faults).toHaveBeenCalledWith(new Error('of the script'));
});

/** Every call of WebAssembly that can fail, failing: its exception comes out as an Error with a code, in each engine. */
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { beforeEach, expect, test } from 'vitest';
import type { Chebnet, ChebnetError, EditState, Mesh } from '../../wasm/chebnet';
import type { Visitor } from './visitor';
import { visitors } from './visitor';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** What C++ gives to JavaScript and nothing makes fail. */
const SAFE = [
  ...['shapes', 'methods', 'initialisations', 'formats', 'defaultOptions', 'defects', 'memory'],
  ...[
    'info',
    'edges',
    'faceStart',
    'faceVertices',
    'restPositions',
    'restLengths',
    'netLines',
    'boundaryLoops',
    'suggestedHandles',
  ],
  ...[
    'method',
    'initialisation',
    'options',
    'handleVertices',
    'handleTargets',
    'handleWeights',
    'handleSlides',
    'locality',
  ],
  ...[
    'reset',
    'positions',
    'fields',
    'bend',
    'smallestAngle',
    'handleError',
    'unreachablePairs',
    'releaseHandles',
    'holdsBack',
  ],
  ...[
    'surfacePositions',
    'ownSurfaces',
    'normals',
    'triangles',
    'describe',
    'nearest',
    'hit',
    'suggest',
    'guide',
    'unguide',
  ],
];

const { open } = visitors(() => ROOT);
let visitor: Visitor;
beforeEach(async () => {
  visitor = await open('web/public/favicon.svg');
});

/** How often each call fails: engines compile what runs often, and what they compile may behave otherwise. */
const TIMES = 60;

declare global {
  interface Window {
    core: Chebnet;
  }
}

/** Runs in the page: makes the calls of `window.core` fail, in turns; gives the codes of each, and whether the core still
 *  works. */
function fail(calls: readonly string[], times: number): { codes: Record<string, string[]>; status: string } {
  const { core } = window;
  const whole = calls.includes('readMesh');
  const editor = core.openRecipe('vault:vertices=300');
  const broken: Mesh = {
    positions: new Float64Array(9),
    faceStart: Int32Array.of(0, 3),
    faceVertices: Int32Array.of(0, 1, 7),
  };
  const spoilt: Partial<EditState>[] = [
    { initialisation: 'nonsense' },
    { options: { nonsense: 1 } },
    { handles: [{ vertex: 999_999, target: [0, 0, 0] }] },
    { locality: { radius: 1, origins: [999_999] } },
    { positions: new Float64Array(3 * editor.info.vertices).fill(NaN) },
    { method: whole ? 'nonsense' : 'li2022' },
  ];
  const surface = whole ? core.ownSurface('hypar') : null!;
  const torn = core.openRecipe('vault:vertices=300');
  const unrested = core.openRecipe('vault:vertices=300');
  if (whole) unrested.setMethod('projection');
  torn.setHandles([0, 1].map((vertex) => ({ vertex, target: [9 * vertex, 0, 0] })));
  let inTurn = false;
  let turn = 0;
  let change = 0;
  const attempts: Record<string, () => unknown> = {
    openRecipe: () => core.openRecipe((inTurn = !inTurn) || whole ? 'nonsense' : 'teddy'),
    openObj: () => core.openObj('v 0 0 0\nf 1 2 3\n'),
    openMesh: () => core.openMesh(broken),
    reach: () => editor.reach(999_999),
    mobility: () => editor.mobility(1, [999_999]),
    flipped: () => editor.flipped(),
    lengthAdapter: () => editor.lengthAdapter([{ vertex: 999_999, target: [0, 0, 0] }]),
    accept: () => torn.lengthAdapter().accept(),
    restSearch: () => unrested.restSearch(),
    moveHandle: () => editor.moveHandle(999_999, [0, 0, 0]),
    dragHandle: () => editor.dragHandle(999_999, [0, 0, 0]),
    setState: () => editor.setState({ ...editor.state(), ...spoilt[turn++ % spoilt.length] }),
    changeState: () => editor.changeState(spoilt[change++ % spoilt.length]!),
    flatPattern: () => editor.flatPattern(),
    rods: () => editor.rods(),
    toObj: () => editor.toObj(),
    edgeTable: () => editor.edgeTable(),
    rodTable: () => editor.rodTable(),
    forces: () => editor.forces(),
    toFile: () => editor.toFile(whole ? ('nonsense' as 'obj') : 'obj'),
    readMesh: () => core.readMesh(new TextEncoder().encode('v 0 0 nonsense'), 'a.obj'),
    repairMesh: () => core.repairMesh(broken),
    equalizer: () => core.equalizer(broken),
    change: () =>
      core.change(core.readMesh(new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'), 'a.obj'), 'coarsen'),
    exactChange: () =>
      core.exactChange({ mesh: broken, origins: new Int32Array(3), lengthFactor: 1, keepsEdges: false }, { length: 1 }),
    solve: () => torn.solve(),
    openSurface: () => core.openSurface(broken),
    ownSurface: () => core.ownSurface('nonsense'),
    propose: () => surface.propose({ length: -1 }),
    proposeSeeds: () => surface.propose({ length: -1, direction: [1, 0, 0] }),
    drape: () => surface.drape({ ...surface.suggest(100), length: -1 }),
    cut: () => surface.cut([[[0, 0, 0]]]),
    cutPath: () =>
      surface.cutPath([
        [99, 0, 0],
        [0, 99, 0],
      ]),
    shortestCut: () => surface.shortestCut(null),
    drapePieces: () => surface.drapePieces({ ...surface.suggest(100), length: -1 }),
    proposeCuts: () => surface.proposeCuts({ ...surface.suggest(100), length: -1 }, 1),
    remesh: () => surface.remesh({ smallestAngle: 9 }),
    measure: () => surface.measure(broken),
  };
  const codes: Record<string, string[]> = {};
  for (let i = 0; i < times; ++i) {
    for (const name of calls) {
      let code = 'returned';
      try {
        attempts[name]!();
      } catch (error) {
        code = String((error as Partial<ChebnetError>).code ?? error);
      }
      codes[name] = [...new Set([...(codes[name] ?? []), code])];
    }
  }
  // Three, for what fewer hold may turn, which the core for a first net leaves to the whole one.
  const moved = [...editor.suggestedHandles.slice(0, 3)].map((vertex) => {
    const [x = 0, y = 0, z = 0] = editor.restPositions.subarray(3 * vertex, 3 * vertex + 3);
    return { vertex, target: [x + 1, y, z] as [number, number, number] };
  });
  editor.setHandles(moved);
  return { codes, status: editor.solve().status };
}

/** What both modules refuse. */
const CODES = {
  openRecipe: ['bad_option'],
  openMesh: ['index_out_of_range'],
  reach: ['index_out_of_range'],
  mobility: ['index_out_of_range'],
  moveHandle: ['index_out_of_range'],
  dragHandle: ['index_out_of_range'],
};
const LEFT_OUT = {
  setState: ['bad_option', 'index_out_of_range', 'non_finite', 'left_out'],
  changeState: ['bad_option', 'index_out_of_range', 'non_finite', 'left_out'],
  flatPattern: ['left_out'],
  rods: ['left_out'],
  flipped: ['left_out'],
  openRecipe: ['bad_option', 'left_out'],
  openObj: ['left_out'],
  toObj: ['left_out'],
  edgeTable: ['left_out'],
  rodTable: ['left_out'],
  forces: ['left_out'],
  toFile: ['left_out'],
  solve: ['left_out'],
};
const WHOLE = {
  setState: ['bad_option', 'index_out_of_range', 'non_finite'],
  changeState: ['bad_option', 'index_out_of_range', 'non_finite'],
  openObj: ['index_out_of_range'],
  flipped: ['bad_option'],
  lengthAdapter: ['index_out_of_range'],
  accept: ['bad_option'],
  restSearch: ['bad_option'],
  toFile: ['bad_option'],
  readMesh: ['bad_syntax'],
  repairMesh: ['index_out_of_range'],
  equalizer: ['index_out_of_range'],
  change: ['impossible_change'],
  exactChange: ['index_out_of_range'],
  openSurface: ['index_out_of_range'],
  ownSurface: ['bad_option'],
  propose: ['bad_option'],
  proposeSeeds: ['bad_option'],
  drape: ['bad_option'],
  cut: ['bad_option'],
  cutPath: ['bad_option'],
  shortestCut: ['bad_option'],
  drapePieces: ['bad_option'],
  proposeCuts: ['bad_option'],
  remesh: ['bad_option'],
  measure: ['index_out_of_range'],
};

test.each([
  ['the core for a first net', 'editors.js', 'loadEditors', 'chebnet_editor.wasm', { ...CODES, ...LEFT_OUT }],
  ['the whole core', 'chebnet.js', 'loadChebnet', 'chebnet_core.wasm', { ...CODES, ...WHOLE }],
])('what %s refuses comes as an Error with a code, every time', async (_, script, load, module, expected) => {
  const wasmUrl = `/some/folder/build/wasm/${module}`;
  await visitor.driver.evaluate(
    `import('/some/folder/wasm/${script}').then(async ({ ${load} }) => void (window.core = await ${load}({ wasmUrl: '${wasmUrl}' })))`,
  );
  const failed = await visitor.run(fail, Object.keys(expected), TIMES);
  expect(failed).toEqual({ codes: expected, status: 'converged' });
});

test('these are all calls of the border', () => {
  const sources = readdirSync(`${ROOT}/wasm`).filter((name) => name.endsWith('.cpp'));
  const code = sources.map((name) => readFileSync(`${ROOT}/wasm/${name}`, 'utf8')).join('\n');
  const bound = [...code.matchAll(/function\("(\w+)"/g)].map(([, name]) => name);
  const tried = Object.keys({ ...CODES, ...LEFT_OUT, ...WHOLE });
  expect([...new Set(bound)].sort()).toEqual([...new Set([...SAFE, ...tried])].sort());
});

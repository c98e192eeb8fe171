/** What crosses the border: lengths of arrays, tables, errors, memory. */
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { Editor, Handle, VertexLists } from '../../wasm/chebnet';
// @ts-expect-error: it has no declaration of its own, so that it is checked itself.
import { loaderOf } from '../../wasm/facade.js';
import { failure, firstEdit, load } from './load';

/** The memories of the modules made; there is one. */
const memories: WebAssembly.Memory[] = [];
const instantiate = WebAssembly.instantiate;
vi.spyOn(WebAssembly, 'instantiate').mockImplementation((async (source: BufferSource, imports: WebAssembly.Imports) => {
  const made = await instantiate(source, imports);
  memories.push(...Object.values(made.instance.exports).filter((each) => each instanceof WebAssembly.Memory));
  return made;
}) as typeof WebAssembly.instantiate);

const chebnet = await load();
const SHAPE = 'vault';

const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';

let editor: Editor;
beforeEach(() => {
  editor = chebnet.openRecipe(`${SHAPE}:vertices=300`);
});
afterEach(() => editor.dispose());

describe('tables', () => {
  test('name every shape with its parameters', () => {
    for (const shape of chebnet.shapes()) {
      expect(shape.title).not.toBe('');
      expect(shape.sentence).not.toBe('');
      expect(shape.parameters.map(({ name }) => name)).toContain('vertices');
      for (const { value, smallest, largest } of shape.parameters) {
        expect(value).toBeGreaterThanOrEqual(smallest);
        expect(value).toBeLessThanOrEqual(largest);
      }
    }
  });

  test('name the methods', () => {
    expect(chebnet.methods().map(({ name }) => name)).toContain(editor.method);
  });

  test('name the initialisations', () => {
    expect(chebnet.initialisations().map(({ name }) => name)).toContain(editor.initialisation);
    for (const { name, counted, sentence, citation } of chebnet.initialisations()) {
      expect(sentence).not.toBe('');
      expect(citation).not.toBe('');
      const initialisation = counted ? `${name}:3` : name;
      editor.setInitialisation(initialisation);
      expect(editor.initialisation).toBe(initialisation);
    }
  });

  test('name the options, with the values a new editor has', () => {
    for (const { name, kind, value } of chebnet.options()) {
      expect(editor.options()[name]).toBe(kind === 'flag' ? value === 1 : value);
    }
  });
});

describe('an editor', () => {
  test('gives arrays of the right lengths and types', () => {
    const { vertices, edges, faces } = editor.info;
    expect(editor.edges).toBeInstanceOf(Int32Array);
    expect(editor.edges).toHaveLength(2 * edges);
    expect(editor.faceStart).toHaveLength(faces + 1);
    expect(editor.faceVertices).toHaveLength(editor.faceStart[faces]!);
    expect(editor.restPositions).toBeInstanceOf(Float64Array);
    expect(editor.restPositions).toHaveLength(3 * vertices);
    expect(editor.positions()).toHaveLength(3 * vertices);
    expect(editor.fields().deviation).toBeInstanceOf(Float32Array);
    expect(editor.fields().deviation).toHaveLength(edges);
    expect(editor.fields().angle).toHaveLength(vertices);
    expect(editor.fields().force).toEqual(new Float32Array(edges));
    expect(Math.max(...editor.edges, ...editor.faceVertices)).toBe(vertices - 1);
    expect(editor.bend()).toBe(0);
  });

  test('gives net lines and boundary loops as lists one after another', () => {
    const square = chebnet.openObj(SQUARE);
    const ascending = (list: Int32Array) => list.slice().sort();
    const lists = ({ start, vertices }: VertexLists) =>
      [...start.subarray(1)].map((end, k) => [...ascending(vertices.subarray(start[k], end))]);
    expect(lists(square.netLines()).sort()).toEqual([
      [0, 1],
      [0, 3],
      [1, 2],
      [2, 3],
    ]);
    expect(lists(square.boundaryLoops())).toEqual([[0, 1, 2, 3]]);
    square.dispose();
  });

  test('gives rods as lists that are those of the table', () => {
    const surface = chebnet.ownSurface('hemisphere');
    const { mesh } = surface.drape({ ...surface.suggest(10), border: 'cut' });
    surface.dispose();
    const net = chebnet.openMesh(mesh);
    const { start, vertices } = net.rods();
    const rods = [...start.subarray(1)].map((end, k) => [...vertices.subarray(start[k], end)].join(' '));
    const rows = net.rodTable().trim().split('\n').slice(1);
    expect(rods).toEqual(rows.map((row) => row.split(',')[4]));
    expect(rods.length).toBeLessThan(net.netLines().start.length - 1);
    net.dispose();
  });

  test('describes its net', () => {
    const square = chebnet.openObj(SQUARE);
    expect(square.info).toEqual({
      vertices: 4,
      edges: 4,
      faces: 1,
      boundaryLoops: 1,
      components: 1,
      facesByArity: { 4: 1 },
      singularVertices: {},
      shortestLength: 1,
      meanLength: 1,
      longestLength: 1,
      edgeLength: 1,
      maxDeviationFromMean: 0,
      isChebyshev: true,
    });
    expect(square.suggestedHandles).toHaveLength(0);
    square.dispose();
  });

  test('suggests handles that differ', () => {
    expect(editor.suggestedHandles.length).toBeGreaterThan(1);
    expect(new Set(editor.suggestedHandles).size).toBe(editor.suggestedHandles.length);
  });

  test('keeps handles exactly, moves them and forgets them', () => {
    const handles = firstEdit(editor);
    editor.setHandles(handles);
    expect(editor.handles()).toEqual(handles);
    const { vertex } = handles[0]!;
    editor.moveHandle(vertex, [0.1, 0.2, 0.3]);
    expect(editor.handles()[0]).toEqual({ vertex, target: [0.1, 0.2, 0.3] });
    expect(editor.positions().subarray(3 * vertex, 3 * vertex + 3)).toEqual(Float64Array.of(0.1, 0.2, 0.3));
    editor.setHandles([]);
    expect(editor.handles()).toEqual([]);
  });

  test('traces each iteration', () => {
    editor.setHandles(firstEdit(editor));
    const { trace, iterations, maxDeviation, status } = editor.solve();
    expect(status).toBe('converged');
    expect(trace).toHaveLength(iterations);
    trace.forEach((row, i) => {
      expect(row.iteration).toBe(i + 1);
      expect([1, 2, 3]).toContain(row.stage);
      expect(Object.values(row).every(Number.isFinite)).toBe(true);
    });
    expect(trace.at(-1)?.maxDeviation).toBe(maxDeviation);
    expect(Math.max(...editor.fields().deviation)).toBeCloseTo(maxDeviation, 12);
  });

  test('sets options by number and by flag', () => {
    editor.setOption('threshold', 1e-5);
    editor.setOption('adaptive_p', false);
    editor.setOption('max_iterations', 7);
    expect(editor.options()).toMatchObject({ threshold: 1e-5, adaptive_p: false, max_iterations: 7 });
  });

  test('initialises each solve', () => {
    const afterFirstIteration = (initialisation: string) => {
      editor.reset();
      editor.setInitialisation(initialisation);
      editor.setHandles(firstEdit(editor));
      editor.solve({ iterations: 1 });
      return editor.positions();
    };
    editor.setMethod('projection');
    const naive = afterFirstIteration('naive');
    expect(afterFirstIteration('arap:5')).not.toEqual(naive);
    expect(afterFirstIteration('naive')).toEqual(naive);
  });

  test('measures the result', () => {
    const square = chebnet.openObj(SQUARE);
    expect(square.smallestAngle()).toBeCloseTo(Math.PI / 2, 12);
    square.dispose();
    editor.setHandles(firstEdit(editor));
    editor.solve();
    expect(editor.handleError()).toBe(0);
    expect(editor.smallestAngle()).toBeLessThanOrEqual(Math.min(...editor.fields().angle) + 1e-6);
  });

  test('says what is left until the net is at rest, and what holds it there', () => {
    expect(editor.forces()).toBeNull();
    editor.setOption('gravity', 0.001);
    editor.setOption('rest_tolerance', 1e-5);
    editor.setHandles(firstEdit(editor));
    const { status, toRest } = editor.solve();
    expect(status).toBe('converged');
    expect(toRest!.gradientNorm).toBeLessThan(1e-5);
    expect(toRest!.cornerLack).toBeLessThan(1e-3);
    expect(toRest!.motion).toBeLessThan(0.01);
    const { edges, corners, handles, energies } = editor.forces()!;
    expect(edges).toHaveLength(editor.info.edges);
    expect(corners.every(({ push }) => push > 0)).toBe(true);
    expect(handles).toHaveLength(editor.handles().length);
    const up = handles.reduce((sum, [, , z]) => sum + z, 0);
    expect(up).toBeCloseTo(0.001 * editor.info.edges, 4);
    expect(Object.keys(energies)).toEqual(['bending', 'shear', 'gravity']);

    editor.setMethod('projection');
    expect(editor.solve().toRest).toBeNull();
    expect(editor.forces()).toBeNull();
  });

  test('takes positions and goes back to rest', () => {
    const moved = editor.restPositions.map((coordinate) => 1.5 * coordinate);
    editor.setPositions(moved);
    expect(editor.positions()).toEqual(moved);
    editor.reset();
    expect(editor.positions()).toEqual(editor.restPositions);
  });

  test('writes an OBJ that opens as the same net', () => {
    const again = chebnet.openObj(editor.toObj());
    expect(again.restPositions).toEqual(editor.positions());
    expect(again.faceVertices).toEqual(editor.faceVertices);
    expect(again.edges).toEqual(editor.edges);
    again.dispose();
    expect(editor.toObj(3).length).toBeLessThan(editor.toObj(17).length);
  });

  test('gives copies: what is changed outside stays outside', () => {
    editor.positions().fill(NaN);
    editor.restPositions.fill(NaN);
    expect(editor.positions().every(Number.isFinite)).toBe(true);
  });

  test('names handles out of reach', () => {
    const [first, last] = [editor.suggestedHandles[0]!, editor.suggestedHandles.at(-1)!];
    editor.setHandles([
      { vertex: first, target: [0, 0, 0] },
      { vertex: last, target: [1000, 0, 0] },
    ]);
    expect(editor.solve().status).toBe('unreachable');
    const [pair] = editor.unreachablePairs();
    expect([pair?.vertexA, pair?.vertexB].sort()).toEqual([first, last].sort());
    expect(pair?.distance).toBe(1000);
    expect(pair?.reach).toBeLessThan(1000);
    expect(editor.positions().every(Number.isFinite)).toBe(true);
  });
});

describe('errors', () => {
  const cases: [string, string, RegExp, () => unknown][] = [
    ['an unknown shape', 'bad_option', /nosuch/, () => chebnet.openRecipe('nosuch')],
    ['a recipe that is none', 'bad_syntax', /recipe/, () => chebnet.openRecipe(7 as never)],
    ['an OBJ that is none', 'bad_syntax', /OBJ/, () => chebnet.openObj(new Uint8Array(3) as never)],
    ['a bad line', 'bad_syntax', /net\.obj:2/, () => chebnet.openObj('v 0 0 0\nv 1 zero 0\n', 'net.obj')],
    ['an OBJ without faces', 'no_faces', /face/, () => chebnet.openObj('v 0 0 0\n')],
    ['a face too far', 'index_out_of_range', /5/, () => chebnet.openObj(`${SQUARE}f 3 4 5\n`)],
    [
      'three faces at an edge',
      'non_manifold_edge',
      /./,
      () => chebnet.openObj('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n'),
    ],
    ['a handle too far', 'index_out_of_range', /999999/, () => editor.setHandles([handle(999999)])],
    ['half a vertex', 'index_out_of_range', /0\.5/, () => editor.setHandles([handle(0.5)])],
    ['a vertex beyond int', 'index_out_of_range', /4294967296/, () => editor.setHandles([handle(2 ** 32)])],
    ['two handles at a vertex', 'repeated_vertex', /3/, () => editor.setHandles([handle(3), handle(3)])],
    ['a target that is NaN', 'non_finite', /./, () => editor.setHandles([handle(3, [0, NaN, 0])])],
    ['a target of 2 numbers', 'non_finite', /3 numbers/, () => editor.setHandles([handle(3, [0, 1] as never)])],
    ['handles that are none', 'bad_option', /array/, () => editor.setHandles('all' as never)],
    ['moving what is no handle', 'index_out_of_range', /5/, () => editor.moveHandle(5, [0, 0, 0])],
    ['an unknown method', 'bad_option', /li2022/, () => editor.setMethod('magic')],
    ['an unknown initialisation', 'bad_option', /local_global:N/, () => editor.setInitialisation('arap')],
    ['an initialisation that is none', 'bad_option', /initialisation/, () => editor.setInitialisation(5 as never)],
    ['an unknown option', 'bad_option', /threshold/, () => editor.setOption('treshold', 1)],
    ['an option that is NaN', 'bad_option', /threshold/, () => editor.setOption('threshold', NaN)],
    ['an option that is text', 'bad_option', /threshold/, () => editor.setOption('threshold', 'low' as never)],
    ['positions too short', 'index_out_of_range', /Float64Array/, () => editor.setPositions(new Float64Array(3))],
    [
      'positions of floats',
      'index_out_of_range',
      /Float64Array/,
      () => editor.setPositions(new Float32Array(3) as never),
    ],
    ['positions that are NaN', 'non_finite', /./, () => editor.setPositions(editor.positions().fill(NaN))],
    ['a budget below 0', 'bad_option', /budget/, () => editor.solve({ iterations: -1 })],
    ['a budget of NaN ms', 'bad_option', /budget/, () => editor.solve({ milliseconds: NaN })],
    ['18 digits', 'bad_option', /digits/, () => editor.toObj(18)],
    ['a state that is none', 'bad_option', /state of an edit/, () => editor.setState(null as never)],
    [
      'options that are none',
      'bad_option',
      /options/,
      () => editor.setState({ ...editor.state(), options: null as never }),
    ],
    ['a budget that is none', 'bad_option', /budget/, () => editor.solve(null as never)],
    ['a locality of no vertices', 'bad_option', /origins/, () => editor.setLocality(3, undefined as never)],
    ['a mobility of no vertices', 'bad_option', /origins/, () => editor.mobility(3, null as never)],
    ['no options of draping', 'bad_option', /draping/, () => surface().drape(undefined as never)],
    ['no options of a net over it', 'bad_option', /over a surface/, () => surface().remesh(null as never)],
    ['a mark that is none', 'bad_option', /singular/, () => surface().remesh({ singular: [null as never] })],
    ['a region that is none', 'bad_option', /region/, () => surface().remesh({ forbidden: [null as never] })],
    ['progress that is none', 'bad_option', /progress/, () => surface().remesh({}, 'often' as never)],
    ['cuts that are none', 'bad_option', /cuts/, () => surface().cut(null as never)],
    ['no options of equalising', 'bad_option', /equalising/, () => chebnet.equalizer(square(), null as never)],
    ['a place that is none', 'bad_option', /place/, () => chebnet.change(square(), 'refine', null as never)],
    ['no changed mesh', 'bad_option', /changed mesh/, () => chebnet.exactChange(null as never, { length: null })],
    ['no options of a change', 'bad_option', /exact change/, () => chebnet.exactChange(null as never, null as never)],
  ];

  test.each(cases)('%s', (_, code, message, action) => {
    const error = failure(action);
    expect(error).toBeInstanceOf(Error);
    expect(error.code).toBe(code);
    expect(error.message).toMatch(message);
  });

  test('a handle is moved nowhere where no net can be; one of an edit from before may be there', () => {
    editor.setHandles([handle(3)]);
    const far: Handle['target'] = [0, -1e200, 0];
    for (const way of [() => editor.moveHandle(3, far), () => editor.dragHandle(3, far)])
      expect(failure(way)).toMatchObject({ code: 'bad_scale', message: expect.stringMatching(/vertex 3 .*1e\+150/) });
    expect(editor.handles()).toEqual([handle(3)]);

    const surface = chebnet.ownSurface('shell');
    editor.setState({ ...editor.state(), handles: [handle(3, far), handle(5)] });
    editor.setGuide(surface);
    editor.setOption('guide_mode', 1);
    expect(editor.solve({ iterations: 20 }).status).toBe('unreachable');
    expect(editor.positions().every(Number.isFinite)).toBe(true);
    surface.dispose();
  });

  test('points and numbers of vertices may be typed arrays', () => {
    editor.setHandles([handle(3, Float64Array.of(1, 2, 3) as never)]);
    expect(editor.handles()).toEqual([handle(3, [1, 2, 3])]);
    editor.setLocality(3, Int32Array.of(3) as never);
    expect(editor.state().locality?.origins).toEqual([3]);
  });

  test('leave the editor as it was', () => {
    editor.setHandles([handle(3)]);
    failure(() => editor.setHandles([handle(4), handle(999999)]));
    expect(editor.handles()).toEqual([handle(3)]);
  });

  test('say so after dispose, and dispose may be repeated', () => {
    const adapter = editor.lengthAdapter();
    adapter.dispose();
    adapter.dispose();
    const other = editor.lengthAdapter();
    const search = editor.restSearch();
    editor.dispose();
    editor.dispose();
    const ofSearches = [() => adapter.solve(), () => adapter.accept(), () => other.accept(), () => search.accept()];
    for (const action of [...ofSearches, () => editor.positions(), () => editor.solve(), () => editor.method]) {
      expect(failure(action).code).toBe('disposed');
      expect(failure(action).message).toMatch(/disposed/);
    }
  });
});

test('memory does not grow with editors disposed', () => {
  const openAndDispose = (count: number) => {
    for (let i = 0; i < count; ++i) {
      const each = chebnet.openRecipe(`${SHAPE}:vertices=1000`);
      each.setHandles(firstEdit(each));
      each.solve({ iterations: 2 });
      failure(() => each.setMethod('magic')); // neither do errors keep anything
      each.dispose();
    }
  };
  const bytes = () => memories.reduce((sum, memory) => sum + memory.buffer.byteLength, 0);
  openAndDispose(10);
  const before = bytes();
  openAndDispose(200);
  expect(memories).toHaveLength(1);
  expect(bytes()).toBe(before);
  expect(chebnet.memory()).toBe(before);
});

const surface = () => chebnet.ownSurface('hypar');

const square = () => chebnet.readMesh(new TextEncoder().encode(SQUARE), 'square.obj');

function handle(vertex: number, target: Handle['target'] = [0, 0, 0]): Handle {
  return { vertex, target };
}

test('what is wrong is told by its kind', () => {
  const positions = Float32Array.from(editor.positions());
  expect(failure(() => editor.setPositions(positions as never)).message).toMatch(
    /a Float64Array of \d+ numbers, not Float32Array$/,
  );
  expect(failure(() => chebnet.openObj(new Uint8Array(4) as never)).message).toBe(
    'an OBJ must be text, not Uint8Array',
  );
});

test('a module that is not found fails like all else, also where nothing is given', async () => {
  const load = loaderOf(() => Promise.reject(new TypeError('fetch failed')));
  const said = { code: 'internal', message: expect.stringMatching(/fetch failed/) };
  await expect(load({})).rejects.toMatchObject(said);
  await expect(load(undefined as never)).rejects.toMatchObject(said);
});

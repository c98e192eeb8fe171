/** Files on their way in and out, without a page. */
import { describe, expect, test } from 'vitest';
import type { Mesh } from '../../wasm/chebnet';
import type { GuideSource, HandleSeed, NetSource, UpAxis } from '../../web/src/document/document';
import type { Subject } from '../../web/src/equalize/subject';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { fileNameOf } from '../../web/src/files/file_name';
import { kindsFor, typeOf } from '../../web/src/export/kinds';
import type { FileRequest, FileResponse, ReadStep } from '../../web/src/files/file_protocol';
import type { FileWorkerLike } from '../../web/src/files/file_reading';
import type { FileReport } from '../../web/src/files/file_report';
import { postureOf } from '../../web/src/files/posture';
import { FileImporter } from '../../web/src/files/file_importer';
import { FileOpener, LARGEST_FILE } from '../../web/src/dialogs/file_opener';
import type {
  DraperLike,
  EqualizerEnd,
  EqualizerLike,
  FileChoice,
  FileDialogLike,
  TakenNet,
} from '../../web/src/dialogs/file_opener';
import { objText } from '../../web/src/document/obj_text';
import { acceptOf } from '../../web/src/files/pick_file';
import { en } from '../../web/src/language/en';
import { panels as panelsInEnglish } from '../../web/src/language/en/panels';
import { zh } from '../../web/src/language/zh';
import {
  faceWords,
  largestDifference,
  lengthWords,
  percentWords,
  singularWords,
} from '../../web/src/dialogs/file_words';
import { load } from '../wasm/load';
import { grid } from './nets';

const core = await load();
const meshOf = (text: string): Mesh => core.readMesh(new TextEncoder().encode(text), 'net.obj');

const SQUARES = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n';
const TRIANGLES = `${SQUARES.split('f')[0]}f 1 2 3\nf 1 3 4\n`;
/** A Möbius strip. */
const ONE_SIDED = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n';
const OBLONG = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n';
const DOUBLE_FACE = `${SQUARES}v 7 7 7\nf 4 3 2 1\n`;
const TURNED_FACE = SQUARES.replace('f 2 5 6 3', 'f 3 6 5 2');

test('lengths are measured', () => {
  const lengths = edgeLengths(Float64Array.of(0, 0, 0, 3, 4, 0, 3, 4, 1), Int32Array.of(0, 1, 1, 2));
  expect(lengths).toEqual(Float64Array.of(5, 1));
  expect(largestDifference({ shortestLength: 1, meanLength: 3, longestLength: 5 })).toBe(2 / 3);
});

test('the text of a mesh brings every coordinate back, in few digits', () => {
  const mesh = meshOf('v 0.1 -2.5e-30 1e22\nv 1 0.3333333333333333 0\nv 0 1 0\nf 3 1 2\n');
  const text = objText(mesh);
  expect(text.split('\n')[0]).toBe('v 0.1 -2.5e-30 1e+22');
  expect(meshOf(text)).toEqual(mesh);
});

test('a file to be saved is named after what was opened', () => {
  const formats = core.formats();
  expect(fileNameOf({ recipe: 'dome:vertices=2000' }, 'ply', formats)).toBe('dome.ply');
  expect(fileNameOf({ obj: '', name: 'My scan.PLY' }, 'obj', formats)).toBe('My scan.obj');
  for (const name of ['roof.glb', 'roof.gltf', 'roof.3DM'])
    expect(fileNameOf({ obj: '', name }, 'obj', formats)).toBe('roof.obj');
  expect(fileNameOf({ obj: '', name: 'Dome 2.5' }, 'obj', formats)).toBe('Dome 2.5.obj');
  expect(fileNameOf({ obj: '', name: '.obj' }, 'csv', formats)).toBe('net.csv');
  expect(typeOf('png', formats)).toBe('image/png');
  expect(typeOf('stl', formats)).toBe('model/stl');
});

describe("the core's table of formats says", () => {
  const formats = core.formats();
  const dxf = { name: 'dxf', title: 'DXF', sentence: 'for drawings', mediaType: 'image/vnd.dxf' };

  test('what a picker accepts', () => {
    expect(acceptOf([...formats, dxf], 'any')).toMatch(/^\.obj,\.ply,\.off,.*,\.dxf,\.glb,\.gltf,\.3dm,\.json$/);
    expect(acceptOf(formats, 'mesh')).not.toContain('json');
  });

  test("what can be saved, with the page's own formats among them", () => {
    const words = panelsInEnglish.exports;
    const meshes = kindsFor('meshes', formats, words);
    expect(meshes.map(({ kind }) => kind).join()).toMatch(/^obj,3dm,ply,off,stl,glb/);
    expect(kindsFor('meshes', [...formats, dxf], words)).toEqual([
      ...meshes,
      { kind: 'dxf', title: 'DXF', hint: 'for drawings' },
    ]);
    const offered = (['meshes', 'making', 'pictures'] as const).flatMap((purpose) => kindsFor(purpose, formats, words));
    for (const name of Object.keys(words.hints)) expect(offered.map(({ kind }) => kind)).toContain(name);
    for (const { kind } of offered) expect(typeOf(kind, formats)).toMatch(/^[a-z]+\/[\w.+-]+$/);
  });

  test('what the tile for opening a file names', () => {
    const read = [...formats, dxf].map(({ title }) => title);
    expect(en.gallery.openFileHint(read)).toMatch(/an OBJ, PLY, OFF, .* or DXF file/);
    expect(zh.gallery.openFileHint(read)).toMatch(/OBJ、PLY、OFF、.* 或 DXF/);
  });
});

test('a file that is none of these is refused with the formats that the page reads', async () => {
  const said: FileResponse[] = [];
  const importer = new FileImporter(core, (response) => said.push(response));
  for (const [name, bytes] of [
    ['notes.txt', 'Tomorrow'],
    ['a.png', '\x89PNG'],
  ] as const)
    await importer.handle({ type: 'read', file: new Blob([Uint8Array.from(bytes, (c) => c.charCodeAt(0))]), name });
  const reasons = said.flatMap((each) => (each.type === 'error' ? [each.message] : []));
  expect(reasons).toEqual([
    'notes.txt: not a mesh of a format that is read, which are OBJ, PLY, OFF, STL, GLB and 3DM',
    'a.png: this is a PNG picture; meshes are read from OBJ, PLY, OFF, STL, GLB and 3DM',
  ]);
});

describe('words', () => {
  test('for faces', () => {
    expect(faceWords({ faces: 1200, facesByArity: { 4: 1200 } })).toBe('1,200 quads');
    expect(faceWords({ faces: 10, facesByArity: { 3: 1, 4: 7, 9: 2 } })).toBe('10: 7 quads, 2 9-gons, 1 triangle');
  });
  test('for singular vertices', () => {
    expect(singularWords({})).toBe('none');
    expect(singularWords({ 3: 4, 5: 1 })).toBe('4 of valence 3, 1 of valence 5');
  });
  test('for lengths and fractions', () => {
    expect([0.1234567, 1, 291.934, 1234.56, 123456].map(lengthWords)).toEqual([
      '0.12346',
      '1',
      '291.93',
      '1,234.6',
      '123,460',
    ]);
    expect([0, 1e-7, 0.0123, 0.5, 2.345].map(percentWords)).toEqual(['0 %', 'below 0.001 %', '1.2 %', '50 %', '235 %']);
  });
});

/** A worker in name only: the importer answers in this thread. */
class LocalWorker implements FileWorkerLike {
  onmessage: FileWorkerLike['onmessage'] = null;
  onerror: FileWorkerLike['onerror'] = null;
  terminated = false;
  readonly #importer = new FileImporter(core, (data) => this.#say(data));

  postMessage(request: FileRequest): void {
    void this.#importer.handle(request);
  }

  terminate(): void {
    this.terminated = true;
  }

  #say(data: FileResponse): void {
    if (!this.terminated) this.onmessage?.({ data } as MessageEvent<FileResponse>);
  }
}

class FakeDialog implements FileDialogLike {
  readonly #answer: (dialog: FakeDialog) => Promise<FileChoice>;
  steps: ReadStep[] = [];
  report: FileReport | null = null;
  isClosed = false;
  close!: () => void;
  readonly closed = new Promise<null>((resolve) => {
    this.close = () => {
      this.isClosed = true;
      resolve(null);
    };
  });

  constructor(
    readonly name: string,
    answer: (dialog: FakeDialog) => Promise<FileChoice>,
  ) {
    this.#answer = answer;
  }

  setStep(step: ReadStep): void {
    this.steps.push(step);
  }

  ask(report: FileReport): Promise<FileChoice> {
    this.report = report;
    return this.#answer(this);
  }
}

const AS_IT_IS: FileChoice = { repaired: false, restLengths: 'automatic' };

/** Opens files one after the other; `answer` is what the user does. */
function makeOpener(
  answer: (dialog: FakeDialog) => Promise<FileChoice> = () => Promise.resolve(AS_IT_IS),
  equalized: (subject: Subject, closed: Promise<null>) => Promise<EqualizerEnd> = () => Promise.resolve(null),
  draped: (surface: { name: string; mesh: Mesh }, closed: Promise<null>) => Promise<TakenNet | null> = () =>
    Promise.resolve(null),
) {
  const [workers, dialogs, opened]: [LocalWorker[], FakeDialog[], NetSource[]] = [[], [], []];
  const held: HandleSeed[] = [];
  const guides: (GuideSource | undefined)[] = [];
  const ups: (UpAxis | undefined)[] = [];
  const createEqualizer = (subject: Subject): EqualizerLike => {
    let close = (): void => {};
    const closed = new Promise<null>((resolve) => (close = () => resolve(null)));
    return { result: equalized(subject, closed), close };
  };
  const opener = new FileOpener({
    spawnWorker: () => workers[workers.push(new LocalWorker()) - 1]!,
    createDialog: (name) => dialogs[dialogs.push(new FakeDialog(name, answer)) - 1]!,
    createEqualizer,
    createDraper: (surface): DraperLike => {
      let close = (): void => {};
      const closed = new Promise<null>((resolve) => (close = () => resolve(null)));
      return { result: draped(surface, closed), close };
    },
    open: async ({ net, handles, guide, upAxis }) => {
      opened.push(net);
      ups.push(upAxis);
      guides.push(guide);
      held.push(...handles);
    },
  });
  return {
    workers,
    dialogs,
    opened,
    held,
    guides,
    ups,
    open: (text: string, name = 'net.obj') => opener.open(new File([text], name)),
    opener,
  };
}

describe('which way a mesh is up', () => {
  const nets = core.shapes().map(({ name }) => name);
  const upright = (name: string): Mesh => {
    const { restPositions: positions, faceStart, faceVertices } = core.openRecipe(`${name}:vertices=600`);
    return { positions, faceStart, faceVertices };
  };
  /** With y up: (x, y, z) becomes (x, z, -y). */
  const onItsBack = (mesh: Mesh): Mesh => {
    const { positions: p } = mesh;
    return { ...mesh, positions: p.map((_, i) => (i % 3 === 0 ? p[i]! : i % 3 === 1 ? p[i + 1]! : -p[i - 1]!)) };
  };

  test.each(nets)('%s, as it is and on its back, is guessed right or not at all', (name) => {
    for (const [mesh, up] of [
      [upright(name), 'z'],
      [onItsBack(upright(name)), 'y'],
    ] as const) {
      const posture = postureOf(mesh);
      if (posture.isClear) expect(posture.up).toBe(up);
      expect(Math.max(...posture.sketch.edges)).toBeLessThan(posture.sketch.positions.length / 3);
    }
  });

  test.each([
    ['a canopy with a flat crown', 1],
    ['a dish with a flat bottom', -1],
  ])('%s arches over its border, or hangs within it', (_, sign) => {
    const { restPositions, faceStart, faceVertices } = grid(21, 21);
    const positions = restPositions.map((x, i) => {
      const [u, v] = [restPositions[i - (i % 3)]! / 10 - 1, restPositions[i - (i % 3) + 1]! / 10 - 1];
      return i % 3 === 2 ? sign * 8 * (1 - (u * u + v * v) ** 2 / 4) : x;
    });
    const mesh = { positions, faceStart, faceVertices };
    expect(postureOf(mesh)).toMatchObject({ up: 'z', isClear: true });
    expect(postureOf(onItsBack(mesh))).toMatchObject({ up: 'y', isClear: true });
  });

  test('most of them show it clearly', () => {
    const clear = nets.filter((name) => postureOf(onItsBack(upright(name))).isClear);
    expect(clear.length).toBeGreaterThan(0.7 * nets.length);
  });
});

describe('a file', () => {
  test('is read in steps, told about and opened', async () => {
    const { open, opened, dialogs, workers } = makeOpener();
    await open(SQUARES);
    expect(dialogs[0]?.steps).toEqual(['loading', 'reading', 'checking', 'measuring']);
    expect(dialogs[0]?.report).toEqual({
      vertices: 6,
      edges: 7,
      faces: 2,
      facesByArity: { 4: 2 },
      boundaryLoops: 1,
      components: 1,
      singularVertices: {},
      shortestLength: 1,
      meanLength: 1,
      longestLength: 1,
      edgeLength: 1,
      maxDeviationFromMean: 0,
      isChebyshev: true,
      findings: [],
      refusal: null,
      surface: null,
      posture: { up: 'z', isClear: true, sketch: expect.anything() },
    });
    expect(opened).toEqual([{ mesh: meshOf(SQUARES), name: 'net.obj', restLengths: 'automatic' }]);
    expect(workers[0]?.terminated).toBe(true);
    expect(dialogs[0]?.isClosed).toBe(true);
  });

  test('of unequal edges opens with the lengths that are chosen', async () => {
    const { open, opened, dialogs } = makeOpener(() => Promise.resolve({ repaired: false, restLengths: 'equal' }));
    await open(OBLONG);
    expect(dialogs[0]?.report).toMatchObject({
      isChebyshev: false,
      ...{ shortestLength: 1, meanLength: 1.5, longestLength: 2 },
    });
    expect(opened).toMatchObject([{ restLengths: 'equal' }]);
  });

  test('that was equalised has its surface beside it, if it has one', async () => {
    const surfaces = [meshOf(OBLONG), null];
    const { open, guides } = makeOpener(
      () => Promise.resolve({ repaired: false, restLengths: 'equalized' }),
      () => Promise.resolve({ mesh: meshOf(SQUARES), surface: surfaces.shift()!, isResized: false }),
    );
    await open(OBLONG);
    await open(OBLONG);
    expect(guides).toEqual([{ mesh: meshOf(OBLONG), name: 'net.obj' }, undefined]);
  });

  test('of unequal edges is equalised if the user likes the result, and asked about again if not', async () => {
    const subjects: Subject[] = [];
    const answers: FileChoice[] = [
      { repaired: true, restLengths: 'equalized' },
      { repaired: false, restLengths: 'equalized' },
    ];
    const { open, opened } = makeOpener(
      () => Promise.resolve(answers.shift()!),
      (subject) =>
        Promise.resolve(
          subjects.push(subject) === 1 ? null : { mesh: meshOf(SQUARES), surface: null, isResized: false },
        ),
    );
    await open(OBLONG);
    expect(subjects.map(({ name, net, handles }) => [name, net.info.edges, handles])).toEqual([
      ['net.obj', 4, []],
      ['net.obj', 4, []],
    ]);
    expect(opened).toEqual([{ mesh: meshOf(SQUARES), name: 'net.obj' }]);
  });

  test('of triangles is told about as a surface, and a net made on it is opened with its handles', async () => {
    const surfaces: string[] = [];
    const handles = [{ vertex: 1, target: null, anchor: false }];
    const answers: FileChoice[] = [
      { repaired: true, restLengths: 'draped' },
      { repaired: false, restLengths: 'draped' },
    ];
    const net = { mesh: meshOf(SQUARES), name: 'net-net.obj' };
    const { open, opened, held, dialogs } = makeOpener(
      () => Promise.resolve(answers.shift()!),
      undefined,
      ({ name }) => Promise.resolve(surfaces.push(name) === 1 ? null : { net, handles }),
    );
    await open(TRIANGLES);
    expect(dialogs[0]?.report?.surface).toMatchObject({ triangles: 2, prospect: 'one_piece' });
    expect(surfaces).toEqual(['net.obj', 'net.obj']);
    expect([opened, held]).toEqual([[net], handles]);
  });

  test('lies as its axis says, and one of our own surfaces chosen in its place as that does', async () => {
    const net = { mesh: meshOf(SQUARES), name: 'net-net.obj' };
    const taken: TakenNet[] = [
      { net, handles: [] },
      { net, handles: [], guide: { own: 'shell' }, upAxis: 'z' },
    ];
    const { open, ups } = makeOpener(
      () => Promise.resolve({ repaired: false, restLengths: 'draped' as const, upAxis: 'y' as const }),
      undefined,
      () => Promise.resolve(taken.shift()!),
    );
    await open(TRIANGLES);
    await open(TRIANGLES);
    expect(ups).toEqual(['y', 'z']);
  });

  test('that folds sharply once it is equalised may have a new net made on its surface', async () => {
    const surfaces: Mesh[] = [];
    const net = { mesh: meshOf(SQUARES), name: 'net-net.obj' };
    const { open, opened } = makeOpener(
      () => Promise.resolve({ repaired: false, restLengths: 'equalized' as const }),
      () => Promise.resolve('newNet'),
      ({ mesh }) => Promise.resolve(surfaces.push(mesh) === 1 ? null : { net, handles: [] }),
    );
    await open(SQUARES);
    expect(surfaces).toEqual([meshOf(SQUARES), meshOf(SQUARES)]);
    expect(opened).toEqual([net]);
  });

  test('that cannot be a surface says why', async () => {
    const { open, dialogs } = makeOpener();
    await open(ONE_SIDED);
    expect(dialogs[0]?.report?.surface).toMatchObject({ code: 'non_manifold_edge' });
  });

  test('whose dialog is closed is not equalised any more', async () => {
    const { open, opened, dialogs } = makeOpener(
      () => Promise.resolve({ repaired: false, restLengths: 'equalized' }),
      (_, closed) => {
        dialogs[0]?.close();
        return closed;
      },
    );
    await open(OBLONG);
    expect(opened).toEqual([]);
  });

  test('that the core refuses is repaired with consent', async () => {
    const { open, opened, dialogs } = makeOpener(() => Promise.resolve({ repaired: true, restLengths: 'automatic' }));
    await open(DOUBLE_FACE);
    const { findings, refusal, vertices } = dialogs[0]?.report ?? expect.fail('no report');
    expect(findings.map(({ defect, count }) => [defect, count])).toEqual([
      ['duplicate_faces', 1],
      ['unused_vertices', 1],
    ]);
    expect(refusal?.message).toMatch(/vertex|edge/);
    expect(vertices).toBe(6);
    expect(opened).toMatchObject([{ mesh: meshOf(SQUARES) }]);
  });

  test('with a flaw the core puts up with may stay as it is', async () => {
    const { open, opened, dialogs } = makeOpener();
    await open(TURNED_FACE);
    expect(dialogs[0]?.report).toMatchObject({ findings: [{ defect: 'inconsistent_winding' }], refusal: null });
    expect(opened).toMatchObject([{ mesh: meshOf(TURNED_FACE) }]);
  });

  test.each([
    ['a bad line', 'v 0 0 zero\n', 'bad_syntax', /^net\.obj:1: /],
    ['only points', 'v 0 0 0\nv 1 0 0\n', 'no_faces', /^net\.obj: the net has no faces\. .* save it as a mesh/],
    ['a face beyond the vertices', `${SQUARES}f 1 2 77\n`, 'index_out_of_range', /^net\.obj:9: /],
    [
      'a drawing in it',
      '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>',
      'bad_syntax',
      /^net\.obj: this is an SVG drawing/,
    ],
    ['an archive in it', 'PK\x03\x04\x14\0\0\0', 'bad_syntax', /^net\.obj: this is a ZIP archive/],
  ])('with %s is refused in the words of the core', async (_, text, code, message) => {
    const { open, opened, dialogs, workers } = makeOpener();
    await expect(open(text)).rejects.toMatchObject({ code, message: expect.stringMatching(message) });
    expect(opened).toEqual([]);
    expect([dialogs[0]?.isClosed, workers[0]?.terminated]).toEqual([true, true]);
  });

  test('that is too large is not even read', async () => {
    const { opener, dialogs } = makeOpener();
    const file = { name: 'huge.ply', size: LARGEST_FILE + 1e6 } as File;
    await expect(opener.open(file)).rejects.toMatchObject({
      code: 'too_large',
      message: expect.stringMatching(/101 MB/),
    });
    expect(dialogs).toEqual([]);
  });

  test('that cannot be read is said to be so', async () => {
    const { opener } = makeOpener();
    const folder = {
      name: 'folder',
      size: 4096,
      arrayBuffer: () => Promise.reject(new Error('NotReadableError')),
    } as File;
    await expect(opener.open(folder)).rejects.toMatchObject({
      code: 'file_access',
      message: expect.stringMatching(/folder/),
    });
  });

  test('is given up when its dialog is closed, and its worker ended', async () => {
    const { open, opened, dialogs, workers } = makeOpener((dialog) => {
      dialog.close();
      return new Promise(() => {});
    });
    await open(SQUARES);
    expect(opened).toEqual([]);
    expect([dialogs[0]?.isClosed, workers[0]?.terminated]).toEqual([true, true]);
  });

  test('takes the place of one that is still being asked about', async () => {
    let asked = 0;
    const { open, opened } = makeOpener(() => (asked++ === 0 ? new Promise(() => {}) : Promise.resolve(AS_IT_IS)));
    const first = open(SQUARES, 'first.obj');
    await expect.poll(() => asked).toBe(1);
    await Promise.all([first, open(OBLONG, 'second.obj')]);
    expect(opened).toMatchObject([{ name: 'second.obj' }]);
  });

  test('whose worker does not start is an error', async () => {
    const { opener, workers } = makeOpener();
    const opening = opener.open(new File([SQUARES], 'net.obj'));
    workers[0]?.onerror?.({ message: 'blocked' } as ErrorEvent);
    await expect(opening).rejects.toMatchObject({ code: 'internal', message: 'blocked' });
  });
});

/** Projects: what goes in comes out to the last bit, and nothing else does. */
import { describe, expect, test, vi } from 'vitest';
import { ProjectRow } from '../../web/src/dialogs/project_row';
import { asFileName } from '../../web/src/files/file_name';
import {
  type CameraPlace,
  type HandleData,
  LONGEST_PROJECT_NAME,
  type NetSource,
  type Vec3,
} from '../../web/src/document/document';
import {
  checkSize,
  leastBytes,
  parseProject,
  projectText,
  readProject,
  writeProject,
} from '../../web/src/document/project';
import type { Project } from '../../web/src/document/project';
import { sentenceOf } from '../../web/src/document/naming';
import type { Entry, Snapshot } from '../../web/src/document/undo';
import { documentHere } from './elements_here';
import { documentAt, grid, million } from './nets';
import { printedSeed, random } from './random';

const NETS: NetSource[] = [
  { recipe: 'vault:vertices=1000' },
  { obj: 'v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n# größer 网\n', name: 'small.obj', restLengths: 'own' },
];

function projectOf(states: Snapshot[], present = states.length - 1): Project {
  const { view } = documentAt(null);
  return { entries: states.map((state, i) => ({ name: `step ${i}`, state })), present, view };
}

function stateAt(positions: Float64Array): Snapshot {
  const { view: _, ...state } = documentAt(positions);
  return state;
}

test('a file has the name of its project, if that is a name', () => {
  const project = projectOf([stateAt(new Float64Array(3))]);
  expect(parseProject(projectText({ ...project, title: 'Halle "3"' })).title).toBe('Halle "3"');
  expect('title' in parseProject(projectText({ ...project, title: '' }))).toBe(false);
  const long = projectText({ ...project, title: 'x'.repeat(81) });
  expect(parseProject(long).title).toBe('x'.repeat(80));
  expect(['../a:b', ' .x ', 'Halle 3', '网'].map(asFileName)).toEqual(['a b', 'x', 'Halle 3', '网']);
});

test('a copy has a name of its own, however long the other is, and as a file it opens again', () => {
  const page = documentHere();
  const names: string[] = [];
  const row = new ProjectRow({
    isPresent: false,
    picture: { width: 1, height: 1 },
    longestName: LONGEST_PROJECT_NAME,
    rename: () => {},
    open: () => {},
    copy: (name) => names.push(name),
    delete: () => {},
  });
  const line = { id: 'a', name: '', date: null, picture: null, isElsewhere: false };
  for (const title of ['hall', 'x'.repeat(255)]) {
    row.update({ ...line, title });
    page.button('Duplicate').tell('click');
  }
  vi.unstubAllGlobals();
  expect(names).toEqual(['Copy of hall', `Copy of ${'x'.repeat(72)}`]);
  const project = projectOf([stateAt(new Float64Array(3))]);
  expect(parseProject(projectText({ ...project, title: names[1] })).title).toBe(names[1]);
});

test('a file tells which axis of a net is up that is not the present one, if that is known', () => {
  const project = projectOf([0, 1, 2].map((x) => stateAt(Float64Array.of(x, x, x))));
  const entries = project.entries.map((entry, i): Entry => (i === 0 ? { ...entry, upAxis: 'y' } : entry));
  const parsed = parseProject(projectText({ ...project, entries }));
  expect(parsed.entries).toEqual(entries);
  const other = projectText({ ...project, entries }).replace('"upAxis":"y"', '"upAxis":"x"');
  expect(() => parseProject(other)).toThrow(/upAxis/);
});

test('a net may be held by as many vertices as it has', () => {
  const target: [number, number, number] = [1, 2, 3];
  const handles = Array.from({ length: 100_001 }, (_, vertex) => ({ vertex, target, anchor: false }));
  const project = projectOf([{ ...stateAt(new Float64Array(3)), handles }]);
  expect(readProject(writeProject(project, Infinity)).entries[0]!.state.handles).toHaveLength(handles.length);
});

test('the least that a file can take is known without writing it', () => {
  const { restPositions: positions, faceStart, faceVertices } = grid(60, 60);
  const small = projectOf([
    { ...stateAt(positions), net: { mesh: { positions, faceStart, faceVertices }, name: 'a' } },
  ]);
  const { length } = projectText(small);
  expect(leastBytes(small)).toBeLessThan(length);
  expect(leastBytes(small)).toBeGreaterThan(0.7 * length);
  const mesh = million();
  const large = projectOf([{ ...stateAt(mesh.positions), net: { mesh, name: 'large.obj' } }]);
  expect(() => checkSize('large', leastBytes(large))).toThrow(/large has 6\d MB; projects have 64 MB at most/);
});

describe('a project comes back', () => {
  const next = random(printedSeed('projects'));
  const pick = <T>(choices: readonly T[]): T => choices[Math.floor(next() * choices.length)]!;
  /** Any finite number: all 64 bits of it are random. */
  const anyNumber = (): number => {
    const bits = new DataView(new ArrayBuffer(8));
    bits.setUint32(0, next() * 2 ** 32);
    bits.setUint32(4, next() * 2 ** 32);
    const value = bits.getFloat64(0);
    return Number.isFinite(value) ? value : anyNumber();
  };

  function anyHandle(): HandleData {
    const handle: HandleData = {
      vertex: Math.floor(next() * 1e4),
      target: [anyNumber(), anyNumber(), anyNumber()],
      anchor: next() < 0.5,
    };
    if (next() < 0.3) handle.name = pick(['crown', '顶点', '"\\"', '']);
    if (next() < 0.3) handle.hidden = next() < 0.5;
    if (next() < 0.3) handle.weight = next() + 1e-9;
    return handle;
  }

  function anyState(earlier: Snapshot[]): Snapshot {
    const positions = Float64Array.from({ length: 3 * Math.floor(10 * next()) }, anyNumber);
    return {
      net: pick(NETS),
      handles: Array.from({ length: Math.floor(4 * next()) }, anyHandle),
      positions: next() < 0.3 ? (earlier.at(-1)?.positions ?? null) : positions,
      method: pick(['li2022', 'projection']),
      initialisation: pick(['naive', 'arap:5']),
      options: next() < 0.5 ? {} : { threshold: next(), adaptive_p: next() < 0.5 },
      settled: next() < 0.5,
      ...(next() < 0.7 ? { numbering: Math.floor(2 ** 32 * next()) } : {}),
      ...(next() < 0.3 ? { symmetry: { axis: pick(['x', 'y', 'z']), through: pick(['centre', 'origin']) } } : {}),
      ...(next() < 0.3 ? { experiment: 'long-edges', compare: ['li2022', 'dp4'] } : {}),
    };
  }

  function anyProject(): Project {
    const states: Snapshot[] = [];
    for (let count = 1 + Math.floor(6 * next()); count > 0; --count) states.push(anyState(states));
    return projectOf(states, Math.floor(next() * states.length));
  }

  /** Bits rather than numbers: 0 and −0 differ. */
  const bits = ({ entries }: Project) =>
    entries.map(({ state }) => state.positions && new BigUint64Array(state.positions.slice().buffer));

  test.each(Array.from({ length: 40 }, (_, i) => i))('whole, from a file: %i', () => {
    const project = anyProject();
    const back = parseProject(projectText(project));
    expect(back).toEqual(project);
    expect(bits(back)).toEqual(bits(project));
  });

  test('whole, from the browser, where positions are not copied', () => {
    const project = anyProject();
    const back = readProject(writeProject(project, Infinity));
    expect(back).toEqual(project);
    back.entries.forEach(({ state }, i) => expect(state.positions).toBe(project.entries[i]!.state.positions));
  });

  test('with what its states share', () => {
    const positions = Float64Array.of(1, 2, 3);
    const net = { recipe: 'vault' };
    const states = [0, 1, 2].map(() => ({ ...stateAt(positions), net }));
    const { entries } = parseProject(projectText(projectOf(states)));
    expect(new Set(entries.map(({ state }) => state.net)).size).toBe(1);
    expect(new Set(entries.map(({ state }) => state.positions)).size).toBe(1);
  });

  test('as far as it fits: the present state always, then the past, then what was undone', () => {
    const states = Array.from({ length: 9 }, () => stateAt(new Float64Array(300)));
    const names = (largest: number) => {
      const { entries, present } = readProject(writeProject(projectOf(states, 4), largest));
      return [entries.map(({ name }) => name.slice(5)).join(''), entries[present]!.name];
    };
    expect(names(1)).toEqual(['4', 'step 4']);
    expect(names(3 * 2400)).toEqual(['234', 'step 4']);
    expect(names(7 * 2400)).toEqual(['0123456', 'step 4']);
    expect(names(Infinity)).toEqual(['012345678', 'step 4']);
  });
});

describe('an entry', () => {
  const named = (name: Entry['name']): Project => ({
    ...projectOf([stateAt(Float64Array.of(1, 2, 3))]),
    entries: [{ name, state: stateAt(Float64Array.of(1, 2, 3)) }],
  });
  const nameIn = (text: string) => parseProject(text).entries[0]!.name;
  const text = projectText(named(['move', { handle: '7' }]));

  test('keeps what its name speaks of, for any language, and the words for older versions', () => {
    expect(nameIn(text)).toEqual(['move', { handle: '7' }]);
    expect(sentenceOf(nameIn(text))).toBe('Move handle 7');
    expect(text).toContain('"name":"Move handle 7"');
    expect(sentenceOf(['option', { option: 'p_end' }, '50'])).toBe('p end: 50');
    expect(sentenceOf(['option', { option: 'straight_rods' }, 'true'])).toBe('Straight rods: on');
    expect(sentenceOf(['option', { option: 'length_scale' }, '1.22'])).toBe('Edges: +22 %');
    expect(sentenceOf(['option', { option: 'shear_limit' }, '30'])).toBe('Corners: from 30°');
    expect(sentenceOf(['option', { option: 'guide_mode' }, '2'])).toBe('Keeps the net: on it');
    expect(sentenceOf(['option', { option: 'guide_mode' }, 'x'])).toBe('Keeps the net: x');
    for (const kind of ['shape', 'surface', 'method', 'behaviour'] as const)
      expect(sentenceOf(['open', { [kind]: 'toString' }])).toBe('Open toString');
    expect(sentenceOf(['optionBack', { option: 'length_scale' }])).toBe('Edges: as made');
    expect(sentenceOf(['optionBack', { option: 'guide_mode' }])).toBe('Keeps the net: near it');
    expect(sentenceOf(['optionBack', { option: 'square_corners' }])).toBe('Quads: as they were');
    expect(sentenceOf(['optionBack', { option: 'threshold' }])).toMatch(/: default$/);
    expect(sentenceOf(['weight', '4'])).toBe('Gravity: 4 of 9');
    expect(sentenceOf(['behaviour', { behaviour: 'cloth' }])).toBe('The net is soft cloth');
    expect(sentenceOf(['remove', { handles: '3' }])).toBe('Remove 3 handles');
    expect(sentenceOf(['open', 'mine.obj'])).toBe('Open mine.obj');
  });

  test('whose name is too long is read all the same, shortened', () => {
    const long = 'x'.repeat(600);
    expect(nameIn(projectText(named(['open', long])))).toBe(`Open ${'x'.repeat(495)}`);
    expect(nameIn(projectText(named(long)))).toBe('x'.repeat(500));
  });

  test('of an older version, or of one that knows more, keeps its words', () => {
    expect(nameIn(projectText(named('Move it')))).toBe('Move it');
    const changes = [
      '["knit",{"handle":"7"}]',
      '["move",{"loop":"7"}]',
      '["move",{"handle":7}]',
      '["move"]',
      '["constructor","x"]',
      '["one","x","y"]',
      '7',
      '[[]]',
      '["move",null]',
    ];
    for (const change of changes) {
      const other = text.replace('["move",{"handle":"7"}]', change);
      expect(other).toContain(change);
      expect(nameIn(other), change).toBe('Move handle 7');
    }
  });
});

test('handles that states share are written once, as they are in a file where each state has its own', () => {
  const positions = new Float64Array(3);
  const [stays, moves] = [0, 1].map((vertex): HandleData => ({ vertex, target: [0, 0, vertex], anchor: false }));
  const [before, after] = [
    [stays!, moves!],
    [stays!, { ...moves!, target: [1, 2, 3] as Vec3 }],
  ];
  const states = [before, before, after].map((handles) => ({ ...stateAt(positions), handles }));
  const written = writeProject(projectOf(states), Infinity)['states'] as { handles: unknown[] }[];
  expect(written[1]!.handles).toBe(written[0]!.handles);
  expect(written[2]!.handles[0]).toBe(written[0]!.handles[0]);
  expect(parseProject(projectText(projectOf(states))).entries.map(({ state }) => state.handles)).toEqual([
    before,
    before,
    after,
  ]);
});

describe('a long history with many handles that states share', () => {
  const handles = Array.from({ length: 5000 }, (_, vertex): HandleData => {
    return { vertex, target: [vertex / 3, -0, 1 / (vertex + 1)], anchor: false };
  });
  const [net, positions] = [{ recipe: 'vault' }, new Float64Array(3)];
  const long = projectOf(Array.from({ length: 200 }, () => ({ ...stateAt(positions), net, handles })));
  const distinct = ({ entries }: Project) => new Set(entries.map(({ state }) => state.handles)).size;

  test('stays whole however often it is kept and read again', () => {
    let project = long;
    for (let round = 0; round < 2; ++round) project = readProject(structuredClone(writeProject(project, 8e6)));
    expect([project.entries.length, distinct(project)]).toEqual([200, 1]);
  });

  test('is cut in a file, where each state has its own, rather than too large; what is left shares them again', () => {
    const text = projectText(long);
    expect(() => checkSize('long', text.length)).not.toThrow();
    const read = parseProject(text);
    expect(read.entries.length).toBeGreaterThan(10);
    expect(distinct(read)).toBe(1);
  });
});

test('states with other handles do not share them, whatever small it is that differs', () => {
  const handle: HandleData = { vertex: 0, target: [0, 0, 0], anchor: false };
  const others: HandleData[] = [
    handle,
    { ...handle, target: [0, 0, -0] },
    { ...handle, weight: 1 },
    { ...handle, weight: 2 },
    handle,
  ];
  const project = projectOf(others.map((each) => ({ ...stateAt(new Float64Array(3)), handles: [each] })));
  expect(readProject(writeProject(project, Infinity))).toEqual(project);
});

test('the camera of a net far from the origin comes back, and is none where it was written too coarsely', () => {
  const project = projectOf([stateAt(new Float64Array(3))]);
  const camera: CameraPlace = { position: [5.4e6 + 0.25, 1e8, 1e8 - 3], target: [5.4e6, 1e8, 1e8] };
  const written = projectText({ ...project, view: { ...project.view, camera } });
  expect(parseProject(written).view.camera).toEqual(camera);
  const coarse = written.replace(/"camera":\[[^\]]*\]/, '"camera":[1,2,3,1,2,3]');
  expect(parseProject(coarse).view.camera).toBeNull();
});

describe('a hostile project is refused, and it is said where', () => {
  const entry: Entry = {
    name: 'open',
    state: {
      ...stateAt(Float64Array.of(1, 2, 3)),
      numbering: 7,
      handles: [{ vertex: 3, target: [1, 2, 3], anchor: false }],
    },
  };
  const text = projectText({ ...projectOf([entry.state]), entries: [entry] });

  test.each([
    ['', /no chebnet project/],
    ['{', /no chebnet project/],
    ['null', /no chebnet project/],
    ['[]', /no chebnet project/],
    ['{"v":1}', /no chebnet project/],
    ['{"chebnet":0}', /another version/],
    ['{"chebnet":7}', /another version/],
    ['{"chebnet":"1"}', /another version/],
    ['{"chebnet":[1]}', /another version/],
    ['{"chebnet":1}', /^nets must be a list/],
    ['{"chebnet":2}', /^nets must be a list/],
  ])('%s', (foreign, said) => expect(() => parseProject(foreign)).toThrow(said));

  test.each([
    ['"present":0', '"present":1', /^present must be/],
    ['"present":0', '"present":-1', /^present must be/],
    ['"present":0', '"present":"0"', /^present must be/],
    ['"name":"open"', '"name":7', /^states\[0\]\.name must be/],
    ['"net":0', '"net":1', /^states\[0\]\.net must be/],
    ['"net":0', '"net":0.5', /^states\[0\]\.net must be/],
    ['"positions":0', '"positions":1', /^states\[0\]\.positions must be/],
    ['[3,0,1,2,3]', '[3,0]', /^states\[0\]\.handles must be/],
    ['[3,0,1,2,3]', '[3,0,1,2]', /^states\[0\]\.handles\[0\] must be/],
    ['[3,0,1,2,3]', '[3,2,1,2,3]', /^states\[0\]\.handles\[0\]\[1\] must be/],
    ['[3,0,1,2,3]', '[3,0,1,2,1e999]', /^states\[0\]\.handles\[0\]\[4\] must be/],
    ['[3,0,1,2,3]', '[3,0,1,2,3,{"weight":-1}]', /^states\[0\]\.handles\[0\]\[5\]\.weight must be/],
    ['"options":{}', '"options":{"threshold":null}', /^states\[0\]\.options\.threshold must be/],
    ['"options":{}', '"options":{"__proto__":"x"}', /^states\[0\]\.options\.__proto__ must be/],
    ['"settled":true', '"settled":"yes"', /^states\[0\]\.settled must be/],
    ['"numbering":7', '"numbering":-7', /^states\[0\]\.numbering must be/],
    ['"numbering":7', '"numbering":"7"', /^states\[0\]\.numbering must be/],
    ['{"recipe":"vault:vertices=1000"}', '{"obj":"v"}', /^nets\[0\]\.name must be/],
    ['{"recipe":"vault:vertices=1000"}', '"vault"', /^nets\[0\] must be/],
    ['"camera":null', '"camera":[1,2,3,1,2]', /^view\.camera must be/],
    ['"field":"deviation"', '"field":"__proto__"', /^view\.field must be one of/],
    ['AAAAAAAA8D8AAAAAAAAAQAAAAAAAAAhA', 'AAAAAAAA8D8AAAAAAAAAQA==', /^positions\[0\] must be/],
    ['AAAAAAAA8D8AAAAAAAAAQAAAAAAAAAhA', 'AAAAAAAA8D8AAAAAAAAAQAAAAAAAA', /^positions\[0\] must be/],
    ['AAAAAAAA8D8AAAAAAAAAQAAAAAAAAAhA', 'AAAAAAAA8H8AAAAAAAAAQAAAAAAAAAhA', /^positions\[0\] must be/],
    ['AAAAAAAA8D8AAAAAAAAAQAAAAAAAAAhA', '!!!!', /^positions\[0\] must be/],
  ])('%s as %s', (part, instead, said) => {
    expect(text).toContain(part);
    expect(() => parseProject(text.replace(part, instead))).toThrow(said);
  });

  test('without any of its fields', () => {
    for (const [field] of text.matchAll(
      /"(view|present|states|nets|positions|name|handles|method|options|settled|net|numbering|recipe|camera)":/g,
    )) {
      expect(() => parseProject(text.replace(field, '"else":')), field).toThrow();
    }
  });

  test('noise', () => {
    const next = random(printedSeed('noise in projects'));
    for (let round = 0; round < 300; ++round) {
      const bytes = Buffer.from(text);
      for (let hit = 0; hit < 3; ++hit) bytes[Math.floor(next() * bytes.length)] = Math.floor(256 * next());
      try {
        expect(parseProject(bytes.toString()).entries).toHaveLength(1);
      } catch (error) {
        expect((error as Error).message).toMatch(/must be|project/);
      }
    }
  });
});

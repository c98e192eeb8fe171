/** Links: a scene goes in and comes out, and nothing else does. */
import { deflateSync } from 'fflate';
import { describe, expect, test, vi } from 'vitest';
import type { ChebnetDocument, Vec3 } from '../../web/src/document/document';
import { packMesh } from '../../web/src/document/packed_mesh';
import { unpackPositions } from '../../web/src/document/packing';
import { linkAdvice } from '../../web/src/document/link_advice';
import { edgeLengths } from '../../web/src/net/edge_lengths';
import { LARGEST_LINK, LONG_LINK, decodeScene, encodeScene } from '../../web/src/document/share';
import { largestDistance } from '../wasm/load';
import { hashWithZeros } from './hash_with_zeros';
import { documentAt, grid, million } from './nets';
import { printedSeed, random } from './random';

/** What has been deflated, which is what takes the time. */
const deflated = vi.hoisted(() => ({ bytes: 0 }));
vi.mock('fflate', async (load) => {
  const fflate = await load<typeof import('fflate')>();
  const deflateSync: typeof fflate.deflateSync = (data, options) => {
    deflated.bytes += data.length;
    return fflate.deflateSync(data, options);
  };
  return { ...fflate, deflateSync };
});

const net = grid(10, 10);
const SQUARE = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5),
  faceStart: Int32Array.of(0, 4),
  faceVertices: Int32Array.of(0, 1, 2, 3),
};
const moved = net.restPositions.map((x, i) => x + 0.1 * Math.sin(i));

function hashOf(document: ChebnetDocument, on = net): string {
  const { hash } = encodeScene(document, on, 1e-6);
  if (hash === null) throw new Error('no hash');
  return hash;
}

describe('a scene comes back', () => {
  const view: ChebnetDocument['view'] = {
    camera: { position: [1.5, -2, 3], target: [0, 0.25, 0] },
    field: 'angle',
    colourMap: 'log',
    ends: { angle: [60, 120] },
    showFaces: false,
    upAxis: 'y',
  };
  const full: ChebnetDocument = {
    ...documentAt(moved),
    handles: [
      { vertex: 0, target: [0, 0, 0], anchor: true },
      { vertex: 37, target: [0.1 + 0.2, -1e-17, 123456.789012345], anchor: false },
      { vertex: 41, target: [1, 2, 3], anchor: false, name: 'Südspitze 南', hidden: true, weight: 0.25 },
    ],
    numbering: 2 ** 32 - 1,
    symmetry: { axis: 'y', through: 'origin' },
    locality: 12,
    influence: 4,
    method: 'another',
    initialisation: 'arap:5',
    options: { threshold: 1e-8, adaptive_p: false },
    view,
  };

  test('whole', () => {
    const { positions, handles, ...rest } = decodeScene(hashOf(full));
    const { net: source, numbering, symmetry, locality, influence, method, initialisation, options } = full;
    expect(rest).toEqual({
      net: source,
      numbering,
      symmetry,
      locality,
      influence,
      method,
      initialisation,
      options,
      view,
      settled: true,
    });
    expect(handles).toEqual([{ vertex: 0, target: null, anchor: true }, full.handles[1], full.handles[2]]);
    expect(positions).toHaveProperty('packed');
    if (positions && 'packed' in positions) {
      expect(largestDistance(unpackPositions(positions.packed, net), moved)).toBeLessThan(1e-4);
    }
  });

  test('at rest, without positions', () => {
    const hash = hashOf(documentAt(net.restPositions));
    expect(decodeScene(hash).positions).toBeNull();
    expect(hash.length).toBeLessThan(300);
  });

  test('with a small file, as text', () => {
    const source = { mesh: SQUARE, name: 'größer.ply' };
    const obj = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 1 2 3 4\n';
    expect(decodeScene(hashOf({ ...documentAt(null), net: source })).net).toEqual({ obj, name: 'größer.ply' });
  });

  test('with a larger file, packed, and positions beside it', () => {
    const sheet = grid(30, 20);
    const mesh = { ...sheet, positions: sheet.restPositions.map((x, i) => x + 0.3 * Math.sin(i * i)) };
    const on = { ...sheet, restPositions: mesh.positions, restLengths: edgeLengths(mesh.positions, sheet.edges) };
    const positions = mesh.positions.map((x, i) => x + 0.1 * Math.sin(i));
    const source = { mesh, name: 'größer.ply', restLengths: 'own' } as const;
    const handles = [
      { vertex: 3, target: [...mesh.positions.subarray(9, 12)] as Vec3, anchor: true },
      { vertex: 70, target: [1, 2, 3] as Vec3, anchor: false, slides: 'xy' as const },
    ];
    const hash = hashOf({ ...documentAt(positions), net: source, handles }, on);
    expect(hash).toMatch(/^#v5=/);
    const scene = decodeScene(hash);
    expect(scene).toMatchObject({
      net: { name: 'größer.ply', restLengths: 'own', mesh: { faceStart: on.faceStart, faceVertices: on.faceVertices } },
      handles: [{ ...handles[0], target: null }, handles[1]],
      settled: true,
    });
    if (!('mesh' in scene.net) || scene.positions === null || !('packed' in scene.positions))
      throw new Error('not packed');
    expect(largestDistance(scene.net.mesh.positions, mesh.positions)).toBeLessThan(2e-7);
    const opened = { ...on, restPositions: scene.net.mesh.positions };
    expect(largestDistance(unpackPositions(scene.positions.packed, opened), positions)).toBeLessThan(1e-4);
    // At rest it says nothing of positions; where there is room for fewer digits it has those; then it leaves positions out.
    const atRest = hashOf({ ...documentAt(mesh.positions), net: source }, on);
    expect(decodeScene(atRest).positions).toBeNull();
    const shorter = encodeScene({ ...documentAt(mesh.positions), net: source }, on, 1e-6, atRest.length - 500);
    expect(shorter).toMatchObject({ positions: true });
    const { net: rounded } = decodeScene(shorter.hash!);
    if (!('mesh' in rounded)) throw new Error('not packed');
    const error = largestDistance(rounded.mesh.positions, mesh.positions);
    expect(error).toBeGreaterThan(2e-7);
    expect(error).toBeLessThan(1e-4);
    const shortest = encodeScene({ ...documentAt(positions), net: source }, on, 1e-6, shorter.hash!.length);
    expect(shortest).toMatchObject({ positions: false });
    expect(decodeScene(shortest.hash!)).toMatchObject({ positions: null, settled: false });
  });

  test('with the lengths that the edges of a file are to keep', () => {
    const source = { mesh: SQUARE, name: 'small.ply', restLengths: 'equal' } as const;
    expect(decodeScene(hashOf({ ...documentAt(null), net: source })).net).toMatchObject({ restLengths: 'equal' });
  });

  test.each(['deviation', 'angle', 'shear', 'force', 'longer'] as const)('in its colours, by %s', (field) => {
    const document = documentAt(null);
    expect(decodeScene(hashOf({ ...document, view: { ...document.view, field } })).view.field).toBe(field);
  });

  test('as the experiment that it was opened as', () => {
    const part = { experiment: 'long-edges', compare: ['li2022', 'dp4'] };
    expect(decodeScene(hashOf({ ...documentAt(null), ...part }))).toMatchObject(part);
    expect(decodeScene(hashOf(documentAt(null)))).not.toHaveProperty('experiment');
  });

  test.each(['toString', ' Waves :vertices=600'])('with the recipe "%s" as it stands', (recipe) => {
    const net = { recipe };
    expect(decodeScene(hashOf({ ...documentAt(null), net })).net).toEqual(net);
  });

  test('while it is being solved', () => {
    expect(decodeScene(hashOf({ ...documentAt(moved), settled: false })).settled).toBe(false);
  });

  test('from an address that may stand anywhere', () => {
    expect(hashOf(full)).toMatch(/^#v2=[\w-]+$/);
  });
});

describe('what is too large', () => {
  const next = random(1);
  const large = grid(150, 150);
  const shaken = large.restPositions.map((x) => x + next());

  test('are positions: they are left out, the net is solved for its handles instead, and this is said', () => {
    const shared = encodeScene(documentAt(shaken), large, 1e-6);
    expect(shared).toMatchObject({ positions: false });
    expect(decodeScene(shared.hash ?? '')).toMatchObject({ positions: null, settled: false });
    expect(linkAdvice(shared)).toMatch(/too large/);
  });

  test('for a QR code is left out likewise', () => {
    const shared = encodeScene(documentAt(shaken), large, 1e-6, 1000);
    expect(shared).toMatchObject({ positions: false });
    expect(shared.hash!.length).toBeLessThanOrEqual(1000);
  });

  test('is a file: there is no link, and this is said', () => {
    const mesh = { ...SQUARE, positions: Float64Array.from({ length: 60_000 }, next) };
    const shared = encodeScene({ ...documentAt(null), net: { mesh, name: 'large.obj' } }, net, 1e-6);
    expect(shared).toEqual({ hash: null });
    expect(linkAdvice(shared)).toMatch(/too large for a link/);
  });

  test('by far is refused by its number of vertices, also for a QR code', () => {
    const mesh = million();
    deflated.bytes = 0;
    const document = { ...documentAt(mesh.positions), net: { mesh, name: 'large.obj' } };
    const open = { ...net, restPositions: mesh.positions };
    expect(encodeScene(document, open, 1e-6)).toEqual({ hash: null });
    const dragged = mesh.positions.map((x) => x + 1);
    expect(encodeScene(documentAt(dragged), open, 1e-6, 3000)).toMatchObject({ positions: false });
    expect(encodeScene(documentAt(mesh.positions), open, 1e-6, 3000)).toMatchObject({ positions: true });
    expect(deflated.bytes).toBeLessThan(10_000);
  });

  test('is a surface that a visitor brought: it is left out, and this is said; one of ours is named', () => {
    const brought = encodeScene({ ...documentAt(null), guide: { name: 'scan.obj', mesh: SQUARE } }, net, 1e-6);
    expect(decodeScene(brought.hash ?? '')).not.toHaveProperty('guide');
    expect(linkAdvice(brought)).toMatch(/leaves out the surface/);
    const ours = encodeScene({ ...documentAt(null), guide: { own: 'shell' } }, net, 1e-6);
    expect(decodeScene(ours.hash ?? '').guide).toEqual({ own: 'shell' });
    expect(linkAdvice(ours)).toBeNull();
  });

  test('for some programs is said', () => {
    expect(linkAdvice({ hash: '#'.repeat(LONG_LINK), positions: true })).toBeNull();
    expect(linkAdvice({ hash: '#'.repeat(LONG_LINK + 1), positions: true })).toMatch(/2,001 characters/);
    expect(linkAdvice({ hash: '#'.repeat(8001), positions: true })).toMatch(/file/);
    expect(LARGEST_LINK).toBeGreaterThan(8000);
  });
});

describe('hostile links are refused', () => {
  const valid = {
    net: { recipe: 'vault' },
    handles: [[3, 0, 1, 2, 3]],
    method: 'li2022',
    options: {},
    view: { camera: null, field: 'deviation', colourMap: 'paper', showFaces: true },
    settled: true,
  };

  function hash(content: Uint8Array, version = 1): string {
    return `#v${version}=${Buffer.from(deflateSync(content)).toString('base64url')}`;
  }

  function hashOfJson(json: string, version = 1): string {
    const text = Buffer.from(json);
    const length = Buffer.alloc(4);
    length.writeUInt32LE(text.length);
    return hash(Buffer.concat([length, text]), version);
  }

  function failureOf(text: string): unknown {
    try {
      decodeScene(text);
    } catch (error) {
      return error;
    }
    return null;
  }

  const bad = (text: string) =>
    expect(failureOf(text)).toMatchObject({ code: 'bad_link', message: expect.stringMatching(/link/) });

  test('with drags that are to be made again in steps beyond count, or in none', () => {
    const withReplay = (replay: unknown) => hashOfJson(JSON.stringify({ ...valid, numbering: 1, replay }), 6);
    expect(decodeScene(withReplay([10, 3])).replay).toEqual([10, 3]);
    for (const replay of [
      [],
      [10],
      [0, 3],
      [10, 0],
      [21, 3],
      [10, 21],
      [10, 3, 1],
      [1.5, 3],
      [-1, 3],
      ['10', 3],
      10,
      {},
      null,
    ])
      bad(withReplay(replay));
  });

  test('not this one, made before links had an initialisation, ends of colours, an up axis, a symmetry, a locality, and names of handles', () => {
    const scene = decodeScene(hashOfJson(JSON.stringify(valid)));
    expect(scene).toMatchObject({ net: { recipe: 'vault' }, initialisation: 'naive' });
    expect(scene.view).not.toHaveProperty('ends');
    expect(scene.view).not.toHaveProperty('upAxis');
    expect(scene).not.toHaveProperty('symmetry');
    expect(scene).not.toHaveProperty('locality');
    expect(scene.handles).toEqual([{ vertex: 3, anchor: false, target: [1, 2, 3] }]);
  });

  test('nor this one, of the version after it, whose net was not looked at since', () => {
    const scene = decodeScene(hashOfJson(JSON.stringify({ ...valid, numbering: null }), 2));
    expect(scene).toMatchObject({ net: { recipe: 'vault' } });
    expect(scene).not.toHaveProperty('numbering');
  });

  test('of more handles than any that is made has room for', () => {
    const handles = Array.from({ length: 100_001 }, () => [0, 0]);
    bad(hashOfJson(JSON.stringify({ ...valid, handles })));
  });

  test.each([undefined, -1, 0.5, 2 ** 32, '7', true, [7]])(
    'of the second version with the numbering %j',
    (numbering) => {
      bad(hashOfJson(JSON.stringify({ ...valid, numbering }), 2));
    },
  );

  test.each([
    '#',
    '#nonsense',
    '#%E0%A4%A',
    '#v7=AAAA',
    '#v0=AAAA',
    '#v01=',
    '#v1',
    '#v1.0=',
    '#v1e0=',
    '#v=',
    '#V1=AAAA',
    `#${'A'.repeat(5000)}`,
  ])('foreign: %.20s', (text) => {
    expect(failureOf(text)).toMatchObject({ code: 'foreign_link', message: expect.stringMatching(/link/) });
  });

  test.each([
    '#v1=',
    '#v1=A',
    '#v1=!!!!',
    '#v1=%20',
    '#v1=\u{1F600}',
    '#v1=AAAA',
    '#v1=____',
    '#v2=',
    '#v2=AAAA',
    '#v5=',
    '#v5=AAAA',
  ])('not deflated: %s', bad);

  test('with names of the core, or a list of methods, as long as none is; the name of a file is shortened', () => {
    const long = 'x'.repeat(5000);
    const hashWith = (part: object) => hashOfJson(JSON.stringify({ ...valid, ...part }));
    for (const part of [
      { net: { recipe: long } },
      { method: long },
      { initialisation: long },
      { experiment: long },
      { guide: { own: long } },
      { compare: [long] },
      { compare: Array(5000).fill('dp4') },
    ])
      bad(hashWith(part));
    const { net: named } = decodeScene(hashWith({ net: { obj: 'v 0 0 0\n', name: long } }));
    expect(named).toMatchObject({ name: 'x'.repeat(255) });
  });

  test('cut off anywhere', () => {
    const whole = hashOf({ ...documentAt(moved), handles: [{ vertex: 3, target: [1, 2, 3], anchor: false }] });
    for (let length = 4; length < whole.length; length += 7) {
      const scene = failureOf(whole.slice(0, length)) ?? decodeScene(whole.slice(0, length));
      // What is cut off at the very end may be no more than some positions, which the net then misses.
      if (scene instanceof Error) expect(scene).toMatchObject({ code: 'bad_link' });
      else
        expect(() => unpackPositions((scene as { positions: { packed: Uint8Array } }).positions.packed, net)).toThrow();
    }
  });

  test('packed nets that are none, or as long as no link is', () => {
    const packed = (bytes: unknown, mesh: Uint8Array, version = 5): string => {
      const header = Buffer.from(JSON.stringify({ ...valid, numbering: null, net: { name: 'x', packed: bytes } }));
      const length = Buffer.alloc(4);
      length.writeUInt32LE(header.length);
      return hash(Buffer.concat([length, header, mesh]), version);
    };
    const mesh = packMesh(SQUARE, 1e-4)!;
    expect(failureOf(packed(mesh.length, mesh))).toBeNull();
    for (const bytes of [-1, 0, 0.5, 3, mesh.length - 1, mesh.length + 1, 2 ** 40, '9', null, [9]])
      bad(packed(bytes, mesh));
    bad(packed(2e6, new Uint8Array(2e6)));
    bad(packed(mesh.length, mesh.fill(255)));
  });

  test('bombs of 20 MB and of a gigabyte, which 6 MB are not', () => {
    expect(failureOf(hashWithZeros(valid, 6e6))).toBeNull();
    [hash(new Uint8Array(20e6)), hashWithZeros(valid, 20e6), hashWithZeros(valid, 1e9)].forEach(bad);
  });

  test('headers longer than the content', () => {
    bad(hash(new Uint8Array()));
    bad(hash(Uint8Array.of(1, 2)));
    bad(hash(Uint8Array.of(255, 255, 255, 255, 123, 125)));
  });

  test.each(['', '{', 'null', '[]', '"x"', '{}', '\ufeff{}'])('no scene: %s', (json) => bad(hashOfJson(json)));

  const point = '"handles":[[3,0,1,2,3]]';
  const json = JSON.stringify(valid);
  test.each([
    [point, '"handles":[[-1,0]]'],
    [point, '"handles":[[1.5,0]]'],
    [point, '"handles":[[2147483648,0]]'],
    [point, '"handles":[[1e999,0]]'],
    [point, '"handles":[["3",0]]'],
    [point, '"handles":[[null,0]]'],
    [point, '"handles":[[3,2]]'],
    [point, '"handles":[[3]]'],
    [point, '"handles":[[3,0,1]]'],
    [point, '"handles":[[3,0,1,2,3,4]]'],
    [point, '"handles":[[3,0,1,2,1e999]]'],
    [point, '"handles":[[3,0,1,2,NaN]]'],
    [point, '"handles":[[3,0,1,2,null]]'],
    [point, '"handles":{}'],
    [point, '"handles":[[3,0,{"name":7}]]'],
    [point, `"handles":[[3,0,{"name":"${'x'.repeat(41)}"}]]`],
    [point, '"handles":[[3,0,{"hidden":1}]]'],
    [point, '"handles":[[3,0,{"weight":0}]]'],
    [point, '"handles":[[3,0,{"weight":1e999}]]'],
    [point, '"handles":[[3,0,{},1,2,3]]'],
    [point, '"handles":[[3,0,1,2,3,null]]'],
    ['"showFaces":true', '"showFaces":true,"ends":[1,2]'],
    ['"showFaces":true', '"showFaces":true,"ends":{"angle":[60]}'],
    ['"showFaces":true', '"showFaces":true,"ends":{"angle":[60,60]}'],
    ['"showFaces":true', '"showFaces":true,"ends":{"angle":[60,120,130]}'],
    ['"showFaces":true', '"showFaces":true,"ends":{"deviation":[0,1]}'],
    ['"settled":true', '"settled":true,"symmetry":{"axis":"w","through":"centre"}'],
    ['"settled":true', '"settled":true,"symmetry":null'],
    ['"settled":true', '"settled":true,"locality":0'],
    ['"settled":true', '"settled":true,"locality":"near"'],
    ['"settled":true', '"settled":true,"influence":-1'],
    ['"settled":true', '"settled":true,"experiment":7'],
    ['"settled":true', '"settled":true,"compare":"li2022"'],
    ['{"recipe":"vault"}', '{"recipe":7}'],
    ['{"recipe":"vault"}', '{"obj":"v"}'],
    ['{"recipe":"vault"}', 'null'],
    ['"options":{}', '"options":{"threshold":"1"}'],
    ['"options":{}', '"options":{"threshold":1e999}'],
    ['"options":{}', '"options":[]'],
    ['"li2022"', '{}'],
    ['"camera":null', '"camera":[1,2,3]'],
    ['"camera":null', '"camera":[1,2,3,4,5,1e999]'],
    ['"deviation"', '"__proto__"'],
    ['"paper"', '"rainbow"'],
    ['"showFaces":true', '"showFaces":true,"upAxis":"x"'],
    ['"options":{}', '"options":{},"initialisation":5'],
    ['"settled":true', '"settled":1'],
  ])('%s as %s', (part, instead) => {
    expect(json).toContain(part);
    bad(hashOfJson(json.replace(part, instead)));
  });

  test('noise', () => {
    const next = random(printedSeed('noise in links'));
    const whole = hashOf(documentAt(moved)).slice(4);
    for (let round = 0; round < 300; ++round) {
      const bytes = Buffer.from(whole, 'base64url');
      for (let hit = 0; hit < 3; ++hit) bytes[Math.floor(next() * bytes.length)] = Math.floor(256 * next());
      const error = failureOf(`#v2=${bytes.toString('base64url')}`);
      if (error !== null) expect(error).toMatchObject({ code: 'bad_link' });
    }
  });
});

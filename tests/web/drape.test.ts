/** Nets on surfaces, without a page: answers of the worker, what waits while it works, and the geometry of the seed. */
import { describe, expect, test } from 'vitest';
import type { Mesh, Point } from '../../wasm/chebnet';
import { guideTitle } from '../../web/src/document/changes';
import { sentenceOf } from '../../web/src/document/naming';
import { cellsOf, lengthOf } from '../../web/src/drape/cells';
import type { Cut, DrapeRequest, DrapeResponse, Ray, SurfaceSource } from '../../web/src/drape/drape_protocol';
import { Draper } from '../../web/src/drape/draper';
import { Draping } from '../../web/src/drape/draping';
import type { DrapeWorkerLike } from '../../web/src/drape/draping';
import { DrawnLine } from '../../web/src/drape/drawn_line';
import { dot, laidInto, reference, turned, turnOf } from '../../web/src/drape/seed';
import { proposedHandles } from '../../web/src/handles/proposal';
import { dialogs } from '../../web/src/language/en/dialogs';
import { panelWords } from '../../web/src/language/panels';
import { load } from '../wasm/load';

const core = await load();

/** What the worker answers, in turn. */
function answers(...requests: DrapeRequest[]): DrapeResponse[] {
  const responses: DrapeResponse[] = [];
  const draper = new Draper(core, (response) => responses.push(response));
  for (const request of requests) draper.handle(request);
  return responses;
}

const OPEN: DrapeRequest = { type: 'open', source: { own: 'hypar' } };
const SETTINGS = { seed: [0, 0, 0] as Point, direction: [1, 1, 0] as Point, length: 0.3, cuts: [] as Point[][] };

describe('the worker', () => {
  test('opens a surface, lays a net from a ray, and measures it', () => {
    const ray = { origin: [0.5, 0.2, 9] as Point, direction: [0, 0, -1] as Point };
    const [opened, draped, measured] = answers(
      OPEN,
      { type: 'drape', settings: { ...SETTINGS, seed: ray } },
      { type: 'measure' },
    );
    if (opened?.type !== 'opened' || draped?.type !== 'draped' || measured?.type !== 'measured') return expect.fail();
    expect(opened.surface.report.prospect).toBe('one_piece');
    expect(opened.surface.normals).toHaveLength(opened.surface.positions.length);
    expect(opened.length).toBeGreaterThan(0);
    const { position, normal, direction } = draped.seed;
    expect(position[0]).toBeCloseTo(0.5);
    expect(dot(direction, normal)).toBeCloseTo(0);
    expect(draped.net.info.isChebyshev).toBe(true);
    expect(draped.net.info.meanLength).toBeCloseTo(0.3, 9);
    expect(draped.fields.angle).toHaveLength(draped.net.info.vertices);
    expect(measured.report.coverage).toBeGreaterThan(0.95);
    expect(measured.report.gaps).toBe(0);
    expect(Object.keys(draped.times)).toEqual(['lay', 'open']);
  });

  test('measures a net most of whose edges a border has cut by the length it was laid with', () => {
    const source = { own: 'hemisphere' };
    const [opened] = answers({ type: 'open', source });
    if (opened?.type !== 'opened') return expect.fail();
    const { area } = opened.surface.report;
    for (const cells of [8, 10, 12, 15]) {
      const length = Math.sqrt(area / cells);
      const settings = { ...SETTINGS, seed: [0, 0, 9] as Point, length, border: 'cut' as const };
      const [, , measured] = answers({ type: 'open', source }, { type: 'drape', settings }, { type: 'measure' });
      if (measured?.type !== 'measured') return expect.fail();
      const { report } = measured;
      expect(report.length).toBeCloseTo(length, 9);
      expect(report.wholeCells).toBeGreaterThan(0);
      expect(report.smallestAngle).toBeLessThan(Math.PI / 2);
    }
  });

  test('begins on a curve nearest to the seed that is wanted, and has its direction', () => {
    const along: Point[] = [
      [-2, 0, 0],
      [2, 0, 0],
    ];
    const settings = { ...SETTINGS, seed: [0.7, 0.4, 0] as Point, arms: 'curve' as const, along };
    for (const cuts of [[], [[[-3, 2, -1.2] as Point, [3, 2, 1.2] as Point]]]) {
      const [, draped] = answers(OPEN, { type: 'drape', settings: { ...settings, cuts } });
      if (draped?.type !== 'draped') return expect.fail();
      expect(draped.arms).toBe('curve');
      const { position, direction } = draped.seed;
      // The x axis lies on the hypar.
      expect(Math.hypot(position[1], position[2])).toBeLessThan(1e-9);
      expect(direction[0]).toBeCloseTo(1, 3);
    }
    const [, refused] = answers(OPEN, { type: 'drape', settings: { ...settings, along: [along[0]!] } });
    expect(refused).toMatchObject({ type: 'error', code: 'bad_option' });
  });

  test('proposes beginnings on a ribbon that is too narrow for the large cells of the pictures', () => {
    const count = 200;
    const place = (i: number, width: number): Point => {
      const [angle, radius] = [(9 * Math.PI * i) / count, 1 + width];
      return [radius * Math.cos(angle), radius * Math.sin(angle), (1.5 * i) / count];
    };
    const rows = Array.from({ length: count + 1 }, (_, i) => [place(i, 0), place(i, 0.06)]);
    const faceVertices = rows.slice(1).flatMap((_, i) => [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
    const mesh = {
      positions: Float64Array.from(rows.flat(2)),
      faceStart: Int32Array.from({ length: count + 1 }, (_, i) => 4 * i),
      faceVertices: Int32Array.from(faceVertices),
    };
    for (const border of ['beyond', 'inside'] as const) {
      const [, proposed] = answers(
        { type: 'open', source: { mesh } },
        { type: 'propose', settings: { length: 0.03, border } },
      );
      if (proposed?.type !== 'proposed') return expect.fail(JSON.stringify(proposed));
      for (const { wireframe } of proposed.proposals) expect(wireframe.edges.length).toBeGreaterThan(0);
    }
  });

  test('proposes where to begin, with a picture of each', () => {
    const [, proposed, draped] = answers(
      OPEN,
      { type: 'propose', settings: { length: 0.3 } },
      { type: 'drape', settings: SETTINGS },
    );
    if (proposed?.type !== 'proposed') return expect.fail();
    expect(proposed.proposals).toHaveLength(4);
    for (const { wireframe, direction, covered, muchSheared, meanDistance } of proposed.proposals) {
      expect(covered).toBeGreaterThan(0.5);
      expect(muchSheared).toBeLessThan(0.5);
      expect(meanDistance).toBeGreaterThan(0);
      expect(meanDistance).toBeLessThan(0.1);
      expect(Math.hypot(...direction)).toBeCloseTo(1);
      expect(Math.max(...wireframe.edges)).toBeLessThan(wireframe.positions.length / 3);
    }
    expect(draped?.type).toBe('draped');
  });

  test('draws a cut point by point, and lays a net on each piece', () => {
    const from: Point = [-3.35, 0.3, 0];
    const across = { origin: [9, 0.3, 0] as Point, direction: [-1, 0, 0] as Point };
    const [, first, second, missed] = answers(
      OPEN,
      { type: 'trace', line: 'cuts', points: [from], revision: 1 },
      { type: 'trace', line: 'cuts', points: [from, [3.35, 0.4, 0]], revision: 2 },
      { type: 'trace', line: 'cuts', points: [from, { ...across, direction: [1, 0, 0] }], revision: 3 },
    );
    if (first?.type !== 'traced' || second?.type !== 'traced') return expect.fail();
    expect([first.cut.points.length, first.cut.path.length]).toEqual([1, 3]);
    expect(second.cut.points).toHaveLength(2);
    expect(second.cut.path.length).toBeGreaterThan(30);
    expect(missed).toMatchObject({ type: 'traced', cut: first.cut, revision: 3 });

    const ends: Point[] = [first.cut.points[0]!, second.cut.points[1]!];
    const [, whole, halves, report] = answers(
      OPEN,
      { type: 'drape', settings: SETTINGS },
      { type: 'drape', settings: { ...SETTINGS, cuts: [ends] } },
      { type: 'measure' },
    );
    if (whole?.type !== 'draped' || halves?.type !== 'draped' || report?.type !== 'measured') return expect.fail();
    expect([whole.pieces, whole.bare, halves.pieces, halves.bare]).toEqual([1, 0, 2, 0]);
    expect([whole.net.info.components, halves.net.info.components]).toEqual([1, 2]);
    expect(report.report.coverage).toBeGreaterThan(0.95);
  });

  test('says when a ray misses, and what is refused; the surface stays', () => {
    const away = { origin: [0, 0, 9] as Point, direction: [0, 0, 1] as Point };
    const responses = answers(
      OPEN,
      { type: 'drape', settings: { ...SETTINGS, seed: away } },
      { type: 'drape', settings: { ...SETTINGS, length: -1 } },
      { type: 'drape', settings: SETTINGS },
    );
    expect(responses.map(({ type }) => type)).toEqual(['opened', 'missed', 'error', 'draped']);
    expect(responses[2]).toMatchObject({ code: 'bad_option' });
  });

  test('makes a net over the whole surface, tells how far it is, and measures it', () => {
    const responses = answers(
      { type: 'open', source: { own: 'pebble' } },
      { type: 'remesh', options: { cells: 150 } },
      { type: 'measure' },
    );
    const phases = responses.flatMap((response) => (response.type === 'progress' ? [response.phase] : []));
    expect([...new Set(phases)]).toEqual(['triangles', 'field', 'grid', 'fit']);
    const [remeshed, measured] = responses.slice(-2);
    if (remeshed?.type !== 'remeshed' || measured?.type !== 'measured') return expect.fail();
    expect(remeshed.net.info.isChebyshev).toBe(true);
    const defects = remeshed.singularVertices.map(({ valence, count }) => (4 - valence) * count);
    expect(defects.reduce((sum, each) => sum + each)).toBe(8);
    expect(measured.report.coverage).toBeGreaterThan(0.95);
  });

  test('counts as folds of the net itself none where it follows an edge of the surface, and all where that has none', () => {
    const measured = (source: SurfaceSource, mesh: Mesh) => {
      const [, response] = answers({ type: 'open', source }, { type: 'measure', mesh });
      return response?.type === 'measured' ? [response.report.folds, response.report.crumpled] : expect.fail();
    };
    // A gutter of three walls as a surface of six triangles, and as a net of squares.
    const gutter = (across: number[][], along: number): Mesh => {
      const quads = across.slice(1).flatMap((_, i) => Array.from({ length: along }, (_, j) => [i, j] as const));
      const at = (i: number, j: number): number => i * (along + 1) + j;
      return {
        positions: Float64Array.from(
          across.flatMap(([x, z]) => Array.from({ length: along + 1 }, (_, j) => [x!, (4 * j) / along, z!]).flat()),
        ),
        faceStart: Int32Array.from({ length: quads.length + 1 }, (_, i) => 4 * i),
        faceVertices: Int32Array.from(
          quads.flatMap(([i, j]) => [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]),
        ),
      };
    };
    const walls = [
      [0, 2],
      [0, 0],
      [2, 0],
      [2, 2],
    ];
    const net = gutter(
      [
        [0, 2],
        [0, 1],
        [0, 0],
        [1, 0],
        [2, 0],
        [2, 1],
        [2, 2],
      ],
      4,
    );
    expect(measured({ mesh: gutter(walls, 1) }, net)).toEqual([8, 0]);
    expect(
      measured(
        {
          mesh: gutter(
            [
              [0, 0],
              [2, 0],
            ],
            1,
          ),
        },
        net,
      ),
    ).toEqual([8, 8]);
    const pleated = gutter(
      [
        [0, 2],
        [0, 1],
        [0, 0],
        [0.5, 0.9],
        [1, 0],
        [2, 0],
        [2, 1],
        [2, 2],
      ],
      4,
    );
    expect(measured({ mesh: gutter(walls, 1) }, pleated)).toEqual([16, 8]);
  });

  test('tries how few singular vertices it takes, and says so, if that is asked for', () => {
    const responses = answers(
      { type: 'open', source: { own: 'pebble' } },
      { type: 'remesh', options: { cells: 150, fewest: true } },
    );
    const phases = responses.flatMap((response) => (response.type === 'progress' ? [response.phase] : []));
    expect([...new Set(phases)]).toEqual(['triangles', 'singular', 'field', 'grid', 'fit']);
    expect(responses.at(-1)).toMatchObject({ type: 'remeshed', singularVertices: [{ valence: 3, count: 8 }] });
  });

  test('says where a mark stands on the surface, and makes a net with singular vertices where they are pinned', () => {
    const down = { origin: [0.3, 0.2, 9] as Point, direction: [0, 0, -1] as Point };
    const responses = answers(
      { type: 'open', source: { own: 'pebble' } },
      { type: 'place', at: down, mark: 2, revision: 5 },
      { type: 'place', at: { ...down, direction: [0, 0, 1] }, mark: null, revision: 6 },
    );
    const [, placed, missed] = responses;
    if (placed?.type !== 'placed' || placed.place === null) return expect.fail();
    expect(placed).toMatchObject({ mark: 2, revision: 5 });
    expect(placed.place.position.slice(0, 2)).toEqual([expect.closeTo(0.3), expect.closeTo(0.2)]);
    expect(missed).toEqual({ type: 'placed', place: null, mark: null, revision: 6 });

    const singular = [{ point: placed.place.position, valence: 3 as const }];
    const remeshed = answers(
      { type: 'open', source: { own: 'pebble' } },
      { type: 'remesh', options: { cells: 300, singular } },
    ).at(-1);
    if (remeshed?.type !== 'remeshed') return expect.fail();
    expect(remeshed.kept.vertices).toEqual([true]);
    const { position } = placed.place;
    const away = remeshed.singular.map((each) => Math.hypot(...each.position.map((x, i) => x - position[i]!)));
    expect(Math.min(...away)).toBeLessThan(1.5 * remeshed.net.info.meanLength);
    for (const { normal } of remeshed.singular) expect(Math.hypot(...normal)).toBeCloseTo(1);
  });

  test('makes a net with net lines along marked creases, and says how near', () => {
    const crease: Point[] = [-2, -1, 0, 1, 2].map((x) => [x, 0.4 + 0.1 * x, 3]);
    const [, traced] = answers(
      { type: 'open', source: { own: 'hemisphere' } },
      {
        type: 'trace',
        line: 'creases',
        points: crease.map(([x, y]) => ({ origin: [x, y, 9], direction: [0, 0, -1] })),
        revision: 1,
      },
    );
    if (traced?.type !== 'traced') return expect.fail();
    const remeshed = answers(
      { type: 'open', source: { own: 'hemisphere' } },
      { type: 'remesh', options: { cells: 400, markedCreases: [traced.cut.points] } },
    ).at(-1);
    if (remeshed?.type !== 'remeshed') return expect.fail();
    expect(remeshed.kept.markedCreases).toEqual([{ followed: true, distance: expect.any(Number) }]);
  });

  test('lays a direction that stands upright along some other', () => {
    const [, draped] = answers(OPEN, { type: 'drape', settings: { ...SETTINGS, direction: [0, 0, 1] } });
    expect(draped).toMatchObject({ type: 'draped' });
  });
});

describe('a line that is drawn', () => {
  const away = { origin: [9, 9, 9] as Point, direction: [1, 0, 0] as Point };
  const start = () => {
    const asked: { points: (Point | Ray)[]; revision: number }[] = [];
    const ended: Cut[] = [];
    const line = new DrawnLine({
      traceWanted: (points, revision) => asked.push({ points, revision }),
      changed: () => {},
      ended: (cut) => ended.push(cut),
    });
    /** The worker knows no points of rays that miss. */
    const answer = () => {
      const { points, revision } = asked.at(-1)!;
      line.setTraced(
        { points: points.filter((each): each is Point => !('origin' in each)), path: new Float64Array() },
        revision,
      );
    };
    return { line, asked, ended, answer };
  };
  const [a, b, c]: Point[] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
  ];

  test('is closed to a ring by its first point, and ends once all of it is known', () => {
    const { line, asked, ended, answer } = start();
    line.close();
    expect(asked).toEqual([]);
    for (const point of [a!, b!, c!]) line.add(point);
    answer();
    line.close();
    expect(ended).toEqual([]);
    answer();
    expect(ended.map(({ points }) => points)).toEqual([[a, b, c, a]]);
    expect(line.known).toBeNull();
  });

  test('has its last point moved, which stays where it was if the hand leaves the surface', () => {
    const { line, answer } = start();
    line.add(a!);
    line.add(b!);
    answer();
    line.moveLast({ ...away });
    answer();
    expect(line.known?.points).toEqual([a, b]);
    line.add(away);
    answer();
    expect(line.known?.points).toEqual([a, b]);
    line.add(c!);
    answer();
    expect(line.known?.points).toEqual([a, b, c]);
  });
});

describe('while a net is being laid', () => {
  /** A worker that answers when it is told to. */
  class SlowWorker implements DrapeWorkerLike {
    onmessage: DrapeWorkerLike['onmessage'] = null;
    onerror: DrapeWorkerLike['onerror'] = null;
    readonly asked: DrapeRequest[] = [];
    postMessage(request: DrapeRequest): void {
      this.asked.push(request);
    }
    answer(data: DrapeResponse): void {
      this.onmessage?.({ data } as MessageEvent<DrapeResponse>);
    }
    terminate(): void {}
  }

  function start() {
    const worker = new SlowWorker();
    const told: string[] = [];
    const draping = new Draping(() => worker, {
      opened: () => told.push('opened'),
      proposed: () => told.push('proposed'),
      traced: () => told.push('traced'),
      cutFound: () => told.push('cutFound'),
      cutsProposed: () => told.push('cutsProposed'),
      placed: () => told.push('placed'),
      draped: () => told.push('draped'),
      missed: () => told.push('missed'),
      progressed: (phase) => told.push(phase),
      remeshed: () => told.push('remeshed'),
      measured: () => told.push('measured'),
      refused: ({ code }, request) => told.push(request === null ? code : `${code} ${request}`),
    });
    const lengths = () =>
      worker.asked.map((request) => (request.type === 'drape' ? request.settings.length : request.type));
    return { worker, told, draping, lengths };
  }
  const [opened, draped, measured] = answers(OPEN, { type: 'drape', settings: SETTINGS }, { type: 'measure' }) as [
    DrapeResponse,
    DrapeResponse,
    DrapeResponse,
  ];

  test('of requests of one kind only the latest waits', () => {
    const { worker, told, draping, lengths } = start();
    for (const length of [1, 2, 3, 4]) draping.drape({ ...SETTINGS, length });
    expect([lengths(), draping.isLaying]).toEqual([[1], true]);
    worker.answer(draped);
    expect([lengths(), draping.isLaying]).toEqual([[1, 4], true]);
    worker.answer({ type: 'missed' });
    expect(draping.isLaying).toBe(false);
    expect(told).toEqual(['draped', 'missed']);
    draping.close();
  });

  test('a request takes no place from one of another kind, and what is measured is of the net asked for', async () => {
    const { worker, told, draping, lengths } = start();
    draping.drape({ ...SETTINGS, length: 1 });
    draping.drape({ ...SETTINGS, length: 2 });
    draping.trace('cuts', [[0, 0, 0]], 1);
    draping.proposeCuts(SETTINGS);
    worker.answer(draped);
    worker.answer(draped);
    worker.answer({ type: 'traced', cut: { points: [], path: new Float64Array() }, revision: 1 });
    worker.answer({ type: 'cutsProposed', cuts: [], coverage: [1] });
    expect(told).toEqual(['draped', 'draped', 'traced', 'cutsProposed']);
    const asked = [1, 2, 'trace', 'proposeCuts', 'measure'];
    await expect.poll(lengths).toEqual(asked);
    draping.drape({ ...SETTINGS, length: 3 });
    worker.answer(measured);
    expect(told).not.toContain('measured');
    worker.answer({ type: 'missed' });
    await expect.poll(lengths).toEqual([...asked, 3, 'measure']);
    worker.answer(measured);
    expect(told.at(-1)).toBe('measured');
    draping.close();
  });

  test('another surface is not given the requests of the one before', () => {
    const { worker, told, draping, lengths } = start();
    draping.drape(SETTINGS);
    draping.open({ own: 'torso' });
    draping.drape(SETTINGS);
    worker.answer(draped);
    worker.answer(opened);
    expect(lengths()).toEqual([SETTINGS.length, 'open']);
    expect(told).toEqual(['opened']);
    draping.close();
  });

  test('a surface that is being opened is not given the requests of the one before, nor with what is set for that', () => {
    const { worker, told, draping, lengths } = start();
    draping.open({ own: 'torso' });
    draping.drape(SETTINGS);
    worker.answer(opened);
    draping.drape(SETTINGS);
    expect(lengths()).toEqual(['open', SETTINGS.length]);
    expect(told).toEqual(['opened']);
    draping.close();
  });

  test('each new mark gets a place, and one that is moved only its last', () => {
    const { worker, draping } = start();
    const at: Point = [0, 0, 0];
    draping.drape(SETTINGS);
    for (const mark of [null, null, 3, 4, 3]) draping.place(at, mark, 0);
    for (let answered = 0; answered < 4; answered++) worker.answer(draped);
    expect(worker.asked.slice(1).map((request) => request.type === 'place' && request.mark)).toEqual([
      null,
      null,
      4,
      3,
    ]);
    draping.close();
  });

  test('lines of different kinds are each traced, and of one that grows only the last', () => {
    const { worker, draping } = start();
    draping.drape(SETTINGS);
    (['cuts', 'arms', 'cuts', 'creases'] as const).forEach((line, i) => draping.trace(line, [[i, 0, 0]], i));
    for (let answered = 0; answered < 3; answered++) worker.answer(draped);
    expect(worker.asked.slice(1)).toMatchObject([
      { line: 'arms', revision: 1 },
      { line: 'cuts', revision: 2 },
      { line: 'creases', revision: 3 },
    ]);
    draping.close();
  });

  test('a worker that is lost says so once, and another one opens what is chosen next', () => {
    const { worker, told, draping, lengths } = start();
    draping.open({ own: 'torso' });
    worker.onerror?.({ message: 'no script' } as ErrorEvent);
    expect(told).toEqual(['worker_lost']);
    draping.open({ own: 'pebble' });
    worker.answer(opened);
    draping.drape(SETTINGS);
    expect(lengths()).toEqual(['open', 'open', SETTINGS.length]);
    expect(told).toEqual(['worker_lost', 'opened']);
    draping.close();
  });

  test('to stop opens the surface again in another worker, and says nothing of it', () => {
    const { worker, told, draping, lengths } = start();
    draping.open({ own: 'pebble' });
    worker.answer(opened);
    draping.remesh({ cells: 100 });
    worker.answer({ type: 'progress', phase: 'field', done: 0 });
    draping.stop();
    expect(lengths()).toEqual(['open', 'remesh', 'open']);
    worker.answer(opened);
    expect(told).toEqual(['opened', 'field']);
    draping.open({ own: 'torso' });
    worker.answer(opened);
    expect(told).toEqual(['opened', 'field', 'opened']);
    draping.close();
  });

  test('to stop gives up the net alone: what else was asked of the surface is asked of the next worker', () => {
    const { worker, told, draping, lengths } = start();
    draping.open({ own: 'pebble' });
    worker.answer(opened);
    draping.propose({ length: 0.3 });
    draping.trace('creases', [[0, 0, 0]], 1);
    draping.proposeCuts(SETTINGS);
    draping.remesh({ cells: 100 });
    draping.stop();
    worker.answer(opened);
    worker.answer({ type: 'proposed', proposals: [] });
    expect(lengths()).toEqual(['open', 'propose', 'open', 'propose', 'trace']);
    // Also where the next one is stopped before it has opened the surface.
    draping.remesh({ cells: 100 });
    draping.stop();
    draping.remesh({ cells: 100 });
    draping.stop();
    worker.answer(opened);
    expect(lengths().slice(5)).toEqual(['open', 'open', 'trace']);
    expect(told).toEqual(['opened', 'proposed']);
    draping.close();
  });

  test('to stop leaves the net of before, which is measured if it was not yet, by the next worker', () => {
    const { worker, told, draping, lengths } = start();
    const mesh = { positions: new Float64Array(), faceStart: Int32Array.of(0), faceVertices: new Int32Array() };
    const remeshed = { type: 'remeshed' } as DrapeResponse;
    draping.open({ own: 'pebble' });
    worker.answer(opened);
    draping.remesh({ cells: 100 });
    worker.answer(remeshed);
    draping.remesh({ cells: 200 });
    draping.stop(mesh);
    worker.answer(opened);
    expect(lengths().slice(3)).toEqual(['open', 'measure']);
    expect(worker.asked.at(-1)).toEqual({ type: 'measure', mesh });
    worker.answer(measured);
    expect(told).toEqual(['opened', 'remeshed', 'measured']);
    draping.remesh({ cells: 200 });
    draping.stop(mesh);
    worker.answer(opened);
    expect(lengths().slice(5)).toEqual(['remesh', 'open']);
    draping.close();
  });

  test('a net that stands still is measured', async () => {
    const { worker, told, draping, lengths } = start();
    draping.drape(SETTINGS);
    worker.answer(draped);
    await expect.poll(lengths).toEqual([SETTINGS.length, 'measure']);
    worker.answer({ type: 'error', code: 'internal', message: 'no' });
    expect(told).toEqual(['draped', 'internal measure']);
    draping.close();
  });
});

describe('at the seed', () => {
  const normals: Point[] = [
    [0, 0, 1],
    [1, 0, 0],
    [0, -0.6, 0.8],
  ];
  test.each(normals)('a turn leads to a direction and back: %f %f %f', (...normal) => {
    expect(dot(reference(normal), normal)).toBeCloseTo(0);
    for (const angle of [0, 0.4, 1.6, 3]) {
      const direction = turned(angle, normal);
      expect(Math.hypot(...direction)).toBeCloseTo(1);
      expect(turnOf(direction, normal)).toBeCloseTo(angle);
      expect(turnOf(turned(angle + Math.PI, normal), normal) % Math.PI).toBeCloseTo(angle);
      expect(laidInto(direction, normal)).toEqual(direction.map((each) => expect.closeTo(each)));
    }
  });

  test.each(['beyond', 'cut', 'inside'] as const)('handles are the corners of a border that has some: %s', (border) => {
    const [, draped] = answers(OPEN, { type: 'drape', settings: { ...SETTINGS, border } });
    if (draped?.type !== 'draped') throw new Error('no net');
    const { net } = draped;
    const handles = proposedHandles(draped.net);
    expect(handles.map(({ anchor }) => anchor)).toEqual([true, true, true, false]);
    const { restPositions: at } = net;
    const corner = (x: number, y: number) =>
      Math.min(...handles.map(({ vertex }) => Math.hypot(at[3 * vertex]! - x, at[3 * vertex + 1]! - y)));
    const largest = Math.max(...at.filter((_, i) => i % 3 < 2));
    for (const x of [-largest, largest])
      for (const y of [-largest, largest]) expect(corner(x, y)).toBeLessThan(2 * net.info.meanLength);
  });

  test('each piece has handles of its own, of which one is free', () => {
    const ends: Point[] = [
      [-3, 0.9, -0.54],
      [3, 0.9, 0.54],
    ];
    const [, draped] = answers(OPEN, { type: 'drape', settings: { ...SETTINGS, cuts: [ends] } });
    if (draped?.type !== 'draped') throw new Error('no net');
    expect(draped.pieces).toBe(2);
    const { restPositions: at } = draped.net;
    const handles = proposedHandles(draped.net);
    for (const side of [-1, 1]) {
      const here = handles.filter(({ vertex }) => Math.sign(at[3 * vertex + 1]! - 0.9) === side);
      expect(here.length).toBeGreaterThan(2);
      expect(here.filter(({ anchor }) => !anchor)).toHaveLength(1);
    }
  });

  test('cells and length are two names of one thing', () => {
    expect(cellsOf(lengthOf(400, 7), 7)).toBeCloseTo(400);
  });
});

test('of lines that are not followed it is said how far net lines are off', () => {
  const { kept } = dialogs.drape.markedCreases;
  expect(kept(2, '0.7')).toBe('Not followed: 2. On average along a line, net lines are up to 0.7 edges off.');
  expect(kept(0, '0')).toBe('Net lines run along what is drawn.');
});

test('every surface of our own has its words, in the history too', () => {
  expect(Object.entries(panelWords.guide.own)).toEqual(core.ownSurfaces().map(({ name, title }) => [name, title]));
  expect(sentenceOf(['guide', guideTitle({ own: 'shell' })])).toBe(panelWords.changes.guide('Free-form shell'));
});

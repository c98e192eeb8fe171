/** The calls of `window.chebnet` about nets on surfaces, loaded with the first of them. Types are those of the core
 *  (wasm/chebnet.d.ts); angles are in radians. */
import type {
  DrapeOptions,
  DrapeReport,
  Point,
  RemeshOptions,
  SurfaceReport,
  WishedSingular,
} from '../../wasm/chebnet';
import type { App } from './app/app';
import { netName, openTaken } from './dialogs/taken_scene';
import type { TakenNet } from './dialogs/file_opener';
import type { GuideSource } from './document/document';
import { given } from './document/given';
import type { Untrusted } from './document/untrusted';
import { AskedDraper, type Watch } from './drape/asking';
import { SUGGESTED_CELLS } from './drape/cells';
import type { DrapedNet, DrapeSettings, PhaseTimes, ProposalSettings, SurfaceSource } from './drape/drape_protocol';
import { proposedHandles } from './handles/proposal';
import { Failure } from './failure';
import { dialogWords } from './language/dialogs';
import { guideOf, readSurface } from './script_arguments';

/** What a call may have of them: each takes time, and others may have sent them. */
const [MOST_LINES, MOST_POINTS, MOST_MARKS] = [100, 1000, 1000];

/** Without a length, about so many cells would cover the surface; without a seed, the net begins where the best of several trials
 *  does, which are in the direction, if one is given. */
export type ScriptDrape = Partial<Omit<DrapeOptions, 'seed' | 'direction'>> & {
  seed?: Point;
  direction?: Point;
  cells?: number;
  /** Each by its points: the surface is cut open along them, and each piece of it gets a net. "proposed": along those with which
   *  more is covered, if there are such, which takes a while to find. */
  cuts?: Point[][] | 'proposed';
};

/** How the net that has been opened lies on its surface. */
export type LaidReport = DrapeReport &
  Pick<DrapedNet, 'locked' | 'met' | 'cutEnds' | 'arms' | 'pieces' | 'bare'> & {
    cuts: Point[][];
    milliseconds: PhaseTimes;
  };
export type WholeReport = DrapeReport & {
  singularVertices: { valence: number; count: number }[];
  milliseconds: PhaseTimes;
};

export async function describe(given: Untrusted): Promise<SurfaceReport> {
  return look(surfaceOf(given), async (_, { report }) => report);
}

export async function drape(app: App, given: Untrusted, options: Untrusted): Promise<LaidReport> {
  const guide = surfaceOf(given);
  const { seed, direction, length, cells = SUGGESTED_CELLS, cuts = [], ...rest } = readOptions(options, DRAPE);
  return withSurface(guide, async (draper, { report: { area } }) => {
    const how = { ...rest, length: length ?? Math.sqrt(area / cells) };
    const directed = { ...how, ...(direction && { direction }) };
    const begun = seed ? { seed, direction: [1, 0, 0] as Point } : await best(draper, directed);
    const uncut = { ...begun, ...directed, cuts: [] };
    const along = cuts === 'proposed' ? await proposedCuts(draper, uncut) : cuts;
    const draped = await draper.ask({ type: 'drape', settings: { ...uncut, cuts: along } }, 'draped');
    const { locked, met, cutEnds, arms, pieces, bare } = draped;
    const { report, milliseconds } = await measured(draper, draped);
    await open(app, draped, guide, proposedHandles(draped.net));
    return { ...report, locked, met, cutEnds, arms, pieces, bare, cuts: along, milliseconds };
  });
}

export async function remesh(
  app: App,
  given: Untrusted,
  options: Untrusted,
  watching: Untrusted,
): Promise<WholeReport> {
  const guide = surfaceOf(given);
  const wanted = readOptions(options, REMESH);
  const watch = readWatch(watching);
  return withSurface(guide, async (draper) => {
    const made = await draper.ask({ type: 'remesh', options: wanted }, 'remeshed', watch);
    const { report, milliseconds } = await measured(draper, made);
    watch.signal?.throwIfAborted();
    await open(app, made, guide, proposedHandles(made.net));
    return { ...report, singularVertices: made.singularVertices, milliseconds };
  });
}

/** Of the net that is open, on the surface beside it. */
export async function report(app: App): Promise<DrapeReport> {
  const { document: { guide } = {}, net, frame } = app.opening ?? {};
  if (guide === undefined || net === undefined || frame === undefined)
    throw new Failure('bad_option', dialogWords.drape.noGuide);
  const { faceStart, faceVertices } = net;
  const mesh = { positions: Float64Array.from(frame.positions), faceStart, faceVertices };
  return look(guide, async (draper) => (await draper.ask({ type: 'measure', mesh }, 'measured')).report);
}

async function measured(draper: AskedDraper, { times }: Pick<DrapedNet, 'times'>) {
  const { report, milliseconds: measure } = await draper.ask({ type: 'measure' }, 'measured');
  return { report, milliseconds: { ...times, measure } };
}

async function best(draper: AskedDraper, settings: ProposalSettings) {
  const { proposals } = await draper.ask({ type: 'propose', settings }, 'proposed');
  const { seed, direction } = proposals[0]!;
  return { seed, direction };
}

async function proposedCuts(draper: AskedDraper, settings: DrapeSettings): Promise<Point[][]> {
  const { cuts } = await draper.ask({ type: 'proposeCuts', settings }, 'cutsProposed');
  return cuts.map(({ points }) => points);
}

type WithSurface<T> = (draper: AskedDraper, surface: { report: SurfaceReport }) => Promise<T>;

/** Ends when the calls so far that change no net have. */
let looked: Promise<unknown> = Promise.resolve();

/** For such a call. They come one after another, as those that change the net do: many at once would take a core each. */
function look<T>(guide: GuideSource, doing: WithSurface<T>): Promise<T> {
  const looking = looked.then(() => withSurface(guide, doing));
  looked = looking.catch(() => {});
  return looking;
}

/** With a worker of its own, as long as that takes. */
async function withSurface<T>(guide: GuideSource, doing: WithSurface<T>): Promise<T> {
  const source: SurfaceSource = 'own' in guide ? guide : { mesh: guide.mesh };
  const draper = new AskedDraper(new Worker(new URL('./drape/drape_worker.ts', import.meta.url), { type: 'module' }));
  try {
    const { surface } = await draper.ask({ type: 'open', source }, 'opened');
    return await doing(draper, surface);
  } finally {
    draper.close();
  }
}

async function open(app: App, { net }: Pick<DrapedNet, 'net'>, guide: GuideSource, handles: TakenNet['handles']) {
  const { restPositions: positions, faceStart, faceVertices } = net;
  const name = netName('own' in guide ? guide.own : guide.name);
  await openTaken(app, { net: { mesh: { positions, faceStart, faceVertices }, name }, handles, guide });
}

// ------------------------------------------------------------------------------------------------------------- arguments

function surfaceOf(given: Untrusted): GuideSource {
  return guideOf(readSurface(given));
}

function readWatch(watch: Untrusted): Watch {
  const signalOf = (each: Untrusted) => (each.value instanceof AbortSignal ? each.value : each.fail('AbortSignal'));
  return given({
    progress: watch.at('progress').maybe((each) => each.function<NonNullable<Watch['progress']>>()),
    signal: watch.at('signal').maybe(signalOf),
  });
}

type Readers<T> = { [Name in keyof Required<T>]: (value: Untrusted) => Required<T>[Name] };

const DRAPE: Readers<ScriptDrape> = {
  seed: (each) => each.point(),
  direction: (each) => each.point(),
  length: (each) => each.positive(),
  cells: (each) => each.positive(),
  angle: (each) => each.positive(),
  smallestAngle: (each) => each.positive(),
  reach: (each) => each.index(2 ** 31),
  border: (each) => each.oneOf(['inside', 'beyond', 'cut'] as const),
  arms: (each) => each.oneOf(['geodesic', 'least_shear', 'curve'] as const),
  along: readPoints,
  cuts: (each) => (each.value === 'proposed' ? each.value : readLines(each)),
  leave: (each) => each.number(),
};

const REMESH: Readers<RemeshOptions> = {
  cells: (each) => each.index(2 ** 31),
  length: (each) => each.positive(),
  smallestAngle: (each) => each.number(),
  smoothing: (each) => each.number(),
  fewest: (each) => each.flag(),
  crease: (each) => each.number(),
  markedCreases: readLines,
  border: (each) => each.oneOf(['fitting', 'always', 'outer', 'across', 'never'] as const),
  only: (each) => each.flag(),
  singular: (each) =>
    // Whether there can be such, the core says.
    each.list(MOST_MARKS).map((mark) => ({
      point: mark.at('point').point(),
      valence: mark.at('valence').index(100) as WishedSingular['valence'],
    })),
  forbidden: (each) =>
    each.list(MOST_MARKS).map((mark) => ({ centre: mark.at('centre').point(), radius: mark.at('radius').positive() })),
};

/** Those that are given. One that does not exist is refused: it would have been a wish. */
function readOptions<T extends object>(options: Untrusted, readers: Readers<T>): T {
  const isKnown = (name: string): name is Extract<keyof T, string> => Object.hasOwn(readers, name);
  const read = options.fields().map(([name, value]) => {
    if (!isKnown(name)) throw new Failure('bad_option', dialogWords.drape.unknownOption(name, Object.keys(readers)));
    return [name, value.maybe(readers[name])];
  });
  return given(Object.fromEntries(read)) as T;
}

function readLines(lines: Untrusted): Point[][] {
  return lines.list(MOST_LINES).map(readPoints);
}

function readPoints(points: Untrusted): Point[] {
  return points.list(MOST_POINTS).map((each) => each.point());
}

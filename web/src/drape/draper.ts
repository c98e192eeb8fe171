/** Answers the requests of draping.ts, in the worker: lays nets on one surface. */
import type {
  Chebnet,
  Drape,
  DrapeOptions,
  Mesh,
  Point,
  RemeshOptions,
  Surface,
  SurfacePlace,
} from '../../../wasm/chebnet';
import { codeOf, messageOf } from '../failure';
import { withEditor } from '../files/file_report';
import { handleBy } from '../worker/handlers';
import type { Handlers } from '../worker/handlers';
import { describe, openSurface } from '../worker/opened_net';
import type {
  DrapeRequest,
  DrapeResponse,
  DrapeSettings,
  PhaseTimes,
  Proposal,
  ProposalSettings,
  Ray,
  Seed,
  ShownNet,
  SurfaceSource,
} from './drape_protocol';
import { SUGGESTED_CELLS } from './cells';
import { combined, laidInto } from './seed';

const MOST_PROPOSALS = 4;
/** Proposed at a time: looking for each takes seconds. */
const MOST_CUTS = 2;
/** More would be black in a small picture. */
const PICTURED_CELLS = 300;

export class Draper {
  readonly #core: Chebnet;
  readonly #post: (response: DrapeResponse) => void;
  #surface: Surface | null = null;
  /** The surface, cut open, and along what. */
  #opened: { surface: Surface; cuts: string } | null = null;
  /** The last net, and the length that it was laid with: one that a border has cut may not say it. */
  #mesh: Mesh | null = null;
  #length: number | undefined;

  constructor(core: Chebnet, post: (response: DrapeResponse) => void) {
    this.#core = core;
    this.#post = post;
  }

  handle(request: DrapeRequest): void {
    try {
      this.#post(handleBy(this.#answers, request));
    } catch (error) {
      this.#post({ type: 'error', code: codeOf(error), message: messageOf(error) });
    }
  }

  readonly #answers: Handlers<DrapeRequest, DrapeResponse> = {
    open: ({ source }) => this.#open(source),
    propose: ({ settings }) => this.#propose(this.#present(), settings),
    drape: ({ settings }) => this.#lay(this.#present(), settings),
    trace: ({ points, revision }) => trace(this.#present(), points, revision),
    shortestCut: (request) => this.#shortestCut(this.#present(), request),
    place: ({ at, mark, revision }) => ({ type: 'placed', place: placeOf(this.#present(), at), mark, revision }),
    proposeCuts: ({ settings }) => this.#proposeCuts(this.#present(), settings),
    remesh: ({ options }) => this.#cover(this.#present(), options),
    measure: ({ mesh }) => this.#measure(this.#present(), mesh),
  };

  #present(): Surface {
    if (this.#surface === null) throw new Error('no surface is open');
    return this.#surface;
  }

  #open(source: SurfaceSource): DrapeResponse {
    const surface = openSurface(this.#core, source);
    this.#surface?.dispose();
    this.#opened?.surface.dispose();
    this.#opened = null;
    this.#surface = surface;
    this.#mesh = null;
    const { positions, normals, triangles } = surface;
    return {
      type: 'opened',
      surface: { positions, normals, triangles, report: surface.describe() },
      length: surface.suggest(SUGGESTED_CELLS).length,
    };
  }

  #propose(surface: Surface, settings: ProposalSettings): DrapeResponse {
    const proposals = surface.propose(settings).slice(0, MOST_PROPOSALS);
    return {
      type: 'proposed',
      proposals: proposals.map((proposal) => {
        const { seed, direction } = proposal;
        const options = { ...settings, seed, direction };
        const mesh = pictured(surface, options);
        const edges = withEditor(this.#core, mesh, (editor) => editor.edges);
        const wireframe = { edges, positions: Float32Array.from(mesh.positions) };
        return { ...proposal, ...promised(surface, options), wireframe };
      }),
    };
  }

  #lay(surface: Surface, settings: DrapeSettings): DrapeResponse {
    const place = placeOf(surface, settings.seed);
    if (place === null) return { type: 'missed' };
    const direction = laidInto(settings.direction, place.normal);
    const start = performance.now();
    const options = { ...settings, seed: place.position, direction };
    const drape =
      settings.cuts.length === 0
        ? { ...surface.drape(options), pieces: 1, bare: 0 }
        : this.#cutOpen(surface, settings.cuts).drapePieces(options);
    const lay = performance.now() - start;
    const { mesh, ...rest } = drape;
    const seed = drape.arms === 'curve' ? begunOn(surface, drape) : { ...place, direction };
    return { type: 'draped', seed, ...rest, ...this.#shown(mesh, { lay }, settings.length) };
  }

  /** While the seed is dragged the cuts stay. */
  #cutOpen(surface: Surface, cuts: Point[][]): Surface {
    const key = JSON.stringify(cuts);
    if (this.#opened?.cuts !== key) {
      const opened = surface.cut(cuts);
      this.#opened?.surface.dispose();
      this.#opened = { surface: opened, cuts: key };
    }
    return this.#opened.surface;
  }

  #shortestCut(
    surface: Surface,
    { from, cuts, revision }: Extract<DrapeRequest, { type: 'shortestCut' }>,
  ): DrapeResponse {
    const points = this.#cutOpen(surface, cuts).shortestCut(from);
    return { type: 'cutFound', cut: { points, path: surface.cutPath(points) }, revision };
  }

  #proposeCuts(surface: Surface, settings: DrapeSettings): DrapeResponse {
    const place = placeOf(surface, settings.seed);
    if (place === null) return { type: 'missed' };
    const options = { ...settings, seed: place.position, direction: laidInto(settings.direction, place.normal) };
    const { cuts, coverage } = surface.proposeCuts(options, MOST_CUTS);
    return { type: 'cutsProposed', cuts: cuts.map((points) => ({ points, path: surface.cutPath(points) })), coverage };
  }

  #cover(surface: Surface, options: RemeshOptions): DrapeResponse {
    const { mesh, singularVertices, singular, kept, sharpQuads, leftOff, milliseconds } = surface.remesh(
      options,
      (phase, done) => this.#post({ type: 'progress', phase, done }),
    );
    return {
      type: 'remeshed',
      singularVertices,
      singular: singular.map(({ position, valence }) => ({ ...surface.nearest(position), position, valence })),
      kept,
      sharpQuads,
      leftOff,
      ...this.#shown(mesh, milliseconds),
    };
  }

  /** The last net, unless it is another one. */
  #measure(surface: Surface, other: Mesh | undefined): DrapeResponse {
    const mesh = other ?? this.#mesh;
    if (mesh === null) throw new Error('no net has been laid');
    const start = performance.now();
    const report = surface.measure(mesh, other ? undefined : this.#length);
    return { type: 'measured', report, milliseconds: performance.now() - start };
  }

  #shown(mesh: Mesh, times: PhaseTimes, length?: number): ShownNet {
    this.#mesh = mesh;
    this.#length = length;
    const start = performance.now();
    const shown = withEditor(this.#core, mesh, (editor) => ({ net: describe(editor), fields: editor.fields() }));
    return { ...shown, times: { ...times, open: performance.now() - start } };
  }
}

type Promised = Pick<Proposal, 'covered' | 'muchSheared' | 'meanDistance'>;

/** What is said of the net once it is chosen: trials count the area of their cells. Nothing where it was only tried. */
function promised(surface: Surface, options: DrapeOptions): Partial<Promised> {
  try {
    const { length } = options;
    const { coverage, muchSheared, meanDistance } = surface.measure(surface.drape(options).mesh, length);
    return { covered: coverage, muchSheared, meanDistance: meanDistance / length };
  } catch {
    return {};
  }
}

/** With large cells, unless none fits where the net begins. */
function pictured(surface: Surface, options: DrapeOptions): Mesh {
  const length = Math.max(options.length, surface.suggest(PICTURED_CELLS).length);
  try {
    return surface.drape({ ...options, length }).mesh;
  } catch {
    return surface.drape(options).mesh;
  }
}

function trace(surface: Surface, wanted: readonly (Point | Ray)[], revision: number): DrapeResponse {
  const places = wanted.map((point) => placeOf(surface, point));
  const points = places.flatMap((place) => (place === null ? [] : [place.position]));
  const path = points.length < 2 ? Float64Array.from(points.flat()) : surface.cutPath(points);
  return { type: 'traced', cut: { points, path }, revision };
}

/** Where a net on a curve begins, and which way it runs there: that is not what was asked for. */
function begunOn(surface: Surface, { mesh: { positions }, places }: Drape): Seed {
  const at = (i: number): Point | undefined => {
    for (let k = 0; k < places.length; k += 2)
      if (places[k] === i && places[k + 1] === 0) return [...positions.subarray(1.5 * k, 1.5 * k + 3)] as Point;
    return undefined;
  };
  const begin = at(0)!;
  const place = surface.nearest(begin);
  return { ...place, direction: laidInto(combined(1, at(1) ?? begin, -1, at(-1) ?? begin), place.normal) };
}

function placeOf(surface: Surface, seed: DrapeSettings['seed']): SurfacePlace | null {
  return 'origin' in seed ? surface.hit(seed.origin, seed.direction) : surface.nearest(seed satisfies Point);
}

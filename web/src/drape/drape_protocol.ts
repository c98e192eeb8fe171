/** Messages between page and draping worker; one request at a time. To cancel is to terminate the worker. */
import type {
  CoreFields,
  DrapeArms,
  DrapeOptions,
  DrapeProposal,
  DrapeReport,
  KeptWishes,
  Mesh,
  Point,
  Remesh,
  RemeshOptions,
  RemeshPhase,
  SurfacePlace,
  SurfaceReport,
} from '../../../wasm/chebnet';
import type { Wireframe } from '../elements/thumbnail';
import type { OpenedNet } from '../worker/protocol';

/** What a user brings, or one of our own by its name. */
export type SurfaceSource = { mesh: Mesh } | { own: string };

/** What is drawn of a surface, and what is known of it. */
export interface ShownSurface {
  positions: Float64Array;
  normals: Float64Array;
  triangles: Int32Array;
  report: SurfaceReport;
}

/** From an eye through a point of the picture. */
export interface Ray {
  origin: Point;
  direction: Point;
}

/** How a net is to be laid. */
export interface DrapeSettings extends Omit<DrapeOptions, 'seed'> {
  /** A ray: the first point of the surface that it meets. */
  seed: Point | Ray;
  /** Along which the surface is cut open before, each by its points. */
  cuts: Point[][];
}

/** How nets are to be laid whose beginnings are looked for; with a direction, in that one. */
export type ProposalSettings = Omit<DrapeSettings, 'seed' | 'direction' | 'cuts'> &
  Partial<Pick<DrapeSettings, 'direction'>>;

/** A cut that is being drawn, or has been. */
export interface Cut {
  points: Point[];
  /** How it runs over the surface, 3 numbers a point. */
  path: Float64Array;
}

/** Where the seed of a net stands on its surface, and the direction of its first family laid into it, of length 1. */
export interface Seed extends SurfacePlace {
  direction: Point;
}

/** A net on the surface, as it is drawn. */
export interface ShownNet {
  net: OpenedNet;
  fields: CoreFields;
  times: PhaseTimes;
}

/** Milliseconds that it took: to lay a net, or by the phases of one over the whole surface; to open it for the picture; and
 *  to measure it. */
export type PhaseTimes = Partial<Record<'lay' | RemeshPhase | 'open' | 'measure', number>>;

/** One piece, laid from a seed. */
export interface DrapedNet extends ShownNet {
  /** Steps from the seed; see wasm/chebnet.d.ts. */
  places: Int32Array;
  seed: Seed;
  locked: number;
  met: number;
  cutEnds: number;
  arms: DrapeArms;
  /** Of the surface, with a net and without one. */
  pieces: number;
  bare: number;
}

/** Over the whole surface. */
export interface RemeshedNet extends ShownNet {
  singularVertices: Remesh['singularVertices'];
  /** Each of them, and the normal of the surface there. */
  singular: SingularPlace[];
  kept: KeptWishes;
  /** Cells with a corner sharper than the limit. */
  sharpQuads: number;
  /** Limbs of the surface too thin for cells of this size. */
  leftOff: Remesh['leftOff'];
}

interface SingularPlace extends SurfacePlace {
  valence: number;
}

/** What a line is drawn for. */
export type DrawnKind = 'arms' | 'cuts' | 'creases';

export type DrapeRequest =
  /** Answered with `opened`. */
  | { type: 'open'; source: SurfaceSource }
  /** Answered with `draped`, `missed` or `error`. */
  | { type: 'drape'; settings: DrapeSettings }
  /** Where a net would begin well. Answered with `proposed`. */
  | { type: 'propose'; settings: ProposalSettings }
  /** A line through some points, without those that are beside the surface. Answered with `traced` or `error`. */
  | { type: 'trace'; line: DrawnKind; points: (Point | Ray)[]; revision: number }
  /** The shortest cut from a point to the border, or between two borders, of the surface cut open along others. Answered with
   *  `cutFound` or `error`. */
  | { type: 'shortestCut'; from: Point | null; cuts: Point[][]; revision: number }
  /** A point of the surface, for a mark on it; null: for a new one. Answered with `placed`. */
  | { type: 'place'; at: Point | Ray; mark: number | null; revision: number }
  /** Cuts that help a net. Answered with `cutsProposed` or `error`. */
  | { type: 'proposeCuts'; settings: DrapeSettings }
  /** Answered with `remeshed` or `error`, and `progress` before. */
  | { type: 'remesh'; options: RemeshOptions }
  /** How the last net, or another one, lies. Answered with `measured`. */
  | { type: 'measure'; mesh?: Mesh };

export type DrapeResponse =
  | { type: 'opened'; surface: ShownSurface; length: number }
  | { type: 'proposed'; proposals: Proposal[] }
  /** `revision` is that of the `trace`. */
  | { type: 'traced'; cut: Cut; revision: number }
  /** `revision` is that of the `shortestCut`. */
  | { type: 'cutFound'; cut: Cut; revision: number }
  /** null: the ray does not meet the surface. `mark` and `revision` are those of the `place`. */
  | { type: 'placed'; place: SurfacePlace | null; mark: number | null; revision: number }
  /** @see CutProposals of wasm/chebnet.d.ts about `coverage`. */
  | { type: 'cutsProposed'; cuts: Cut[]; coverage: number[] }
  | ({ type: 'draped' } & DrapedNet)
  | { type: 'progress'; phase: RemeshPhase; done: number }
  | ({ type: 'remeshed' } & RemeshedNet)
  /** The ray does not meet the surface. */
  | { type: 'missed' }
  | { type: 'measured'; report: DrapeReport; milliseconds: number }
  /** `code` as in core/base/error.h. What was open stays so. */
  | { type: 'error'; code: string; message: string };

/** Where a net would begin well, how it lies, and what is drawn of it. */
export interface Proposal extends DrapeProposal {
  wireframe: Wireframe;
}

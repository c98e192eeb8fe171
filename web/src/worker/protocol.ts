import type {
  Axes,
  Ball,
  CoreFields,
  FlatPattern,
  Handle,
  NetInfo,
  PatternFault,
  Status,
  ToRest,
  TraceRow,
  UnreachablePair,
  VertexLists,
} from '../../../wasm/chebnet';
import type { Scene, SolverSettings, Vec3 } from '../document/document';
import type { Tables } from '../net/tables';

/** Raised whenever a message changes its meaning; page and worker of different versions refuse each other. */
export const PROTOCOL_VERSION = 13;

/** From the page to the worker. `id` counts up and comes back in the answer. */
export type Request = { id: number } & (
  | { type: 'hello'; version: number }
  /** If it fails, the net edited before stays. A net that is numbered otherwise than the scene says is refused. */
  | { type: 'open'; scene: Omit<Scene, 'view'> }
  | { type: 'handles'; handles: Handle[] }
  /** The targets of the moment while handles are dragged; others stay. Answered when they are taken: at once, or when the
   *  solve for those before has had its share of time. `inHand`: they are held back where no net leads there. `asked`: where
   *  the hand is, if targets are kept nearer. `along`: the axes to which it is kept, also when it is held back. */
  | { type: 'drag'; targets: Handle[]; inHand: boolean; asked?: Handle[]; along?: Axes }
  /** The hand lets go: handles that are held back take the place where they stand as target when the solve ends. */
  | { type: 'release' }
  /** Before a drag: only what lies so many edge lengths from the origins may move until other handles are moved or set;
   *  null: everything. */
  | { type: 'locality'; radius: number | null; origins: number[] }
  /** Looks for another state of the net, and takes it. Ended as "cancelled" by the next request that touches the net. */
  | { type: 'search'; what: SearchFor }
  /** Starts no solve; one under way goes on with them. */
  | { type: 'options'; settings: SolverSettings }
  /** Solve on until it ends. */
  | { type: 'solve' }
  /** One iteration, then stop. */
  | { type: 'step' }
  /** Stop where the net stands. */
  | { type: 'cancel' }
  /** Back to the rest positions, handles too. */
  | { type: 'reset' }
  /** Put the open net into an earlier state, e.g. for undo. Unless `settled`, solve on from there. */
  | { type: 'restore'; scene: Omit<Scene, 'view' | 'net'> }
  /** The page has received the last frame; the next is sent only after that. Has no answer. */
  | { type: 'seen' }
  /** `format`: a name from the core's table of formats, or `edges` or `rods`, their lengths as CSV. */
  | { type: 'export'; format: string }
  /** Measures that are too expensive for every frame. */
  | { type: 'measure' }
  /** Where each of these handles may be moved; see Editor.reach(). */
  | { type: 'reach'; vertices: number[] }
  /** How freely a locality would let each vertex move; see Editor.mobility(). */
  | { type: 'mobility'; radius: number; origins: number[] }
  /** Where the net's other equilibrium may be; see Editor.flipped(). */
  | { type: 'flipped' }
  /** What is drawn of the surface beside the net. */
  | { type: 'guide' }
  /** Of each point the nearest one of that surface; without one, the point itself. */
  | { type: 'nearest'; points: Vec3[] }
  /** The net laid flat. */
  | { type: 'pattern' }
  /** The lines that its rods are laid along; see Editor.rods(). */
  | { type: 'rods' }
);

export interface Measures {
  /** Fairness, see core/net/measures.h. */
  bend: number;
  /** At a face corner, radians. */
  smallestAngle: number;
  /** Largest distance of an exact handle from its target. */
  handleError: number;
}

export interface OpenedNet {
  info: NetInfo;
  /** See document/numbering.ts. */
  numbering: number;
  edges: Int32Array;
  faceStart: Int32Array;
  faceVertices: Int32Array;
  restPositions: Float64Array;
  restLengths: Float64Array;
  suggestedHandles: Int32Array;
  /** Net line k is `lineVertices[lineStart[k]] … lineVertices[lineStart[k + 1] - 1]`, boundary loops likewise; see
   *  wasm/chebnet.d.ts. */
  lineStart: Int32Array;
  lineVertices: Int32Array;
  loopStart: Int32Array;
  loopVertices: Int32Array;
  /** What is drawn of faces and edges, three vertices a triangle; see triangles.ts. */
  triangles: Uint32Array<ArrayBuffer>;
  strips: Uint32Array<ArrayBuffer>;
  handles: Handle[];
}

/** A surface as it is drawn. */
export interface DrawnSurface {
  /** 3 numbers a vertex. */
  positions: Float64Array;
  normals: Float64Array;
  /** 3 vertices each. */
  triangles: Int32Array;
}

export interface FrameData {
  positions: Float64Array;
  /** What rest lengths are multiplied by: the option `length_scale`. */
  lengthScale: number;
  fields: CoreFields;
  /** Those in hand where they stand. */
  handles: Handle[];
  /** The hand is beyond what the net can reach. */
  holdsBack: boolean;
  /** The last hand was beyond what the net can reach, and its handles stand elsewhere than it asked. */
  fellShort: boolean;
  status: Status;
  maxDeviation: number;
  /** Of the solve under way, or just ended. */
  iterations: number;
  milliseconds: number;
  stage: number;
  method: string;
  /** What is left until the net is at rest; null: not known. */
  toRest: ToRest | null;
  /** Rows since the frame before; `iteration` 1 begins a new solve. */
  trace: TraceRow[];
  /** Where the net stood before the single step that led here; null if anything else did. */
  stepFrom: Float64Array | null;
  /** The worst, at most a hundred. */
  unreachable: UnreachablePair[];
  /** Bytes that the core has taken, see Editors.memory(). */
  memory: number;
}

/**
 * From the worker to the page. `id` is that of the request answered. `frame` and `settled` are news: they carry the id of
 * the last request that touched the net (`touchesNet`) and did not fail. After such a request `settled` comes when
 * nothing is left to solve; requests that follow fast share one.
 */
export type Response = { id: number } & (
  | ({ type: 'ready'; version: number } & Tables)
  | { type: 'opened'; net: OpenedNet; frame: FrameData }
  | { type: 'frame'; frame: FrameData }
  | { type: 'settled'; frame: FrameData }
  /** The bytes of a file. */
  | { type: 'exported'; bytes: Uint8Array<ArrayBuffer> }
  | { type: 'measured'; measures: Measures }
  | { type: 'reach'; balls: Ball[][] }
  | { type: 'mobility'; mobility: Float32Array }
  | { type: 'flipped'; positions: Float64Array }
  /** null: there is none. */
  | { type: 'guide'; surface: DrawnSurface | null }
  | { type: 'nearest'; points: Vec3[] }
  | { type: 'pattern'; pattern: FlatPattern | PatternFault }
  | { type: 'rods'; rods: VertexLists }
  /** While a search goes on. No answer yet. */
  | { type: 'searching'; progress: SearchProgress }
  /** The option `length_scale` that was found, or the part of the energy that is left; null: nothing does, and nothing has
   *  changed. */
  | { type: 'searched'; found: number | null }
  | { type: 'done' }
  | { type: 'error'; code: string; message: string }
);

/** `lengths`: all edges grow by one factor, as little as brings exact handles to where they, or a hand that was held back, are
 *  to be. `rest`: another net at rest, with less energy. */
export type SearchFor = 'lengths' | 'rest';

export interface SearchProgress {
  /** The scale of the moment, or the part of the ways that has been tried, about. */
  reached: number;
  /** Since it began: one way may take most of them. */
  iterations: number;
}

const TOUCHING = [
  'open',
  'handles',
  'drag',
  'release',
  'search',
  'options',
  'solve',
  'step',
  'cancel',
  'reset',
  'restore',
] as const;

/** Whether a request changes the net, its targets or the solve; a `settled` follows it then. */
export function touchesNet(type: Request['type']): type is (typeof TOUCHING)[number] {
  return (TOUCHING as readonly string[]).includes(type);
}

/** Code of the error when a method cannot take a net of this size. It also comes as news, with the id of the last request that
 *  touched the net, after a `settled`: the solve was given up, the net stays as it is. */
export const TOO_LARGE = 'too_large';

/** Code of what the core for a first net refuses and the whole one has; the page never hears it. */
export const LEFT_OUT = 'left_out';

/** Code of the error after which the worker that sent it must be discarded: the module itself broke. */
export const CRASHED = 'crashed';

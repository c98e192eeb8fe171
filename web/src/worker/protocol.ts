import type {
  Handle,
  MethodInfo,
  NetInfo,
  OptionInfo,
  ShapeInfo,
  Status,
  TraceRow,
  UnreachablePair,
} from '../../../wasm/chebnet';
import type { HandleData, NetSource, SolverOptions } from '../document/document';

/** Raised whenever a message changes its meaning; page and worker of different versions refuse each other. */
export const PROTOCOL_VERSION = 1;

/** From the page to the worker. `id` comes back in the answer. */
export type Request = { id: number } & (
  | { type: 'hello'; version: number }
  | { type: 'open'; net: NetSource; handles: HandleData[] | 'suggested'; method: string; options: SolverOptions; positions: Float64Array | null }
  | { type: 'handles'; handles: Handle[] }
  /** The target of the moment while a handle is dragged. Latest wins. */
  | { type: 'drag'; vertex: number; target: [number, number, number] }
  | { type: 'release' }
  | { type: 'options'; method: string; options: SolverOptions }
  /** Solve on until it ends. */
  | { type: 'solve' }
  /** One iteration, then stop. */
  | { type: 'step' }
  /** Stop where the net stands. */
  | { type: 'cancel' }
  /** Back to the rest positions, handles too. */
  | { type: 'reset' }
  /** Put positions and handles back, e.g. by undo. */
  | { type: 'restore'; positions: Float64Array; handles: Handle[] }
  | { type: 'export'; format: 'obj'; digits: number }
  /** A small net for the gallery; does not touch the one being edited. */
  | { type: 'thumbnail'; recipe: string }
);

export interface OpenedNet {
  info: NetInfo;
  edges: Int32Array;
  faceStart: Int32Array;
  faceVertices: Int32Array;
  restPositions: Float64Array;
  suggestedHandles: Int32Array;
  handles: Handle[];
}

export interface FrameData {
  positions: Float64Array;
  /** Per edge. */
  deviations: Float32Array;
  /** Per vertex, radians. */
  cornerAngles: Float32Array;
  handles: Handle[];
  status: Status;
  maxDeviation: number;
  /** Of the solve under way, or just ended. */
  iterations: number;
  milliseconds: number;
  stage: number;
  bend: number;
  method: string;
  /** Rows since the frame before; `iteration` 1 begins a new solve. */
  trace: TraceRow[];
  unreachable: UnreachablePair[];
}

/** From the worker to the page. `id` is that of the request answered, 0 for news. */
export type Response = { id: number } & (
  | { type: 'ready'; version: number; shapes: ShapeInfo[]; methods: MethodInfo[]; options: OptionInfo[] }
  | { type: 'opened'; net: OpenedNet; frame: FrameData }
  | { type: 'frame'; frame: FrameData }
  | { type: 'settled'; frame: FrameData }
  | { type: 'exported'; text: string }
  | { type: 'thumbnail'; edges: Int32Array; positions: Float32Array }
  | { type: 'done' }
  | { type: 'error'; code: string; message: string }
);

/** What wasm/*.cpp give to JavaScript; only wasm/facade.js uses it. Copied beside the built module. */
import type {
  AdaptReport,
  ChangedMesh,
  CoreFields,
  CutProposals,
  Defect,
  Drape,
  DrapeOptions,
  DrapeProposal,
  DrapeReport,
  EqualizeReport,
  ExactChangeReport,
  FlatPattern,
  FormatInfo,
  InitialisationInfo,
  Mesh,
  MethodInfo,
  NetForces,
  NetInfo,
  OptionInfo,
  OwnSurfaceInfo,
  Remesh,
  RemeshOptions,
  RemeshPhase,
  PatternFault,
  PiecesDrape,
  Point,
  RepairedMesh,
  RestSearchReport,
  ShapeInfo,
  Status,
  SurfacePlace,
  SurfaceReport,
  ToRest,
  UnreachablePair,
  VertexLists,
} from '../../wasm/chebnet';

export interface CoreReport {
  status: Status;
  maxDeviation: number;
  milliseconds: number;
  factorisationMs: number;
  iterations: number;
  toRest: ToRest | null;
  /** 12 numbers a row, in the order of TraceRow. */
  trace: Float64Array;
}

export interface CoreHandles {
  vertices: Int32Array;
  targets: Float64Array;
  /** Infinity: exact. */
  weights: Float64Array;
  /** The sum of 1 for x, 2 for y and 4 for z. */
  slides: Int32Array;
}

export interface CoreLocality {
  radius: number;
  origins: Int32Array;
  /** Empty: where the net stands now. */
  heldAt: Float64Array;
}

/** Method, initialisation, options (names and values in turn), handles, locality and positions. */
export type CoreState = [string, string, string[], CoreHandles, CoreLocality | null, Float64Array];

export interface Session {
  info(): NetInfo;
  edges(): Int32Array;
  faceStart(): Int32Array;
  faceVertices(): Int32Array;
  restPositions(): Float64Array;
  restLengths(): Float64Array;
  netLines(): VertexLists;
  rods(): VertexLists;
  boundaryLoops(): VertexLists;
  flatPattern(): FlatPattern | PatternFault;
  suggestedHandles(): Int32Array;
  method(): string;
  initialisation(): string;
  options(): OptionInfo[];
  handleVertices(): Int32Array;
  handleTargets(): Float64Array;
  /** Infinity: exact. */
  handleWeights(): Float64Array;
  handleSlides(): Int32Array;
  locality(): CoreLocality | null;
  /** 5 numbers a ball: the vertex, the centre, the radius. */
  reach(vertex: number): Float64Array;
  mobility(radius: number, origins: Int32Array): Float32Array;
  flipped(): Float64Array;
  moveHandle(vertex: number, x: number, y: number, z: number): void;
  dragHandle(vertex: number, x: number, y: number, z: number, along: number): void;
  releaseHandles(): void;
  holdsBack(): boolean;
  setState(...state: CoreState): void;
  changeState(...changed: CoreState): void;
  solve(iterations: number, milliseconds: number): CoreReport;
  reset(): void;
  positions(): Float64Array;
  fields(): CoreFields;
  bend(): number;
  smallestAngle(): number;
  handleError(): number;
  unreachablePairs(): UnreachablePair[];
  toObj(digits: number): string;
  edgeTable(): string;
  rodTable(): string;
  toFile(format: string): Uint8Array<ArrayBuffer>;
  delete(): void;
}

export interface CoreEqualizeOptions {
  choice: string;
  /** If that is `given`. */
  length: number;
  handles: Int32Array;
  /** Empty: the usual one. */
  method: string;
  shearLimit: number;
  guide: CoreSurface | null;
}

export interface CoreEqualizer {
  solve(iterations: number, milliseconds: number): EqualizeReport;
  positions(): Float64Array;
  surfacePositions(): Float64Array | null;
  delete(): void;
}

export interface CoreExactChange {
  solve(iterations: number, milliseconds: number): ExactChangeReport;
  positions(): Float64Array;
  delete(): void;
}

export interface CoreLengthAdapter {
  solve(iterations: number, milliseconds: number): AdaptReport;
  accept(session: Session): void;
  delete(): void;
}

export interface CoreRestSearch {
  solve(iterations: number, milliseconds: number): RestSearchReport;
  accept(session: Session): void;
  delete(): void;
}

/** `along`: 3 numbers a point. */
export type CoreDrapeOptions = Required<Omit<DrapeOptions, 'along'>> & { along: Float64Array };

/** `markedCreases`: likewise, each. */
export type CoreRemeshOptions = Required<Omit<RemeshOptions, 'markedCreases'>> & {
  triesCreases: boolean;
  markedCreases: Float64Array[];
};

export interface CoreSurface {
  positions(): Float64Array;
  normals(): Float64Array;
  triangles(): Int32Array;
  describe(): SurfaceReport;
  nearest(x: number, y: number, z: number): SurfacePlace;
  /** Origin and direction. */
  hit(ray: Float64Array): SurfacePlace | null;
  suggest(cells: number): { seed: Point; direction: Point; length: number };
  propose(options: CoreDrapeOptions): DrapeProposal[];
  /** In the direction of the options. */
  proposeSeeds(options: CoreDrapeOptions): DrapeProposal[];
  drape(options: CoreDrapeOptions): Drape;
  /** 3 numbers a point, as for `cut`. */
  cutPath(points: Float64Array): Float64Array;
  shortestCut(from: Point | null): Point[];
  cut(cuts: Float64Array[]): CoreSurface;
  drapePieces(options: CoreDrapeOptions): PiecesDrape;
  proposeCuts(options: CoreDrapeOptions, most: number): CutProposals;
  remesh(options: CoreRemeshOptions, progress: (phase: RemeshPhase, done: number) => void): Remesh;
  /** `length`: 0 where it is not known. */
  measure(net: Mesh, length: number): DrapeReport;
  delete(): void;
}

export interface Core {
  shapes(): ShapeInfo[];
  methods(): MethodInfo[];
  initialisations(): InitialisationInfo[];
  formats(): FormatInfo[];
  defaultOptions(): OptionInfo[];
  memory(): number;
  openRecipe(recipe: string): Session;
  openObj(text: string, name: string, restLengths: string): Session;
  openMesh(mesh: Mesh, restLengths: string): Session;
  readMesh(bytes: Uint8Array, name: string): Mesh;
  repairMesh(mesh: Mesh, chosen: readonly string[], mergeTolerance: number): RepairedMesh;
  defects(): Defect[];
  change(mesh: Mesh, name: string, vertices: Int32Array, edges: Int32Array): ChangedMesh;
  exactChange(
    changed: ChangedMesh,
    options: { length: number | null; held: Int32Array; shearLimit: number },
  ): CoreExactChange;
  equalizer(mesh: Mesh, options: CoreEqualizeOptions): CoreEqualizer;
  lengthAdapter(session: Session, vertices: Int32Array, targets: Float64Array): CoreLengthAdapter;
  restSearch(session: Session): CoreRestSearch;
  /** Of handles 3 numbers each. */
  forces(session: Session): (Omit<NetForces, 'handles'> & { handles: Float64Array }) | null;
  guide(session: Session, surface: CoreSurface): void;
  unguide(session: Session): void;
  openSurface(mesh: Mesh): CoreSurface;
  ownSurface(name: string): CoreSurface;
  ownSurfaces(): OwnSurfaceInfo[];
  readonly mergeTolerance: number;
  /** Of coordinates. */
  readonly largestSize: number;
}

export default function createCore(settings: {
  locateFile?: (path: string) => string;
  wasmBinary?: ArrayBuffer | Uint8Array;
}): Promise<Core>;

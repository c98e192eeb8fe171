/**
 * The core of chebnet in WebAssembly. Arrays cross the border flat and by copy: what you get is yours, what you give may
 * be reused. Positions are 3 numbers a vertex, x y z, in the net's own unit. Every failure is a thrown `ChebnetError`.
 */

/**
 * An `Error` whose `code` is a name from core/base/error.h, e.g. "non_manifold_edge" or "left_out" (see
 * wasm/editors.d.ts), and whose message is the core's. Two codes more: "disposed" (what was used had been disposed) and
 * "internal" (a fault of chebnet itself). Only a trap of the module, a `WebAssembly.RuntimeError`, carries no code: then
 * nothing of it may be used any more.
 */
export interface ChebnetError extends Error {
  code: string;
}

export type Status = 'running' | 'converged' | 'exact' | 'stalled' | 'max_iterations' | 'unreachable' | 'non_finite';

export interface ShapeParameter {
  name: string;
  value: number;
  smallest: number;
  largest: number;
  sentence: string;
}

export interface ShapeInfo {
  name: string;
  title: string;
  sentence: string;
  parameters: ShapeParameter[];
  /** The recipe that a gallery opens: with what a shape has got since its name alone began to stand for what it was. */
  offered: string;
}

export interface MethodInfo {
  name: string;
  sentence: string;
  citation: string;
  /** Whether it lets handles slide; others hold them where they stand. */
  slides: boolean;
  /** What its stages are called, that of number 1 first. */
  stages: string[];
  /** The names of the options that it reads. */
  options: string[];
}

export interface InitialisationInfo {
  name: string;
  /** It wants a number of iterations: `name:N`. */
  counted: boolean;
  sentence: string;
  citation: string;
}

export interface OptionInfo {
  name: string;
  kind: 'number' | 'integer' | 'flag';
  value: number;
  smallest: number;
  largest: number;
  sentence: string;
}

/** A format of mesh files, read and written. All keep faces, order and every bit of a coordinate but STL, which holds
 *  triangles with floats. */
export interface FormatInfo {
  /** Behind a dot, the extension of its files. */
  name: string;
  title: string;
  /** What it is for, in a few words. */
  sentence: string;
  mediaType: string;
}

/** Numbers of the edges or vertices of a net, by the names of the table in core/edit/field.cpp. */
export interface CoreFields {
  /** dL of every edge. */
  deviation: Float32Array;
  /** At each vertex the corner angle farthest from a right angle, in radians. */
  angle: Float32Array;
  /** Of every edge, what holds it at its length, as NetForces has it: above 0 it pulls, below it pushes.
   *  All 0 unless the method is `equilibrium`. */
  force: Float32Array;
  /** How far each vertex is above the guide, below it less than 0. All 0 without a guide. */
  height: Float32Array;
  [name: string]: Float32Array;
}

export interface NetInfo {
  vertices: number;
  edges: number;
  faces: number;
  boundaryLoops: number;
  components: number;
  /** Number of corners → how many faces. */
  facesByArity: Record<string, number>;
  /** Inner vertices of valence other than 4: valence → how many. */
  singularVertices: Record<string, number>;
  /** Of the edges at rest. */
  shortestLength: number;
  meanLength: number;
  longestLength: number;
  /** That of most edges: where a border has cut the net some are shorter. The mean, if they share none. */
  edgeLength: number;
  /** Largest dL of the rest positions against the mean length. */
  maxDeviationFromMean: number;
  isChebyshev: boolean;
}

/** Along which a handle slides. */
export type Axes = 'x' | 'y' | 'z' | 'xy' | 'xz' | 'yz';

export interface Handle {
  vertex: number;
  target: [number, number, number];
  /** Above 0: a soft handle, which pulls with this weight beside that of an edge; without one the target is kept exactly. */
  weight?: number;
  /**
   * An exact handle that slides: it holds its other coordinates exactly and leaves these to the net, where its target
   * follows the vertex. Methods whose `slides` is false hold the vertex where it stands.
   */
  slides?: Axes;
}

/** Where a net may move; see `setLocality`. */
export interface Locality {
  radius: number;
  origins: readonly number[];
  /** Where the net stood when this began and is held; without it, where it stands now. */
  heldAt?: Float64Array;
}

/** All that another editor of the same net needs to go on from there; see core/edit/edit_state.h. */
export interface EditState {
  handles: readonly Handle[];
  method: string;
  initialisation: string;
  /** Those not named are at their defaults. */
  options: Readonly<Record<string, number | boolean>>;
  /** null: everything may move. */
  locality: Locality | null;
  positions: Float64Array;
}

/** All points as near to a centre as this, where a vertex is held. */
export interface Ball {
  vertex: number;
  centre: [number, number, number];
  radius: number;
}

export interface UnreachablePair {
  vertexA: number;
  vertexB: number;
  /** Between the targets. */
  distance: number;
  /** Along the net. */
  reach: number;
}

export interface TraceRow {
  /** From 1; those of an initialisation end at 0. */
  iteration: number;
  /** From 1, by the method's `stages`; 0 in an initialisation. */
  stage: number;
  p: number;
  energy: number;
  maxDeviation: number;
  gradientNorm: number;
  step: number;
  freeVertices: number;
  assemblyMs: number;
  factorisationMs: number;
  lineSearchMs: number;
  totalMs: number;
}

/** What is left until a net is at rest; see core/solve/rest_state.h. */
export interface ToRest {
  /** Of the force that is left beside those of lengths and limit, in units of 1 / mean length. */
  gradientNorm: number;
  /** By how much a quad's diagonal is too short for the shear limit at most, in edge lengths. */
  cornerLack: number;
  /** About how far the vertex that moves most still goes, in edge lengths; Infinity: not known. */
  motion: number;
}

/** What holds a net at rest, in the unit of the option `gravity`: an edge of mean length has that weight. See
 *  core/edit/net_forces.h. */
export interface NetForces {
  /** How hard each edge pulls its ends together, or below 0 pushes them apart. */
  edges: Float64Array;
  /** What keeps the ends of a quad's diagonal apart where its corners are at the shear limit. */
  corners: { vertexA: number; vertexB: number; push: number }[];
  /** Of each of `handles()`, what it does to the net: the support of an exact one, the pull of a soft one. */
  handles: [number, number, number][];
  /** Of each term by its name: `bending`, `shear`, `tips`, `gravity`, `closeness`, `pull`. */
  energies: Record<string, number>;
}

export interface SolveReport {
  status: Status;
  maxDeviation: number;
  milliseconds: number;
  factorisationMs: number;
  iterations: number;
  /** null: the method does not bring nets to rest, or has not come so far. */
  toRest: ToRest | null;
  trace: TraceRow[];
}

/** Which length each edge is to keep: its own, the mean of all, or, `automatic`, the mean if all are as good as equal. */
export type RestLengths = 'automatic' | 'equal' | 'own';

/** Vertices and faces as a file gives them, sound or not. */
export interface Mesh {
  /** 3 numbers a vertex. */
  positions: Float64Array;
  /** Face f is `faceVertices[faceStart[f]] … faceVertices[faceStart[f + 1] - 1]`. */
  faceStart: Int32Array;
  faceVertices: Int32Array;
}

/** Lists of vertices one after another: list k is `vertices[start[k]] … vertices[start[k + 1] - 1]`. */
export interface VertexLists {
  start: Int32Array;
  vertices: Int32Array;
}

/** A net laid flat, where it can be: a piece of the square grid, or several; see core/fabricate/flat_pattern.h. */
export interface FlatPattern {
  /** Column and row of each vertex, from 0, between two where a rod is cut; rows count upwards, and the first face of a
   *  piece that has a whole rod is seen from its front. */
  places: Float64Array;
  columns: number;
  rows: number;
  /** Where each piece of the net lies: the squares from a column and a row on. By their first faces. */
  pieces: { column: number; row: number; columns: number; rows: number }[];
}

/** Why a net has no flat pattern. */
export type PatternFault =
  | { reason: 'not_quads'; face: number }
  | { reason: 'unequal' }
  /** Nothing says where the face lies: no rod leads to it, or only some that are cut at both ends. */
  | { reason: 'loose'; face: number }
  | { reason: 'singular'; vertex: number; valence: number }
  /** Two ways to the vertex lead to two places. */
  | { reason: 'closed'; vertex: number }
  /** The face would lie upon another one. */
  | { reason: 'overlap'; face: number }
  /** Faces meet at the vertex, but not at an edge there. */
  | { reason: 'touching'; vertex: number; valence: number };

/** What can be wrong with a mesh; see core/net/repair.h. */
export type Defect =
  | 'duplicate_vertices'
  | 'degenerate_faces'
  | 'duplicate_faces'
  | 'non_manifold_edges'
  | 'inconsistent_winding'
  | 'unused_vertices';

/** One kind of defect that was found. */
export interface Finding {
  defect: Defect;
  repaired: boolean;
  /** How many vertices or faces, at least 1. */
  count: number;
  /** The first few of them, as the mesh that was given numbers them, from 0. */
  examples: number[];
  /** The same for a person, e.g. "2 vertices at the place of an earlier one, merged: 4, 7". */
  sentence: string;
}

export interface RepairedMesh {
  mesh: Mesh;
  /** For each vertex that was given where it is now, -1 if it was dropped. */
  newVertex: Int32Array;
  /** Empty if nothing was found. */
  findings: Finding[];
}

/** A way to change the faces of a net: its name in the table of core/change/change.cpp, which says what it does. */
export type NetChange =
  | 'refine'
  | 'coarsen'
  | 'cut'
  | 'cut_flat'
  | 'keep_larger'
  | 'keep_smaller'
  | 'delete_rows'
  | 'delete_faces'
  | 'keep_pieces'
  | 'delete_pieces'
  | 'add_row'
  | 'insert_row'
  | 'remove_line'
  | 'join';

/** Where; edges by their numbers in `Editor.edges`. */
export interface ChangePlace {
  vertices?: readonly number[];
  edges?: readonly number[];
}

/** A net with other faces, not yet exact; see core/change/change.h. */
export interface ChangedMesh {
  mesh: Mesh;
  /** Of each vertex the one that it was; -1: it is new. */
  origins: Int32Array;
  /** All edges are to be so many times as long as before. */
  lengthFactor: number;
  /** Every edge is as long as one of before. */
  keepsEdges: boolean;
}

export interface ExactChangeOptions {
  /** Of all edges of the net before; null: each has its own, and keeps what it gets. */
  length: number | null;
  /** Vertices of the net before that stay where they are, if a net is found so. */
  held?: readonly number[];
  /** As EqualizeOptions has it. */
  shearLimit?: number;
}

export interface ExactChangeReport {
  status: Status;
  /** Since the beginning. */
  iterations: number;
}

/** Makes a changed net exact; see core/edit/exact_change.h, whose contract this follows. */
export interface ExactChange {
  /** Goes on until it ends or the budget runs out (`running`). */
  solve(budget?: Budget): ExactChangeReport;
  /** Exact once it is `converged`, or `exact`: then corners are sharper than the limit. */
  positions(): Float64Array;
  /** Frees the memory on the other side; it must not be used again. */
  dispose(): void;
}

/** How much one call of `solve` may do; without a field, no limit. */
export interface Budget {
  iterations?: number;
  milliseconds?: number;
}

/** A net being edited; see core/edit/editor.h, whose contract this follows. */
export interface Editor {
  readonly info: NetInfo;
  /** 2 vertices an edge. */
  readonly edges: Int32Array;
  /** Face f is `faceVertices[faceStart[f]] … faceVertices[faceStart[f + 1] - 1]`. */
  readonly faceStart: Int32Array;
  readonly faceVertices: Int32Array;
  readonly restPositions: Float64Array;
  /** The length each edge is to keep, as the net came: times the option `length_scale` in fact. */
  readonly restLengths: Float64Array;
  /** Chains of edges that go straight on, from end to end; a closed one ends with the vertex it begins with
   *  (core/net/topology.h). */
  netLines(): VertexLists;
  /** The net lines that rods are laid along, as `rodTable` has them: past inward corners, without rims (core/net/rods.h). */
  rods(): VertexLists;
  /** Closed chains of edges with one face, without repetition of the first vertex. */
  boundaryLoops(): VertexLists;
  flatPattern(): FlatPattern | PatternFault;
  /** For a net made from a recipe: vertices that make a good first edit, the last the one to drag. Empty otherwise. */
  readonly suggestedHandles: Int32Array;

  readonly method: string;
  setMethod(name: string): void;
  /** What is done to the positions at the beginning of each solve: `naive`, `arap:N` or `local_global:N`. */
  readonly initialisation: string;
  setInitialisation(text: string): void;
  options(): Record<string, number | boolean>;
  setOption(name: string, value: number | boolean): void;

  state(): EditState;
  /** Exact handles then snap to their targets. If anything of it is refused, nothing changes; if it is the present state, a
   *  solve under way goes on. */
  setState(state: EditState): void;
  /** The same for the present state with some of it changed, as other functions of this interface that begin with `set` change
   *  it: if the option `length_scale` changes and the positions do not, these grow with it. */
  changeState(change: Partial<EditState>): void;

  /** Those dragged where they stand. */
  handles(): Handle[];
  setHandles(handles: readonly Handle[]): void;
  moveHandle(vertex: number, target: readonly [number, number, number]): void;
  /** Likewise by hand: with `equilibrium` every frame is then a net, and where none leads to the target the handle is held
   *  back, as near as the net goes, and on the axis or plane `along` which the hand is kept, if it is. Other methods:
   *  `moveHandle`. */
  dragHandle(vertex: number, target: readonly [number, number, number], along?: Axes): void;
  /** Lets go of what was dragged: when the solve ends, handles that are held back take the place where they stand as target; but
   *  where all are to be home, as at rest, the net rests as it did, unless it had been pushed into another shape before. */
  releaseHandles(): void;
  /** Whether dragged handles are held back now. */
  readonly holdsBack: boolean;

  /** From now on only what lies within `radius` edge lengths of the `origins`, along the net, may move; Infinity: everything. */
  setLocality(radius: number, origins: readonly number[]): void;
  /** Where the other exact handles, and the border of a locality, let the handle at `vertex` be moved: the points in all these
   *  balls. A handle that has another on a shortest path to this one has no ball: it allows no less. None for a soft handle. */
  reach(vertex: number): Ball[];
  /** Where to begin in order to find the other equilibrium of a net that has buckled, on the other side of its handles: for
   *  `setPositions`; see core/edit/flip.h. */
  flipped(): Float64Array;
  /** How freely `setLocality` would let each vertex move, 0 … 1; see core/edit/locality.h. */
  mobility(radius: number, origins: readonly number[]): Float32Array;

  /** Goes on with the present solve until it ends or the budget runs out (`running`). */
  solve(budget?: Budget): SolveReport;
  /** Back to rest; handles keep their vertices and take the rest positions as targets. */
  reset(): void;

  /** A search for the smallest `length_scale` with which the exact handles are met, those named at these targets. Throws
   *  "left_out" in a module that does without. */
  lengthAdapter(wanted?: readonly Handle[]): LengthAdapter;
  /** Looks for another net at rest, with less energy. Throws `bad_option` for another method than `equilibrium`,
   *  "left_out" in a module that does without. */
  restSearch(): RestSearch;

  /** Of the last solve; null where its method does not tell, and while handles are on their way. Throws "left_out" in a
   *  module that does without. */
  forces(): NetForces | null;

  /** A surface that draws the net, or null, as the options `guide_mode` and `guide_weight` of the method `equilibrium`
   *  say. It stays while other states are set, and may be disposed of. */
  setGuide(surface: Surface | null): void;

  positions(): Float64Array;
  setPositions(positions: Float64Array): void;
  /** At the present positions. */
  fields(): CoreFields;
  /** Root mean square change of the bend of net lines from rest (core/net/measures.h). */
  bend(): number;
  /** The smallest angle at a face corner, in radians. */
  smallestAngle(): number;
  /** Largest distance of an exact handle from its target: 0 by construction. */
  handleError(): number;
  /** Pairs of handles that no net can hold, worst first, without those that have a third handle on a shortest path. */
  unreachablePairs(): UnreachablePair[];

  /** The present positions as OBJ text; 17 digits return every coordinate exactly. */
  toObj(digits?: number): string;
  /** The edges with their present lengths, and their forces where `forces` knows them, as CSV; see core/fabricate/edge_table.h. */
  edgeTable(): string;
  /** The rods with their present lengths, and the marks where others cross them, as CSV; see core/fabricate/rod_table.h. */
  rodTable(): string;
  /** The present positions as the bytes of a file. `format`: a name from `formats()`, or `ply_text`, where `ply` is binary. */
  toFile(format: string): Uint8Array<ArrayBuffer>;
  /** Frees the memory on the other side; the editor must not be used again. */
  dispose(): void;
}

export interface AdaptReport {
  /** `converged`: found; `unreachable`: no scale does. */
  status: Status;
  /** The smallest found so far, or else the one being tried. */
  scale: number;
  /** Since the beginning, as are the milliseconds. */
  iterations: number;
  milliseconds: number;
}

/** For handles beyond reach: how little all edges must grow; see core/edit/length_adapter.h, whose contract this follows. */
export interface LengthAdapter {
  solve(budget?: Budget): AdaptReport;
  /** Sets the editor it was made by to what is found. Only once it has `converged`. */
  accept(): void;
  /** Frees the memory on the other side; it must not be used again. */
  dispose(): void;
}

export interface RestSearchReport {
  /** `converged`: a net with less energy is found; `unreachable`: none is. */
  status: Status;
  /** 0 … 1, about. */
  done: number;
  /** Of the net as it was; Infinity: it was none. */
  energyBefore: number;
  /** The least found so far. */
  energy: number;
  /** Since the beginning, as are the milliseconds. */
  iterations: number;
  milliseconds: number;
}

/** For an edit that has several equilibria; see core/edit/rest_search.h, whose contract this follows. */
export interface RestSearch {
  solve(budget?: Budget): RestSearchReport;
  /** Sets the editor it was made by to what is found. Only once it has `converged`. */
  accept(): void;
  /** Frees the memory on the other side; it must not be used again. */
  dispose(): void;
}

/** How edge lengths differ, as parts of their mean. */
export interface EqualizeSpread {
  shortest: number;
  longest: number;
  standardDeviation: number;
}

export interface EqualizeOptions {
  /** The length all edges are to have: the `mean` of the original's, unless said otherwise; the one with which the net
   *  lies nearest to the original; or a number. */
  length?: 'mean' | 'fitting' | number;
  /** Vertices that stay exactly where they are; without any the whole net is free. */
  handles?: readonly number[];
  /** `equilibrium`: near the surface of the mesh, fair, no corner too sharp; `projection`: lengths alone; without it the
   *  one that is usual for a net of this size. */
  method?: 'equilibrium' | 'projection';
  /** For `equilibrium`: no corner of a quad is sharper, in radians; 0: no limit; 30° unless said otherwise. */
  shearLimit?: number;
  /** For `equilibrium`, which is then the usual method: the net comes near this surface and not near that of the mesh. It
   *  may be disposed of. */
  guide?: Surface;
}

export interface EqualizeReport {
  status: Status;
  /** What has made it: `projection` also where `equilibrium` found no such net. */
  method: 'equilibrium' | 'projection';
  /** What all edges have if it is `converged` or `exact`. */
  length: number;
  fittingLength: number;
  /** Against that length; `converged` and `exact` mean below 1e-9. */
  maxDeviation: number;
  /** Since the beginning, as are the milliseconds. */
  iterations: number;
  milliseconds: number;
  /** Of handles. */
  unreachablePairs: UnreachablePair[];
  // Measured at the end alone: 0, empty or null while the status is `running`.
  before: EqualizeSpread;
  after: EqualizeSpread;
  /** From the guide or else the surface of the mesh, in edge lengths; null if its faces are no surface. */
  distance: { mean: number; largest: number } | null;
  /** Of corners, in radians. */
  smallestAngle: number;
  /** Quads with a corner sharper than the limit; with any, a solve for `equilibrium` ends as `exact` and not as `converged`. */
  quadsBeyondLimit: number;
  /** Edges at which the mesh and the net fold by more than 60°: a net is crumpled there. */
  foldsBefore: number;
  folds: number;
  /** Of vertices from where they were, in edge lengths. */
  meanMove: number;
  maxMove: number;
  /** A few of those that are off, the worst first. */
  worstEdges: { vertexA: number; vertexB: number; length: number }[];
}

/** Turns a mesh into a net near it whose edges have one length; see core/edit/equalize.h, whose contract this follows. */
export interface Equalizer {
  /** Goes on until it ends or the budget runs out (`running`). */
  solve(budget?: Budget): EqualizeReport;
  /** Those held now; of the original, bit for bit, if its edges have the length already, it has no guide, and with
   *  `equilibrium` no corner is to be opened. */
  positions(): Float64Array;
  /** Where the vertices of the surface lie that the net is near: the mesh's own, or scaled as the net is by a length that
   *  is given. Null if its faces are no surface, or the net is near a guide. */
  surfacePositions(): Float64Array | null;
  /** Frees the memory on the other side; the equalizer must not be used again. */
  dispose(): void;
}

export type Point = [number, number, number];

/** A surface of our own to make nets on; see core/surface/gallery.h. */
export interface OwnSurfaceInfo {
  name: string;
  title: string;
  sentence: string;
}

/** Integrals of Gaussian curvature by its sign, in radians. */
export interface TotalCurvature {
  positive: number;
  /** 0 or below. */
  negative: number;
}

/** What may be expected of one net; see core/surface/curvature.h. */
export type Prospect = 'one_piece' | 'tight' | 'a_seam' | 'too_curved';

export interface SurfaceReport {
  vertices: number;
  triangles: number;
  trianglesWithoutArea: number;
  components: number;
  boundaryLoops: number;
  /** Of all components together. */
  genus: number;
  area: number;
  /** As the triangles have it. */
  curvature: TotalCurvature;
  /** Of the shape without its noise. */
  smoothedCurvature: TotalCurvature;
  /** The larger of the latter's two, in the component where that is largest; one net can take 2π. */
  hardestCurvature: number;
  /** Part of the largest piece that a net of a few hundred cells covers, the best of some that were tried. */
  triedCoverage: number;
  prospect: Prospect;
  /** The prospect, for a person. */
  sentence: string;
}

/** A place on a surface, with the unit vector upright on it there. */
export interface SurfacePlace {
  position: Point;
  normal: Point;
}

/** Ways of the arms of a net: straight on; bent so that cells are sheared less, where that makes a better net; those of the
 *  first family along a curve. */
export type DrapeArms = 'geodesic' | 'least_shear' | 'curve';

/** How a net is laid on a surface; see core/drape/drape.h. */
export interface DrapeOptions {
  /** The net begins at the nearest point of the surface. */
  seed: Readonly<Point>;
  /** Of the first family of net lines there. */
  direction: Readonly<Point>;
  /** Of all edges. */
  length: number;
  /** Between the two families at the seed, in radians; a right angle unless said otherwise. */
  angle?: number;
  /** No corner is sharper, in radians; 30° unless said otherwise. */
  smallestAngle?: number;
  /** Cells from the seed along each family; as far as it goes unless said otherwise. */
  reach?: number;
  /** What happens where the surface ends: `beyond`, unless said otherwise, cells go over it that have a vertex on it, but not
   *  over cuts, behind which more of the net lies; `cut`, these are cut at the boundary curve, with edges as long as what is
   *  left. */
  border?: 'inside' | 'beyond' | 'cut';
  /** How the net lines through the seed run; `geodesic` unless said otherwise. */
  arms?: DrapeArms;
  /** For `curve`: points near the surface, at least two, joined by shortest ways; the last may be the first again. The seed
   *  goes to the nearest point of the curve, from which the first family runs as it was drawn, whatever the direction. */
  along?: readonly Readonly<Point>[];
  /** Where the net would lock it leaves the surface by up to this, in edge lengths, which takes longer; 0, unless said
   *  otherwise: a gap stays. See core/drape/bridged_drape.h. Proposals pass over it. */
  leave?: number;
}

/** Where a net may begin, and what came of it when it was tried, with longer edges but for the first few; see core/drape/proposals.h. */
export interface DrapeProposal {
  seed: Point;
  direction: Point;
  /** Area of the cells as a part of the surface's. */
  covered: number;
  /** Part of the cells with a corner more than 30° from a right angle. */
  muchSheared: number;
  /** Of vertices and middles of edges from the surface, in edge lengths. */
  meanDistance: number;
}

/** A net on a surface, each vertex on it, as far as it need not leave it, and each edge of one length, but for those that are cut at the border. */
export interface Drape {
  mesh: Mesh;
  /** Of each vertex the steps from the seed along the first and the second family; of an end that was cut those to the
   *  vertex beyond the border. */
  places: Int32Array;
  /** Ends of rods that were cut. */
  cutEnds: number;
  /** `geodesic` also where `least_shear` would not have made a better net. */
  arms: DrapeArms;
  /** How many vertices were refused, since corners would have been too sharp, or since the net would have met itself. */
  locked: number;
  met: number;
}

/** Nets on all pieces of a surface, as one mesh: that of the seed first, of whose vertices `places` are the first, no two joined. */
export interface PiecesDrape extends Drape {
  /** How many have a net, and how many are too small or too bent for one. */
  pieces: number;
  bare: number;
}

/** Cuts that help, in their order; see core/drape/cut_proposals.h. */
export interface CutProposals {
  /** Each by its points, for `cut`. */
  cuts: Point[][];
  /** Part of the surface's area that is within half an edge of the nets: uncut, and with each further cut. */
  coverage: number[];
}

/** How a whole surface is made a net; see core/remesh/remesh.h. */
export interface RemeshOptions {
  /** About so many, 4000 unless said otherwise; not asked for if there is a length. */
  cells?: number;
  /** Of all edges, exactly. */
  length?: number;
  /** No corner is to be sharper, in radians; 30° unless said otherwise. See `sharpQuads` of whether none is. */
  smallestAngle?: number;
  /** 0 … 100, 1 unless said otherwise: the more, the larger are the bumps that make no singular vertices. */
  smoothing?: number;
  /** As few singular vertices as a net can do with whose corners keep the limit, no more than 0.2 edges away from the surface on
   *  average: cells shear where others would have one. Takes longer; not where creases are followed, nor together with `singular`
   *  or `only`. */
  fewest?: boolean;
  /** Net lines follow edges of the surface that are sharper than this angle between two triangles' normals, in radians; 0: no
   *  edge is followed. Unless said otherwise nets that follow edges sharper than 30° are tried, too, if `fewest` is not asked
   *  for, and made where they lie better. */
  crease?: number;
  /** And curves that are marked on the surface, each by points near it, at least two, joined by shortest ways; the last may be
   *  the first again. Not always followed: see `kept` of what comes of it, and core/remesh/marked_creases.h. */
  markedCreases?: readonly (readonly Readonly<Point>[])[];
  /** Whether the net ends in a net line where the surface ends (`always`), in one there, but in steps around holes (`outer`),
   *  in steps as cells fall (`never`), or with net lines that run up to it at 45° (`across`); unless said otherwise as fits
   *  best, left open along gaps where all others would crumple. */
  border?: 'fitting' | 'always' | 'outer' | 'across' | 'never';
  /** Where singular vertices are wanted. Not always kept: see `kept` of what comes of it. */
  singular?: readonly WishedSingular[];
  /** Where none are wanted. */
  forbidden?: readonly ForbiddenRegion[];
  /** No others than `singular` are wanted. On a closed piece of the surface 4 − valence must then add up to four times its
   *  Euler characteristic; a `bad_option` says what is missing. */
  only?: boolean;
}

/** A singular vertex where it is wanted: on the surface, or that point of it which is nearest. */
export interface WishedSingular {
  point: Readonly<Point>;
  valence: 3 | 5 | 6;
}

/** The part of a surface that is in a ball; the radius is in the surface's unit. */
export interface ForbiddenRegion {
  centre: Readonly<Point>;
  radius: number;
}

/** An inner vertex of a net at which other than four edges meet. */
export interface SingularVertex {
  vertex: number;
  valence: number;
  position: Point;
}

/** What has become of what was wanted. */
export interface KeptWishes {
  /** Of each of `singular`, whether one of its valence stands within one and a half edges of its point. */
  vertices: boolean[];
  /** Of each, how far away the nearest of its valence stands, in edges; null: there is none. */
  distances: (number | null)[];
  /** Of each of `forbidden`, the singular vertices that stand in it. */
  intruders: number[];
  /** Singular vertices beyond those wanted, if there were to be none. */
  others: number;
  /** Of each of `markedCreases`, how far the net lines that run along it are from it on average, in edges, and whether that is
   *  near enough to say that they follow it. */
  markedCreases: { followed: boolean; distance: number }[];
  /** One for each wish that is not kept. */
  sentences: string[];
}

/** What is done, in this order; `border` only where the surface has one, and no way is asked for in which the net ends there. */
export type RemeshPhase = 'border' | 'triangles' | 'singular' | 'field' | 'grid' | 'fit';

/** Part of a surface around which too few cells go for a net. */
export interface ThinLimb {
  /** On it, farthest from what is left. */
  point: Point;
  /** Around it where it is thin, on average, in cells. */
  girth: number;
}

/** A net over a whole surface, near it, each edge of one length. */
export interface Remesh {
  mesh: Mesh;
  /** Ascending by valence. */
  singularVertices: { valence: number; count: number }[];
  /** Each of them, in the order of their numbers. */
  singular: SingularVertex[];
  kept: KeptWishes;
  /** With a corner sharper than the limit: above 0 where no net was found that keeps it everywhere. */
  sharpQuads: number;
  /** Of the surface: a net with these limbs was not found, or was more crumpled. */
  leftOff: ThinLimb[];
  milliseconds: Record<RemeshPhase, number>;
}

/** How well a net lies on a surface. Its whole cells are quads with edges of one length. */
export interface DrapeReport {
  /** Of most edges; where a border has cut these, of whole ones. */
  length: number;
  /** Part of the surface's area that is within half an edge of the net. */
  coverage: number;
  /** Length of the net's border that is not beside the surface's: of gaps, and of both sides of slits, which `coverage`
   *  counts as covered. */
  openBorder: number;
  /** How many stretches of border that is; a whole loop is one. */
  gaps: number;
  /** Of vertices and middles of edges from the surface, in its unit. */
  meanDistance: number;
  largestDistance: number;
  /** Without any, the next four say nothing. */
  wholeCells: number;
  /** Of corners of whole cells, in radians. */
  smallestAngle: number;
  largestAngle: number;
  /** Parts of the whole cells with a corner more than 15° and more than 30° from a right angle. */
  sheared: number;
  muchSheared: number;
  /** Edges at which the net folds by more than 60°. */
  folds: number;
  /** Those of them at which it folds by so much more than the surface does: it is crumpled there. */
  crumpled: number;
  /** Net lines from end to end, but for those along a border that cuts, and the length of all together. */
  rods: number;
  rodLength: number;
  maxDeviation: number;
}

/** A surface of triangles on which nets are made; see core/surface/surface.h. */
export interface Surface {
  /** 3 numbers a vertex. */
  readonly positions: Float64Array;
  /** Likewise, of length 1. */
  readonly normals: Float64Array;
  /** 3 vertices each. */
  readonly triangles: Int32Array;
  describe(): SurfaceReport;
  nearest(point: Readonly<Point>): SurfacePlace;
  /** Where a ray first meets the surface, from either side. */
  hit(origin: Readonly<Point>, direction: Readonly<Point>): SurfacePlace | null;
  /** A beginning in the middle, with the length that gives about so many cells. */
  suggest(cells: number): { seed: Point; direction: Point; length: number };
  /** Of several trials the best beginnings, first those that cover most, are sheared least and come nearest; with a direction,
   *  all in that one. */
  propose(
    options: Omit<DrapeOptions, 'seed' | 'direction'> & Partial<Pick<DrapeOptions, 'direction'>>,
  ): DrapeProposal[];
  drape(options: DrapeOptions): Drape;
  /** Cut open along shortest ways over the surface between points near it, at least two a cut; see
   *  core/surface/surface_cut.h. Shape and area stay. */
  cut(cuts: readonly (readonly Readonly<Point>[])[]): Surface;
  /** How one of these runs, 3 numbers a point. */
  cutPath(points: readonly Readonly<Point>[]): Float64Array;
  /** The shortest cut to the border, for `cut`: from the point of the surface nearest to `from`, or with null between the two
   *  boundaries that are nearest to each other; all of its points are to be handed on. Of a surface that has been cut, cuts
   *  are border, too. A `bad_option` says which border is missing. */
  shortestCut(from: Readonly<Point> | null): Point[];
  /** A net on each piece of the surface, with edges of one length: from the seed on its piece, from their middles on the
   *  others; none goes across a cut. See core/drape/drape_pieces.h. */
  drapePieces(options: DrapeOptions): PiecesDrape;
  /** Up to `most` cuts with which such nets cover more of the surface; there may be none. Takes seconds. */
  proposeCuts(options: DrapeOptions, most: number): CutProposals;
  /** The phases may begin anew where the first attempt does not do. @param progress is told how far a phase is, 0 … 1. */
  remesh(options?: RemeshOptions, progress?: (phase: RemeshPhase, done: number) => void): Remesh;
  /** @param length with which the net was laid, of its whole edges; a net of few cells most of whose edges a border has cut
   *  may not say it. */
  measure(net: Mesh, length?: number): DrapeReport;
  /** Frees the memory on the other side; the surface must not be used again. */
  dispose(): void;
}

/** What wasm/editors.js gives, too. */
export interface Editors {
  shapes(): ShapeInfo[];
  methods(): MethodInfo[];
  initialisations(): InitialisationInfo[];
  formats(): FormatInfo[];
  options(): OptionInfo[];
  /** Bytes that the module has taken for all that it holds; it takes more when it needs them and gives none back. */
  memory(): number;
  openRecipe(recipe: string): Editor;
  /** `name` is what messages call the text; `restLengths` are `automatic` unless said otherwise. */
  openObj(text: string, name?: string, restLengths?: RestLengths): Editor;
  openMesh(mesh: Mesh, restLengths?: RestLengths): Editor;

  /** Polygons are cut into triangles. */
  openSurface(mesh: Mesh): Surface;
  ownSurfaces(): OwnSurfaceInfo[];
  /** One of these, by its name. */
  ownSurface(name: string): Surface;
}

export interface Chebnet extends Editors {
  /** Reads the bytes of a file of one of the formats. What they begin with decides between these before the extension
   *  of `name` does, by which messages call the file. */
  readMesh(bytes: Uint8Array, name: string): Mesh;
  /** Everything that `repairMesh` looks for, in this order. */
  defects(): Defect[];
  /** Looks for every defect and repairs those `chosen`, all unless said otherwise. Vertices closer than `mergeTolerance`
   *  times the mean edge length count as duplicates. What is given stays as it is. */
  repairMesh(mesh: Mesh, chosen?: readonly Defect[], mergeTolerance?: number): RepairedMesh;

  /** Where the net does not allow it, the code is "impossible_change" and the message says why. */
  change(mesh: Mesh, name: NetChange, place?: ChangePlace): ChangedMesh;
  exactChange(changed: ChangedMesh, options: ExactChangeOptions): ExactChange;
  equalizer(mesh: Mesh, options?: EqualizeOptions): Equalizer;
}

/** Loads the module once. In the browser give `wasmUrl`, where build/wasm/chebnet_core.wasm is; elsewhere its bytes, `wasmBinary`. */
export function loadChebnet(source: { wasmUrl?: string; wasmBinary?: ArrayBuffer | Uint8Array }): Promise<Chebnet>;

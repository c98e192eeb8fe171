/** What is being edited, as plain data: everything a link, a file or undo must bring back. */
import type { Axes, Handle, Mesh, RestLengths } from '../../../wasm/chebnet';
import type { Colouring, ShownColouring } from '../fields/fields';

export type Vec3 = [number, number, number];

/** What a net is made from. */
export type NetSource = DocumentNet | FileText;

/** A file as links, projects and scripts carry it: OBJ text. Once it is open its document has it as arrays. */
export interface FileText extends FileTraits {
  obj: string;
}

/** As a document has it: every state of the history shares it, so it is no text, which takes twice the room. */
export type DocumentNet = { recipe: string } | FileNet;

export interface FileNet extends FileTraits {
  mesh: Mesh;
}

interface FileTraits {
  name: string;
  /** Which length each edge is to keep, `automatic` unless it is said. */
  restLengths?: RestLengths;
}

/** A surface beside a net, which draws it as the options `guide_mode` and `guide_weight` say: one of our own by its name,
 *  or what a visitor brought. */
export type GuideSource = { own: string } | GuideFile;

export interface GuideFile {
  name: string;
  mesh: Mesh;
}

/** Of a handle, in characters. */
export const LONGEST_NAME = 40;
export const LONGEST_PROJECT_NAME = 80;
/** As file systems have it: of a net or a surface that came in a file. */
export const LONGEST_FILE_NAME = 255;

export interface HandleData {
  vertex: number;
  target: Vec3;
  /** Locked: drawn apart, and no hand moves or removes it; to the solver both are the same. */
  anchor: boolean;
  /** How the user calls it; without one, by its vertex. */
  name?: string;
  /** Not drawn, and not to be caught by a click; holds the net all the same. */
  hidden?: boolean;
  /** Above 0: a soft handle, which pulls with this weight beside that of an edge; without one the target is kept exactly. */
  weight?: number | undefined;
  /** An exact handle that slides: it holds its other coordinates, and along these its target follows the vertex. */
  slides?: Axes | undefined;
}

/** A handle of a scene that is yet to be opened; `target` null: where the vertex rests. */
export interface HandleSeed extends Omit<HandleData, 'target'> {
  target: Vec3 | null;
}

/** What of handles the solver wants to know. */
export function targetsOf(handles: readonly Pick<HandleData, 'vertex' | 'target' | 'weight' | 'slides'>[]): Handle[] {
  return handles.map(({ vertex, target, weight, slides }) => ({
    vertex,
    target,
    ...(weight === undefined ? {} : { weight }),
    ...(slides === undefined ? {} : { slides }),
  }));
}

/** Along which a handle slides, in the order of the list of choices: on the ground first. */
export function axesToSlide(up: UpAxis = 'z'): readonly Axes[] {
  return up === 'z' ? ['xy', 'x', 'y', 'z', 'xz', 'yz'] : ['xz', 'x', 'z', 'y', 'xy', 'yz'];
}

/** A plane across an axis of the net; what is done to handles on one side of it is done on the other too. */
export interface Symmetry {
  axis: 'x' | 'y' | 'z';
  /** Where it lies: in the middle of the net at rest, or at 0. */
  through: 'centre' | 'origin';
}

/** Positions as a link carries them (packing.ts); they become numbers beside the net they belong to. */
interface PackedPositions {
  packed: Uint8Array;
}

/** Options of core/solve/options.h that differ from their defaults. */
export type SolverOptions = Record<string, number | boolean>;

/** How a net is solved. */
export interface SolverSettings {
  method: string;
  /** What each solve begins with: `naive`, `arap:N` or `local_global:N`. */
  initialisation: string;
  options: SolverOptions;
}

export type UpAxis = 'y' | 'z';

/** What is beyond a plane across an axis of the net is not drawn. */
export interface Section {
  axis: 'x' | 'y' | 'z';
  /** From 0 to 1, through a box somewhat larger than the rest net's diagonal. */
  at: number;
}

export interface CameraPlace {
  position: Vec3;
  target: Vec3;
  /** Width of the picture by its height. Those of before did not say. */
  aspect?: number | undefined;
}

/** From where a net is seen. */
export interface ViewPlace {
  /** Null: nobody has turned the view, and all of the net is seen. */
  camera: CameraPlace | null;
  /** Whether that is from behind; left to the net unless it says. */
  behind?: boolean | undefined;
}

export interface ViewState extends Colouring, ViewPlace {
  showFaces: boolean;
  /** The axis of the net that points up on the screen: z unless it says y, as many files from elsewhere want. */
  upAxis?: UpAxis;
  /** Edges are drawn as rods of this diameter, as a part of their length; without one, as lines. */
  rods?: number | undefined;
  section?: Section | undefined;
  /** Seen in parallel projection rather than in perspective. */
  parallel?: boolean;
  /** Whether the surface beside the net is not drawn. */
  guideHidden?: boolean;
}

/** What a document says that was opened as an experiment. */
interface ExperimentPart {
  /** The name of a figure in experiments/figures.json, or of what showed it in older versions. */
  experiment?: string | undefined;
  /** Methods worth comparing on it. */
  compare?: string[] | undefined;
}

export interface ChebnetDocument extends SolverSettings, ExperimentPart {
  net: DocumentNet;
  /** By which handles and positions go; see numbering.ts. Unknown until the net is open. */
  numbering?: number | undefined;
  handles: HandleData[];
  symmetry?: Symmetry | undefined;
  /** How far from handles being moved the net moves with them, in edge lengths along it; without one, everywhere. */
  locality?: number | undefined;
  /** How far from handles being dragged other handles follow them, in edge lengths along the net; without one, none do. */
  influence?: number | undefined;
  guide?: GuideSource | undefined;
  view: ViewState;
  /** The positions of the moment, 3 numbers a vertex; null until the net is open. */
  positions: Float64Array | null;
  /** Nothing is left to be solved. */
  settled: boolean;
  /** How the solve of a settled net ended, unless at rest. */
  ending?: Ending | undefined;
}

/** Those states of a solve in which it leaves a net that is not at rest, and of which the net itself does not tell. `running`: it
 *  was stopped. */
export const ENDINGS = ['running', 'exact', 'stalled', 'max_iterations'] as const;
export type Ending = (typeof ENDINGS)[number];

export function endingOf(status: string): Ending | undefined {
  return ENDINGS.find((each) => each === status);
}

/** How the net of a document looks. */
export type Look = ViewState & ShownColouring;

export function lookOf({ view, options }: Pick<ChebnetDocument, 'view' | 'options'>): Look {
  const limit = options['shear_limit'];
  return typeof limit === 'number' ? { ...view, cornerLimit: limit } : view;
}

/** Drags made again: in so many equal steps, with so many iterations after each. */
export type Replay = readonly [steps: number, iterations: number];

/** What can be opened: a document whose handles and positions may still be where the net has them. */
export interface Scene extends SolverSettings, ExperimentPart {
  net: NetSource;
  /** A net numbered otherwise is refused. */
  numbering?: number | undefined;
  /** `suggested`: those that come with the recipe. */
  handles: HandleSeed[] | 'suggested';
  symmetry?: Symmetry | undefined;
  locality?: number | undefined;
  influence?: number | undefined;
  guide?: GuideSource | undefined;
  view: ViewState;
  /** null: the rest positions. */
  positions: Float64Array | PackedPositions | null;
  /** Instead of positions: handles are dragged from where they rest to their targets. A net that buckles has several shapes at
   *  rest, and comes to this one so. */
  replay?: Replay | undefined;
  /** The positions are final and stay untouched; else the net is solved on from them. */
  settled: boolean;
  /** Of a settled net; what the net itself shows goes before. */
  ending?: Ending | undefined;
}

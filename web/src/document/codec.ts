/**
 * The parts of a document as JSON and back; links, project files and what the browser keeps are made of them. A field
 * that is new needs one line here, where it is read: writing takes whatever there is. See also versions.ts.
 */
import type { Mesh, RestLengths } from '../../../wasm/chebnet';
import type { Ends } from '../fields/colour_map';
import { areEnds, FIELD_NAMES, type FieldName, fieldOf } from '../fields/fields';
import { readCoreName } from './core_name';
import { axesToSlide, ENDINGS, LONGEST_FILE_NAME, LONGEST_NAME } from './document';
import type {
  CameraPlace,
  FileText,
  HandleData,
  HandleSeed,
  NetSource,
  Scene,
  Section,
  SolverOptions,
  Symmetry,
  UpAxis,
  ViewState,
} from './document';
import { DEFAULT_INITIALISATION } from './defaults';
import { objText } from './obj_text';
import type { Untrusted } from './untrusted';
import { given } from './given';
import { readingWords } from '../language/reading';
import type { Snapshot } from './undo';

/** Everything that is undone, but for the net and its positions, which are large and often shared. */
export type State<Handle> = Omit<Snapshot, 'net' | 'positions' | 'handles'> & { handles: Handle[] };

// ------------------------------------------------------------------------------------------------------------- writing

/** @param handles as they are written, see writeHandle(). */
export function writeState(
  { net, numbering, positions, handles: _, guide, ...settings }: Snapshot,
  handles: unknown[],
): object {
  return {
    ...settings,
    // A mesh is not for links; projects have it beside their states.
    ...(guide && 'own' in guide ? { guide } : {}),
    numbering: numbering ?? null,
    handles,
  };
}

/** `[vertex, anchor]`, the target unless the handle is at rest, and what else is said of it, if anything.
 *  @param rest targets that are the rest positions need no place; null: all are written. */
export function writeHandle({ vertex, anchor, target, ...more }: HandleData, rest: Float64Array | null): unknown[] {
  const atRest = rest !== null && target.every((x, axis) => x === rest[3 * vertex + axis]);
  const said = given(more);
  return [vertex, anchor ? 1 : 0, ...(atRest ? [] : target), ...(Object.keys(said).length > 0 ? [said] : [])];
}

export function writeView(view: ViewState): object {
  return {
    ...view,
    camera: view.camera && writeCamera(view.camera),
    aspect: view.camera?.aspect,
  };
}

/** Digits of a camera that stands no farther from the origin than from what it looks at. */
const CAMERA_DIGITS = 7;
/** All that numbers have. */
const MOST_DIGITS = 17;

/** Farther from the origin with more digits: what is seen is between the two points. */
function writeCamera({ position, target }: CameraPlace): number[] {
  const apart = Math.hypot(...position.map((x, axis) => x - target[axis]!));
  const all = [...position, ...target];
  const far = Math.max(...all.map(Math.abs)) / apart;
  const digits = Math.min(MOST_DIGITS, CAMERA_DIGITS + Math.max(0, Math.floor(Math.log10(far))));
  return all.map((x) => Number(x.toPrecision(digits)));
}

/** As links and files have a net. */
export function netAsText(net: NetSource): { recipe: string } | FileText {
  if (!('mesh' in net)) return net;
  const { mesh, ...traits } = net;
  return { obj: objText(mesh), ...traits };
}

// ------------------------------------------------------------------------------------------------------------- reading

/** Many more methods than there are. */
const MOST_COMPARED = 100;

/** All these throw a Failure if it is no such thing. What only the net can tell (does vertex 9000 exist?) the core says when it is opened. */
export function readState(state: Untrusted): State<HandleSeed> {
  return {
    handles: state.at('handles').list().map(readHandle),
    method: readCoreName(state.at('method')),
    // Links made before there was a choice have none.
    initialisation: state.at('initialisation').maybe(readCoreName) ?? DEFAULT_INITIALISATION,
    options: readOptions(state.at('options')),
    settled: state.at('settled').flag(),
    ...given({
      symmetry: state.at('symmetry').maybe(readSymmetry),
      locality: state.at('locality').maybe((each) => each.positive()),
      influence: state.at('influence').maybe((each) => each.positive()),
      guide: state.at('guide').maybe((each) => ({ own: readCoreName(each.at('own')) })),
      experiment: state.at('experiment').maybe(readCoreName),
      ending: state.at('ending').maybe((each) => each.oneOf(ENDINGS)),
      compare: state.at('compare').maybe((each) => each.list(MOST_COMPARED).map(readCoreName)),
    }),
  };
}

/** null: the state is of a version that did not say, and was not looked at since. */
export function readNumbering(state: Untrusted): { numbering?: number } {
  const numbering = state.at('numbering');
  return numbering.value === null ? {} : { numbering: numbering.index(2 ** 32) };
}

export function readNet(net: Untrusted): NetSource {
  const recipe = net.at('recipe').maybe(readCoreName);
  if (recipe !== undefined) return { recipe };
  return { obj: net.at('obj').text(), ...readFileTraits(net) };
}

/** As what the browser keeps has it. */
export function readKeptNet(net: Untrusted): NetSource {
  const mesh = net.at('mesh').maybe(readMesh);
  return mesh === undefined ? readNet(net) : { mesh, ...readFileTraits(net) };
}

/** Whether it is one, the core says. */
function readMesh(mesh: Untrusted): Mesh {
  return {
    positions: mesh.at('positions').array(Float64Array),
    faceStart: mesh.at('faceStart').array(Int32Array),
    faceVertices: mesh.at('faceVertices').array(Int32Array),
  };
}

export function readFileTraits(net: Untrusted): Omit<FileText, 'obj'> {
  return {
    name: net.at('name').name(LONGEST_FILE_NAME),
    // Links made before there was a choice have none.
    ...given({
      restLengths: net.at('restLengths').maybe((each) => each.oneOf<RestLengths>(['automatic', 'equal', 'own'])),
    }),
  };
}

function readHandle(row: Untrusted): HandleSeed {
  const [vertex, anchor, ...others] = row.list();
  if (vertex === undefined || anchor === undefined) row.fail(readingWords.handle);
  const more = others.at(-1)?.isRecord ? others.pop() : undefined;
  if (others.length !== 0 && others.length !== 3) row.fail(readingWords.handle);
  const [x, y, z] = others.map((each) => each.number());
  return {
    vertex: vertex.index(2 ** 31),
    anchor: anchor.index(2) === 1,
    target: x === undefined || y === undefined || z === undefined ? null : [x, y, z],
    ...(more ? readMore(more) : {}),
  };
}

function readMore(more: Untrusted): Partial<HandleSeed> {
  return given({
    name: more.at('name').maybe((each) => each.text(LONGEST_NAME)),
    hidden: more.at('hidden').maybe((each) => each.flag()),
    weight: more.at('weight').maybe((each) => each.positive()),
    slides: more.at('slides').maybe((each) => each.oneOf(axesToSlide())),
  });
}

function readSymmetry(symmetry: Untrusted): Symmetry {
  return {
    axis: symmetry.at('axis').oneOf<Symmetry['axis']>(['x', 'y', 'z']),
    through: symmetry.at('through').oneOf<Symmetry['through']>(['centre', 'origin']),
  };
}

function readOptions(options: Untrusted): SolverOptions {
  const read = (each: Untrusted): number | boolean => (typeof each.value === 'boolean' ? each.value : each.number());
  return Object.fromEntries(options.fields().map(([name, each]) => [name, read(each)]));
}

export function readView(view: Untrusted): Scene['view'] {
  const camera = view.at('camera').value === null ? null : readCamera(view.at('camera'));
  return {
    camera: camera && { ...camera, ...given({ aspect: view.at('aspect').maybe((each) => each.positive()) }) },
    field: view.at('field').oneOf(FIELD_NAMES),
    colourMap: view.at('colourMap').oneOf(['paper', 'log']),
    showFaces: view.at('showFaces').flag(),
    ...given({
      ends: view.at('ends').maybe(readEnds),
      behind: view.at('behind').maybe((each) => each.flag()),
      rods: view.at('rods').maybe((each) => each.positive()),
      section: view.at('section').maybe(readSection),
      parallel: view.at('parallel').maybe((each) => each.flag()),
      guideHidden: view.at('guideHidden').maybe((each) => each.flag()),
      upAxis: view.at('upAxis').maybe(readUpAxis),
    }),
  };
}

export function readUpAxis(axis: Untrusted): UpAxis {
  return axis.oneOf<UpAxis>(['y', 'z']);
}

function readSection(section: Untrusted): Section {
  return { axis: section.at('axis').oneOf<Section['axis']>(['x', 'y', 'z']), at: section.at('at').number() };
}

function readEnds(ends: Untrusted): ViewState['ends'] {
  const read = (name: FieldName) =>
    ends.at(name).maybe((pair): Ends => {
      const [low = NaN, high = NaN, ...more] = pair.list().map((each) => each.number());
      return more.length === 0 && areEnds(fieldOf(name), [low, high]) ? [low, high] : pair.fail(readingWords.ends);
    });
  const names = FIELD_NAMES.filter((name) => fieldOf(name).ends);
  return given(Object.fromEntries(names.map((name) => [name, read(name)])));
}

/** Null, as if nobody had turned the view: of a net far from the origin, pages of before wrote one point twice. */
function readCamera(camera: Untrusted): CameraPlace | null {
  const [x, y, z, u, v, w, ...more] = camera.list().map((each) => each.number());
  const complete =
    x !== undefined && y !== undefined && z !== undefined && u !== undefined && v !== undefined && w !== undefined;
  if (!complete || more.length > 0) camera.fail(readingWords.camera);
  return x === u && y === v && z === w ? null : { position: [x, y, z], target: [u, v, w] };
}

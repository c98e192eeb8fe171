// Gives a module built from wasm/*.cpp the shape of chebnet.d.ts, and refuses what C++ would misread: there,
// a number that is no integer becomes one and a missing coordinate becomes 0.

/**
 * @import { Axes, Ball, Budget, ChangedMesh, Chebnet, Defect, DrapeArms, DrapeOptions, EditState, Editor, EqualizeOptions, EqualizeReport, Equalizer, ExactChange, Handle, LengthAdapter, Locality, Mesh, Point, RemeshOptions, RemeshPhase, RestLengths, RestSearch, SolveReport, Surface, TraceRow, WishedSingular } from './chebnet'
 * @import { Core, CoreDrapeOptions, CoreEqualizer, CoreExactChange, CoreHandles, CoreLengthAdapter, CoreLocality, CoreRemeshOptions, CoreRestSearch, CoreState, CoreSurface, Session } from '../build/wasm/chebnet_core.js'
 */

const LARGEST_INT = 2 ** 31 - 1;
/** In radians: k_usual_shear_limit of core/base/angle.h. */
const SHEAR_LIMIT = Math.PI / 6;
/** @satisfies {readonly (keyof TraceRow)[]} */
const TRACE_COLUMNS = /** @type {const} */ ([
  'iteration',
  'stage',
  'p',
  'energy',
  'maxDeviation',
  'gradientNorm',
  'step',
  'freeVertices',
  'assemblyMs',
  'factorisationMs',
  'lineSearchMs',
  'totalMs',
]);

/** @param {string} code @param {string} message */
function failure(code, message) {
  return Object.assign(new Error(message), { code });
}

/** What a message shows of a bad value. @param {unknown} value */
function shown(value) {
  if (typeof value === 'string') return JSON.stringify(value.slice(0, 60));
  if (ArrayBuffer.isView(value)) return value.constructor.name;
  return typeof value === 'object' && value !== null ? `an ${Array.isArray(value) ? 'array' : 'object'}` : String(value);
}

/** @param {unknown} value @param {string} what @param {string} code @returns {string} */
function text(value, what, code) {
  if (typeof value !== 'string') throw failure(code, `${what} must be text, not ${shown(value)}`);
  return value;
}

/** @template {object} T @param {T} value @param {string} what @returns {T} */
function record(value, what) {
  if (typeof value !== 'object' || value === null) throw failure('bad_option', `${what} must be an object, not ${shown(value)}`);
  return value;
}

/** @param {unknown} value @returns {value is ArrayLike<unknown>} */
function isList(value) {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

/** @param {unknown} value @returns {number} */
function vertexNumber(value) {
  if (typeof value !== 'number' || !Number.isInteger(value) || Math.abs(value) > LARGEST_INT) {
    throw failure('index_out_of_range', `a vertex must be an integer, not ${shown(value)}`);
  }
  return value;
}

/** @param {unknown} value @param {string} what @returns {Point} */
function triple(value, what) {
  const [x, y, z] = isList(value) && value.length === 3 ? Array.from(value) : [];
  if (typeof x !== 'number' || typeof y !== 'number' || typeof z !== 'number') {
    throw failure('non_finite', `${what} must be 3 numbers`);
  }
  return [x, y, z];
}

/** @param {unknown} value @param {number} vertex @returns {Point} */
function point(value, vertex) {
  return triple(value, `the target of vertex ${vertex}`);
}

/** Where a handle is moved to; one that is read with a net may be anywhere, as it always could. @param {Core} core @param {unknown} value @param {number} vertex @returns {Point} */
function target({ largestSize }, value, vertex) {
  const place = point(value, vertex);
  const isTooFar = (/** @type {number} */ each) => Number.isFinite(each) && Math.abs(each) > largestSize;
  if (place.some(isTooFar)) {
    throw failure('bad_scale', `the target of vertex ${vertex} is beyond ${largestSize}, farther away than any net can be`);
  }
  return place;
}

/** @param {unknown} value @param {string} what @returns {Point} */
function finite(value, what) {
  const numbers = triple(value, what);
  if (!numbers.every(Number.isFinite)) throw failure('non_finite', `${what} must be finite`);
  return numbers;
}

/** @param {unknown} value @param {string} what @param {number} smallest @param {number} largest @returns {number} */
function integer(value, what, smallest, largest) {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < smallest || value > largest) {
    throw failure('bad_option', `${what} must be an integer, ${smallest} … ${largest}, not ${shown(value)}`);
  }
  return value;
}

/** @param {unknown} value @param {string} what @returns {number} */
function size(value, what) {
  if (typeof value !== 'number') throw failure('bad_option', `${what} must be a number above 0, not ${shown(value)}`);
  return value;
}

/** By the sum of 1 for x, 2 for y and 4 for z. @type {readonly (Axes | undefined)[]} */
const AXES = [undefined, 'x', 'y', 'xy', 'z', 'xz', 'yz'];

/** @param {unknown} value @returns {number} */
function axesNumber(value) {
  const number = AXES.findIndex((axes) => axes === value);
  if (number >= 0) return number;
  throw failure('bad_option', `a handle slides along one of ${AXES.slice(1).join(', ')}, not ${shown(value)}`);
}

/** @param {readonly Handle[]} handles @returns {CoreHandles} */
function flatHandles(handles) {
  if (!Array.isArray(handles)) throw failure('bad_option', `handles must be an array, not ${shown(handles)}`);
  return {
    vertices: Int32Array.from(handles, (handle) => vertexNumber(handle?.vertex)),
    targets: Float64Array.from(handles.flatMap((handle) => point(handle.target, handle.vertex))),
    weights: Float64Array.from(handles, ({ weight = Infinity }) => size(weight, 'the weight of a handle')),
    slides: Int32Array.from(handles, ({ slides }) => axesNumber(slides)),
  };
}

/** @param {Locality} locality @param {number} numbers of all positions @returns {CoreLocality} */
function flatLocality({ radius, origins, heldAt }, numbers) {
  return {
    radius: size(radius, 'a locality'),
    origins: numbersOf(origins, 'the origins of a locality'),
    heldAt: heldAt === undefined ? new Float64Array() : allPositions(heldAt, numbers),
  };
}

/** @param {unknown} value @param {number} numbers how many there must be @returns {Float64Array} */
function allPositions(value, numbers) {
  if (value instanceof Float64Array && value.length === numbers) return value;
  const got = value instanceof Float64Array ? `one of ${value.length}` : shown(value);
  throw failure('index_out_of_range', `positions must be a Float64Array of ${numbers} numbers, not ${got}`);
}

/** @param {string} name @param {unknown} value @returns {[string, string]} */
function option(name, value) {
  text(name, 'the name of an option', 'bad_option');
  if (typeof value !== 'number' && typeof value !== 'boolean') {
    throw failure('bad_option', `option ${name} must be a number or true or false, not ${shown(value)}`);
  }
  return [name, String(value)];
}

/** Of the two modules one cannot do all. @param {Core} core */
function wholeCore(core) {
  if (!('openSurface' in core)) throw failure('left_out', 'chebnet_core can do this, chebnet_editor cannot');
  return core;
}

/** @param {Budget} budget @returns {[number, number]} iterations and milliseconds */
function limits(budget) {
  const { iterations = LARGEST_INT, milliseconds = Infinity } = record(budget, 'a budget');
  if (typeof milliseconds !== 'number' || !(milliseconds >= 0)) {
    throw failure('bad_option', `a budget of milliseconds must be a number from 0, not ${shown(milliseconds)}`);
  }
  const count = iterations === Infinity ? LARGEST_INT : iterations;
  return [integer(count, 'a budget of iterations', 0, LARGEST_INT), milliseconds];
}

/** @param {Float64Array} flat @returns {TraceRow[]} */
function traceRows(flat) {
  const rows = [];
  for (let i = 0; i < flat.length; i += TRACE_COLUMNS.length) {
    const row = Object.fromEntries(TRACE_COLUMNS.map((name, k) => [name, flat[i + k]]));
    rows.push(/** @type {TraceRow} */ (/** @type {unknown} */ (row)));
  }
  return rows;
}

/** @param {unknown} value @returns {Uint8Array} */
function bytes(value) {
  if (!(value instanceof Uint8Array)) throw failure('bad_syntax', `the bytes of a file must be a Uint8Array, not ${shown(value)}`);
  return value;
}

/** Refuses what C++ could not walk through; which vertices a face names is checked by the core. @param {Mesh} value */
function mesh(value) {
  const { positions, faceStart, faceVertices } = value ?? {};
  if (!(positions instanceof Float64Array) || positions.length % 3 !== 0) {
    throw failure('bad_syntax', 'the positions of a mesh must be a Float64Array of 3 numbers a vertex');
  }
  if (!(faceStart instanceof Int32Array) || !(faceVertices instanceof Int32Array)) {
    throw failure('bad_syntax', 'the faces of a mesh must be two Int32Arrays, faceStart and faceVertices');
  }
  const ascends = faceStart.every((start, f) => start >= (faceStart[f - 1] ?? 0));
  if (faceStart[0] !== 0 || !ascends || faceStart.at(-1) !== faceVertices.length) {
    throw failure('bad_syntax', 'faceStart of a mesh must ascend from 0 to the length of faceVertices');
  }
  return value;
}

/** @param {RestLengths} value */
function restLengths(value) {
  return text(value, 'the choice of rest lengths', 'bad_option');
}

/** @param {readonly Defect[]} value */
function defects(value) {
  if (!Array.isArray(value)) throw failure('bad_option', `the defects to repair must be an array, not ${shown(value)}`);
  return value.map((defect) => text(defect, 'a defect', 'bad_option'));
}

/**
 * Holds what is on the other side until it is disposed.
 * @template {{ delete(): void }} T
 */
class Owner {
  /** @type {T | null} */
  #owned;
  #what;

  /** @param {T} owned @param {string} what it is, for messages */
  constructor(owned, what) {
    this.#owned = owned;
    this.#what = what;
  }

  /** @protected */
  get open() {
    if (this.#owned === null) throw failure('disposed', `this ${this.#what} was disposed and cannot be used any more`);
    return this.#owned;
  }

  dispose() {
    this.#owned?.delete();
    this.#owned = null;
  }
}

/** @implements {Editor} @extends {Owner<Session>} */
class WasmEditor extends Owner {
  /** @type {Core} */
  #core;

  /** @param {Core} core @param {Session} session */
  constructor(core, session) {
    super(session, 'editor');
    this.#core = core;
    this.info = session.info();
    this.edges = session.edges();
    this.faceStart = session.faceStart();
    this.faceVertices = session.faceVertices();
    this.restPositions = session.restPositions();
    this.restLengths = session.restLengths();
    this.suggestedHandles = session.suggestedHandles();
  }

  netLines() {
    return this.open.netLines();
  }

  rods() {
    return this.open.rods();
  }

  boundaryLoops() {
    return this.open.boundaryLoops();
  }

  flatPattern() {
    return this.open.flatPattern();
  }

  get method() {
    return this.open.method();
  }

  /** @param {string} name */
  setMethod(name) {
    this.changeState({ method: name });
  }

  get initialisation() {
    return this.open.initialisation();
  }

  /** @param {string} initialisation */
  setInitialisation(initialisation) {
    this.changeState({ initialisation });
  }

  options() {
    const rows = this.open.options();
    return Object.fromEntries(rows.map(({ name, kind, value }) => [name, kind === 'flag' ? value !== 0 : value]));
  }

  /** @param {string} name @param {number | boolean} value */
  setOption(name, value) {
    this.changeState({ options: { ...this.options(), [name]: value } });
  }

  /** @returns {EditState} */
  state() {
    const locality = this.open.locality();
    return {
      handles: this.handles(),
      method: this.method,
      initialisation: this.initialisation,
      options: this.options(),
      locality: locality && { ...locality, origins: Array.from(locality.origins) },
      positions: this.positions(),
    };
  }

  /** @param {EditState} state */
  setState(state) {
    this.open.setState(...this.#flatState(state));
  }

  /** @param {Partial<EditState>} change */
  changeState(change) {
    this.open.changeState(...this.#flatState({ ...this.state(), ...change }));
  }

  /** @param {EditState} state @returns {CoreState} */
  #flatState(state) {
    const { handles, method, initialisation, options, locality, positions } = record(state, 'the state of an edit');
    const numbers = this.restPositions.length;
    return [
      text(method, 'the name of a method', 'bad_option'),
      text(initialisation, 'an initialisation', 'bad_option'),
      Object.entries(record(options, 'the options of an edit')).flatMap(([name, value]) => option(name, value)),
      flatHandles(handles),
      locality ? flatLocality(locality, numbers) : null,
      allPositions(positions, numbers),
    ];
  }

  handles() {
    const vertices = this.open.handleVertices();
    const targets = this.open.handleTargets();
    const weights = this.open.handleWeights();
    const slides = this.open.handleSlides();
    return Array.from(vertices, (vertex, i) => {
      const axes = AXES[slides[i] ?? 0];
      return {
        vertex,
        target: point(Array.from(targets.subarray(3 * i, 3 * i + 3)), vertex),
        ...(weights[i] === Infinity ? {} : { weight: weights[i] ?? 0 }),
        ...(axes === undefined ? {} : { slides: axes }),
      };
    });
  }

  /** @param {readonly Handle[]} handles */
  setHandles(handles) {
    this.changeState({ handles, locality: null });
  }

  /** @param {number} radius @param {readonly number[]} origins */
  setLocality(radius, origins) {
    this.changeState({ locality: { radius, origins } });
  }

  flipped() {
    return this.open.flipped();
  }

  /** @param {number} vertex @returns {Ball[]} */
  reach(vertex) {
    const flat = this.open.reach(vertexNumber(vertex));
    return Array.from({ length: flat.length / 5 }, (_, i) => ({
      vertex: flat[5 * i] ?? 0,
      centre: point(Array.from(flat.subarray(5 * i + 1, 5 * i + 4)), vertex),
      radius: flat[5 * i + 4] ?? 0,
    }));
  }

  /** @param {number} radius @param {readonly number[]} origins */
  mobility(radius, origins) {
    return this.open.mobility(size(radius, 'a locality'), numbersOf(origins, 'the origins of a locality'));
  }

  /** @param {number} vertex @param {readonly [number, number, number]} place */
  moveHandle(vertex, place) {
    this.open.moveHandle(vertexNumber(vertex), ...target(this.#core, place, vertex));
  }

  /** @param {number} vertex @param {readonly [number, number, number]} place @param {Axes} [along] */
  dragHandle(vertex, place, along) {
    this.open.dragHandle(vertexNumber(vertex), ...target(this.#core, place, vertex), axesNumber(along));
  }

  releaseHandles() {
    this.open.releaseHandles();
  }

  /** @param {readonly Handle[]} [wanted] @returns {LengthAdapter} */
  lengthAdapter(wanted = []) {
    const { vertices, targets } = flatHandles(wanted);
    return new WasmSearch(wholeCore(this.#core).lengthAdapter(this.open, vertices, targets), 'adapter', () => this.open);
  }

  /** @returns {RestSearch} */
  restSearch() {
    return new WasmSearch(wholeCore(this.#core).restSearch(this.open), 'search', () => this.open);
  }

  forces() {
    const forces = wholeCore(this.#core).forces(this.open);
    if (forces === null) return null;
    const handles = Array.from({ length: forces.handles.length / 3 }, (_, i) =>
      triple(Array.from(forces.handles.subarray(3 * i, 3 * i + 3)), 'a force'),
    );
    return { ...forces, handles };
  }

  get holdsBack() {
    return this.open.holdsBack();
  }

  /** @param {Budget} [budget] @returns {SolveReport} */
  solve(budget = {}) {
    const report = this.open.solve(...limits(budget));
    return { ...report, trace: traceRows(report.trace) };
  }

  reset() {
    this.open.reset();
  }

  /** @param {Surface | null} surface */
  setGuide(surface) {
    if (surface === null) return this.#core.unguide?.(this.open);
    wholeCore(this.#core).guide(this.open, coreGuide(surface));
  }

  positions() {
    return this.open.positions();
  }

  /** @param {Float64Array} positions */
  setPositions(positions) {
    this.changeState({ positions, locality: null });
  }

  fields() {
    return this.open.fields();
  }

  bend() {
    return this.open.bend();
  }

  smallestAngle() {
    return this.open.smallestAngle();
  }

  handleError() {
    return this.open.handleError();
  }

  unreachablePairs() {
    return this.open.unreachablePairs();
  }

  toObj(digits = 17) {
    return this.open.toObj(integer(digits, 'the number of digits', 1, 17));
  }

  edgeTable() {
    return this.open.edgeTable();
  }

  rodTable() {
    return this.open.rodTable();
  }

  /** @param {string} format */
  toFile(format) {
    return this.open.toFile(text(format, 'a format', 'bad_option'));
  }
}

/** What looks for another state of an editor.
 *  @template {CoreLengthAdapter | CoreRestSearch} Core
 *  @extends {Owner<Core>} */
class WasmSearch extends Owner {
  #session;

  /** @param {Core} search @param {string} name @param {() => Session} session that of the editor it was made by */
  constructor(search, name, session) {
    super(search, name);
    this.#session = session;
  }

  /** @param {Budget} [budget] @returns {ReturnType<Core['solve']>} */
  solve(budget = {}) {
    return /** @type {ReturnType<Core['solve']>} */ (this.open.solve(...limits(budget)));
  }

  accept() {
    this.open.accept(this.#session());
  }
}

/** @implements {Equalizer} @extends {Owner<CoreEqualizer>} */
class WasmEqualizer extends Owner {
  /** @param {CoreEqualizer} equalizer */
  constructor(equalizer) {
    super(equalizer, 'equalizer');
  }

  /** @param {Budget} [budget] @returns {EqualizeReport} */
  solve(budget = {}) {
    return this.open.solve(...limits(budget));
  }

  positions() {
    return this.open.positions();
  }

  surfacePositions() {
    return this.open.surfacePositions();
  }
}

/** @implements {ExactChange} @extends {Owner<CoreExactChange>} */
class WasmExactChange extends Owner {
  /** @param {CoreExactChange} exact */
  constructor(exact) {
    super(exact, 'change');
  }

  /** @param {Budget} [budget] */
  solve(budget = {}) {
    return this.open.solve(...limits(budget));
  }

  positions() {
    return this.open.positions();
  }
}

/** @param {readonly number[]} numbers @param {string} what */
function numbersOf(numbers, what) {
  if (!isList(numbers)) throw failure('bad_option', `${what} must be an array, not ${shown(numbers)}`);
  return Int32Array.from(numbers, vertexNumber);
}

/** @param {Core} core @param {Mesh} original @param {EqualizeOptions} options */
function newEqualizer(core, original, options) {
  const { length = 'mean', handles = [], method, shearLimit = SHEAR_LIMIT, guide } = record(options, 'options of equalising');
  const vertices = numbersOf(handles, 'handles');
  const [choice, number] = typeof length === 'number' ? ['given', length] : [text(length, 'a length', 'bad_option'), 0];
  return new WasmEqualizer(
    core.equalizer(mesh(original), {
      choice,
      length: number,
      handles: vertices,
      method: method === undefined ? '' : text(method, 'a method', 'bad_option'),
      shearLimit: size(shearLimit, 'the shear limit'),
      guide: guide === undefined ? null : coreGuide(guide),
    }),
  );
}

/** @param {ChangedMesh} changed @returns {ChangedMesh} */
function changedMesh(changed) {
  const { mesh: given, origins, lengthFactor, keepsEdges } = record(changed, 'a changed mesh');
  if (!(origins instanceof Int32Array)) throw failure('bad_syntax', 'the origins of a changed mesh must be an Int32Array');
  return {
    mesh: mesh(given),
    origins,
    lengthFactor: size(lengthFactor, 'the length factor of a changed mesh'),
    keepsEdges: Boolean(keepsEdges),
  };
}

/** @param {DrapeOptions} options @returns {CoreDrapeOptions} */
function allDrapeOptions(options) {
  const { seed, direction, length, angle = Math.PI / 2, smallestAngle = SHEAR_LIMIT } = record(options, 'options of draping');
  const { reach, border, arms, along = [], leave = 0 } = options;
  return {
    seed: triple(seed, 'the seed'),
    direction: triple(direction, 'the direction'),
    length: size(length, 'an edge length'),
    angle: size(angle, 'the angle at the seed'),
    smallestAngle: size(smallestAngle, 'the shear limit'),
    reach: integer(reach ?? LARGEST_INT, 'the reach', 1, LARGEST_INT),
    border: /** @type {CoreDrapeOptions['border']} */ (text(border ?? 'beyond', 'what happens at the border', 'bad_option')),
    arms: /** @type {DrapeArms} */ (text(arms ?? 'geodesic', 'the way of the arms', 'bad_option')),
    along: curvePoints(along, 'the curve'),
    leave: size(leave, 'how far the net may leave the surface'),
  };
}

/** @template T @param {readonly T[]} value @param {string} what */
function list(value, what) {
  if (!Array.isArray(value)) throw failure('bad_option', `${what} must be an array, not ${shown(value)}`);
  return /** @type {readonly T[]} */ (value);
}

/** @param {readonly Readonly<Point>[]} points @param {string} what */
function curvePoints(points, what) {
  return Float64Array.from(list(points, what).flatMap((point) => finite(point, `a point of ${what}`)));
}

/** @param {RemeshOptions} options @returns {CoreRemeshOptions} */
function allRemeshOptions(options) {
  const { cells = 4000, length = 0, smallestAngle = SHEAR_LIMIT, smoothing = 1, fewest = false } = record(options, 'options of a net over a surface');
  const { crease, markedCreases = [], border = 'fitting', singular = [], forbidden = [], only = false } = options;
  return {
    cells: integer(cells, 'a number of cells', 1, LARGEST_INT),
    length: size(length, 'an edge length'),
    smallestAngle: size(smallestAngle, 'the shear limit'),
    smoothing: size(smoothing, 'the smoothing'),
    fewest: fewest === true,
    crease: size(crease ?? 0, 'the angle of creases'),
    triesCreases: crease === undefined,
    markedCreases: list(markedCreases, 'marked creases').map((points) => curvePoints(points, 'a marked crease')),
    border: /** @type {CoreRemeshOptions['border']} */ (text(border, 'what happens at the border', 'bad_option')),
    singular: list(singular, 'singular vertices').map((each) => ({
      point: finite(record(each, 'a singular vertex').point, 'the place of a singular vertex'),
      valence: /** @type {WishedSingular['valence']} */ (integer(each.valence, 'the valence of a singular vertex', 3, LARGEST_INT)),
    })),
    forbidden: list(forbidden, 'forbidden regions').map((each) => ({
      centre: finite(record(each, 'a forbidden region').centre, 'the centre of a forbidden region'),
      radius: size(each.radius, 'the radius of a forbidden region'),
    })),
    only: only === true,
  };
}

/** @implements {Surface} @extends {Owner<CoreSurface>} */
class WasmSurface extends Owner {
  /** @param {CoreSurface} surface */
  constructor(surface) {
    super(surface, 'surface');
    this.positions = surface.positions();
    this.normals = surface.normals();
    this.triangles = surface.triangles();
  }

  /** For editors and equalizers. */
  get core() {
    return this.open;
  }

  describe() {
    return this.open.describe();
  }

  /** @param {Readonly<Point>} near */
  nearest(near) {
    return this.open.nearest(...finite(near, 'a point'));
  }

  /** @param {Readonly<Point>} origin @param {Readonly<Point>} direction */
  hit(origin, direction) {
    return this.open.hit(Float64Array.of(...finite(origin, 'an origin'), ...finite(direction, 'a direction')));
  }

  /** @param {number} cells */
  suggest(cells) {
    return this.open.suggest(integer(cells, 'a number of cells', 1, LARGEST_INT));
  }

  /** @param {Omit<DrapeOptions, 'seed' | 'direction'> & Partial<Pick<DrapeOptions, 'direction'>>} options */
  propose(options) {
    const { direction } = options;
    const all = allDrapeOptions({ ...options, seed: [0, 0, 0], direction: direction ?? [1, 0, 0] });
    return direction === undefined ? this.open.propose(all) : this.open.proposeSeeds(all);
  }

  /** @param {DrapeOptions} options */
  drape(options) {
    return this.open.drape(allDrapeOptions(options));
  }

  /** @param {readonly (readonly Readonly<Point>[])[]} cuts */
  cut(cuts) {
    return new WasmSurface(this.open.cut(list(cuts, 'cuts').map((points) => curvePoints(points, 'a cut'))));
  }

  /** @param {readonly Readonly<Point>[]} points */
  cutPath(points) {
    return this.open.cutPath(curvePoints(points, 'a cut'));
  }

  /** @param {Readonly<Point> | null} from */
  shortestCut(from) {
    return this.open.shortestCut(from === null ? null : finite(from, 'the beginning of a cut'));
  }

  /** @param {DrapeOptions} options */
  drapePieces(options) {
    return this.open.drapePieces(allDrapeOptions(options));
  }

  /** @param {DrapeOptions} options @param {number} most */
  proposeCuts(options, most) {
    return this.open.proposeCuts(allDrapeOptions(options), integer(most, 'a number of cuts', 1, 100));
  }

  /** @param {RemeshOptions} [options] @param {(phase: RemeshPhase, done: number) => void} [progress] */
  remesh(options = {}, progress = () => {}) {
    if (typeof progress !== 'function') throw failure('bad_option', `progress must be a function, not ${shown(progress)}`);
    return this.open.remesh(allRemeshOptions(options), progress);
  }

  /** @param {Mesh} net @param {number} [length] */
  measure(net, length) {
    if (length === undefined) return this.open.measure(mesh(net), 0);
    const what = 'the length of whole edges';
    if (!(size(length, what) > 0)) throw failure('bad_option', `${what} must be a number above 0, not ${shown(length)}`);
    return this.open.measure(mesh(net), length);
  }
}

/** @param {unknown} surface */
function coreGuide(surface) {
  if (surface instanceof WasmSurface) return surface.core;
  throw failure('bad_option', `a guide must be a surface or null, not ${shown(surface)}`);
}

/** @param {Core} core @returns {Chebnet} */
function facade(core) {
  return {
    shapes: () => core.shapes(),
    methods: () => core.methods(),
    initialisations: () => core.initialisations(),
    formats: () => core.formats(),
    options: () => core.defaultOptions(),
    memory: () => core.memory(),
    openRecipe: (recipe) => new WasmEditor(core, core.openRecipe(text(recipe, 'a recipe', 'bad_syntax'))),
    openObj: (obj, name = 'OBJ', lengths = 'automatic') =>
      new WasmEditor(
        core,
        core.openObj(text(obj, 'an OBJ', 'bad_syntax'), text(name, 'the name of an OBJ', 'bad_syntax'), restLengths(lengths)),
      ),
    openMesh: (given, lengths = 'automatic') => new WasmEditor(core, core.openMesh(mesh(given), restLengths(lengths))),
    readMesh: (file, name) => core.readMesh(bytes(file), text(name, 'the name of a file', 'bad_syntax')),
    defects: () => core.defects(),
    repairMesh: (given, chosen = core.defects(), mergeTolerance = core.mergeTolerance) => {
      if (typeof mergeTolerance !== 'number') {
        throw failure('bad_option', `the tolerance for merging vertices must be a number, not ${shown(mergeTolerance)}`);
      }
      return core.repairMesh(mesh(given), defects(chosen), mergeTolerance);
    },
    change: (given, name, place = {}) => {
      const { vertices = [], edges = [] } = record(place, 'the place of a change');
      return core.change(
        mesh(given),
        text(name, 'the name of a change', 'bad_option'),
        numbersOf(vertices, 'vertices'),
        numbersOf(edges, 'edges'),
      );
    },
    exactChange: (changed, options) => {
      const { length, held = [], shearLimit = SHEAR_LIMIT } = record(options, 'options of an exact change');
      return new WasmExactChange(
        core.exactChange(changedMesh(changed), {
          length: length === null ? null : size(length, 'the length of edges'),
          held: numbersOf(held, 'vertices that are held'),
          shearLimit: size(shearLimit, 'the shear limit'),
        }),
      );
    },
    equalizer: (original, options = {}) => newEqualizer(core, original, options),
    openSurface: (given) => new WasmSurface(wholeCore(core).openSurface(mesh(given))),
    ownSurfaces: () => wholeCore(core).ownSurfaces(),
    ownSurface: (name) => new WasmSurface(wholeCore(core).ownSurface(text(name, 'the name of a surface', 'bad_option'))),
  };
}

/**
 * What loads a module, once; `create` is the one that Emscripten made.
 * @param {typeof import('../build/wasm/chebnet_core.js').default} create
 * @returns {typeof import('./chebnet').loadChebnet}
 */
export function loaderOf(create) {
  /** @type {Promise<Chebnet> | null} */
  let loading = null;
  return ({ wasmUrl, wasmBinary } = {}) => {
    loading ??= create({
      ...(wasmUrl === undefined ? {} : { locateFile: () => wasmUrl }),
      ...(wasmBinary === undefined ? {} : { wasmBinary }),
    }).then(facade, (/** @type {unknown} */ reason) => {
      loading = null; // another try may have better luck
      throw failure('internal', `the WebAssembly module cannot be loaded: ${String(reason)}`);
    });
    return loading;
  };
}

/** Arguments of the calls of `window.chebnet`, which may be anything, from a script or a host page. Each reader gives a value
 *  of its type or throws a Failure that says which argument must be what. */
import type { Axes } from '../../wasm/chebnet';
import { readCoreName } from './document/core_name';
import { axesToSlide, type GuideSource, LONGEST_FILE_NAME, LONGEST_NAME, type Vec3 } from './document/document';
import type { Untrusted } from './document/untrusted';
import { Failure } from './failure';
import { words } from './language/language';
import { scriptWords } from './language/scripts';

export type ScriptNet = { recipe: string } | { obj: string; name?: string };

export interface ScriptHandle {
  vertex: number;
  /** Without it, where the vertex stands. */
  target?: Vec3;
  /** Locked: drawn apart, and no hand moves it. Without it, a handle without a target is locked. */
  anchor?: boolean;
  /** See HandleData. */
  name?: string;
  hidden?: boolean;
  weight?: number;
  slides?: Axes;
}

/** One of our own by its name, or polygons by the numbers of their vertices. */
export type ScriptSurface =
  | { own: string }
  | { vertices: readonly Vec3[]; faces: readonly (readonly number[])[]; name?: string };

/** By the names in core/solve/options.h. */
export type ScriptOptions = { method?: string; initialisation?: string } & Record<
  string,
  number | boolean | string | undefined
>;

/** Of a surface's faces, for each that it may have. A list may stand in another one many times, and take no more room there. */
const MOST_CORNERS = 10;

const NET_FIELDS = ['recipe', 'obj', 'name'];
const HANDLE_FIELDS = ['vertex', 'target', 'anchor', 'name', 'hidden', 'weight', 'slides'];
const SURFACE_FIELDS = ['own', 'vertices', 'faces', 'name'];

/** @param longest characters of an OBJ. */
export function readNet(net: Untrusted, longest = Infinity): ScriptNet {
  refuseOthers(net, NET_FIELDS);
  const recipe = net.at('recipe').maybe(readRecipe);
  if (recipe !== undefined) return { recipe };
  const obj = net.at('obj').maybe((each) => each.text(longest)) ?? net.fail(scriptWords.net);
  const name = net.at('name').maybe((each) => each.name(LONGEST_FILE_NAME));
  return name === undefined ? { obj } : { obj, name };
}

/** As people type it: its shape may be called as its button says, too. */
function readRecipe(text: Untrusted): string {
  const [shape = '', ...parameters] = readCoreName(text).split(':');
  const called = shape.trim().toLowerCase();
  const [name = called] = Object.entries(words.core.shapes()).find(([, title]) => title === called) ?? [];
  return [name, ...parameters].join(':');
}

/** @param most handles in the list. */
export function readHandles(handles: Untrusted, most = Infinity): ScriptHandle[] {
  return handles.list(most).map(readHandle);
}

function readHandle(handle: Untrusted): ScriptHandle {
  refuseOthers(handle, HANDLE_FIELDS);
  const target = handle.at('target').maybe((each) => each.point());
  const anchor = handle.at('anchor').maybe((each) => each.flag());
  const name = handle.at('name').maybe((each) => each.name(LONGEST_NAME));
  const hidden = handle.at('hidden').maybe((each) => each.flag());
  const weight = handle.at('weight').maybe((each) => each.positive());
  const slides = handle.at('slides').maybe((each) => each.oneOf(axesToSlide()));
  return {
    vertex: readVertex(handle.at('vertex')),
    ...(target === undefined ? {} : { target }),
    ...(anchor === undefined ? {} : { anchor }),
    ...(name === undefined ? {} : { name }),
    ...(hidden === undefined ? {} : { hidden }),
    ...(weight === undefined ? {} : { weight }),
    ...(slides === undefined ? {} : { slides }),
  };
}

/** Whether the net has it, the core says. */
export function readVertex(vertex: Untrusted): number {
  return vertex.index(2 ** 31);
}

export function readLocality(radius: Untrusted): number | null {
  return radius.value === null ? null : radius.positive();
}

/** Null: there is to be none. */
export function readGuide(surface: Untrusted, most = Infinity): ScriptSurface | null {
  return surface.value === null ? null : readSurface(surface, most);
}

/** Whether there is such a surface, the core says.
 *  @param most vertices or faces. */
export function readSurface(surface: Untrusted, most = Infinity): ScriptSurface {
  refuseOthers(surface, SURFACE_FIELDS);
  const own = surface.at('own').maybe(readCoreName);
  if (own !== undefined) return { own };
  if (surface.at('vertices').value === undefined) surface.fail(scriptWords.surface);
  const name = surface.at('name').maybe((each) => each.name(LONGEST_FILE_NAME));
  let corners = MOST_CORNERS * most;
  return {
    vertices: surface
      .at('vertices')
      .list(most)
      .map((each) => each.point()),
    faces: surface
      .at('faces')
      .list(most)
      .map((face) => {
        const ring = face.list(corners).map(readVertex);
        corners -= ring.length;
        return ring;
      }),
    ...(name === undefined ? {} : { name }),
  };
}

export function guideOf(surface: ScriptSurface): GuideSource {
  if ('own' in surface) return surface;
  const { vertices, faces, name = 'surface' } = surface;
  const faceStart = new Int32Array(faces.length + 1);
  faces.forEach((face, i) => (faceStart[i + 1] = faceStart[i]! + face.length));
  const mesh = {
    positions: Float64Array.from(vertices.flat()),
    faceStart,
    faceVertices: Int32Array.from(faces.flat()),
  };
  return { name, mesh };
}

/** Whether there are such, the core says. */
export function readOptions(options: Untrusted): ScriptOptions {
  const given = options.fields().filter(([, each]) => each.value !== undefined);
  return Object.fromEntries(
    given.map(([name, each]) => [
      name,
      name === 'method' || name === 'initialisation' ? readCoreName(each) : readSetting(each),
    ]),
  );
}

function readSetting(setting: Untrusted): number | boolean {
  return typeof setting.value === 'boolean' ? setting.value : setting.number();
}

/** One that does not exist would have been a wish. */
function refuseOthers(record: Untrusted, known: readonly string[]): void {
  const isOther = ([name, { value }]: [string, Untrusted]) => value !== undefined && !known.includes(name);
  const [, other] = record.fields().find(isOther) ?? [];
  if (other) throw new Failure(other.code, scriptWords.unknownField(other.path, known));
}

export function readEvent(event: Untrusted): 'frame' | 'settled' | 'error' {
  return event.oneOf(['frame', 'settled', 'error']);
}

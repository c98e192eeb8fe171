/**
 * Projects: a document with its history, exact to the last bit. As a record they are what the browser keeps; as text,
 * one JSON file, where positions are the base64 of their 64-bit floats and meshes OBJ. Nets and positions that states
 * share are written once, in records handles, too; in a file each state has its own.
 */
import { Failure } from '../failure';
import { panelWords } from '../language/panels';
import { fromBase64, toBase64 } from './base64';
import { netAsText, readUpAxis, writeHandle, writeState, writeView } from './codec';
import {
  type GuideFile,
  type HandleData,
  type HandleSeed,
  LONGEST_FILE_NAME,
  LONGEST_PROJECT_NAME,
  type NetSource,
  type ViewState,
} from './document';
import { given } from './given';
import { Untrusted } from './untrusted';
import { readName, writeName } from './naming';
import { Measure } from './undo';
import type { Entry, Snapshot } from './undo';
import { doSlide, readerOf, VERSION, VERSION_WITH_ARRAYS, VERSION_WITH_SLIDES } from './versions';
import type { Reader } from './versions';

export { writeView };

export const PROJECT_ENDING = '.chebnet.json';
/** Larger files are not read. */
const LARGEST_PROJECT = 64e6;
/** Bytes of nets, positions and handles in a file; as base64 positions take a third more. */
const LARGEST_STATES = 36e6;
const MOST_STATES = 10_000;

export interface Project {
  /** Of the history; `entries[present]` is the document. */
  entries: Entry[];
  present: number;
  view: ViewState;
  /** That its author gave it, in files. */
  title?: string | undefined;
}

/** A project as plain data. Its arrays are not copied. */
type ProjectRecord = { chebnet: number; positions: (Float64Array | string)[]; guides?: GuideFile[] } & Record<
  string,
  unknown
>;

// ------------------------------------------------------------------------------------------------------------- writing

/** @param largest bytes of nets, positions and handles; of the history as much is written as fits, the document always.
 *  @param measure counts them. */
export function writeProject(project: Project, largest: number, measure = new Measure()): ProjectRecord {
  const { entries, present } = cut(project, largest, measure);
  const nets = new Numbered<NetSource>();
  const positions = new Numbered<Float64Array>();
  const guides = new Numbered<GuideFile>();
  const rowOf = once((handle: HandleData) => writeHandle(handle, null));
  const rowsOf = once((handles: readonly HandleData[]) => handles.map(rowOf));
  const states = entries.map(({ name, state, upAxis }) => ({
    ...writeName(name),
    ...writeState(state, rowsOf(state.handles)),
    ...given({ upAxis }),
    net: nets.numberOf(state.net),
    positions: state.positions && positions.numberOf(state.positions),
    ...(state.guide && 'mesh' in state.guide ? { guideFile: guides.numberOf(state.guide) } : {}),
  }));
  return {
    chebnet: versionOf(entries, nets.values),
    ...(project.title ? { title: project.title } : {}),
    view: writeView(project.view),
    present,
    states,
    nets: nets.values,
    positions: positions.values,
    ...(guides.values.length > 0 ? { guides: guides.values } : {}),
  };
}

function versionOf(entries: readonly Entry[], nets: readonly NetSource[]): number {
  if (entries.some(({ state }) => doSlide(state.handles))) return VERSION_WITH_SLIDES;
  return nets.some((net) => 'mesh' in net) ? VERSION_WITH_ARRAYS : VERSION;
}

/** How many bytes the text of a file has at least, a line for each vertex and face and the positions: far too many are not
 *  written out to be counted, which would block the page. */
export function leastBytes({ entries, present }: Project): number {
  const { net, positions } = entries[present]!.state;
  const base64 = (4 / 3) * (positions?.byteLength ?? 0);
  if (!('mesh' in net)) return base64;
  const { positions: rest, faceVertices } = net.mesh;
  const vertices = rest.length / 3;
  return base64 + 'v 0 0 0\n'.length * vertices + faceVertices.length * (Math.log10(vertices) + 0.5);
}

/** The text of a file. */
export function projectText(project: Project): string {
  const written = writeProject(withTexts(project), LARGEST_STATES, new Measure(false));
  const positions = written.positions.map((each) => (typeof each === 'string' ? each : toBase64(bytesOf(each))));
  return JSON.stringify({
    ...written,
    positions,
    ...(written.guides ? { guides: written.guides.map(guideText) } : {}),
  });
}

/** Its arrays as base64. */
function guideText({ name, mesh }: GuideFile): object {
  return {
    name,
    mesh: {
      positions: toBase64(bytesOf(mesh.positions)),
      faceStart: toBase64(bytesOf(mesh.faceStart)),
      faceVertices: toBase64(bytesOf(mesh.faceVertices)),
    },
  };
}

function withTexts(project: Project): Project {
  const texts = new Map<NetSource, NetSource>();
  const textOf = (net: NetSource): NetSource => {
    const text = texts.get(net) ?? netAsText(net);
    texts.set(net, text);
    return text;
  };
  const entries = project.entries.map((entry) => ({
    ...entry,
    state: { ...entry.state, net: textOf(entry.state.net) },
  }));
  return { ...project, entries };
}

/** The entries around the present one that fit: first those before it, then those after it. */
function cut({ entries, present }: Project, largest: number, measure: Measure): Pick<Project, 'entries' | 'present'> {
  const fits = (entry: Entry | undefined): boolean => {
    if (entry === undefined) return false;
    measure.add(entry.state);
    return measure.bytes <= largest;
  };
  let [first, last] = [present, present];
  fits(entries[present]);
  while (fits(entries[first - 1])) first -= 1;
  while (fits(entries[last + 1])) last += 1;
  return { entries: entries.slice(first, last + 1), present: present - first };
}

/** Writes each thing once: what states share stays shared, and browsers copy it once. */
function once<Thing, Written>(write: (thing: Thing) => Written): (thing: Thing) => Written {
  const all = new Map<Thing, Written>();
  return (thing) => {
    const written = all.get(thing) ?? write(thing);
    all.set(thing, written);
    return written;
  };
}

/** A list in which each value stands once. */
class Numbered<T> {
  readonly #numbers = new Map<T, number>();

  get values(): T[] {
    return [...this.#numbers.keys()];
  }

  numberOf(value: T): number {
    const number = this.#numbers.get(value) ?? this.#numbers.size;
    this.#numbers.set(value, number);
    return number;
  }
}

function bytesOf({ buffer, byteOffset, byteLength }: Float64Array | Int32Array): Uint8Array {
  return new Uint8Array(buffer, byteOffset, byteLength);
}

// ------------------------------------------------------------------------------------------------------------- reading

/** Throws a Failure if a project is larger than one may be. */
export function checkSize(name: string, bytes: number): void {
  if (bytes > LARGEST_PROJECT)
    throw new Failure('too_large', panelWords.project.tooLarge(name, Math.ceil(bytes / 1e6), LARGEST_PROJECT / 1e6));
}

/** The project of a file. Throws a Failure that says what is wrong with it, and where. */
export function parseProject(text: string): Project {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new Failure('bad_project', panelWords.project.noJson);
  }
  return readProject(value);
}

/** The project of a record. Throws a Failure that says what is wrong, and where. */
export function readProject(value: unknown): Project {
  const project = new Untrusted(value);
  const reader = readerOfProject(project);
  const nets = project
    .at('nets')
    .list()
    .map((net) => reader.net(net));
  const positions = project.at('positions').list().map(readPositions);
  const guides = project.at('guides').maybe((list) => list.list().map(readGuide)) ?? [];
  const shared = new SharedHandles();
  const states = project.at('states').list();
  if (states.length === 0 || states.length > MOST_STATES)
    project.at('states').fail(panelWords.project.states(MOST_STATES));
  const entries = states.map((state) => shared.in(readEntry(reader, state, nets, positions, guides), state));
  const title = project.at('title').maybe((each) => each.name(LONGEST_PROJECT_NAME));
  const present = project.at('present').index(entries.length);
  return { entries, present, view: reader.view(project.at('view')), ...(title && { title }) };
}

function readerOfProject(project: Untrusted): Reader {
  const version = project.isRecord ? project.at('chebnet').value : undefined;
  if (version === undefined) throw new Failure('bad_project', panelWords.project.foreign);
  const reader = readerOf(version);
  if (reader === undefined) throw new Failure('bad_project', panelWords.project.otherVersion);
  return reader;
}

function readEntry(
  reader: Reader,
  field: Untrusted,
  nets: readonly NetSource[],
  positions: readonly Float64Array[],
  guides: readonly GuideFile[],
): Entry {
  const net = nets[field.at('net').index(nets.length)]!;
  const place = field.at('positions');
  const guide = field.at('guideFile').maybe((each) => guides[each.index(guides.length)]);
  const { handles, ...settings } = reader.state(field);
  const state: Snapshot = {
    ...settings,
    ...(guide ? { guide } : {}),
    handles: handles.map((handle) => withTarget(handle, field.at('handles'))),
    net,
    positions: place.value === null ? null : positions[place.index(positions.length)]!,
  };
  return { name: readName(field), state, ...given({ upAxis: field.at('upAxis').maybe(readUpAxis) }) };
}

/** States that had the same handles share them again: apart they would take so much more room that the history was forgotten. */
class SharedHandles {
  /** By what they were read from, which states share in records. */
  readonly #read = new Map<unknown, HandleData[]>();
  #last: HandleData[] = [];

  in({ state, ...entry }: Entry, field: Untrusted): Entry {
    const written = field.at('handles').value;
    // In a file each state has rows of its own.
    const handles = this.#read.get(written) ?? (areAlike(state.handles, this.#last) ? this.#last : state.handles);
    this.#read.set(written, handles);
    this.#last = handles;
    return { ...entry, state: { ...state, handles } };
  }
}

/** Whether these hold the same, to the last bit. */
function areAlike(one: unknown, other: unknown): boolean {
  if (Object.is(one, other)) return true;
  if (typeof one !== 'object' || typeof other !== 'object' || one === null || other === null) return false;
  const keys = Object.keys(one);
  const alike = (key: string) => areAlike(one[key as keyof typeof one], other[key as keyof typeof other]);
  return keys.length === Object.keys(other).length && keys.every(alike);
}

function withTarget({ target, ...handle }: HandleSeed, handles: Untrusted): HandleData {
  return { ...handle, target: target ?? handles.fail(panelWords.project.targets) };
}

/** Whether it is a surface, the core says. */
function readGuide(guide: Untrusted): GuideFile {
  const mesh = guide.at('mesh');
  const ints = (each: Untrusted): Int32Array =>
    each.value instanceof Int32Array ? each.value : decode(each, (buffer) => new Int32Array(buffer));
  return {
    name: guide.at('name').name(LONGEST_FILE_NAME),
    mesh: {
      positions: readPositions(mesh.at('positions')),
      faceStart: ints(mesh.at('faceStart')),
      faceVertices: ints(mesh.at('faceVertices')),
    },
  };
}

function readPositions(field: Untrusted): Float64Array {
  const positions =
    field.value instanceof Float64Array ? field.value : decode(field, (buffer) => new Float64Array(buffer));
  if (positions.length % 3 !== 0 || !positions.every(Number.isFinite)) field.fail(panelWords.project.positions);
  return positions;
}

function decode<T>(field: Untrusted, arrayOf: (buffer: ArrayBufferLike) => T): T {
  const text = field.text();
  try {
    return arrayOf(fromBase64(text).buffer);
  } catch {
    return field.fail(panelWords.project.positions);
  }
}

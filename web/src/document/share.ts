/**
 * Scenes as links. A link carries the scene in its hash: `#v1=` and, deflated and in the base64 of URLs, the length of
 * a JSON header (32 bits, little end first), the header, and the packed positions (packing.ts).
 *
 * A link is foreign input: every field is checked here, and what only the net can tell (does vertex 9000 exist?) by the
 * core when the scene is opened.
 */
import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import type { RestLengths } from '../../../wasm/chebnet';
import { words } from '../language/language';
import type { ChebnetDocument, HandleData, HandleSeed, NetSource, Scene, SolverOptions, Symmetry, UpAxis, Vec3, ViewState } from './document';
import { LONGEST_NAME } from './document';
import { DEFAULT_INITIALISATION } from './defaults';
import { packPositions } from './packing';
import type { PackingNet } from './packing';

const TAG = 'v1=';
/** Chat programs cut longer links. */
export const LONG_LINK = 2_000;
/** Longer links are better sent as a file. */
export const HUGE_LINK = 8_000;
/** Longer links are not made: not every browser opens them. */
export const LARGEST_LINK = 64_000;
/** A link read may inflate to so many bytes, no more. */
const LARGEST_CONTENT = 8_000_000;

/** A hash that is no scene. `code`: "bad_link", damaged; "foreign_link", not ours or of another version. */
export class LinkError extends Error {
  constructor(
    readonly code: 'bad_link' | 'foreign_link',
    message: string,
  ) {
    super(message);
  }
}

/** A hash, and whether it holds the positions; null: the net is too large for one. */
export type Shared = { hash: string; positions: boolean } | { hash: null };

/**
 * The hash of a scene, `#` and all. Positions at rest need no place; others are left out if the link would be longer
 * than LARGEST_LINK, and whoever opens it solves for them.
 * @param threshold dL below which edges are in order; see packPositions.
 */
export function encodeScene(document: ChebnetDocument, net: PackingNet, threshold: number): Shared {
  const atRest = document.positions === null || document.positions.every((x, i) => x === net.restPositions[i]);
  const packed = atRest || document.positions === null ? null : packPositions(document.positions, net, threshold);
  const whole = toHash(header(document, net, document.settled), packed);
  if (whole.length <= LARGEST_LINK) return { hash: whole, positions: true };
  const small = toHash(header(document, net, false), null);
  return small.length <= LARGEST_LINK ? { hash: small, positions: false } : { hash: null };
}

/** The scene of a hash (with or without its `#`). Throws LinkError. */
export function decodeScene(hash: string): Scene {
  const text = hash.replace(/^#/, '');
  if (!text.startsWith(TAG)) {
    const newer = /^v\d+=/.test(text);
    throw new LinkError('foreign_link', newer ? words.link.otherVersion : words.link.foreign);
  }
  const content = inflate(fromBase64(text.slice(TAG.length)));
  const headerEnd = 4 + (content.length < 4 ? NaN : new DataView(content.buffer).getUint32(0, true));
  if (!(headerEnd <= content.length)) throw damaged();
  const packed = content.subarray(headerEnd);
  return readScene(parse(content.subarray(4, headerEnd)), packed.length > 0 ? packed : null);
}

/** What to tell a user about the link just made, or null if there is nothing to tell. */
export function linkAdvice(shared: Shared): string | null {
  if (shared.hash === null) return words.link.tooLarge;
  const size = shared.hash.length.toLocaleString(words.locale);
  if (!shared.positions) return words.link.withoutShape(size);
  if (shared.hash.length > HUGE_LINK) return words.link.huge(size);
  if (shared.hash.length > LONG_LINK) return words.link.long(size);
  return null;
}

// ------------------------------------------------------------------------------------------------------------- writing

function header(document: ChebnetDocument, net: PackingNet, settled: boolean): object {
  const { method, initialisation, options, view } = document;
  const source = 'recipe' in document.net ? { recipe: document.net.recipe } : document.net;
  const camera = view.camera && [...view.camera.position, ...view.camera.target].map((x) => Number(x.toPrecision(7)));
  const handles = document.handles.map((handle) => writeHandle(handle, net));
  const { symmetry } = document;
  return { net: source, handles, symmetry, method, initialisation, options, view: { ...view, camera }, settled };
}

/** `[vertex, anchor]`, the target unless the handle is at rest, and what else there is to say about it. */
function writeHandle({ vertex, anchor, target, ...rest }: HandleData, { restPositions }: PackingNet): unknown[] {
  const atRest = target.every((x, axis) => x === restPositions[3 * vertex + axis]);
  return [vertex, anchor ? 1 : 0, ...(atRest ? [] : target), ...(Object.keys(rest).length > 0 ? [rest] : [])];
}

function toHash(head: object, packed: Uint8Array | null): string {
  const json = strToU8(JSON.stringify(head));
  const content = new Uint8Array(4 + json.length + (packed?.length ?? 0));
  new DataView(content.buffer).setUint32(0, json.length, true);
  content.set(json, 4);
  if (packed) content.set(packed, 4 + json.length);
  return `#${TAG}${toBase64(deflateSync(content, { level: 9 }))}`;
}

function toBase64(bytes: Uint8Array): string {
  return btoa(strFromU8(bytes, true)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

// ------------------------------------------------------------------------------------------------------------- reading

function damaged(): LinkError {
  return new LinkError('bad_link', words.link.damaged);
}

function fromBase64(text: string): Uint8Array {
  try {
    return strToU8(atob(text.replaceAll('-', '+').replaceAll('_', '/')), true);
  } catch {
    throw damaged();
  }
}

/** Inflates piece by piece, so that a small link cannot fill the memory. */
function inflate(deflated: Uint8Array): Uint8Array {
  const pieces: Uint8Array[] = [];
  let size = 0;
  const stream = new Inflate((piece) => {
    pieces.push(piece);
    size += piece.length;
  });
  const pieceSize = 1024;
  try {
    for (let at = 0; at < deflated.length; at += pieceSize) {
      stream.push(deflated.subarray(at, at + pieceSize), at + pieceSize >= deflated.length);
      if (size > LARGEST_CONTENT) throw damaged();
    }
  } catch {
    throw damaged();
  }
  const content = new Uint8Array(size);
  let at = 0;
  for (const piece of pieces) {
    content.set(piece, at);
    at += piece.length;
  }
  return content;
}

function parse(json: Uint8Array): Record<string, unknown> {
  try {
    return record(JSON.parse(strFromU8(json)));
  } catch {
    throw damaged();
  }
}

function readScene(head: Record<string, unknown>, packed: Uint8Array | null): Scene {
  return {
    net: readNet(record(head.net)),
    handles: list(head.handles).map(readHandle),
    ...(head.symmetry === undefined ? {} : { symmetry: readSymmetry(record(head.symmetry)) }),
    method: text(head.method),
    // Links made before there was a choice have none.
    initialisation: head.initialisation === undefined ? DEFAULT_INITIALISATION : text(head.initialisation),
    options: readOptions(record(head.options)),
    view: readView(record(head.view)),
    positions: packed && { packed },
    settled: flag(head.settled),
  };
}

function readNet(net: Record<string, unknown>): NetSource {
  if ('recipe' in net) return { recipe: text(net.recipe) };
  const file = { obj: text(net.obj), name: text(net.name) };
  // Links made before there was a choice have none.
  if (net.restLengths === undefined) return file;
  return { ...file, restLengths: oneOf<RestLengths>(net.restLengths, ['automatic', 'equal', 'own']) };
}

function readHandle(row: unknown): HandleSeed {
  const fields = list(row);
  const rest = typeof fields.at(-1) === 'object' ? record(fields.pop()) : {};
  const [vertex, anchor, ...target] = fields.map(number);
  if (vertex === undefined || !Number.isInteger(vertex) || vertex < 0 || vertex >= 2 ** 31) throw damaged();
  if (anchor !== 0 && anchor !== 1) throw damaged();
  return { vertex, anchor: anchor === 1, target: target.length === 0 ? null : point(target), ...readRest(rest) };
}

/** What a handle may have; links made before there was such a thing have none. */
function readRest({ name, hidden, weight }: Record<string, unknown>): Pick<HandleSeed, 'name' | 'hidden' | 'weight'> {
  return {
    ...(name === undefined ? {} : { name: nameOf(name) }),
    ...(hidden === undefined ? {} : { hidden: flag(hidden) }),
    ...(weight === undefined ? {} : { weight: weightOf(weight) }),
  };
}

function nameOf(value: unknown): string {
  const name = text(value);
  if (name.length > LONGEST_NAME) throw damaged();
  return name;
}

function weightOf(value: unknown): number {
  const weight = number(value);
  if (weight <= 0) throw damaged();
  return weight;
}

function readSymmetry({ axis, through }: Record<string, unknown>): Symmetry {
  return { axis: oneOf(axis, ['x', 'y', 'z']), through: oneOf(through, ['centre', 'origin']) };
}

function readOptions(options: Record<string, unknown>): SolverOptions {
  return Object.fromEntries(
    Object.entries(options).map(([name, value]) => [name, typeof value === 'boolean' ? value : number(value)]),
  );
}

function readView(view: Record<string, unknown>): ViewState {
  return {
    camera: view.camera === null ? null : readCamera(list(view.camera).map(number)),
    field: oneOf(view.field, ['deviation', 'angle']),
    colourMap: oneOf(view.colourMap, ['paper', 'log']),
    showFaces: flag(view.showFaces),
    ...(view.upAxis === undefined ? {} : { upAxis: oneOf<UpAxis>(view.upAxis, ['y', 'z']) }),
  };
}

function readCamera(numbers: number[]): NonNullable<ViewState['camera']> {
  const camera = { position: point(numbers.slice(0, 3)), target: point(numbers.slice(3)) };
  const apart = camera.position.some((x, axis) => x !== camera.target[axis]);
  if (!apart) throw damaged();
  return camera;
}

function record(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw damaged();
  return value as Record<string, unknown>;
}

function list(value: unknown): unknown[] {
  if (!Array.isArray(value)) throw damaged();
  return value;
}

function text(value: unknown): string {
  if (typeof value !== 'string') throw damaged();
  return value;
}

function flag(value: unknown): boolean {
  if (typeof value !== 'boolean') throw damaged();
  return value;
}

function number(value: unknown): number {
  if (typeof value !== 'number' || !Number.isFinite(value)) throw damaged();
  return value;
}

function point([x, y, z, ...more]: number[]): Vec3 {
  if (x === undefined || y === undefined || z === undefined || more.length > 0) throw damaged();
  return [x, y, z];
}

function oneOf<T extends string>(value: unknown, choices: readonly T[]): T {
  const choice = choices.find((name) => name === value);
  if (choice === undefined) throw damaged();
  return choice;
}

/**
 * Scenes as links. A link carries the scene in its hash: `#v2=`, where 2 is the version (versions.ts), and, deflated and in
 * the base64 of URLs, the length of a JSON header (32 bits, little end first), the header (codec.ts), the packed mesh if its
 * net says how many bytes that has (packed_mesh.ts), and the packed positions (packing.ts).
 */
import type { Mesh } from '../../../wasm/chebnet';
import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { readingWords } from '../language/reading';
import { fromBase64, toBase64 } from './base64';
import { netAsText, readFileTraits, writeHandle, writeState, writeView } from './codec';
import type { ChebnetDocument, DocumentNet, NetSource, Replay, Scene } from './document';
import { given } from './given';
import { packMesh, unpackMesh } from './packed_mesh';
import { packPositions } from './packing';
import type { PackingNet } from './packing';
import { Untrusted } from './untrusted';
import * as versions from './versions';
import type { Reader } from './versions';
import { Failure } from '../failure';

/** Chat programs cut longer links. */
export const LONG_LINK = 2_000;
/** Longer links are better sent as a file. */
export const HUGE_LINK = 8_000;
/** Longer links are not made: not every browser opens them. */
export const LARGEST_LINK = 64_000;
/** Positions of more vertices for each character of a link are not packed, to find out that they do not fit: that would block
 *  the page. Those of smooth nets take some characters a vertex. */
const MOST_VERTICES_A_CHARACTER = 4;
/** A link read may inflate to so many bytes, no more. */
const LARGEST_CONTENT = 8_000_000;
/** More than any link made here has room for. A short one could list millions, each an object of its own. */
const MOST_HANDLES = 100_000;
/** Vertices of the largest net of a file that goes as text, exact to the last bit; those of more are packed. */
const MOST_AS_TEXT = 200;
/** Steps of a drag that is made again, and iterations after each: many more than lead anywhere. */
const MOST_REPLAYED = 20;
/** Of packed nets, in mean edge lengths: the first is as good as exact, and the first with which a link is short enough is taken. */
const PRECISIONS = [1e-7, 1e-6, 1e-5, 1e-4];

/** A hash, and whether it holds the positions; null: the net is too large for one. `surface` false: that of the document is
 *  left out, which a visitor brought. */
export type Shared = { hash: string; positions: boolean; surface?: boolean } | { hash: null };

/**
 * The hash of a scene, `#` and all. Positions at rest need no place; others are left out if the link would be longer
 * than `largest`, and whoever opens it solves for them. The net of a file comes back within 1e-4 of its mean edge.
 * @param threshold dL below which edges are in order; see packPositions.
 */
export function encodeScene(
  document: ChebnetDocument,
  net: PackingNet,
  threshold: number,
  largest = LARGEST_LINK,
): Shared {
  const surface = document.guide && 'mesh' in document.guide ? { surface: false } : {};
  for (const form of forms(document, net, threshold, largest))
    if (form.hash.length <= largest) return { ...form, ...surface };
  return { hash: null };
}

/** The hash of a scene of a recipe without its positions: whoever opens it solves for them, after the drags that are to be made
 *  again, if any. */
export function encodeEdit(
  document: ChebnetDocument & { net: { recipe: string } },
  net: PackingNet,
  replay?: Replay,
): string {
  return withoutPositions({ ...document, ...given({ replay }) }, net, plain(document.net));
}

/** The scene of a hash (with or without its `#`). Throws a Failure: "bad_link", damaged; "foreign_link", not ours or of another version. */
export function decodeScene(hash: string): Scene {
  const tag = /^#?v([1-9]\d*)=/.exec(hash);
  if (tag === null) throw new Failure('foreign_link', readingWords.foreign);
  const reader = versions.readerOf(Number(tag[1]));
  if (reader === undefined) throw new Failure('foreign_link', readingWords.otherVersion);
  const content = inflate(fromUrl(hash.slice(tag[0].length)));
  const headerEnd = 4 + (content.length < 4 ? NaN : new DataView(content.buffer).getUint32(0, true));
  if (!(headerEnd <= content.length)) throw damaged();
  return readScene(reader, content.subarray(4, headerEnd), content.subarray(headerEnd));
}

// ------------------------------------------------------------------------------------------------------------- writing

/** A net as a link carries it: what its header says of it, and the mesh behind that. */
interface CarriedNet {
  head: object;
  mesh: Uint8Array;
}

/** What a link can be, the most exact first; nothing if the shortest is too long, so that the others are not packed for nothing:
 *  each takes a while. */
function* forms(
  document: ChebnetDocument,
  net: PackingNet,
  threshold: number,
  largest: number,
): Generator<{ hash: string; positions: boolean }> {
  if ('mesh' in document.net && !isWorthPacking(document.net.mesh.positions, largest)) return;
  const smallest = smallestNet(document.net);
  const shortest = smallest && withoutPositions(document, net, smallest);
  if (shortest === undefined || shortest.length > largest) return;
  if (isWorthPacking(document.positions, largest) || isAtRest(document, net))
    for (const carried of carriedNets(document.net))
      yield { hash: withPositions(document, net, carried, threshold), positions: true };
  yield { hash: shortest, positions: false };
}

function isWorthPacking(positions: Float64Array | null, largest: number): boolean {
  return positions === null || positions.length <= 3 * MOST_VERTICES_A_CHARACTER * largest;
}

/** The most exact first. */
function* carriedNets(source: DocumentNet): Generator<CarriedNet, undefined> {
  if (!('mesh' in source) || source.mesh.positions.length <= 3 * MOST_AS_TEXT) yield plain(source);
  if ('mesh' in source) yield* packedNets(source, PRECISIONS);
}

/** Undefined: there is none at all. */
function smallestNet(source: DocumentNet): CarriedNet | undefined {
  const coarsest = 'mesh' in source ? packedNets(source, [...PRECISIONS].reverse()).next().value : undefined;
  return coarsest ?? carriedNets(source).next().value ?? undefined;
}

function* packedNets(
  { mesh, ...traits }: Extract<DocumentNet, { mesh: Mesh }>,
  precisions: readonly number[],
): Generator<CarriedNet, undefined> {
  for (const precision of precisions) {
    const packed = packMesh(mesh, precision);
    if (packed) yield { head: { ...traits, packed: packed.length }, mesh: packed };
  }
}

function plain(net: DocumentNet): CarriedNet {
  return { head: netAsText(net), mesh: new Uint8Array() };
}

function withPositions(document: ChebnetDocument, net: PackingNet, carried: CarriedNet, threshold: number): string {
  const { positions, settled } = document;
  if (positions === null || isAtRest(document, net)) return toHash(document, net, carried, settled, new Uint8Array());
  const opened = carried.mesh.length > 0 ? { ...net, restPositions: unpackMesh(carried.mesh).positions } : net;
  return toHash(document, net, carried, settled, packPositions(positions, opened, threshold));
}

function isAtRest({ positions }: ChebnetDocument, { restPositions }: PackingNet): boolean {
  return positions === null || positions.every((x, i) => x === restPositions[i]);
}

/** What a link says of a document. */
type Carried = ChebnetDocument & Pick<Scene, 'replay'>;

function withoutPositions(document: Carried, net: PackingNet, carried: CarriedNet): string {
  return toHash(document, net, carried, false, new Uint8Array());
}

function toHash(
  { view, ...state }: Carried,
  { restPositions }: PackingNet,
  { head, mesh }: CarriedNet,
  settled: boolean,
  positions: Uint8Array,
): string {
  const handles = state.handles.map((handle) => writeHandle(handle, restPositions));
  const header = { ...writeState({ ...state, settled }, handles), net: head, view: writeView(view) };
  const json = strToU8(JSON.stringify(header));
  const content = new Uint8Array(4 + json.length + mesh.length + positions.length);
  new DataView(content.buffer).setUint32(0, json.length, true);
  content.set(json, 4);
  content.set(mesh, 4 + json.length);
  content.set(positions, 4 + json.length + mesh.length);
  return `#v${versionOf(state, mesh)}=${toUrl(toBase64(deflateSync(content, { level: 9 })))}`;
}

function versionOf({ replay, handles }: Pick<Carried, 'replay' | 'handles'>, mesh: Uint8Array): number {
  if (replay !== undefined) return versions.VERSION_WITH_REPLAYS;
  if (mesh.length > 0) return versions.VERSION_WITH_PACKED_NETS;
  return versions.doSlide(handles) ? versions.VERSION_WITH_SLIDES : versions.VERSION;
}

function toUrl(base64: string): string {
  return base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

// ------------------------------------------------------------------------------------------------------------- reading

function damaged(): Failure {
  return new Failure('bad_link', readingWords.damaged);
}

function fromUrl(text: string): Uint8Array {
  try {
    return fromBase64(text.replaceAll('-', '+').replaceAll('_', '/'));
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

/** @param packed the mesh, if there is one, and positions, if there are any. */
function readScene(reader: Reader, json: Uint8Array, packed: Uint8Array): Scene {
  try {
    const head = new Untrusted(JSON.parse(strFromU8(json)));
    head.at('handles').list(MOST_HANDLES);
    const net = head.at('net');
    const meshEnd = net.at('packed').maybe((bytes) => bytes.index(packed.length + 1)) ?? 0;
    return {
      ...reader.state(head),
      net: meshEnd > 0 ? readPackedNet(net, packed.subarray(0, meshEnd)) : reader.net(net),
      view: reader.view(head.at('view')),
      positions: packed.length > meshEnd ? { packed: packed.subarray(meshEnd) } : null,
      ...given({ replay: head.at('replay').maybe(readReplay) }),
    };
  } catch {
    throw damaged();
  }
}

function readReplay(replay: Untrusted): Replay {
  const [steps, iterations, ...more] = replay.list().map((each) => each.index(MOST_REPLAYED + 1));
  return steps && iterations && more.length === 0 ? [steps, iterations] : replay.fail(readingWords.damaged);
}

function readPackedNet(net: Untrusted, packed: Uint8Array): NetSource {
  return { mesh: unpackMesh(packed), ...readFileTraits(net) };
}

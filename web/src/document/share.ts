/**
 * Scenes as links. A link carries the scene in its hash: `#v2=`, where 2 is the version (versions.ts), and, deflated and in
 * the base64 of URLs, the length of a JSON header (32 bits, little end first), the header (codec.ts), and the packed
 * positions (packing.ts).
 */
import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { words } from '../language/language';
import { fromBase64, toBase64 } from './base64';
import { netAsText, writeState, writeView } from './codec';
import type { ChebnetDocument, Scene } from './document';
import { Untrusted } from './untrusted';
import { packPositions } from './packing';
import type { PackingNet } from './packing';
import { doSlide, readerOf, VERSION, VERSION_WITH_SLIDES } from './versions';
import type { Reader } from './versions';
import { Failure } from '../failure';

/** Chat programs cut longer links. */
export const LONG_LINK = 2_000;
/** Longer links are better sent as a file. */
export const HUGE_LINK = 8_000;
/** Longer links are not made: not every browser opens them. */
export const LARGEST_LINK = 64_000;
/** A link read may inflate to so many bytes, no more. */
const LARGEST_CONTENT = 8_000_000;

/** A hash, and whether it holds the positions; null: the net is too large for one. `surface` false: that of the document is
 *  left out, which a visitor brought. */
export type Shared = { hash: string; positions: boolean; surface?: boolean } | { hash: null };

/**
 * The hash of a scene, `#` and all. Positions at rest need no place; others are left out if the link would be longer
 * than `largest`, and whoever opens it solves for them.
 * @param threshold dL below which edges are in order; see packPositions.
 */
export function encodeScene(
  document: ChebnetDocument,
  net: PackingNet,
  threshold: number,
  largest = LARGEST_LINK,
): Shared {
  const atRest = document.positions === null || document.positions.every((x, i) => x === net.restPositions[i]);
  const packed = atRest || document.positions === null ? null : packPositions(document.positions, net, threshold);
  const whole = toHash(document, header(document, net, document.settled), packed);
  const surface = document.guide && 'mesh' in document.guide ? { surface: false } : {};
  if (whole.length <= largest) return { hash: whole, positions: true, ...surface };
  const small = encodeEdit(document, net);
  return small.length <= largest ? { hash: small, positions: false, ...surface } : { hash: null };
}

/** The hash of a scene without its positions: whoever opens it solves for them. */
export function encodeEdit(document: ChebnetDocument, net: PackingNet): string {
  return toHash(document, header(document, net, false), null);
}

/** The scene of a hash (with or without its `#`). Throws a Failure: "bad_link", damaged; "foreign_link", not ours or of another version. */
export function decodeScene(hash: string): Scene {
  const tag = /^#?v([1-9]\d*)=/.exec(hash);
  if (tag === null) throw new Failure('foreign_link', words.link.foreign);
  const reader = readerOf(Number(tag[1]));
  if (reader === undefined) throw new Failure('foreign_link', words.link.otherVersion);
  const content = inflate(fromUrl(hash.slice(tag[0].length)));
  const headerEnd = 4 + (content.length < 4 ? NaN : new DataView(content.buffer).getUint32(0, true));
  if (!(headerEnd <= content.length)) throw damaged();
  const packed = content.subarray(headerEnd);
  return readScene(reader, content.subarray(4, headerEnd), packed.length > 0 ? packed : null);
}

// ------------------------------------------------------------------------------------------------------------- writing

function header({ view, ...state }: ChebnetDocument, net: PackingNet, settled: boolean): object {
  return { ...writeState({ ...state, settled }, net.restPositions), net: netAsText(state.net), view: writeView(view) };
}

function toHash({ handles }: ChebnetDocument, head: object, packed: Uint8Array | null): string {
  const json = strToU8(JSON.stringify(head));
  const content = new Uint8Array(4 + json.length + (packed?.length ?? 0));
  new DataView(content.buffer).setUint32(0, json.length, true);
  content.set(json, 4);
  if (packed) content.set(packed, 4 + json.length);
  const version = doSlide(handles) ? VERSION_WITH_SLIDES : VERSION;
  return `#v${version}=${toUrl(toBase64(deflateSync(content, { level: 9 })))}`;
}

function toUrl(base64: string): string {
  return base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

// ------------------------------------------------------------------------------------------------------------- reading

function damaged(): Failure {
  return new Failure('bad_link', words.link.damaged);
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

function readScene(reader: Reader, json: Uint8Array, packed: Uint8Array | null): Scene {
  try {
    const head = new Untrusted(JSON.parse(strFromU8(json)));
    return {
      ...reader.state(head),
      net: reader.net(head.at('net')),
      view: reader.view(head.at('view')),
      positions: packed && { packed },
    };
  } catch {
    throw damaged();
  }
}

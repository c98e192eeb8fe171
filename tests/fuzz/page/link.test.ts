/** Links: what is written comes back; anything else is a scene or a Failure. */
import fc from 'fast-check';
import { deflateSync, strToU8 } from 'fflate';
import { expect } from 'vitest';
import { netAsText, writeHandle, writeState, writeView } from '../../../web/src/document/codec';
import type { ChebnetDocument } from '../../../web/src/document/document';
import { Failure } from '../../../web/src/failure';
import { decodeScene, encodeScene } from '../../../web/src/document/share';
import { VERSION_WITH_PACKED_NETS } from '../../../web/src/document/versions';
import { attack, attacks } from './attack';
import { changed, changes, checkFinite, document, net } from './scenes';

function hashOf(given: ChebnetDocument): string {
  const { hash } = encodeScene(given, net, 1e-6);
  if (hash === null) throw new Error('the scene is too large for a link');
  return hash;
}

/** Of any version that is read, and of one that is not yet. */
const tag = fc.integer({ min: 1, max: VERSION_WITH_PACKED_NETS + 1 }).map((version) => `#v${version}=`);

/** The hash of a header that is none of ours, and of bytes behind it. */
function forged(tagged: string, header: string, packed: Uint8Array): string {
  const json = strToU8(header);
  const content = new Uint8Array(4 + json.length + packed.length);
  new DataView(content.buffer).setUint32(0, json.length, true);
  content.set(json, 4);
  content.set(packed, 4 + json.length);
  return tagged + Buffer.from(deflateSync(content)).toString('base64url');
}

function checkDecoded(hash: string): void {
  try {
    checkFinite({ ...decodeScene(hash), positions: null });
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    expect(error.message).not.toBe('');
  }
}

function comesBack(given: ChebnetDocument): void {
  const { positions, handles, ...rest } = decodeScene(hashOf(given));
  const { positions: before, handles: handlesBefore, ...restBefore } = given;
  expect(rest).toEqual({ ...restBefore, net: netAsText(given.net) });
  const isAtRest = before === null || before.every((x, i) => x === net.restPositions[i]);
  expect(positions === null).toBe(isAtRest);
  const targetsBefore = handlesBefore.map((handle) => {
    const atRest = handle.target.every((x, axis) => x === net.restPositions[3 * handle.vertex + axis]);
    return { ...handle, target: atRest ? null : handle.target };
  });
  expect(handles).toEqual(targetsBefore);
}

const bytes = fc.uint8Array({ maxLength: 60 });
/** Where a link is cut or written over. */
const splice = fc.record({ at: fc.nat(), taken: fc.nat(4), put: fc.string({ maxLength: 4 }) });

const damaged = fc.tuple(document, fc.array(splice, { minLength: 1, maxLength: 4 })).map(([given, splices]) => {
  const characters = [...hashOf(given)];
  for (const { at, taken, put } of splices) characters.splice(at % characters.length, taken, ...put);
  return characters.join('');
});

const handlesOf = ({ handles }: ChebnetDocument, rest: Float64Array | null) =>
  handles.map((handle) => writeHandle(handle, rest));

const withForgedHeader = fc.tuple(tag, document, changes, bytes).map(([tagged, given, list, packed]) => {
  const header = {
    ...writeState(given, handlesOf(given, net.restPositions)),
    net: netAsText(given.net),
    view: writeView(given.view),
  };
  return forged(tagged, JSON.stringify(changed(header, list)), packed);
});

/** Bytes that are said to begin with a mesh. */
const withForgedMesh = fc.tuple(tag, document, bytes, fc.nat(70)).map(([tagged, given, packed, length]) => {
  const net = { name: 'forged.obj', packed: length };
  const header = { ...writeState(given, handlesOf(given, null)), net, view: writeView(given.view) };
  return forged(tagged, JSON.stringify(header), packed);
});

const anyText = fc.oneof(
  fc.string(),
  fc.tuple(tag, bytes).map(([tagged, each]) => tagged + Buffer.from(each).toString('base64url')),
  fc.tuple(tag, fc.json()).map(([tagged, each]) => forged(tagged, each, new Uint8Array())),
);

const links = { folder: 'link', holds: (file: Uint8Array) => checkDecoded(Buffer.from(file).toString()) };

attacks('links', links, {
  'a scene comes back': attack(document, comesBack),
  'a damaged link': attack(damaged, checkDecoded),
  'a forged header': attack(withForgedHeader, checkDecoded),
  'a forged mesh': attack(withForgedMesh, checkDecoded),
  'any text': attack(anyText, checkDecoded),
});

/** Golden files: what a page of some day made, and beside each, as JSON, the document that it must open into. */
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { ROOT } from '../wasm/load';
import { netAsText } from '../../web/src/document/codec';
import type { ChebnetDocument, NetSource } from '../../web/src/document/document';
import type { Project } from '../../web/src/document/project';

/** Whether what is missing is to be made; see golden.test.ts. */
export const isMaking = process.env['CHEBNET_GOLDEN'] === 'make';

const GOLDEN = new URL('tests/data/golden/', ROOT);

export interface ExpectedLink {
  /** As it stood on the page that made the link; without positions in the link, as it opens. */
  document: WithText<ChebnetDocument> & { positions: Float64Array };
  /** dL of each edge once the link is open. */
  deviations: number[];
}

export interface Golden {
  /** Folder and name, e.g. `v1/everything`. */
  name: string;
  /** Of the file itself: a hash, the text of a project, or what the browser keeps as `keptText` writes it. */
  text: string;
  expected: unknown;
}

export type Kind = 'link' | 'chebnet.json' | 'kept.json';

export function goldens(kind: Kind): Golden[] {
  return readdirSync(GOLDEN, { withFileTypes: true })
    .filter((each) => each.isDirectory())
    .flatMap(({ name: folder }) => readdirSync(new URL(`${folder}/`, GOLDEN)).map((file) => `${folder}/${file}`))
    .filter((file) => file.endsWith(`.${kind}`))
    .sort()
    .map((file) => {
      const name = file.slice(0, -kind.length - 1);
      return { name, text: read(file), expected: parse(read(`${name}.expected.json`)) };
    });
}

export function isMade(name: string, kind: Kind): boolean {
  return existsSync(new URL(`${name}.${kind}`, GOLDEN));
}

export function writeGolden({ name, text, expected }: Golden, kind: Kind): void {
  mkdirSync(new URL('.', new URL(name, GOLDEN)), { recursive: true });
  writeFileSync(new URL(`${name}.${kind}`, GOLDEN), text);
  writeFileSync(new URL(`${name}.expected.json`, GOLDEN), format(expected));
}

/** A file of golden data that has no files beside it. */
export function readData(file: string): unknown {
  return parse(read(file));
}

export function writeData(file: string, data: unknown): void {
  writeFileSync(new URL(file, GOLDEN), format(data));
}

function read(file: string): string {
  return readFileSync(new URL(file, GOLDEN), 'utf8');
}

// ------------------------------------------------------------------------------------------------------- what is expected

/** Nets of files are written as text there. */
export type WithText<T> = Omit<T, 'net'> & { net: ReturnType<typeof netAsText> };

export function withText<T extends { net: NetSource }>(document: T): WithText<T> {
  return { ...document, net: netAsText(document.net) };
}

export function projectWithText({ entries, ...rest }: Project): Project {
  return { ...rest, entries: entries.map(({ state, ...entry }) => ({ ...entry, state: withText(state) })) };
}

/** Positions as the numbers they are, all bits of them: JSON has no −0, so this one is a text. */
function format(value: unknown): string {
  const replace = (_key: string, each: unknown): unknown => {
    if (each instanceof Int32Array) return Array.from(each);
    return each instanceof Float64Array ? Array.from(each, (x) => (Object.is(x, -0) ? '-0' : x)) : each;
  };
  const onOneLine = (list: string): string => list.replaceAll(/\n\s*/g, ' ');
  return `${JSON.stringify(value, replace, 1).replaceAll(/\[[^[\]{}]*\]/g, onOneLine)}\n`;
}

function parse(text: string): unknown {
  return JSON.parse(text, (key, each: unknown) => {
    if (!Array.isArray(each)) return each;
    if (key === 'faceStart' || key === 'faceVertices') return Int32Array.from(each, Number);
    return key === 'positions' ? Float64Array.from(each, Number) : each;
  });
}

// ---------------------------------------------------------------------------------------------------- what a browser keeps

/** A record of IndexedDB, which has arrays of numbers, and fields that are there without a value. */
export function keptText(record: object): string {
  const replace = (_key: string, each: unknown): unknown => {
    if (each instanceof Float64Array) return { float64: base64Of(each) };
    if (each instanceof Int32Array) return { int32: base64Of(each) };
    return each === undefined ? { undefined: true } : each;
  };
  return JSON.stringify(record, replace);
}

function base64Of({ buffer, byteOffset, byteLength }: Float64Array | Int32Array): string {
  return Buffer.from(buffer, byteOffset, byteLength).toString('base64');
}

export function keptRecord(text: string): unknown {
  return restored(JSON.parse(text));
}

function restored(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if ('undefined' in value) return undefined;
  if ('float64' in value) return new Float64Array(bytesOf(value.float64));
  if ('int32' in value) return new Int32Array(bytesOf(value.int32));
  if (Array.isArray(value)) return value.map(restored);
  return Object.fromEntries(Object.entries(value).map(([name, each]) => [name, restored(each)]));
}

function bytesOf(base64: unknown): ArrayBuffer {
  return new Uint8Array(Buffer.from(String(base64), 'base64')).buffer;
}

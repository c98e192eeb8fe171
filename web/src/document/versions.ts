/**
 * The versions of the format: one number for links (`#v2=…`), project files and what the browser keeps (`"chebnet": 2`). What
 * any version wrote is read for ever; the newest that is needed is written.
 *
 * A version more is a row more, of what it reads otherwise than the one before, and golden files (tests/web/golden.test.ts).
 * It is due when a page of before would misread what is written from now on. A field that it may pass over is none: that is
 * a line in codec.ts, and a golden file.
 */
import { readKeptNet, readNet, readNumbering, readState, readView } from './codec';
import type { State } from './codec';
import type { HandleData, HandleSeed, NetSource, ViewState } from './document';
import type { Untrusted } from './untrusted';

/** Reads the parts of a scene or project. All throw a Failure if it is none. */
export interface Reader {
  net(net: Untrusted): NetSource;
  state(state: Untrusted): State<HandleSeed>;
  view(view: Untrusted): ViewState;
}

const first: Reader = { net: readNet, state: readState, view: readView };
/** Says how each net is numbered. */
const second: Reader = { ...first, state: (state) => ({ ...first.state(state), ...readNumbering(state) }) };
/** Of what the browser keeps, which can hold the net of a file as arrays: text takes long to be made, again and again. */
const third: Reader = { ...second, net: readKeptNet };

/** Of nets with handles that slide: pages of before would hold them. */
const fourth: Reader = third;

/** Of links with a net packed: share.ts reads it, as it stands behind what is read here. */
const fifth: Reader = fourth;

/** Of links with drags made again, which share.ts reads: pages of before would put the handles where they were dragged to. */
const sixth: Reader = fifth;

const READERS = new Map<number, Reader>([
  [1, first],
  [2, second],
  [3, third],
  [4, fourth],
  [5, fifth],
  [6, sixth],
]);

/** Of links and files, and of what the browser keeps without a file. */
export const VERSION = 2;
/** Of what the browser keeps with a file. */
export const VERSION_WITH_ARRAYS = 3;
/** Of whatever has handles that slide. */
export const VERSION_WITH_SLIDES = 4;
/** Of links with a net packed. */
export const VERSION_WITH_PACKED_NETS = 5;
/** Of links with drags made again. */
export const VERSION_WITH_REPLAYS = 6;

export function doSlide(handles: readonly HandleData[]): boolean {
  return handles.some(({ slides }) => slides !== undefined);
}

/** Undefined: there is no such version, or not yet. */
export function readerOf(version: unknown): Reader | undefined {
  return READERS.get(version as number);
}

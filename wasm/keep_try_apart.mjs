// node keep_try_apart.mjs MODULE.wasm: puts a nop between each indirect call and a try, catch or delegate that follows at once.
//
// While a function runs in the interpreter of WebKit (seen in 2.50), an exception out of an indirect call counts as thrown
// by the instruction after the call. If a `try` begins there, it catches what was thrown before it: destructors run for
// objects that were never made, and end in std::terminate. If a `try` ends there, it lets go what it should catch.
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const HEADER = 8;
const CODE_SECTION = 10;
const NOP = 0x01;
const CALL_INDIRECT = 0x11;
/** try, catch, delegate, catch_all, try_table */
const BORDERS = [0x06, 0x07, 0x18, 0x19, 0x1f];

/** A number as WebAssembly writes it: 7 bits a byte, the lowest first. @param {number} number */
function written(number) {
  const bytes = [];
  for (; number > 0x7f; number >>>= 7) bytes.push(0x80 | (number & 0x7f));
  return [...bytes, number];
}

class Reader {
  /** @param {Uint8Array} bytes */
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    const byte = this.bytes[this.at++];
    if (byte === undefined) throw new Error('the module ends too early');
    return byte;
  }

  number() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.byte();
      value += (byte & 0x7f) * 2 ** shift;
      if (byte < 0x80) return value;
    }
  }

  /** @param {number} count of bytes */
  skip(count) {
    this.at += count;
  }

  /** @param {number} count */
  skipNumbers(count) {
    for (let i = 0; i < count; ++i) while (this.byte() >= 0x80);
  }

  /** Also of a type, for those are numbers. */
  skipVector(numbers = 1) {
    this.skipNumbers(numbers * this.number());
  }

  skipLocals() {
    this.skipVector(2);
  }

  /** The opcode of the instruction that is skipped; section 5.4 of the WebAssembly specification. */
  skipInstruction() {
    const opcode = this.byte();
    if (opcode === 0xfc) this.#skipExtended();
    else if (opcode === 0xfd) this.#skipVectorInstruction();
    else this.#skipImmediates(opcode);
    return opcode;
  }

  /** @param {number} opcode */
  #skipImmediates(opcode) {
    if (opcode >= 0x28 && opcode <= 0x3e)
      this.skipNumbers(2); // loads and stores: alignment, offset
    else if (opcode === 0x11 || opcode === 0x13)
      this.skipNumbers(2); // indirect calls: type, table
    else if (opcode === 0x0e)
      this.skipNumbers(1 + this.number()); // br_table: labels and the default
    else if (opcode === 0x1c)
      this.skipVector(); // select: types
    else if (opcode === 0x43)
      this.skip(4); // f32.const
    else if (opcode === 0x44)
      this.skip(8); // f64.const
    else if (opcode === 0x1f) this.#skipTryTable();
    else if (ONE_NUMBER.has(opcode)) this.skipNumbers(1);
    else if (!NOTHING.has(opcode)) throw new Error(`unknown instruction 0x${opcode.toString(16)}`);
  }

  #skipTryTable() {
    this.skipNumbers(1);
    for (let clauses = this.number(); clauses > 0; --clauses) this.skipNumbers(this.byte() < 2 ? 2 : 1);
  }

  #skipExtended() {
    const opcode = this.number();
    if (opcode <= 7) return; // conversions
    const numbers = [2, 1, 2, 1, 2, 1, 2, 1, 1, 1][opcode - 8]; // memory.init … table.fill
    if (numbers === undefined) throw new Error(`unknown instruction 0xfc ${opcode}`);
    this.skipNumbers(numbers);
  }

  #skipVectorInstruction() {
    const opcode = this.number();
    if (opcode <= 11 || opcode === 92 || opcode === 93)
      this.skipNumbers(2); // loads and stores
    else if (opcode === 12 || opcode === 13)
      this.skip(16); // v128.const, i8x16.shuffle
    else if (opcode >= 84 && opcode <= 91) this.#skipLaneInMemory();
    else if (opcode >= 21 && opcode <= 34) this.skip(1); // of a lane
  }

  #skipLaneInMemory() {
    this.skipNumbers(2);
    this.skip(1);
  }
}

/** @param {number} from @param {number} to */
const range = (from, to) => Array.from({ length: to - from + 1 }, (_, i) => from + i);
/** Block, loop, if, try: a type; branches, rethrow, delegate: a label; calls, locals, globals, tables, tags, references: an index. */
const ONE_NUMBER = new Set([
  ...[0x02, 0x03, 0x04, 0x06, 0x07, 0x08, 0x09, 0x0c, 0x0d, 0x10, 0x12, 0x14, 0x15, 0x18],
  ...range(0x20, 0x26),
  ...[0x3f, 0x40, 0x41, 0x42, 0xd0, 0xd2],
]);
const NOTHING = new Set([0x00, 0x01, 0x05, 0x0a, 0x0b, 0x0f, 0x19, 0x1a, 0x1b, ...range(0x45, 0xc4), 0xd1, 0xd3, 0xd4]);

/** @param {readonly (Uint8Array | number[])[]} parts */
function joined(parts) {
  return Buffer.concat(parts.map((part) => Buffer.from(part)));
}

/** @param {Uint8Array} body of a function */
function bodyApart(body) {
  const reader = new Reader(body);
  reader.skipLocals();
  /** @type {(Uint8Array | number[])[]} */
  const parts = [];
  let copied = 0;
  while (reader.at < body.length) {
    const opcode = reader.skipInstruction();
    if (opcode !== CALL_INDIRECT || !BORDERS.includes(body[reader.at] ?? NOP)) continue;
    parts.push(body.subarray(copied, reader.at), [NOP]);
    copied = reader.at;
  }
  if (reader.at !== body.length) throw new Error('a function does not end with its last instruction');
  return joined([...parts, body.subarray(copied)]);
}

/** @param {Uint8Array} section */
function codeApart(section) {
  const reader = new Reader(section);
  const count = reader.number();
  /** @type {(Uint8Array | number[])[]} */
  const parts = [written(count)];
  for (let i = 0; i < count; ++i) {
    const size = reader.number();
    const body = bodyApart(section.subarray(reader.at, reader.at + size));
    parts.push(written(body.length), body);
    reader.skip(size);
  }
  return joined(parts);
}

/** The same module, with those nops. @param {Uint8Array} module */
export function tryApart(module) {
  const reader = new Reader(module, HEADER);
  /** @type {(Uint8Array | number[])[]} */
  const parts = [module.subarray(0, HEADER)];
  while (reader.at < module.length) {
    const id = reader.byte();
    const size = reader.number();
    const content = module.subarray(reader.at, reader.at + size);
    const section = id === CODE_SECTION ? codeApart(content) : content;
    parts.push([id, ...written(section.length)], section);
    reader.skip(size);
  }
  return joined(parts);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const path = process.argv[2] ?? '';
  writeFileSync(path, tryApart(readFileSync(path)));
}

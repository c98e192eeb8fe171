/** What is put into the built modules for WebKit: nothing but nops, and where they belong. */
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { tryApart } from '../../wasm/keep_try_apart.mjs';
import { ROOT } from './load';

/** A module of one function without locals. */
function moduleOf(...body: number[]): Uint8Array {
  const type = [1, 4, 1, 0x60, 0, 0];
  const functions = [3, 2, 1, 0];
  const table = [4, 4, 1, 0x70, 0, 1];
  const size = [0x80 | ((body.length + 1) & 0x7f), (body.length + 1) >> 7];
  const section = [1, ...size, 0, ...body];
  const code = [10, 0x80 | (section.length & 0x7f), section.length >> 7, ...section];
  return Buffer.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, ...type, ...functions, ...table, ...code]);
}

const bodyOf = (module: Uint8Array, length: number) => [...module.subarray(-length)];
/** Long enough that sizes take two bytes. */
const FILLING = Array<number>(130).fill(0x01);
const [INDIRECT, TRY, NOTHING, CATCH_ALL, DELEGATE, END] = [
  [0x41, 0, 0x11, 0, 0],
  0x06,
  0x40,
  0x19,
  0x18,
  0x0b,
] as const;

test('a nop parts an indirect call from the try, catch or delegate that follows it, and from nothing else', () => {
  const before = [
    ...FILLING,
    ...INDIRECT,
    TRY,
    NOTHING,
    ...INDIRECT,
    CATCH_ALL,
    TRY,
    NOTHING,
    ...INDIRECT,
    DELEGATE,
    0,
    ...INDIRECT,
    END,
    END,
  ];
  const after = [
    ...FILLING,
    ...INDIRECT,
    1,
    TRY,
    NOTHING,
    ...INDIRECT,
    1,
    CATCH_ALL,
    TRY,
    NOTHING,
    ...INDIRECT,
    1,
    DELEGATE,
    0,
    ...INDIRECT,
    END,
    END,
  ];
  const given = moduleOf(...before);
  const made = tryApart(given);
  expect([WebAssembly.validate(Uint8Array.from(given)), WebAssembly.validate(Uint8Array.from(made))]).toEqual([
    true,
    true,
  ]);
  expect(bodyOf(made, after.length)).toEqual(after);
});

test('bytes that only look like an indirect call stay as they are', () => {
  const body = [...FILLING, 0x41, 0x11, 0x1a, 0x41, 0x06, 0x1a, 0x44, 0x11, 0, 0, 0x06, 0x11, 0, 0, 0x06, 0x1a, END];
  expect(bodyOf(tryApart(moduleOf(...body)), body.length)).toEqual(body);
});

test('an instruction nobody knows is refused', () => {
  expect(() => tryApart(moduleOf(...FILLING, 0xf7, END))).toThrow('0xf7');
});

test.each(['chebnet_core', 'chebnet_editor'])('the built %s needs no more of them', (name) => {
  const module = readFileSync(new URL(`build/wasm/${name}.wasm`, ROOT));
  expect(Buffer.compare(tryApart(module), module)).toBe(0);
});

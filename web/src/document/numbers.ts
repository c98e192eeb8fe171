/** Numbers as bytes, for links. Small integers of either sign take one: 7 bits a byte, low bits first, the sign in the lowest. */
import { Failure } from '../failure';

/** Larger ones are not written; read, they are damage. */
export const LARGEST_INTEGER = 2 ** 48;

export function writeFloat64(bytes: number[], value: number): void {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value, true);
  bytes.push(...new Uint8Array(view.buffer));
}

export function writeInteger(bytes: number[], value: number): void {
  let rest = value < 0 ? -2 * value - 1 : 2 * value;
  for (; rest >= 128; rest = Math.floor(rest / 128)) bytes.push(128 + (rest % 128));
  bytes.push(rest);
}

/** Reads one number after another. All throw a Failure, "bad_link", where there is none. */
export class NumberReader {
  readonly #bytes: Uint8Array;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  get left(): number {
    return this.#bytes.length - this.#at;
  }

  integer(): number {
    let value = 0;
    for (let unit = 1; unit <= 2 * LARGEST_INTEGER; unit *= 128) {
      const byte = this.#bytes[this.#at++];
      if (byte === undefined) throw damaged();
      value += (byte % 128) * unit;
      if (byte < 128) return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
    }
    throw damaged();
  }

  /** 64 bits, little end first. */
  float64(): number {
    if (this.left < 8) throw damaged();
    this.#at += 8;
    return new DataView(this.#bytes.buffer, this.#bytes.byteOffset).getFloat64(this.#at - 8, true);
  }

  /** What was packed is read by now. */
  end(): void {
    if (this.left !== 0) throw damaged();
  }
}

export function damaged(): Failure {
  return new Failure('bad_link', 'This link is damaged, or belongs to another net.');
}

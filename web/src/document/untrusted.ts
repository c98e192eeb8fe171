/** Reads data from outside (links, projects, messages of other pages) field by field: what is not as it must be is a failure
 *  that says what and where. */
import { Failure } from '../failure';
import { words } from '../language/language';
import type { Vec3 } from './document';

/** A value from outside, and where it was found, e.g. `states[3].handles[0]`. Every method but `at` and `maybe` throws a
 *  Failure if it is no such thing. */
export class Untrusted {
  /** @param code of that failure. */
  constructor(
    readonly value: unknown,
    readonly path = '',
    readonly code = 'bad_data',
  ) {}

  /** A field of a record; if it is missing, its value is undefined. */
  at(name: string): Untrusted {
    const path = this.path === '' ? name : `${this.path}.${name}`;
    const fields = this.record();
    return this.#part(Object.hasOwn(fields, name) ? fields[name] : undefined, path);
  }

  /** What `read` makes of it, or undefined if it is missing. */
  maybe<T>(read: (value: Untrusted) => T): T | undefined {
    return this.value === undefined ? undefined : read(this);
  }

  get isRecord(): boolean {
    return typeof this.value === 'object' && this.value !== null && !Array.isArray(this.value);
  }

  record(): Record<string, unknown> {
    if (!this.isRecord) this.fail(words.fields.record);
    return this.value as Record<string, unknown>;
  }

  fields(): [name: string, value: Untrusted][] {
    return Object.keys(this.record()).map((name) => [name, this.at(name)]);
  }

  /** Also one of numbers of one type. */
  list(longest = Infinity): Untrusted[] {
    const { value } = this;
    if (!isList(value)) this.fail(words.fields.list);
    if (value.length > longest) this.fail(words.fields.listUpTo(longest));
    return Array.from(value, (each, i) => this.#part(each, `${this.path}[${i}]`));
  }

  /** One of numbers of one type. */
  array<T extends Float64Array | Int32Array>(type: new () => T): T {
    return this.value instanceof type ? this.value : this.fail(words.fields.list);
  }

  text(longest = Infinity): string {
    if (typeof this.value !== 'string' || this.value.length > longest) this.fail(words.fields.text);
    return this.value;
  }

  /** The beginning of one that is too long: to a name that does no harm. */
  name(longest: number): string {
    return this.text().slice(0, longest);
  }

  flag(): boolean {
    if (typeof this.value !== 'boolean') this.fail(words.fields.flag);
    return this.value;
  }

  number(): number {
    if (typeof this.value !== 'number' || !Number.isFinite(this.value)) this.fail(words.fields.number);
    return this.value;
  }

  positive(): number {
    return this.number() > 0 ? this.number() : this.fail(words.fields.positive);
  }

  /** A whole number from 0 up to below `end`. */
  index(end: number): number {
    const value = this.number();
    if (!Number.isInteger(value) || value < 0 || value >= end) this.fail(words.fields.index(end));
    return value;
  }

  point(): Vec3 {
    if (isList(this.value) && this.value.length > 3) this.fail(words.fields.point);
    const [x, y, z] = this.list();
    if (x === undefined || y === undefined || z === undefined) this.fail(words.fields.point);
    return [x.number(), y.number(), z.number()];
  }

  /** To be called later. */
  function<T extends (...given: never[]) => unknown>(): T {
    return typeof this.value === 'function' ? (this.value as T) : this.fail(words.fields.function);
  }

  oneOf<T extends string>(choices: readonly T[]): T {
    return choices.find((name) => name === this.value) ?? this.fail(words.fields.oneOf(choices));
  }

  fail(expected: string): never {
    throw new Failure(this.code, words.fields.must(this.path, expected));
  }

  #part(value: unknown, path: string): Untrusted {
    return new Untrusted(value, path, this.code);
  }
}

function isList(value: unknown): value is ArrayLike<unknown> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

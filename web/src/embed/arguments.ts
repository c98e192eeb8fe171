/** Takes apart what a host sends, which may be anything: each reader gives a value of its type or throws. */
import type { ScriptHandle, Scripting } from '../scripting';
import type { Vec3 } from '../document/document';
import type { EmbedEvent } from './protocol';

const LONGEST_OBJ = 20e6;
const LONGEST_TEXT = 1000;
const MOST_HANDLES = 10_000;
const MOST_OPTIONS = 100;

export class BadArguments extends Error {
  readonly code = 'bad_arguments';
}

export function readNet(value: unknown): Parameters<Scripting['open']>[0] {
  const net = readObject(value, 'the net');
  if (net.recipe !== undefined) return { recipe: readText(net.recipe, 'the recipe') };
  const obj = readText(net.obj, 'the OBJ', LONGEST_OBJ);
  return net.name === undefined ? { obj } : { obj, name: readText(net.name, 'the name') };
}

export function readHandles(value: unknown): ScriptHandle[] {
  if (!Array.isArray(value) || value.length > MOST_HANDLES)
    throw new BadArguments(`handles must be a list of at most ${MOST_HANDLES}`);
  return value.map((each) => {
    const { vertex, target, anchor, name, hidden, weight } = readObject(each, 'a handle');
    return {
      vertex: readVertex(vertex),
      ...(target === undefined ? {} : { target: readPoint(target) }),
      ...(typeof anchor === 'boolean' ? { anchor } : {}),
      ...(name === undefined ? {} : { name: readText(name, 'the name of a handle') }),
      ...(typeof hidden === 'boolean' ? { hidden } : {}),
      ...(typeof weight === 'number' ? { weight } : {}),
    };
  });
}

export function readVertex(value: unknown): number {
  if (typeof value !== 'number' || !Number.isSafeInteger(value) || value < 0)
    throw new BadArguments('a vertex must be an integer from 0');
  return value;
}

export function readPoint(value: unknown): Vec3 {
  const [x, y, z] =
    Array.isArray(value) && value.length === 3 && value.every(Number.isFinite) ? (value as number[]) : [];
  if (x === undefined || y === undefined || z === undefined) throw new BadArguments('a point must be 3 finite numbers');
  return [x, y, z];
}

export function readLocality(value: unknown): number | null {
  if (value === null || typeof value === 'number') return value;
  throw new BadArguments('a locality must be a number, or null');
}

export function readOptions(value: unknown): Parameters<Scripting['setOptions']>[0] {
  const entries = Object.entries(readObject(value, 'the options'));
  if (entries.length > MOST_OPTIONS) throw new BadArguments(`at most ${MOST_OPTIONS} options`);
  return Object.fromEntries(entries.map(([name, each]) => [readText(name, 'the name of an option'), readOption(each)]));
}

export function readEvent(value: unknown): EmbedEvent {
  if (value === 'frame' || value === 'settled' || value === 'error') return value;
  throw new BadArguments('an event is frame, settled or error');
}

function readOption(value: unknown): number | boolean | string {
  return typeof value === 'number' || typeof value === 'boolean' ? value : readText(value, 'an option');
}

function readText(value: unknown, what: string, longest = LONGEST_TEXT): string {
  if (typeof value === 'string' && value.length <= longest) return value;
  throw new BadArguments(`${what} must be a text of at most ${longest} characters`);
}

function readObject(value: unknown, what: string): Record<string, unknown> {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw new BadArguments(`${what} must be an object`);
}

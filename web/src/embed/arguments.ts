/** What a host may send, which may be anything: each reader gives a value of its type or throws a Failure. */
import type { Untrusted } from '../document/untrusted';
import type { ScriptHandle, Scripting } from '../scripting';
import type { EmbedEvent } from './protocol';

const LONGEST_OBJ = 20e6;
const LONGEST_TEXT = 1000;
const MOST_HANDLES = 10_000;

export function readNet(net: Untrusted): Parameters<Scripting['open']>[0] {
  const recipe = net.at('recipe').maybe(readText);
  if (recipe !== undefined) return { recipe };
  const obj = net.at('obj').text(LONGEST_OBJ);
  const name = net.at('name').maybe(readText);
  return name === undefined ? { obj } : { obj, name };
}

export function readHandles(handles: Untrusted): ScriptHandle[] {
  return handles.list(MOST_HANDLES).map(readHandle);
}

function readHandle(handle: Untrusted): ScriptHandle {
  const { anchor, hidden, weight } = handle.record();
  const target = handle.at('target').maybe((each) => each.point());
  const name = handle.at('name').maybe(readText);
  return {
    vertex: readVertex(handle.at('vertex')),
    ...(target === undefined ? {} : { target }),
    ...(typeof anchor === 'boolean' ? { anchor } : {}),
    ...(name === undefined ? {} : { name }),
    ...(typeof hidden === 'boolean' ? { hidden } : {}),
    ...(typeof weight === 'number' ? { weight } : {}),
  };
}

/** Whether the net has it, the core says. */
export function readVertex(vertex: Untrusted): number {
  return vertex.index(2 ** 31);
}

export function readLocality(radius: Untrusted): number | null {
  return radius.value === null ? null : radius.number();
}

export function readOptions(options: Untrusted): Parameters<Scripting['setOptions']>[0] {
  return Object.fromEntries(options.fields().map(([name, each]) => [name, readOption(each)]));
}

export function readEvent(event: Untrusted): EmbedEvent {
  return event.oneOf<EmbedEvent>(['frame', 'settled', 'error']);
}

function readOption(option: Untrusted): number | boolean | string {
  const { value } = option;
  return typeof value === 'number' || typeof value === 'boolean' ? value : readText(option);
}

function readText(text: Untrusted): string {
  return text.text(LONGEST_TEXT);
}

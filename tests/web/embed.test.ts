/** What a host may ask of an embedded editor, and what it is refused. */
import { beforeEach, expect, test, vi } from 'vitest';
import type { App } from '../../web/src/app/app';
import { makeWayOut } from '../../web/src/embed/embed';
import { Host } from '../../web/src/embed/host';
import { embedWords } from '../../web/src/language/embed';
import { hashOf } from '../../web/src/projects/link';
import type { Scripting } from '../../web/src/scripting';
import { documentHere } from './elements_here';

vi.mock('../../web/src/projects/link', () => ({ hashOf: vi.fn() }));

const stats = { vertices: 4, status: 'converged' };
let listeners: Map<string, (error?: unknown) => void>;
let script: { [name in keyof Scripting]: ReturnType<typeof vi.fn> };
let posted: unknown[];
let host: Host;

beforeEach(() => {
  listeners = new Map();
  posted = [];
  script = {
    open: vi.fn(async () => undefined),
    setHandles: vi.fn(async () => undefined),
    move: vi.fn(async () => undefined),
    settled: vi.fn(async () => undefined),
    positions: vi.fn(() => Float64Array.of(1, 2, 3)),
    edges: vi.fn(() => Int32Array.of(0, 1)),
    handles: vi.fn(() => []),
    stats: vi.fn(() => stats),
    setOptions: vi.fn(async () => undefined),
    on: vi.fn((event: string, listener: () => void) => {
      listeners.set(event, listener);
      return () => void listeners.delete(event);
    }),
    screenPosition: vi.fn(() => ({ x: 1, y: 2 })),
    link: vi.fn(async () => 'https://host/#v1=x'),
  } as never;
  host = new Host(script as never, (message) => posted.push(message));
});

const ask = async (call: unknown, ...args: unknown[]) => {
  await host.receive({ chebnet: 1, id: 7, call, args });
  return posted.at(-1);
};

test('a call is answered with its id and result', async () => {
  expect(await ask('open', { recipe: 'dome' })).toEqual({ chebnet: 1, id: 7, result: undefined });
  expect(script.open).toHaveBeenCalledWith({ recipe: 'dome' });
  expect(await ask('positions')).toEqual({ chebnet: 1, id: 7, result: Float64Array.of(1, 2, 3) });
  await ask('move', 3, [1, 2, 3]);
  expect(script.move).toHaveBeenCalledWith(3, [1, 2, 3]);
});

test('what fails is answered with code and message', async () => {
  script.open.mockRejectedValue(Object.assign(new Error('no shape'), { code: 'bad_option' }));
  expect(await ask('open', { recipe: 'x' })).toEqual({
    chebnet: 1,
    id: 7,
    error: { code: 'bad_option', message: 'no shape' },
  });
});

test('only what a call needs is passed on', async () => {
  await ask('setHandles', [{ vertex: 1, target: [0, 0, 1], anchor: true, other: undefined }, { vertex: 2 }]);
  expect(script.setHandles).toHaveBeenCalledWith([{ vertex: 1, target: [0, 0, 1], anchor: true }, { vertex: 2 }]);
});

test.each([
  ['a call that is none', 'unknown_call', 'close', []],
  ['a call without a name', 'unknown_call', 5, []],
  ['the name of something inherited', 'unknown_call', 'constructor', []],
  ['a net that is none', 'bad_arguments', 'open', [null]],
  ['a recipe that is no text', 'bad_arguments', 'open', [{ recipe: 5 }]],
  ['a recipe without end', 'bad_arguments', 'open', [{ recipe: 'x'.repeat(1001) }]],
  ['an OBJ that is too large', 'bad_arguments', 'open', [{ obj: ' '.repeat(20e6 + 1) }]],
  ['a vertex that is text', 'bad_arguments', 'move', ['0', [0, 0, 0]]],
  ['a point at infinity', 'bad_arguments', 'move', [0, [0, 0, Infinity]]],
  ['a point that is sparse', 'bad_arguments', 'move', [0, Array(3)]],
  [
    'a face that is there ever again',
    'bad_arguments',
    'describe',
    [{ vertices: [[0, 0, 0]], faces: Array(100_000).fill(Array(100_000).fill(0)) }],
  ],
  ['a point of many numbers', 'bad_arguments', 'move', [0, Array(1e6).fill(0)]],
  ['too many handles', 'bad_arguments', 'setHandles', [Array(10_001).fill({ vertex: 0 })]],
  ['a field that no handle has', 'bad_arguments', 'setHandles', [[{ vertex: 1, other: 'x' }]]],
  ['an option that is an object', 'bad_arguments', 'setOptions', [{ threshold: {} }]],
  ['more arguments than any call takes', 'bad_arguments', 'stats', Array(11).fill(0)],
  ['an event that is none', 'bad_arguments', 'on', ['click']],
])('%s is refused', async (_, code, call, args) => {
  expect(await ask(call, ...args)).toMatchObject({ id: 7, error: { code } });
  for (const method of Object.values(script)) expect(method).not.toHaveBeenCalled();
});

test.each([
  ['text', 'hello'],
  ['null', null],
  ['of another version', { chebnet: 2, id: 1, call: 'stats' }],
  ['without an id', { chebnet: 1, call: 'stats' }],
  ['without a call', { chebnet: 1, id: 1, result: 7 }],
  ['with an id that is too long', { chebnet: 1, id: 'x'.repeat(65), call: 'stats' }],
])('a message %s is not answered', async (_, data) => {
  await host.receive(data);
  expect(posted).toEqual([]);
});

test('events come once each after they are asked for, until no longer', async () => {
  await ask('on', 'settled');
  await ask('on', 'settled');
  expect(script.on).toHaveBeenCalledTimes(1);
  listeners.get('settled')!();
  expect(posted.at(-1)).toEqual({ chebnet: 1, event: 'settled', stats });
  await ask('on', 'error');
  listeners.get('error')!(Object.assign(new Error('lost'), { code: 'worker_lost' }));
  expect(posted.at(-1)).toEqual({ chebnet: 1, event: 'error', error: { code: 'worker_lost', message: 'lost' } });
  await ask('off', 'settled');
  expect(listeners.has('settled')).toBe(false);
});

test('a host that does not wait for answers is told that too many are open', async () => {
  script.settled.mockReturnValue(new Promise(() => undefined));
  for (let i = 0; i < 100; i++) void host.receive({ chebnet: 1, id: i, call: 'settled' });
  expect(await ask('settled')).toMatchObject({ id: 7, error: { code: 'busy' } });
});

test('whichever way it is taken, the way out has the scene of that moment, and leads nowhere if no link can hold it', () => {
  documentHere();
  vi.stubGlobal('location', { pathname: '/editor/' });
  const say = vi.fn();
  const app = { say };
  const link = makeWayOut(app as unknown as App) as HTMLAnchorElement;
  const take = (way: string, detail = 0) =>
    link.dispatchEvent(Object.assign(new Event(way, { cancelable: true }), { detail }));
  const ways = ['click', 'auxclick', 'contextmenu'];
  for (const [i, way] of ['pointerdown', ...ways].entries()) {
    vi.mocked(hashOf)
      .mockClear()
      .mockReturnValue({ hash: `#${i}`, positions: false });
    expect(take(way)).toBe(true);
    expect(link.href).toBe(`/editor/#${i}`);
    // That of a large net takes a while to be made.
    take('click', 1);
    expect(hashOf).toHaveBeenCalledTimes(1);
  }
  vi.mocked(hashOf).mockReturnValue({ hash: null });
  expect(take('pointerdown')).toBe(true);
  expect(say).not.toHaveBeenCalled();
  for (const way of ways) expect(take(way)).toBe(false);
  expect(say.mock.calls).toEqual(ways.map(() => [embedWords.tooLarge]));
  vi.unstubAllGlobals();
});

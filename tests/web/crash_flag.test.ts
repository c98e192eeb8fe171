/** What a tab died of is known to the tabs that start afterwards; with a table for the storage of the browser, and locks that it
 *  grants some time after they were asked for. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';

vi.mock('idb-keyval', () => ({ createStore: () => {} }));

type Flags = typeof import('../../web/src/projects/crash_flag');

/** A tab: the page's part in it, where it hears that it is left, and how it dies. */
interface Tab {
  flags: Flags;
  events: EventTarget;
  die(): void;
}

let stored: Map<string, string>;
let held: { name: string; mode: LockMode; tab: object }[];

beforeEach(() => {
  stored = new Map();
  held = [];
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => stored.set(key, value),
    removeItem: (key: string) => stored.delete(key),
  });
});
afterEach(() => vi.unstubAllGlobals());

/** Some time later, when the browser has dealt with all that was asked of it. */
const later = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 5));

/** Of a tab: what it asks for is granted in a later task, and freed in one. */
function locksOf(tab: object): object {
  const request = async (
    name: string,
    { mode }: { mode: LockMode },
    take: (lock: object | null) => Promise<void> | null,
  ) => {
    await new Promise(setImmediate);
    const isFree = !held.some((each) => each.name === name && (mode === 'exclusive' || each.mode === 'exclusive'));
    const lock = isFree ? { name, mode, tab } : null;
    if (lock) held.push(lock);
    await take(lock);
    held = held.filter((each) => each !== lock);
  };
  return { request, query: async () => ({ held: [...held] }) };
}

/** The page as it starts in another tab. What it does is to be called by `within`. */
async function newTab(): Promise<Tab> {
  vi.resetModules();
  const flags = await import('../../web/src/projects/crash_flag');
  const tab: Tab = {
    flags,
    events: new EventTarget(),
    die: () => {
      held = held.filter((each) => each.tab !== tab);
    },
  };
  return tab;
}

async function within<T>(tab: Tab, doing: (flags: Flags) => T): Promise<Awaited<T>> {
  for (const name of ['addEventListener', 'removeEventListener'] as const)
    vi.stubGlobal(name, (...of: Parameters<EventTarget['addEventListener']>) => tab.events[name](...of));
  vi.stubGlobal('navigator', { locks: locksOf(tab) });
  const done = await doing(tab.flags);
  await later();
  return done;
}

const hasDied = async (what: string): Promise<boolean> => within(await newTab(), (flags) => flags.hasCrashFlag(what));

test('a page that dies while it opens something has died of that; one that lives has not', async () => {
  const tab = await newTab();
  await within(tab, (flags) => flags.setCrashFlag('#net'));
  expect(await hasDied('#net')).toBe(false);
  tab.die();
  expect(await hasDied('#net')).toBe(true);
  expect(await hasDied('#other')).toBe(false);
});

test('what is refused at once hides no crash of another tab', async () => {
  await within(await newTab(), (flags) => flags.setCrashFlag('#net')());
  expect([held, [...stored]]).toEqual([[], []]);
  const other = await newTab();
  await within(other, (flags) => flags.setCrashFlag('#net'));
  other.die();
  expect(await hasDied('#net')).toBe(true);
});

test('tabs that come back together each know what they died of, whatever the others open', async () => {
  const [dies, first] = [await newTab(), await newTab()];
  await within(dies, (flags) => flags.setCrashFlag('#heavy'));
  dies.die();
  const flag = [...stored];
  await within(first, (flags) => flags.setCrashFlag('#light'));
  stored = new Map(flag);
  expect(await hasDied('#heavy')).toBe(true);
});

test('of two tabs that open the same, the second has not died when the first is done', async () => {
  const [first, second] = [await newTab(), await newTab()];
  const clear = await within(first, (flags) => flags.setCrashFlag('#net'));
  await within(second, (flags) => flags.setCrashFlag('#net'));
  const flag = [...stored];
  await within(first, clear);
  stored = new Map(flag);
  expect(await hasDied('#net')).toBe(false);
});

test('the flag of another tab stays when this one is done', async () => {
  const [slow, other] = [await newTab(), await newTab()];
  const clear = await within(slow, (flags) => flags.setCrashFlag('#slow'));
  await within(other, (flags) => flags.setCrashFlag('#heavy'));
  await within(slow, clear);
  other.die();
  expect(await hasDied('#heavy')).toBe(true);
});

test('what is given up for something else clears no flag of that', async () => {
  const tab = await newTab();
  const clear = await within(tab, (flags) => flags.setCrashFlag('#net'));
  await within(tab, (flags) => flags.setCrashFlag('#heavy'));
  await within(tab, clear);
  tab.die();
  expect(await hasDied('#heavy')).toBe(true);
});

test('a page that is left has not died; one that comes back with what it was opening may die of it', async () => {
  const tab = await newTab();
  await within(tab, (flags) => flags.setCrashFlag('#net'));
  await within(tab, () => tab.events.dispatchEvent(new Event('pagehide')));
  expect([held, [...stored]]).toEqual([[], []]);
  await within(tab, () => tab.events.dispatchEvent(Object.assign(new Event('pageshow'), { persisted: true })));
  expect(await hasDied('#net')).toBe(false);
  tab.die();
  expect(await hasDied('#net')).toBe(true);
});

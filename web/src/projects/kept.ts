/** Projects kept in this browser, the newest few. Each tab has one of its own, and every write is whole. */
import { createStore, delMany, get, set, update } from 'idb-keyval';

/** A stored project. Not validated here: it may be of another version of the page; readProject() checks it. */
export interface KeptProject {
  id: string;
  project: unknown;
}

const MOST = 6;
/** Holds the ids, newest first. */
const INDEX = 'index';
/** Key in sessionStorage, which belongs to the tab and survives a reload. */
const TAB = 'chebnet.tab';

const store = createStore('chebnet', 'projects');

/** Of this tab alone. */
export function newId(): string {
  const id = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
  void claim(id);
  return id;
}

/** Locks an id for this tab. False: another tab holds it, of which this one is a duplicate. The lock ends with the tab. */
export function claim(id: string): Promise<boolean> {
  const { locks } = navigator;
  if (locks === undefined) return Promise.resolve(true);
  return new Promise((resolve) => {
    const take = (lock: Lock | null): Promise<never> | null => {
      resolve(lock !== null);
      return lock && new Promise(() => {});
    };
    locks.request(`chebnet.${id}`, { ifAvailable: true }, take).catch(() => resolve(true));
  });
}

/** This tab's project from before the reload, else the newest; undefined: there is none. */
export async function findLast(): Promise<KeptProject | undefined> {
  const own = sessionStorage.getItem(TAB);
  return (own === null ? undefined : await read(own)) ?? findNewest(null);
}

/** Whether this tab stored it. */
export function isOwn(id: string): boolean {
  try {
    return sessionStorage.getItem(TAB) === id;
  } catch {
    return false; // Storage is switched off.
  }
}

/** The second newest. */
export async function findNewest(except: string | null): Promise<KeptProject | undefined> {
  const ids = (await get<string[]>(INDEX, store)) ?? [];
  const newest = ids.find((id) => id !== except);
  return newest === undefined ? undefined : read(newest);
}

export async function keep(id: string, project: unknown): Promise<void> {
  let forgotten: string[] = [];
  const note = (ids: string[] = []): string[] => {
    const all = [id, ...ids.filter((other) => other !== id)];
    forgotten = all.slice(MOST);
    return all.slice(0, MOST);
  };
  // Firefox refuses the first write after one for which there was no room.
  await set(id, project, store).catch(() => set(id, project, store));
  await update(INDEX, note, store);
  await delMany(forgotten, store);
  sessionStorage.setItem(TAB, id);
}

async function read(id: string): Promise<KeptProject | undefined> {
  const project: unknown = await get(id, store);
  return project === undefined ? undefined : { id, project };
}

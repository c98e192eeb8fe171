/** Projects kept in this browser: the newest few, those with a name, and those that are open. Each tab has one of its own, and
 *  every write is whole. What is listed of them, and what can be done with them: collection.ts. */
import { createStore, delMany, get, getMany, promisifyRequest, update } from 'idb-keyval';

/** A stored project. Not validated here: it may be of another version of the page; readProject() checks it. */
export interface KeptProject {
  id: string;
  project: unknown;
}

/** Without a name, and open nowhere. */
const MOST = 6;
/** Holds the ids, newest first. */
export const INDEX = 'index';
/** Holds the names that were given, by id. */
export const NAMES = 'names';
/** Key in sessionStorage, which belongs to the tab and survives a reload. */
const TAB = 'chebnet.tab';
/** Likewise the link in the address then. */
const LINK = 'chebnet.link';

/** Under which there is what is listed of a project. */
export function lookKey(id: string): string {
  return `look ${id}`;
}

/** Under which there is its view, if nothing but that has changed since the project was written. */
function viewKey(id: string): string {
  return `view ${id}`;
}

/** All that there may be of a project. */
export function keysOf(id: string): string[] {
  return [id, lookKey(id), viewKey(id)];
}

export const store = createStore('chebnet', 'projects');

export function freshId(): string {
  return `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
}

/** Of this tab alone. */
export function newId(): string {
  const id = freshId();
  void claim(id);
  return id;
}

interface Claim {
  granted: Promise<boolean>;
  end(): void;
}

/** The locks that this tab has or has asked for. */
const claims = new Map<string, Claim>();

export function lockOf(id: string): string {
  return `chebnet.${id}`;
}

/** Locks an id for this tab, which ends it by `release` or by its own end. False: another tab holds it, e.g. one of which
 *  this is a duplicate. @param mode `shared`: others may hold it in this way as well. */
export function claim(id: string, mode: LockMode = 'exclusive'): Promise<boolean> {
  const { locks } = navigator;
  if (locks === undefined) return Promise.resolve(true);
  return (claims.get(id) ?? ask(locks, id, mode)).granted;
}

function ask(locks: LockManager, id: string, mode: LockMode): Claim {
  let end = (): void => {};
  // At once where it is released before it is granted.
  const ended = new Promise<void>((resolve) => (end = resolve));
  const granted = new Promise<boolean>((resolve) => {
    const take = (lock: Lock | null): Promise<void> | null => {
      if (lock === null && claims.get(id) === asked) claims.delete(id);
      resolve(lock !== null);
      return lock && ended;
    };
    locks.request(lockOf(id), { mode, ifAvailable: true }, take).catch(() => resolve(true));
  });
  const asked = { granted, end };
  claims.set(id, asked);
  return asked;
}

export function release(id: string): void {
  claims.get(id)?.end();
  claims.delete(id);
}

/** Those of all tabs. */
export async function heldLocks(): Promise<ReadonlySet<string | undefined>> {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return new Set(held.map(({ name }) => name));
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

/** Whether it is what this tab has made of the link in its address. */
export function isMadeOfLink(id: string): boolean {
  return isOwn(id) && sessionStorage.getItem(LINK) === location.hash.slice(-999);
}

/** The second newest. */
export async function findNewest(except: string | null): Promise<KeptProject | undefined> {
  const ids = (await get<string[]>(INDEX, store)) ?? [];
  const newest = ids.find((id) => id !== except);
  return newest === undefined ? undefined : read(newest);
}

export function keep(id: string, project: unknown): Promise<void> {
  return write((projects) => {
    projects.put(project, id);
    projects.delete(viewKey(id));
  });
}

/** Of a project that is kept: the camera is turned often, and the rest of it may be large. */
export function keepView(id: string, view: object): Promise<void> {
  return write((projects) => projects.put(view, viewKey(id)));
}

/** What is kept becomes the newest, and this tab's; too many others that nobody has open or has named are forgotten. */
export async function enlist(id: string): Promise<void> {
  let forgotten: string[] = [];
  const note = (ids: string[] = []): string[] => {
    const all = [id, ...ids.filter((other) => other !== id)];
    forgotten = all.filter((each) => !Object.hasOwn(names, each) && !held.has(lockOf(each))).slice(MOST);
    return all.filter((each) => !forgotten.includes(each));
  };
  const names = (await get<Record<string, string>>(NAMES, store)) ?? {};
  const held = await heldLocks();
  await update(INDEX, note, store);
  await delMany(forgotten.flatMap(keysOf), store);
  sessionStorage.setItem(TAB, id);
  // Of long ones the end, in which they differ.
  sessionStorage.setItem(LINK, location.hash.slice(-999));
}

/** Firefox refuses the first write after one for which there was no room. */
function write(change: (projects: IDBObjectStore) => void): Promise<void> {
  return commit(change).catch(() => commit(change));
}

/** By itself: a page that is being left hears no answer after which it could. */
function commit(change: (projects: IDBObjectStore) => void): Promise<void> {
  return store('readwrite', (projects) => {
    change(projects);
    projects.transaction.commit();
    return promisifyRequest(projects.transaction);
  });
}

export async function hasName(id: string): Promise<boolean> {
  return Object.hasOwn((await get<object>(NAMES, store)) ?? {}, id);
}

export async function read(id: string): Promise<KeptProject | undefined> {
  const [project, view] = await getMany<unknown>([id, viewKey(id)], store);
  if (project === undefined) return undefined;
  return { id, project: view === undefined ? project : { ...(project as object), view } };
}

/** The history: every state of what is being made, by the name of the change that led to it. How one looks at it, the
 *  view, is not undone; all else of the document is. */
import type { ChebnetDocument, NetSource, UpAxis } from './document';
import type { ChangeName } from './naming';

/** Nothing in it may be changed afterwards; entries share what did not change. A net that came as text, in a project, is
 *  text until an entry that has it is gone to. */
export type Snapshot = Readonly<Omit<ChebnetDocument, 'view' | 'net'> & { net: NetSource }>;

export interface Entry {
  /** What was done to get here. */
  readonly name: ChangeName;
  readonly state: Snapshot;
  /** In projects, of a net that is not the present one: its axis that points up, if that is known. */
  readonly upAxis?: UpAxis;
}

/** What a panel shows of it. */
export interface HistoryView {
  readonly names: readonly ChangeName[];
  readonly present: number;
  /** How many entries before the first one were too much to keep. */
  readonly forgotten: number;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** A gesture is under way, whose entry is yet to come. */
  readonly inGesture: boolean;
  /** Counts up with whatever happens to it. */
  readonly revision: number;
}

/** The number of an entry, the present one's unless it is said, which stays whatever is forgotten. */
export function numberOf({ forgotten, present }: Pick<HistoryView, 'forgotten' | 'present'>, entry = present): number {
  return forgotten + entry;
}

/** Most bytes kept of the past, all entries together. */
const LARGEST = 100e6;

/**
 * The history of one document. A state is recorded before it is changed, and again when one leaves it to go elsewhere in
 * the history. A gesture, e.g. a drag, is one entry however many changes it makes; one goes nowhere while it goes on.
 */
export class UndoHistory implements HistoryView {
  #names: ChangeName[] = [''];
  /** The state of each entry; that of the present one is of the moment when it was last left. */
  #states: (Snapshot | null)[] = [null];
  #present = 0;
  #forgotten = 0;
  #gesture: Snapshot | null = null;
  /** Changes that have become part of the gesture. */
  #within: { before: Snapshot; name: ChangeName }[] = [];
  #lastKey: string | null = null;
  /** Changes that joined the one before, and the name that the entry had then. Their states are not kept for this. */
  #joined: { before: WeakRef<Snapshot>; name: ChangeName }[] = [];
  /** Those that could be gone forward to when a change was last recorded. */
  #namesAhead: ChangeName[] = [];
  #statesAhead: (Snapshot | null)[] = [];
  #revision = 0;
  readonly #changed: () => void;

  /** @param changed is called whenever another state can be gone to. */
  constructor(changed: () => void = () => {}) {
    this.#changed = changed;
  }

  get names(): readonly ChangeName[] {
    return [...this.#names];
  }

  get present(): number {
    return this.#present;
  }

  get forgotten(): number {
    return this.#forgotten;
  }

  get canUndo(): boolean {
    return this.#gesture === null && this.#present > 0;
  }

  get canRedo(): boolean {
    return this.#gesture === null && this.#present < this.#names.length - 1;
  }

  get inGesture(): boolean {
    return this.#gesture !== null;
  }

  /** The state before the gesture under way; null: none is. */
  get beforeGesture(): Snapshot | null {
    return this.#gesture;
  }

  /** Whether a change has become part of it. */
  get gestureHasChanges(): boolean {
    return this.#within.length > 0;
  }

  get revision(): number {
    return this.#revision;
  }

  /** Forgets all; `entries` are the history from now on. */
  begin(entries: readonly Entry[], present: number): void {
    this.#names = entries.map(({ name }) => name);
    this.#states = entries.map(({ state }) => state);
    this.#present = present;
    this.#gesture = null;
    this.#endJoining();
    this.#revised();
  }

  /** All of it, with `now` as the present state. */
  entries(now: Snapshot): Entry[] {
    return this.#names.map((name, i) => ({ name, state: (i === this.#present ? null : this.#states[i]) ?? now }));
  }

  /**
   * A change called `name`, which began at the state `before`. Changes one after another with the same `key` make one
   * entry, of the last name. Within a gesture a change is part of the gesture.
   */
  record(before: Snapshot, name: ChangeName, key: string | null = null): void {
    if (this.#gesture !== null) return void this.#within.push({ before, name });
    const joins = key !== null && key === this.#lastKey;
    this.#lastKey = key;
    if (joins) this.#join(before, name);
    else this.#push(before, name);
    this.#revised();
  }

  /** Takes back the change last recorded, which began at `before`: it failed. What it had put an end to can be gone to again.
   *  False: it was not the last, or joined one before, whose name comes back, or a gesture goes on; its entry stays. */
  takeBack(before: Snapshot): boolean {
    this.#unjoin(before);
    this.#within = this.#within.filter((each) => each.before !== before);
    if (this.#gesture !== null || this.#states[this.#present - 1] !== before) return false;
    this.#endJoining();
    this.#names.splice(this.#present, Infinity, ...this.#namesAhead);
    this.#present -= 1;
    this.#states.splice(this.#present, Infinity, null, ...this.#statesAhead);
    this.#revised();
    return true;
  }

  /** The next change is an entry of its own. */
  #endJoining(): void {
    this.#lastKey = null;
    this.#joined = [];
  }

  #join(before: Snapshot, name: ChangeName): void {
    this.#joined.push({ before: new WeakRef(before), name: this.#names[this.#present]! });
    this.#names[this.#present] = name;
  }

  /** What a change that joined had for a name before is that of the entry again, or else before the change that joined next. */
  #unjoin(before: Snapshot): void {
    const change = this.#joined.find((each) => each.before.deref() === before);
    if (change === undefined) return;
    const next = this.#joined[this.#joined.indexOf(change) + 1];
    if (next) next.name = change.name;
    else this.#names[this.#present] = change.name;
    this.#joined = this.#joined.filter((each) => each !== change);
    this.#revised();
  }

  /** Before the first change of a gesture. */
  beginGesture(before: Snapshot): void {
    if (this.#gesture !== null) return;
    this.#gesture = before;
    this.#within = [];
  }

  /** After its last change. A gesture without a name has that of the last change that became part of it; it changed nothing
   *  and leaves no entry if there was none. */
  endGesture(name: ChangeName | null): void {
    const before = this.#gesture;
    if (before === null) return;
    const called = name ?? this.#within.at(-1)?.name;
    this.#gesture = null;
    this.#endJoining();
    if (called === undefined) return this.#changed();
    this.#push(before, called);
    this.#revised();
  }

  /** Ends the gesture without a trace and returns the state to go back to, or null if there was none. */
  cancelGesture(): Snapshot | null {
    const before = this.#gesture;
    this.#gesture = null;
    this.#changed();
    return before;
  }

  /** The state to go back to, or null. */
  undo(now: Snapshot): Snapshot | null {
    return this.goTo(this.#present - 1, now);
  }

  /** The state to go forward to, or null. */
  redo(now: Snapshot): Snapshot | null {
    return this.goTo(this.#present + 1, now);
  }

  /** The state of entry `index`, to be gone to; null if there is nowhere to go. */
  stateAt(index: number): Snapshot | null {
    return this.#gesture !== null || index === this.#present ? null : (this.#states[index] ?? null);
  }

  /** Likewise, and it is the present one from now on. */
  goTo(index: number, now: Snapshot): Snapshot | null {
    const state = this.stateAt(index);
    if (state === null) return null;
    this.#endJoining();
    this.#states[this.#present] = now;
    this.#present = index;
    this.#revised();
    return state;
  }

  /** In all entries, for a net that is the same: e.g. that of a file for its text. */
  replaceNet(was: NetSource, is: NetSource): void {
    this.#states = this.#states.map((state) => (state?.net === was ? { ...state, net: is } : state));
  }

  #revised(): void {
    this.#revision += 1;
    this.#changed();
  }

  #push(before: Snapshot, name: ChangeName): void {
    this.#joined = [];
    this.#statesAhead = this.#states.splice(this.#present, Infinity, before, null).slice(1);
    this.#namesAhead = this.#names.splice(this.#present + 1, Infinity, name);
    this.#present += 1;
    const forgotten = firstKept(this.#states, this.#present - 1);
    this.#states.splice(0, forgotten);
    this.#names.splice(0, forgotten);
    this.#present -= forgotten;
    this.#forgotten += forgotten;
  }
}

/** Of the states up to `last` the first that is not too old to be kept; `last` always is. */
function firstKept(states: readonly (Snapshot | null)[], last: number): number {
  const measure = new Measure();
  for (let i = last; i >= 0; --i) {
    const state = states[i];
    if (state) measure.add(state);
    if (i < last && measure.bytes > LARGEST) return i + 1;
  }
  return 0;
}

/** Of a handle, as it is kept; as text it mostly takes less. */
export const HANDLE_BYTES = 200;

/** Adds up the bytes of states; what they share counts once. */
export class Measure {
  bytes = 0;
  readonly #seen = new Set<object | null>([null]);
  readonly #sharesHandles: boolean;

  /** @param sharesHandles false: each state has handles of its own, as in files. */
  constructor(sharesHandles = true) {
    this.#sharesHandles = sharesHandles;
  }

  add({ handles, positions, net, guide }: Snapshot): void {
    this.#add(this.#sharesHandles ? handles : {}, HANDLE_BYTES * handles.length);
    this.#add(positions, positions?.byteLength ?? 0);
    this.#add(net, bytesOf(net));
    if (guide && 'mesh' in guide) this.#add(guide, bytesOf(guide));
  }

  #add(part: object | null, bytes: number): void {
    if (this.#seen.has(part)) return;
    this.#seen.add(part);
    this.bytes += bytes;
  }
}

function bytesOf(net: NetSource): number {
  if ('recipe' in net) return 0;
  if ('obj' in net) return net.obj.length;
  const { positions, faceStart, faceVertices } = net.mesh;
  return positions.byteLength + faceStart.byteLength + faceVertices.byteLength;
}

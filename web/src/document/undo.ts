/** Undo and redo as whole states of what is being made: net, handles and positions. Solver options and the view are how
 *  one works and looks; they are not undone. */
import type { HandleData, NetSource, Symmetry } from './document';

/** Nothing in it may be changed afterwards; entries share what did not change. */
export interface Snapshot {
  readonly net: NetSource;
  readonly handles: readonly HandleData[];
  readonly symmetry?: Symmetry | undefined;
  readonly positions: Float64Array;
  /** Nothing was left to be solved. */
  readonly settled: boolean;
}

/** Most numbers kept in positions, all entries together: 100 MB. */
const LARGEST = 100e6 / Float64Array.BYTES_PER_ELEMENT;

/**
 * The history of one session. A state is recorded before it is changed; undo and redo swap it for the state of the
 * moment. A gesture, e.g. a drag, is one entry however many changes it makes, and cannot be undone while it goes on.
 */
export class UndoHistory {
  #past: Snapshot[] = [];
  #future: Snapshot[] = [];
  #gesture: Snapshot | null = null;
  #lastKey: string | null = null;

  get canUndo(): boolean {
    return this.#gesture === null && this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#gesture === null && this.#future.length > 0;
  }

  get inGesture(): boolean {
    return this.#gesture !== null;
  }

  /**
   * Before a change. Changes one after another with the same `key` make one entry. Within a gesture a change is part of
   * the gesture.
   */
  record(before: Snapshot, key: string | null = null): void {
    if (this.#gesture !== null) return;
    const joins = key !== null && key === this.#lastKey;
    this.#lastKey = key;
    if (!joins) this.#push(before);
  }

  /** Before the first change of a gesture. */
  beginGesture(before: Snapshot): void {
    this.#gesture ??= before;
  }

  /** After its last change; a gesture that changed nothing leaves no entry. */
  endGesture(changed: boolean): void {
    const before = this.#gesture;
    this.#gesture = null;
    this.#lastKey = null;
    if (before !== null && changed) this.#push(before);
  }

  /** Ends the gesture without a trace and returns the state to go back to, or null if there was none. */
  cancelGesture(): Snapshot | null {
    const before = this.#gesture;
    this.#gesture = null;
    return before;
  }

  /** The state to go back to, or null. */
  undo(now: Snapshot): Snapshot | null {
    return this.#swap(this.#past, this.#future, now);
  }

  /** The state to go forward to, or null. */
  redo(now: Snapshot): Snapshot | null {
    return this.#swap(this.#future, this.#past, now);
  }

  #swap(from: Snapshot[], to: Snapshot[], now: Snapshot): Snapshot | null {
    if (this.#gesture !== null) return null;
    const state = from.pop();
    if (state === undefined) return null;
    this.#lastKey = null;
    to.push(now);
    return state;
  }

  #push(before: Snapshot): void {
    this.#past.push(before);
    this.#future = [];
    while (this.#past.length > 1 && numbers(this.#past) > LARGEST) this.#past.shift();
  }
}

/** Numbers held by positions, shared ones counted once. */
function numbers(entries: readonly Snapshot[]): number {
  return [...new Set(entries.map(({ positions }) => positions))].reduce((sum, { length }) => sum + length, 0);
}

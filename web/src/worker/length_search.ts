/** The search for other lengths of all edges, in slices, between which messages come in; it shows no frames. */
import type { LengthAdapter } from '../../../wasm/chebnet';

const SLICE_MS = 100;

interface SearchEvents {
  /** The scale of the moment. */
  passes(scale: number): void;
  /** The net has the lengths that were found; null: there are none, and nothing has changed. */
  ended(scale: number | null): void;
  /** Nothing has come of it. */
  givenUp(why: unknown): void;
}

export class LengthSearch {
  /** null: the search is over. */
  #adapter: LengthAdapter | null;
  readonly #soon: (task: () => void) => void;
  readonly #events: SearchEvents;

  /** @param soon runs a task after the messages that wait already. */
  constructor(adapter: LengthAdapter, soon: (task: () => void) => void, events: SearchEvents) {
    this.#adapter = adapter;
    this.#soon = soon;
    this.#events = events;
    this.#goOnSoon();
  }

  giveUp(why: unknown): void {
    if (this.#adapter === null) return;
    this.#end(this.#adapter);
    this.#events.givenUp(why);
  }

  #goOnSoon(): void {
    this.#soon(() => {
      if (this.#adapter === null) return;
      try {
        this.#goOn(this.#adapter);
      } catch (error) {
        this.giveUp(error);
      }
    });
  }

  #goOn(adapter: LengthAdapter): void {
    const { status, scale } = adapter.solve({ milliseconds: SLICE_MS });
    if (status === 'running') {
      this.#events.passes(scale);
      return this.#goOnSoon();
    }
    const isFound = status === 'converged';
    if (isFound) adapter.accept();
    this.#end(adapter);
    this.#events.ended(isFound ? scale : null);
  }

  #end(adapter: LengthAdapter): void {
    this.#adapter = null;
    adapter.dispose();
  }
}

/** A search for another state of the open net, in slices, between which messages come in; it shows no frames. */
import type { AdaptReport, Editor, Handle, RestSearchReport } from '../../../wasm/chebnet';
import type { SearchFor, SearchProgress } from './protocol';

const SLICE = { milliseconds: 100 };

interface SearchEvents {
  passes(progress: SearchProgress): void;
  /** The net is in the state that was found; null: there is none, and nothing has changed. */
  ended(found: number | null): void;
  /** Nothing has come of it. */
  givenUp(why: unknown): void;
}

/** Of the core. */
interface Searching {
  solve(budget: typeof SLICE): AdaptReport | RestSearchReport;
  accept(): void;
  dispose(): void;
}

export class Search {
  /** null: it is over. */
  #search: Searching | null;
  readonly #soon: (task: () => void) => void;
  readonly #events: SearchEvents;

  /** @param asked where the last hand wanted handles.
   *  @param soon runs a task after the messages that wait already. */
  constructor(
    what: SearchFor,
    editor: Editor,
    asked: readonly Handle[],
    soon: (task: () => void) => void,
    events: SearchEvents,
  ) {
    this.#search = what === 'rest' ? editor.restSearch() : editor.lengthAdapter(asked);
    this.#soon = soon;
    this.#events = events;
    this.#goOnSoon();
  }

  giveUp(why: unknown): void {
    if (this.#search === null) return;
    this.#end(this.#search);
    this.#events.givenUp(why);
  }

  #goOnSoon(): void {
    this.#soon(() => {
      if (this.#search === null) return;
      try {
        this.#goOn(this.#search);
      } catch (error) {
        this.giveUp(error);
      }
    });
  }

  #goOn(search: Searching): void {
    const report = search.solve(SLICE);
    if (report.status === 'running') {
      const reached = 'scale' in report ? report.scale : report.done;
      this.#events.passes({ reached, iterations: report.iterations });
      return this.#goOnSoon();
    }
    const isFound = report.status === 'converged';
    if (isFound) search.accept();
    this.#end(search);
    const found = 'scale' in report ? report.scale : report.energy / report.energyBefore;
    this.#events.ended(isFound ? found : null);
  }

  #end(search: Searching): void {
    this.#search = null;
    search.dispose();
  }
}

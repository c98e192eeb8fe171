/** Placeholder for the results of a comparison, which are loaded on demand. */
import type { Comparison, NetOrigin, Run } from '../compare/run';
import { lazy } from '../lazy';
import type { ComparisonResults } from './results';
import { make } from '../elements/dom';
import type { Panel, PanelEvents } from '../panels';

const loadResults = lazy(() => import('./results'));

export class ComparisonPlace implements Panel {
  /** Replaced when they are loaded. */
  readonly element = make('section', { hidden: true });
  #results: ComparisonResults | null = null;
  #comparison: Comparison | null = null;
  /** Others may have been opened before the results have come. */
  #net: NetOrigin | null = null;
  readonly #events: PanelEvents;
  readonly #failed: (error: unknown) => void;

  /** @param failed is called if they cannot be loaded. */
  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.#failed = failed;
  }

  /** May be called often. */
  setComparison(comparison: Comparison): void {
    const isNew = comparison !== this.#comparison;
    this.#comparison = comparison;
    if (this.#results) this.#results.setComparison(comparison);
    else if (isNew) this.#load().catch(this.#failed);
  }

  setRuns(run: Run | null, beside: readonly Run[]): void {
    this.#results?.setShown(run, beside);
  }

  setDocument({ net, numbering }: NetOrigin): void {
    if (net === this.#net?.net && numbering === this.#net.numbering) return;
    this.#net = { net, numbering };
    this.#results?.setNet(this.#net);
  }

  async #load(): Promise<void> {
    const { ComparisonResults } = await loadResults();
    if (this.#results || !this.#comparison) return;
    this.#results = new ComparisonResults(this.#events);
    this.element.replaceWith(this.#results.element);
    if (this.#net) this.#results.setNet(this.#net);
    this.#results.setComparison(this.#comparison);
  }
}

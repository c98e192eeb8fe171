/** Panels that are told the same news. Those that join later are told the latest of each kind first. */
import type { Panel } from '../panels';

/** Those methods of panels that tell them something. */
type Update = Exclude<keyof Panel, 'element'>;
type News<Name extends Update> = Parameters<NonNullable<Panel[Name]>>;

/** News of one net, which say nothing of the next. */
const OF_ONE_NET: readonly Update[] = ['onFrame', 'setFrame', 'setRuns'];

export class PanelList {
  readonly #panels: Panel[];
  /** The last news of each kind, in the order in which the kinds came first. */
  readonly #told = new Map<Update, unknown[]>();

  constructor(panels: Panel[]) {
    this.#panels = panels;
  }

  tell<Name extends Update>(name: Name, ...news: News<Name>): void {
    if (name === 'setNet') for (const outdated of OF_ONE_NET) this.#told.delete(outdated);
    this.#told.set(name, news);
    for (const panel of this.#panels) hear(panel, name, news);
  }

  join(panel: Panel): void {
    for (const [name, news] of this.#told) hear(panel, name, news);
    this.#panels.push(panel);
  }
}

function hear(panel: Panel, name: Update, news: unknown[]): void {
  (panel[name] as ((...news: unknown[]) => void) | undefined)?.apply(panel, news);
}

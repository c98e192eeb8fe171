/** The experiments: a list of links, and over the picture a note on the one that is open. */
import { experimentLink, findExperiment } from '../experiments/experiment';
import type { Experiment } from '../experiments/experiment';
import { EXPERIMENTS } from '../experiments/list';
import { make, makeButton } from './dom';
import type { PanelEvents } from './panels';

const READING =
  'After the figures of Li et al. 2022, on nets of our own; which experiment stands for which figure is our reading of the paper.';

export class ExperimentsPanel {
  readonly note = make('section', { class: 'experiment', hidden: true, 'aria-label': 'Experiment' });
  readonly content: HTMLElement[];
  private readonly links = new Map<string, HTMLAnchorElement>();
  private shown: string | undefined;

  constructor(private readonly events: PanelEvents) {
    const items = EXPERIMENTS.map((each) => make('li', {}, make('span', {}, `Figure ${each.figure}`), this.makeEntry(each)));
    this.content = [make('ul', { class: 'experiments' }, ...items), make('p', { class: 'quiet' }, READING)];
  }

  show(name: string | undefined): void {
    if (name === this.shown) return;
    this.shown = name;
    for (const [each, link] of this.links) link.setAttribute('aria-current', String(each === name));
    const experiment = findExperiment(name);
    this.note.hidden = experiment === undefined;
    this.note.replaceChildren(...(experiment ? this.describe(experiment) : []));
  }

  private makeEntry({ name, title }: Experiment): HTMLAnchorElement {
    const link = makeLink(experimentLink(name), title);
    this.links.set(name, link);
    return link;
  }

  private describe({ name, figure, title, text, variants = [] }: Experiment): HTMLElement[] {
    const links = [{ label: 'As it is' }, ...variants].map(({ label }, i) => makeLink(experimentLink(name, i), label));
    const buttons = [
      makeButton('Solve', () => this.events.solve(), { title: 'Iterate until the solve ends' }),
      makeButton('One step', () => this.events.step(), { title: 'One iteration, then stop' }),
    ];
    return [
      make('details', { open: true }, make('summary', {}, `Figure ${figure}: ${title}`), make('p', {}, text)),
      make('div', { class: 'buttons' }, ...buttons),
      make('nav', { 'aria-label': 'Settings to try', hidden: variants.length === 0 }, 'Begin again: ', ...links),
    ];
  }
}

/** A link to the address that is open already begins it again; of itself it would do nothing. */
function makeLink(hash: string, text: string): HTMLAnchorElement {
  const link = make('a', { href: hash }, text);
  link.addEventListener('click', () => {
    if (location.hash === hash) dispatchEvent(new HashChangeEvent('hashchange'));
  });
  return link;
}

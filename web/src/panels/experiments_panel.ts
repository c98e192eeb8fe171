/** The experiments: a list of links, and over the picture a note on the one that is open. */
import { experimentLink, findExperiment } from '../experiments/experiment';
import type { Experiment } from '../experiments/experiment';
import { EXPERIMENTS } from '../experiments/list';
import { words } from '../language/language';
import { make, makeButton } from './dom';
import type { PanelEvents } from './panels';

export class ExperimentsPanel {
  readonly note = make('section', { class: 'experiment', hidden: true, 'aria-label': words.experiment.label });
  readonly content: HTMLElement[];
  private readonly links = new Map<string, HTMLAnchorElement>();
  private shown: string | undefined;

  constructor(private readonly events: PanelEvents) {
    const items = EXPERIMENTS.map((each) => make('li', {}, make('span', {}, words.experiment.figure(each.figure)), this.makeEntry(each)));
    this.content = [make('ul', { class: 'experiments' }, ...items), make('p', { class: 'quiet' }, words.experiment.reading)];
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
    const links = [{ label: words.experiment.asItIs }, ...variants].map(({ label }, i) => makeLink(experimentLink(name, i), label));
    const buttons = [
      makeButton(words.solver.solve, () => this.events.solve(), { title: words.solver.solveHint }),
      makeButton(words.step.step, () => this.events.step(), { title: words.step.stepHint }),
    ];
    return [
      make('details', { open: true }, make('summary', {}, words.experiment.heading(figure, title)), make('p', {}, text)),
      make('div', { class: 'buttons' }, ...buttons),
      make('nav', { 'aria-label': words.experiment.settings, hidden: variants.length === 0 }, words.experiment.again, ...links),
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

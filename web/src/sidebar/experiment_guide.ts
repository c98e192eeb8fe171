/** The list of the paper's figures, and the note on the one that is open: what to look for, what the paper claims and what was
 *  measured, and ways to try it. */
import type { ChebnetDocument } from '../document/document';
import {
  EDITS,
  type Figure,
  FIGURES,
  findFigure,
  isOfNet,
  settingsOf,
  textOf,
  type Variant,
} from '../experiments/figures';
import { experimentLink } from '../experiments/links';
import { texts } from '../experiments/texts';
import { variationsOf } from '../experiments/variations';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton } from '../elements/dom';
import { makeClaims, makePicture } from './experiment_claims';
import { hasNewNet, NewNetTrial } from './new_net_trial';
import type { PanelEvents } from '../panels';
import { count } from '../language/numbers';
import './experiment_guide.css';

/** On a smaller screen a note is folded at first. */
const ROOMY = '(min-width: 721px)';

/** A link, and whether a document is what it opens. */
interface Offer {
  link: HTMLAnchorElement;
  hash(document: ChebnetDocument): string;
  isOpen(document: ChebnetDocument): boolean;
}

export class ExperimentGuide {
  /** Of the section in the sidebar. */
  readonly content: HTMLElement[];
  readonly #listed = FIGURES.map(offerFigure);
  #offered: Offer[] = [];
  /** Of the figure that has one, with what was found out, also while another figure is open. */
  #trial: NewNetTrial | null = null;
  #shown: Figure | undefined;
  #document: ChebnetDocument | null = null;
  readonly #note: HTMLElement;
  readonly #events: PanelEvents;
  readonly #failed: (error: unknown) => void;

  /** @param failed is called if something cannot be loaded. */
  constructor(note: HTMLElement, events: PanelEvents, failed: (error: unknown) => void) {
    this.#note = note;
    this.#events = events;
    this.#failed = failed;
    note.setAttribute('aria-label', texts.label);
    const items = FIGURES.map(({ figure }, i) =>
      make('li', {}, make('span', {}, texts.figure(figure)), this.#listed[i]!.link),
    );
    this.content = [
      make('ul', { class: 'experiments' }, ...items),
      make('p', { class: 'quiet' }, texts.about, ' ', makeCitation()),
    ];
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    const figure = findFigure(document.experiment);
    this.#note.hidden = figure === undefined;
    if (figure !== this.#shown) this.#describe(figure);
    for (const { link, hash, isOpen } of [...this.#listed, ...this.#offered]) {
      link.setAttribute('href', hash(document));
      link.setAttribute('aria-current', String(isOpen(document)));
    }
  }

  #describe(figure: Figure | undefined): void {
    this.#shown = figure;
    this.#offered = [];
    this.#trial?.stop();
    if (figure === undefined) return this.#note.replaceChildren();
    const edits = figure.edits.map((edit, place) => offerEdit(figure, edit, place));
    const variants = figure.variants.map((variant, place) => offerVariant(figure, variant, place));
    this.#offered = [...edits, ...variants];
    const buttons = [
      makeButton(panelWords.solver.solve, () => this.#events.solve(), { title: panelWords.solver.solveHint }),
      makeButton(panelWords.step.step, () => this.#events.step(), { title: panelWords.step.stepHint }),
      makeButton(texts.runAll, () => this.#runAll(figure), { title: texts.runAllHint, hidden: variants.length < 2 }),
    ];
    this.#note.replaceChildren(
      make(
        'details',
        { open: matchMedia(ROOMY).matches },
        make('summary', {}, texts.heading(texts.figure(figure.figure), textOf(figure.title))),
        make('p', {}, textOf(figure.look)),
        ...makePicture(figure),
        ...this.#trialOf(figure),
        makeClaims(figure),
        make('p', { class: 'quiet' }, makeCitation()),
      ),
      makeOffers(
        texts.edits,
        edits.map(({ link }) => link),
      ),
      makeOffers(
        texts.variants,
        variants.map(({ link }, i) => (figure.variants[i]!.ours ? marked(link) : link)),
      ),
      make('div', { class: 'buttons' }, ...buttons),
    );
  }

  #trialOf(figure: Figure): HTMLElement[] {
    if (!hasNewNet(figure)) return [];
    this.#trial ??= new NewNetTrial(figure, titleOf, this.#failed);
    return [this.#trial.element];
  }

  #runAll(figure: Figure): void {
    variationsOf(figure, this.#document!).then((requests) => this.#events.runAll(requests), this.#failed);
  }
}

function offerFigure(figure: Figure): Offer {
  return {
    link: makeLink(textOf(figure.title)),
    hash: () => experimentLink(figure.name),
    isOpen: ({ experiment }) => findFigure(experiment) === figure,
  };
}

/** With the variant that is open. */
function offerEdit({ name, variants }: Figure, edit: string, place: number): Offer {
  return {
    link: makeLink(titleOf(edit)),
    hash: (document) =>
      experimentLink(
        name,
        place,
        Math.max(
          0,
          variants.findIndex((each) => isOpenVariant(each, document)),
        ),
      ),
    isOpen: ({ net }) => isOfNet(edit, net),
  };
}

/** With the edit that is open. */
function offerVariant({ name, edits }: Figure, variant: Variant, place: number): Offer {
  return {
    link: makeLink(textOf(variant.label)),
    hash: ({ net }) =>
      experimentLink(
        name,
        Math.max(
          0,
          edits.findIndex((each) => isOfNet(each, net)),
        ),
        place,
      ),
    isOpen: (document) => isOpenVariant(variant, document),
  };
}

function isOpenVariant(variant: Variant, { net, method, initialisation, options }: ChebnetDocument): boolean {
  const own = settingsOf(variant);
  const names = Object.keys({ ...own.options, ...options });
  return (
    own.method === method &&
    own.initialisation === initialisation &&
    names.every((name) => own.options[name] === options[name]) &&
    (variant.edit === undefined || isOfNet(variant.edit, net))
  );
}

/** Of its shape and size. */
function titleOf(edit: string): string {
  const { net, vertices } = EDITS[edit]!;
  if ('mesh' in net) return texts.meshes[net.mesh as keyof typeof texts.meshes] ?? net.mesh;
  const [shape = ''] = net.recipe.split(':');
  return texts.edit(words.core.shapes()[shape] ?? shape, vertices === undefined ? '' : count(vertices));
}

/** Nothing if there is only one to choose. */
function makeOffers(title: string, links: HTMLElement[]): HTMLElement {
  return make('nav', { 'aria-label': title, hidden: links.length < 2 }, make('span', {}, title), ...links);
}

/** Makes a link to the present address open it again; by default nothing would happen. */
function makeLink(text: string): HTMLAnchorElement {
  const link = make('a', {}, text);
  link.addEventListener('click', () => {
    if (location.hash === link.hash) dispatchEvent(new HashChangeEvent('hashchange'));
  });
  return link;
}

function marked(link: HTMLElement): HTMLElement {
  return make('span', { title: texts.oursHint }, link, ` (${texts.ours})`);
}

function makeCitation(): HTMLElement {
  return make('cite', {}, texts.paper);
}

/** Puts the controls together. Over the picture: title, tools, legend and messages; beside it, on a phone below it, the rest in
 *  sections that fold. */
import type { Comparison, Run } from '../compare/run';
import { ComparisonPlace } from '../comparison/place';
import type { ChebnetDocument, HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import { make, makeButton, makeIcon } from '../elements/dom';
import type { Choice } from '../handles/commands';
import { words } from '../language/language';
import { lazy } from '../lazy';
import type { Tables } from '../net/tables';
import { Legend } from '../overlay/legend';
import { Messages } from '../overlay/messages';
import { OpeningNotice } from '../overlay/opening_notice';
import { Title } from '../overlay/title';
import { Toolbar } from '../overlay/toolbar';
import type { Action, Panel, PanelEvents, Panels } from '../panels';
import { isCancelled } from '../worker/client';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { ExperimentsPlace } from './experiments_place';
import { makeLanguageChoice } from './language_choice';
import { PanelList } from './panel_list';
import { createSections, type SidebarServices } from './sections';
import { StatusRow } from './status_row';
import { messageOf } from '../failure';
import '../overlay/overlay.css';
import './sidebar.css';

/** Interval between updates of numbers, in milliseconds: faster ones cannot be read. */
const REFRESH_MS = 120;
/** How long after the first net the other sections are loaded: its picture comes first. */
const LATE_MS = 300;

const CHEVRONS = 'M3.5 3.5 8 8l-4.5 4.5M8.5 3.5 13 8l-4.5 4.5';

const loadLateSections = lazy(() => import('./late_sections'));

export function createPanels(root: HTMLElement, events: PanelEvents): Panels {
  return new Sidebar(root, events);
}

class Sidebar implements Panels {
  readonly #messages = new Messages();
  readonly #toolbar: Toolbar;
  readonly #fold = makeButton(words.page.controls, () => this.#unfold(!this.#sections.classList.contains('open')));
  readonly #narrow = makeButton(
    makeIcon(CHEVRONS),
    () => this.#setNarrow(!this.#element.classList.contains('narrow')),
    {
      class: 'plain narrow-button',
      'aria-label': words.page.hideControls,
      title: words.page.hideControls,
      'aria-pressed': 'false',
    },
  );
  readonly #element: HTMLElement;
  readonly #sections: HTMLElement;
  /** All of them. */
  readonly #panels: PanelList;
  readonly #legend = new Legend();
  readonly #services: SidebarServices;
  readonly #experiments: ExperimentsPlace;
  readonly #shape: Panel;
  readonly #behaviour: Panel;
  #lateAreWanted = false;
  #pending: { frame: FrameData; framesPerSecond: number; solving: boolean } | null = null;
  #timer = 0;

  constructor(root: HTMLElement, events: PanelEvents) {
    const failed = (error: unknown): void => {
      if (!isCancelled(error)) this.say(messageOf(error), 'error');
    };
    this.#experiments = new ExperimentsPlace(events, failed);
    this.#toolbar = new Toolbar(events);
    const over: Panel[] = [
      new Title(events, this.#experiments.note),
      this.#toolbar,
      this.#legend,
      this.#messages,
      new OpeningNotice(() => events.cancelOpening()),
    ];
    const results = new ComparisonPlace(events, failed);
    const status = new StatusRow(events, [this.#narrow, this.#fold]);
    this.#services = {
      events,
      failed,
      say: (message: string) => this.say(message, 'info'),
      fold: () => this.#unfold(false),
    };
    const sections = createSections(this.#services);
    [this.#shape, this.#behaviour] = sections;
    this.#panels = new PanelList([...over, results, status, ...sections, this.#experiments]);

    this.#sections = make('div', { class: 'sections', id: 'sections' }, ...elementsOf(sections));
    this.#fold.classList.add('fold');
    this.#fold.setAttribute('aria-controls', this.#sections.id);
    this.#unfold(false);
    this.#sections.addEventListener('click', (event) => bringIntoSight(event.target));
    this.#element = make(
      'aside',
      { class: 'sidebar', 'aria-label': words.page.controls },
      status.element,
      this.#sections,
      makeLanguageChoice((language) => events.chooseLanguage(language)),
    );
    root.append(
      make('section', { class: 'over', 'aria-label': words.page.over }, ...elementsOf(over), ...this.#toolbar.menus),
      results.element,
      this.#element,
    );
  }

  setTables(tables: Tables): void {
    this.#panels.tell('setTables', tables);
  }

  setDocument(document: ChebnetDocument, choice: Choice): void {
    this.#panels.tell('setDocument', document, choice);
    this.setHandles(document.handles, choice);
  }

  setHistory(history: HistoryView): void {
    this.#panels.tell('setHistory', history);
  }

  setNet(net: OpenedNet): void {
    this.#panels.tell('setNet', net);
    this.#wantLateSections();
  }

  setOpening(isUnderWay: boolean, canCancel: boolean): void {
    this.#panels.tell('setOpening', isUnderWay, canCancel);
  }

  setFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void {
    this.#panels.tell('onFrame', frame);
    this.#pending = { frame, framesPerSecond, solving };
    if (this.#timer === 0) this.#timer = window.setTimeout(() => this.#refresh(), REFRESH_MS);
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    this.#panels.tell('setHandles', handles, choice);
  }

  setComparison(comparison: Comparison): void {
    this.#panels.tell('setComparison', comparison);
  }

  setRuns(run: Run | null, beside: readonly Run[]): void {
    this.#panels.tell('setRuns', run, beside);
  }

  say(message: string, kind: 'info' | 'error', action?: Action): void {
    this.#messages.say(message, kind, action);
  }

  unsay(): void {
    this.#messages.unsay();
  }

  offer(message: string, button: string, accept: () => void): void {
    this.#messages.offer(message, button, accept);
  }

  #refresh(): void {
    this.#timer = 0;
    const { frame, framesPerSecond, solving } = this.#pending!;
    this.#panels.tell('setFrame', frame, framesPerSecond, solving);
  }

  /** Those that could not be loaded are wanted again with the next net, or when there is a network. */
  #wantLateSections(): void {
    if (this.#lateAreWanted) return;
    this.#lateAreWanted = true;
    const failed = (error: unknown): void => {
      this.#lateAreWanted = false;
      addEventListener('online', () => this.#wantLateSections(), { once: true });
      this.#services.failed(error);
    };
    setTimeout(() => this.#addLateSections().catch(failed), LATE_MS);
  }

  async #addLateSections(): Promise<void> {
    const { createLateSections, pause } = await loadLateSections();
    const { panels, elements, notices, tools } = await createLateSections(
      this.#services,
      this.#experiments.element,
      this.#shape.element,
      this.#behaviour.element,
      this.#toolbar.exports,
      this.#legend.ends,
    );
    for (const panel of panels) {
      this.#panels.join(panel);
      await pause();
    }
    this.#sections.append(...elements);
    this.#messages.element.before(...tools);
    this.#messages.element.prepend(...notices);
  }

  #setNarrow(narrow: boolean): void {
    this.#element.classList.toggle('narrow', narrow);
    this.#narrow.setAttribute('aria-pressed', String(narrow));
  }

  #unfold(open: boolean): void {
    this.#sections.classList.toggle('open', open);
    this.#fold.setAttribute('aria-expanded', String(open));
  }
}

/** A section that was opened at the lower end of the sidebar would be out of sight. */
function bringIntoSight(clicked: EventTarget | null): void {
  const section = (clicked as Element).closest('summary')?.parentElement as HTMLDetailsElement | null | undefined;
  // It is unfolded after this event.
  requestAnimationFrame(() => section?.open && section.scrollIntoView({ block: 'nearest' }));
}

function elementsOf(panels: readonly Panel[]): HTMLElement[] {
  return panels.map(({ element }) => element);
}

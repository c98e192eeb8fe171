/** Puts the controls together. Over the picture: title, tools, legend and messages; beside it, on a phone below it, the rest in
 *  sections that fold. */
import type { Comparison, Run } from '../compare/run';
import { ComparisonPlace } from '../comparison/place';
import type { ChebnetDocument, HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import { make, makeButton } from '../elements/dom';
import type { Choice } from '../handles/commands';
import { words } from '../language/language';
import type { Tables } from '../net/tables';
import { Legend } from '../overlay/legend';
import { Messages } from '../overlay/messages';
import { OpeningNotice } from '../overlay/opening_notice';
import { RunNotice } from '../overlay/run_notice';
import { SelectionBar } from '../overlay/selection_bar';
import { Title } from '../overlay/title';
import { Toolbar } from '../overlay/toolbar';
import type { Action, Panel, PanelEvents, Panels } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { ExperimentsPlace } from './experiments_place';
import { makeLanguageChoice } from './language_choice';
import { createSections } from './sections';
import { StatusRow } from './status_row';
import type { Wireframe } from './thumbnail';
import { messageOf } from '../failure';
import '../overlay/overlay.css';
import './sidebar.css';

/** Interval between updates of numbers, in milliseconds: faster ones cannot be read. */
const REFRESH_MS = 120;

export function createPanels(root: HTMLElement, events: PanelEvents): Panels {
  return new Sidebar(root, events);
}

class Sidebar implements Panels {
  readonly #messages = new Messages();
  readonly #fold = makeButton(words.page.controls, () => this.#unfold(!this.#sections.classList.contains('open')));
  readonly #sections: HTMLElement;
  /** All panels, which get every update. */
  readonly #panels: readonly Panel[];
  #pending: { frame: FrameData; framesPerSecond: number; solving: boolean } | null = null;
  #timer = 0;

  constructor(root: HTMLElement, events: PanelEvents) {
    const failed = (error: unknown): void => this.say(messageOf(error), 'error');
    const experiments = new ExperimentsPlace(events, failed);
    const toolbar = new Toolbar(events);
    const over: Panel[] = [
      new Title(experiments.note),
      toolbar,
      new Legend(events),
      new SelectionBar(events),
      this.#messages,
      new RunNotice(events),
      new OpeningNotice(() => events.cancelOpening()),
    ];
    const results = new ComparisonPlace(events, failed);
    const status = new StatusRow(events, this.#fold);
    const services = {
      events,
      failed,
      say: (message: string) => this.say(message, 'info'),
      fold: () => this.#unfold(false),
    };
    const sections = createSections(services, experiments);
    this.#panels = [...over, results, status, ...sections];

    this.#sections = make('div', { class: 'sections', id: 'sections' }, ...elementsOf(sections));
    this.#fold.classList.add('fold');
    this.#fold.setAttribute('aria-controls', this.#sections.id);
    this.#unfold(false);
    root.append(
      make('section', { class: 'over', 'aria-label': words.page.over }, ...elementsOf(over), ...toolbar.menus),
      results.element,
      make(
        'aside',
        { class: 'sidebar', 'aria-label': words.page.controls },
        status.element,
        this.#sections,
        makeLanguageChoice((language) => events.chooseLanguage(language)),
      ),
    );
  }

  setTables(tables: Tables, thumbnail: (recipe: string) => Promise<Wireframe>): void {
    for (const panel of this.#panels) panel.setTables?.(tables, thumbnail);
  }

  setDocument(document: ChebnetDocument, choice: Choice): void {
    for (const panel of this.#panels) panel.setDocument?.(document, choice);
    this.setHandles(document.handles, choice);
  }

  setHistory(history: HistoryView): void {
    for (const panel of this.#panels) panel.setHistory?.(history);
  }

  setNet(net: OpenedNet): void {
    for (const panel of this.#panels) panel.setNet?.(net);
  }

  setOpening(isUnderWay: boolean, canCancel: boolean): void {
    for (const panel of this.#panels) panel.setOpening?.(isUnderWay, canCancel);
  }

  setFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void {
    for (const panel of this.#panels) panel.onFrame?.(frame);
    this.#pending = { frame, framesPerSecond, solving };
    if (this.#timer === 0) this.#timer = window.setTimeout(() => this.#refresh(), REFRESH_MS);
  }

  setHandles(handles: readonly HandleData[], choice: Choice): void {
    for (const panel of this.#panels) panel.setHandles?.(handles, choice);
  }

  setComparison(comparison: Comparison): void {
    for (const panel of this.#panels) panel.setComparison?.(comparison);
  }

  setRuns(run: Run | null, beside: readonly Run[]): void {
    for (const panel of this.#panels) panel.setRuns?.(run, beside);
  }

  say(message: string, kind: 'info' | 'error', action?: Action): void {
    this.#messages.say(message, kind, action);
  }

  offer(message: string, button: string, accept: () => void): void {
    this.#messages.offer(message, button, accept);
  }

  #refresh(): void {
    this.#timer = 0;
    const { frame, framesPerSecond, solving } = this.#pending!;
    for (const panel of this.#panels) panel.setFrame?.(frame, framesPerSecond, solving);
  }

  #unfold(open: boolean): void {
    this.#sections.classList.toggle('open', open);
    this.#fold.setAttribute('aria-expanded', String(open));
  }
}

function elementsOf(panels: readonly Panel[]): HTMLElement[] {
  return panels.map(({ element }) => element);
}

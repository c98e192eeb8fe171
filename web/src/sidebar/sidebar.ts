/** Puts the panels together. Over the picture: title, tools, legend and messages; beside it, on a phone below it, the rest in
 *  sections that fold. */
import type { ShapeInfo } from '../../../wasm/chebnet';
import type { ChebnetDocument, HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import type { Tables } from '../net/tables';
import type { FrameData, OpenedNet } from '../worker/protocol';
import type { Comparison, Run } from '../compare/run';
import { words } from '../language/language';
import type { Choice } from '../handles/wishes';
import { Appearance } from './appearance';
import { ComparisonForm } from '../comparison/form';
import { ComparisonPlace } from '../comparison/place';
import { ConvergencePlot } from './convergence_plot';
import { make, makeButton, makeSection, setSummary, setText } from '../elements/dom';
import { DragPanel } from './drag_panel';
import { ExperimentsPlace } from './experiments_place';
import { Gallery } from './gallery';
import { HandleList } from './handle_list';
import { HistoryPanel } from './history_panel';
import { Idle } from './idle';
import { makeLanguageChoice } from './language_choice';
import { LearnPanel } from './learn_panel';
import { Legend } from '../overlay/legend';
import { LiveNumbers } from './live_numbers';
import { Messages } from '../overlay/messages';
import { OpeningNotice } from '../overlay/opening_notice';
import type { Action, PanelEvents, Panels } from '../panels';
import { SelectionBar } from '../overlay/selection_bar';
import { RunNotice } from '../overlay/run_notice';
import { ShapeParameters } from './shape_parameters';
import { SolverPanel } from './solver_panel';
import { StepPanel } from './step_panel';
import type { Wireframe } from './thumbnail';
import { Toolbar } from '../overlay/toolbar';
import { statusWords } from './status';
import '../overlay/overlay.css';
import './sidebar.css';

/** Numbers that change more often cannot be read. */
const REFRESH_MS = 120;

export function createPanels(root: HTMLElement, events: PanelEvents): Panels {
  return new Sidebar(root, events);
}

class Sidebar implements Panels {
  private readonly idle = new Idle();
  private readonly gallery: Gallery;
  private readonly parameters: ShapeParameters;
  private readonly handles: HandleList;
  private readonly drag: DragPanel;
  private readonly numbers = new LiveNumbers();
  private readonly plot = new ConvergencePlot();
  private readonly appearance: Appearance;
  private readonly solver: SolverPanel;
  private readonly step: StepPanel;
  private readonly learn: LearnPanel;
  private readonly experiments: ExperimentsPlace;
  private readonly history: HistoryPanel;
  private readonly comparison: ComparisonForm;
  private readonly results: ComparisonPlace;
  private readonly runNotice: RunNotice;
  private readonly openingNotice: OpeningNotice;
  private readonly toolbar: Toolbar;
  private readonly bar: SelectionBar;
  private readonly legend: Legend;
  private readonly messages = new Messages();
  private readonly status = make('span', { class: 'status-words' }, words.status.loading);
  private readonly light = make('i', { class: 'light', 'data-status': 'running' });
  private readonly fileName = make('p', { class: 'quiet', hidden: true });
  private readonly toDrag = makeDragLine();
  private readonly toClick = make('p', { hidden: true }, words.intro.click);
  private readonly toSelect = make('p', { class: 'to-select', role: 'status' });
  private readonly handleSection: HTMLDetailsElement;
  private readonly sections: HTMLElement;
  private readonly fold = makeButton(words.page.controls, () => this.unfold(!this.sections.classList.contains('open')));
  private shapes: ShapeInfo[] = [];
  private usualThreshold = 1e-6;
  private pending: { frame: FrameData; framesPerSecond: number; solving: boolean } | null = null;
  private timer = 0;

  constructor(root: HTMLElement, events: PanelEvents) {
    this.gallery = new Gallery(
      this.idle,
      (recipe) => events.openRecipe(recipe),
      () => events.pickFile(),
    );
    this.parameters = new ShapeParameters((recipe) => events.openRecipe(recipe));
    this.handles = new HandleList(events);
    this.drag = new DragPanel(events.handles);
    this.appearance = new Appearance(events);
    this.legend = new Legend(events);
    this.solver = new SolverPanel(events);
    this.step = new StepPanel(events);
    this.learn = new LearnPanel(events);
    this.experiments = new ExperimentsPlace(events, (error) => this.sayFault(error));
    this.comparison = new ComparisonForm((wish) => {
      this.unfold(false); // a phone has no room for the results beside it
      events.compare(wish);
    });
    this.results = new ComparisonPlace(events, (error) => this.sayFault(error));
    this.runNotice = new RunNotice(() => {
      events.showRun(null);
      events.showBeside([]);
    });
    this.openingNotice = new OpeningNotice(() => events.cancelOpening());
    this.history = new HistoryPanel((index) => events.goTo(index));
    this.toolbar = new Toolbar(events);
    this.bar = new SelectionBar(events);
    this.handleSection = makeSection(words.handles.title(0), false, ...this.handles.content);
    const equalize = makeButton(words.equalize.command, () => events.equalize(), { title: words.equalize.commandHint });
    const command = make('div', { class: 'buttons' }, equalize);
    this.sections = make(
      'div',
      { class: 'sections', id: 'sections' },
      makeSection(words.sections.shape, true, this.gallery.element, this.fileName, this.parameters.element, command),
      makeSection(words.sections.convergence, true, this.numbers.element, this.plot.element),
      this.learn.element,
      makeSection(words.sections.step, false, ...this.step.content),
      this.handleSection,
      makeSection(words.sections.drag, false, ...this.drag.content),
      makeSection(words.sections.appearance, false, ...this.appearance.content),
      makeSection(words.sections.solver, false, ...this.solver.content),
      this.history.section,
      this.experiments.section,
      makeSection(words.sections.compare, false, ...this.comparison.content),
    );
    root.append(
      make(
        'section',
        { class: 'over', 'aria-label': words.page.over },
        make(
          'header',
          { class: 'title' },
          make('h1', {}, 'chebnet'),
          this.toDrag,
          this.toClick,
          this.toSelect,
          this.experiments.note,
        ),
        this.toolbar.element,
        this.legend.element,
        this.bar.element,
        this.messages.element,
        this.runNotice.element,
        this.openingNotice.element,
        ...this.toolbar.menus,
      ),
      this.results.element,
      make(
        'aside',
        { class: 'sidebar', 'aria-label': words.page.controls },
        this.statusRow(events),
        this.sections,
        makeLanguageChoice((language) => events.chooseLanguage(language)),
      ),
    );
  }

  showTables(tables: Tables, thumbnail: (recipe: string) => Promise<Wireframe>): void {
    const { shapes, options } = tables;
    this.shapes = shapes;
    this.usualThreshold = options.find(({ name }) => name === 'threshold')?.value ?? this.usualThreshold;
    this.idle.touch();
    this.gallery.showTables(tables, thumbnail);
    this.toolbar.showFormats(tables.formats);
    this.solver.showTables(tables);
    this.comparison.showTable(tables.methods);
  }

  showDocument(document: ChebnetDocument, choice: Choice): void {
    const { net, view, options } = document;
    const recipe = 'recipe' in net ? net.recipe : null;
    this.gallery.showCurrent(recipe?.split(':')[0] ?? null);
    this.parameters.show(recipe, this.shapes);
    this.fileName.hidden = recipe !== null;
    setText(this.fileName, 'name' in net ? net.name : '');
    this.experiments.show(document);
    this.comparison.propose(document.compare);
    this.appearance.show(view);
    this.legend.show(view);
    this.solver.showDocument(document);
    this.plot.setThreshold(Number(options.threshold ?? this.usualThreshold));
    this.handles.showSymmetry(document.symmetry);
    this.drag.show(document.locality);
    this.showHandles(document.handles, choice);
  }

  showHistory(history: HistoryView): void {
    this.toolbar.showHistory(history);
    this.solver.showUndo(history.canUndo);
    this.history.show(history);
  }

  showNet(net: OpenedNet): void {
    this.numbers.showNet(net);
    this.legend.showNet(net);
    this.results.netChanged();
    this.step.showNet(net);
    this.learn.showNet(net);
    this.handles.showNet(net.info.vertices, net.info.meanLength);
    this.drag.showNet(net.info.vertices);
    this.plot.clear();
  }

  showOpening(isUnderWay: boolean, canCancel: boolean): void {
    this.openingNotice.show(isUnderWay, canCancel);
  }

  showFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void {
    this.idle.touch();
    this.plot.add(frame.trace);
    this.learn.take(frame);
    const stage = this.step.take(frame);
    if (stage !== null) this.say(stage, 'info');
    this.pending = { frame, framesPerSecond, solving };
    if (this.timer === 0) this.timer = window.setTimeout(() => this.refresh(), REFRESH_MS);
  }

  showHandles(handles: readonly HandleData[], choice: Choice): void {
    setSummary(this.handleSection, words.handles.title(handles.length));
    this.numbers.showHandles(handles.length);
    const { selecting, selection } = choice;
    const draggable = handles.some(({ anchor }) => !anchor);
    this.toDrag.hidden = selecting || !draggable;
    this.toClick.hidden = selecting || draggable;
    setText(this.toSelect, selecting ? words.intro.select(selection.length) : '');
    this.toolbar.showSelecting(selecting);
    this.handles.show(handles, choice);
    this.bar.show(handles, choice);
  }

  showComparison(comparison: Comparison): void {
    this.results.show(comparison);
  }

  showRuns(run: Run | null, beside: readonly Run[]): void {
    const frame = run?.frame ?? this.pending?.frame;
    if (frame) this.legend.showFrame(frame);
    this.results.showCurrent(run, beside);
    this.runNotice.show(run, beside);
  }

  say(message: string, kind: 'info' | 'error', action?: Action): void {
    this.messages.say(message, kind, action);
  }

  offer(message: string, button: string, accept: () => void): void {
    this.messages.offer(message, button, accept);
  }

  private sayFault(error: unknown): void {
    this.say(error instanceof Error ? error.message : String(error), 'error');
  }

  private refresh(): void {
    this.timer = 0;
    const { frame, framesPerSecond, solving } = this.pending!;
    this.numbers.showFrame(frame, framesPerSecond);
    this.plot.refresh();
    this.step.refresh();
    this.learn.refresh();
    this.legend.showFrame(frame);
    this.solver.showSolving(solving);
    this.light.dataset.status = frame.status === 'running' && !solving ? 'stalled' : frame.status;
    setText(this.status, statusWords(frame.status, solving, frame.iterations));
  }

  /** On a phone the row is all that is left of the sidebar until its button unfolds it. */
  private statusRow(events: PanelEvents): HTMLElement {
    this.fold.classList.add('fold');
    this.fold.setAttribute('aria-controls', this.sections.id);
    this.unfold(false);
    const keys = makeButton('?', () => events.showKeys(), {
      class: 'keys-button',
      'aria-label': words.keys.title,
      title: words.keys.hint,
    });
    return make('div', { class: 'status' }, this.light, this.status, keys, this.fold);
  }

  private unfold(open: boolean): void {
    this.sections.classList.toggle('open', open);
    this.fold.setAttribute('aria-expanded', String(open));
  }
}

function makeDragLine(): HTMLElement {
  const { before, sphere, after } = words.intro.drag;
  return make('p', {}, before, make('em', {}, sphere), after);
}

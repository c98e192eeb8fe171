/** Puts the panels together. Over the picture: title, tools, legend and messages; beside it, on a phone below it, the rest in
 *  sections that fold. */
import type { MethodInfo, OptionInfo, ShapeInfo } from '../../../wasm/chebnet';
import type { ChebnetDocument, HandleData } from '../document/document';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { Appearance } from './appearance';
import { ConvergencePlot } from './convergence_plot';
import { make, makeButton, makeSection, setSummary, setText } from './dom';
import { Gallery } from './gallery';
import { handleCount, HandleList } from './handle_list';
import { Idle } from './idle';
import { Legend } from './legend';
import { LiveNumbers } from './live_numbers';
import { Messages } from './messages';
import type { PanelEvents, Panels } from './panels';
import { ShapeParameters } from './shape_parameters';
import { SolverPanel } from './solver_panel';
import type { Wireframe } from './thumbnail';
import { Toolbar } from './toolbar';
import { statusWords } from './words';

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
  private readonly numbers = new LiveNumbers();
  private readonly plot = new ConvergencePlot();
  private readonly appearance: Appearance;
  private readonly solver: SolverPanel;
  private readonly toolbar: Toolbar;
  private readonly legend = new Legend();
  private readonly messages = new Messages();
  private readonly status = make('span', { class: 'status-words' }, 'Loading the solver');
  private readonly light = make('i', { class: 'light', 'data-status': 'running' });
  private readonly fileName = make('p', { class: 'quiet', hidden: true });
  private readonly toDrag = make('p', {}, 'Drag the ', make('em', {}, 'orange sphere'), '. Every edge keeps its length.');
  private readonly toClick = make('p', { hidden: true }, 'Click a vertex to take hold of it. Every edge keeps its length.');
  private readonly handleSection: HTMLDetailsElement;
  private readonly sections: HTMLElement;
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
    this.appearance = new Appearance(events);
    this.solver = new SolverPanel(events);
    this.toolbar = new Toolbar(events);
    this.handleSection = makeSection(handleCount([]), false, ...this.handles.content);
    this.sections = make(
      'div',
      { class: 'sections', id: 'sections' },
      makeSection('Shape', true, this.gallery.element, this.fileName, this.parameters.element),
      makeSection('Convergence', true, this.numbers.element, this.plot.element),
      this.handleSection,
      makeSection('Appearance', false, ...this.appearance.content),
      makeSection('Solver', false, ...this.solver.content),
    );
    root.append(
      make(
        'section',
        { class: 'over', 'aria-label': 'Title, actions and legend' },
        make(
          'header',
          { class: 'title' },
          make('h1', {}, 'chebnet'),
          this.toDrag,
          this.toClick,
        ),
        this.toolbar.element,
        this.legend.element,
        this.messages.element,
      ),
      make('aside', { class: 'sidebar', 'aria-label': 'Controls' }, this.statusRow(), this.sections),
    );
  }

  showTables(
    shapes: ShapeInfo[],
    methods: MethodInfo[],
    options: OptionInfo[],
    thumbnail: (recipe: string) => Promise<Wireframe>,
  ): void {
    this.shapes = shapes;
    this.usualThreshold = options.find(({ name }) => name === 'threshold')?.value ?? this.usualThreshold;
    this.idle.touch();
    this.gallery.showShapes(shapes, thumbnail);
    this.solver.showTables(methods, options);
  }

  showDocument(document: ChebnetDocument, selected: number | null, canUndo: boolean): void {
    const { net, view, options } = document;
    const recipe = 'recipe' in net ? net.recipe : null;
    this.gallery.showCurrent(recipe?.split(':')[0] ?? null);
    this.parameters.show(recipe, this.shapes);
    this.fileName.hidden = recipe !== null;
    setText(this.fileName, 'name' in net ? net.name : '');
    this.appearance.show(view);
    this.legend.show(view);
    this.solver.showDocument(document, canUndo);
    this.toolbar.showUndo(canUndo);
    this.plot.setThreshold(Number(options.threshold ?? this.usualThreshold));
    this.showHandles(document.handles, selected);
  }

  showNet(net: OpenedNet): void {
    this.numbers.showNet(net);
    this.handles.showNet(net.info.vertices, net.info.meanLength);
    this.plot.clear();
  }

  showFrame(frame: FrameData, framesPerSecond: number, solving: boolean): void {
    this.idle.touch();
    this.plot.add(frame.trace);
    this.pending = { frame, framesPerSecond, solving };
    if (this.timer === 0) this.timer = window.setTimeout(() => this.refresh(), REFRESH_MS);
  }

  showHandles(handles: readonly HandleData[], selected: number | null): void {
    setSummary(this.handleSection, handleCount(handles));
    this.numbers.showHandles(handles.length);
    const draggable = handles.some(({ anchor }) => !anchor);
    this.toDrag.hidden = !draggable;
    this.toClick.hidden = draggable;
    this.handles.show(handles, selected);
  }

  say(message: string, kind: 'info' | 'error'): void {
    this.messages.say(message, kind);
  }

  private refresh(): void {
    this.timer = 0;
    const { frame, framesPerSecond, solving } = this.pending!;
    this.numbers.showFrame(frame, framesPerSecond);
    this.plot.refresh();
    this.legend.showFrame(frame);
    this.solver.showSolving(solving);
    this.light.dataset.status = frame.status === 'running' && !solving ? 'stalled' : frame.status;
    setText(this.status, statusWords(frame.status, solving));
  }

  /** On a phone the row is all that is left of the sidebar until its button unfolds it. */
  private statusRow(): HTMLElement {
    const fold = makeButton('Controls', () => {
      const open = this.sections.classList.toggle('open');
      fold.setAttribute('aria-expanded', String(open));
    });
    fold.classList.add('fold');
    fold.setAttribute('aria-expanded', 'false');
    fold.setAttribute('aria-controls', this.sections.id);
    return make('div', { class: 'status' }, this.light, this.status, fold);
  }
}

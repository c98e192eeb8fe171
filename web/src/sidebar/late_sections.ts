/** The sections of the sidebar that come after the first picture, in the order of what people do. */
import { ComparisonForm } from '../comparison/form';
import { makeSection } from '../elements/dom';
import type { Menu } from '../elements/menu';
import { listenForMenus } from '../elements/menu_keys';
import { panelWords } from '../language/panels';
import { Narrator } from './narrator';
import { ExportLines } from '../overlay/export_menu';
import { Growth } from '../overlay/growth';
import { MapEnds } from '../overlay/map_ends';
import { PartNotice } from '../overlay/part_notice';
import { RunNotice } from '../overlay/run_notice';
import { SelectionBar } from '../overlay/selection_bar';
import { SharpNotice } from '../overlay/sharp_notice';
import { StuckNotice } from '../overlay/stuck_notice';
import type { Panel } from '../panels';
import { Appearance } from './appearance';
import { ChangePanel } from './change_panel';
import { ConvergencePanel } from './convergence_panel';
import { DragPanel } from './drag_panel';
import { FlipControl } from './flip_control';
import { GalleryPictures } from './gallery_pictures';
import { HandleList } from './handle_list';
import { HistoryPanel } from './history_panel';
import { LearnPanel } from './learn_panel';
import { RelaxControl } from './relax_control';
import { RodControls } from './rod_controls';
import type { SidebarServices } from './sections';
import { ShapeHints } from './shape_hints';
import { SolverPanel } from './solver_panel';
import { StepPanel } from './step_panel';
import { StopButton } from './stop_button';
import './late_sections.css';

/** Between two sections, if the page never is idle. */
const PATIENCE_MS = 100;

interface LateSections {
  panels: Panel[];
  /** From top to bottom. */
  elements: HTMLElement[];
  /** To be placed with the messages over the picture. */
  notices: HTMLElement[];
  /** To be placed over the picture. */
  tools: HTMLElement[];
}

/** Between two of them, each of which has much to do at first: a hand at the net, and pictures, go before. */
export function pause(): Promise<void> {
  return new Promise((resolve) => {
    // WebKit has none.
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: PATIENCE_MS });
    else setTimeout(resolve);
  });
}

/** @param experiments exists already, since its note is placed elsewhere. @param shape the section that gets its
 *  pictures and hints.
 *  @param behaviour the section to which more controls are added. @param exports the menu that is still empty. @param ends what
 *  the legend unfolds. */
export async function createLateSections(
  { events, say, failed, fold }: SidebarServices,
  experiments: HTMLElement,
  shape: HTMLElement,
  behaviour: HTMLElement,
  exports: Menu,
  ends: HTMLElement,
): Promise<LateSections> {
  listenForMenus();
  const comparison = new ComparisonForm((request) => {
    fold();
    events.compare(request);
  });
  const drag = new DragPanel(events.handles, say, failed);
  const otherRests = [new FlipControl(events), new RelaxControl(events)];
  drag.element.append(...otherRests.map(({ element }) => element));
  const rods = new RodControls(events);
  behaviour.append(rods.element);
  const mapEnds = new MapEnds(events);
  ends.append(mapEnds.element);
  const stop = new StopButton(events);
  document.querySelector('.status-words')!.after(stop.element);
  await pause();
  const handles = new HandleList(events);
  await pause();
  const usual = [
    handles,
    drag,
    new ChangePanel(events, failed),
    new Appearance(events),
    new HistoryPanel((index) => events.goTo(index)),
    new LearnPanel(events, failed),
  ];
  await pause();
  const [convergence, solver, step] = [new ConvergencePanel(), new SolverPanel(events), new StepPanel(events, say)];
  const research = makeSection(
    panelWords.research,
    false,
    ...[convergence, solver, step].map(({ element }) => element),
    experiments,
    comparison.element,
  );
  research.classList.add('group');
  const tools = [new SelectionBar(events), new PartNotice(events), new RunNotice(events)];
  const notices = [new SharpNotice(events), new StuckNotice(events, failed), new Narrator(events.isChanging)];
  return {
    panels: [
      ...usual,
      new GalleryPictures(shape),
      new ShapeHints(shape),
      new Growth(document.getElementById('view')!, events),
      rods,
      mapEnds,
      ...otherRests,
      new ExportLines(exports, events),
      convergence,
      solver,
      step,
      comparison,
      stop,
      ...tools,
      ...notices,
    ],
    notices: notices.map(({ element }) => element),
    tools: tools.map(({ element }) => element),
    elements: [...usual.map(({ element }) => element), research],
  };
}

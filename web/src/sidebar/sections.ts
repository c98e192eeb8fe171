/** The sections of the sidebar. Another panel is a row here, its own file, and its title in both languages. */
import { ComparisonForm } from '../comparison/form';
import type { Panel, PanelEvents } from '../panels';
import { Appearance } from './appearance';
import { BehaviourPanel } from './behaviour_panel';
import { ConvergencePanel } from './convergence_panel';
import { DragPanel } from './drag_panel';
import { HandleList } from './handle_list';
import { HistoryPanel } from './history_panel';
import { LearnPanel } from './learn_panel';
import { ShapePanel } from './shape_panel';
import { SolverPanel } from './solver_panel';
import { StepPanel } from './step_panel';

/** Services of the sidebar for panels. */
export interface SidebarServices {
  events: PanelEvents;
  say(message: string): void;
  /** A part of a panel could not be loaded. */
  failed(error: unknown): void;
  /** Makes room on a phone for what is behind the sidebar. */
  fold(): void;
}

/** From top to bottom. @param experiments exists already, since its note is placed elsewhere. */
export function createSections({ events, say, failed, fold }: SidebarServices, experiments: Panel): Panel[] {
  return [
    new ShapePanel(events),
    new ConvergencePanel(),
    new LearnPanel(events, failed),
    new StepPanel(events, say),
    new HandleList(events),
    new BehaviourPanel(events),
    new DragPanel(events.handles),
    new Appearance(events),
    new SolverPanel(events),
    new HistoryPanel((index) => events.goTo(index)),
    experiments,
    new ComparisonForm((request) => {
      fold();
      events.compare(request);
    }),
  ];
}

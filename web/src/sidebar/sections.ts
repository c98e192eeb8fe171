/** The sections of the sidebar. Another panel is a row here or in late_sections.ts, its own file, and its title in both
 *  languages. */
import type { PanelEvents } from '../panels';
import { BehaviourPanel } from './behaviour_panel';
import { ShapePanel } from './shape_panel';

/** Services of the sidebar for panels. */
export interface SidebarServices {
  events: PanelEvents;
  say(message: string): void;
  /** A part of a panel could not be loaded, or what it asked for was not done; what was cancelled is not told. */
  failed(error: unknown): void;
  /** Makes room on a phone for what is behind the sidebar. */
  fold(): void;
}

/** From top to bottom, those that the first visitor looks at; the others follow (late_sections.ts). */
export function createSections({ events, failed }: SidebarServices): [ShapePanel, BehaviourPanel] {
  return [new ShapePanel(events), new BehaviourPanel(events, failed)];
}

/** Frequent commands, over the view: project, undo, selecting several, showing the whole net, sharing, exporting. */
import type { HandleData } from '../document/document';
import type { HistoryView } from '../document/undo';
import type { Choice } from '../handles/commands';
import { words } from '../language/language';
import { make, makeButton, makeIcon } from '../elements/dom';
import { setDisabled } from '../elements/leave';
import { Menu } from '../elements/menu';
import type { Panel, PanelEvents } from '../panels';
import { createProjectMenu } from './project_menu';
import './toolbar.css';

const ICONS = {
  select:
    'M5.6 10.2C3.5 9.6 2 8.2 2 6.4c0-2.2 2.7-3.9 6-3.9s6 1.7 6 3.9-2.7 3.9-6 3.9c-.8 0-1.7 0-2.4-.1M5.6 10.2A1.4 1.4 0 1 0 3.4 11c.2 1 .9 1.8 2.1 2.5',
  undo: 'M5.5 3 2.5 6l3 3M2.5 6h7a4 4 0 0 1 0 8h-3',
  redo: 'M10.5 3l3 3-3 3M13.5 6h-7a4 4 0 0 0 0 8h3',
  reset: 'M3 8a5 5 0 1 0 1.6-3.7M3 2.5v3h3',
  frame: 'M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3',
  link: 'M6.5 9.5l3-3M7.5 5l1.7-1.7a2.5 2.5 0 0 1 3.5 3.5L11 8.5M8.5 11l-1.7 1.7a2.5 2.5 0 0 1-3.5-3.5L5 7.5',
};
const EXPORT_ICON = 'M8 2.5v8M4.8 7.5 8 10.7l3.2-3.2M2.5 13.5h11';

export class Toolbar implements Panel {
  readonly element: HTMLElement;
  /** To be placed outside the toolbar element. */
  readonly menus: HTMLElement[];
  /** Of what the net can be exported as; its lines come after the first picture. */
  readonly exports: Menu;
  readonly #undo: HTMLButtonElement;
  readonly #redo: HTMLButtonElement;
  readonly #select: HTMLButtonElement;

  constructor(events: PanelEvents) {
    const tool = (name: keyof typeof ICONS, click: () => void) => {
      const { label, hint } = words.toolbar[name];
      const button = makeButton(makeIcon(ICONS[name]), click, { title: hint, 'aria-label': label });
      button.append(make('span', {}, label));
      return button;
    };
    this.exports = new Menu({ id: 'export-menu', icon: EXPORT_ICON, ...words.toolbar.export }, []);
    const projects = createProjectMenu(events, () => this.exports.menu.showPopover());
    this.menus = [projects.menu, this.exports.menu];
    this.#undo = tool('undo', () => events.undo());
    this.#redo = tool('redo', () => events.redo());
    for (const each of [this.#undo, this.#redo]) each.classList.add('undoing');
    this.#select = tool('select', () => events.handles.toggleSelecting());
    this.element = make(
      'div',
      { class: 'toolbar', role: 'group', 'aria-label': words.toolbar.actions },
      projects.button,
      this.#undo,
      this.#redo,
      tool('reset', () => events.reset()),
      this.#select,
      tool('frame', () => events.frameAll()),
      tool('link', () => events.share()),
      this.exports.button,
    );
  }

  setHandles(_handles: readonly HandleData[], { selecting }: Choice): void {
    this.#select.setAttribute('aria-pressed', String(selecting));
  }

  setHistory({ canUndo, canRedo }: HistoryView): void {
    setDisabled(this.#undo, !canUndo);
    setDisabled(this.#redo, !canRedo);
  }
}

/** What the net can be saved as: a button and the menu it opens, which closes by Escape or a click elsewhere. */
import { EXPORT_KINDS } from '../files/export';
import type { ExportKind, FileKind } from '../files/export';
import { words } from '../language/language';
import { make, makeButton, makeIcon } from './dom';

const ICON = 'M8 2.5v8M4.8 7.5 8 10.7l3.2-3.2M2.5 13.5h11';
/** Between button and menu, and between menu and the edge of the page. */
const GAP = 8;

export class ExportMenu {
  readonly button = make(
    'button',
    { type: 'button', title: words.toolbar.save.hint, 'aria-label': words.toolbar.save.label, popovertarget: 'export-menu', 'aria-haspopup': 'true' },
    makeIcon(ICON),
    make('span', {}, words.toolbar.save.label),
  );
  readonly menu: HTMLElement;

  constructor(private readonly save: (kind: FileKind) => void) {
    const items = EXPORT_KINDS.map((each, i) => this.makeItem(each, i === 0));
    this.menu = make('div', { class: 'menu', id: 'export-menu', popover: 'auto', role: 'group', 'aria-label': words.file.saveAs }, ...items);
    this.menu.addEventListener('toggle', () => this.place());
    // Escape is for the menu alone.
    this.menu.addEventListener('keydown', (event) => event.stopPropagation());
  }

  private makeItem({ kind }: ExportKind, first: boolean): HTMLButtonElement {
    const choose = (): void => {
      this.menu.hidePopover();
      this.save(kind);
    };
    // Whoever opens the menu by key goes on from its first entry.
    const item = makeButton(make('strong', {}, kind.toUpperCase()), choose, { class: 'plain', autofocus: first });
    item.append(make('span', {}, words.file.kinds[kind]));
    return item;
  }

  /** Below the button, or above it where there is more room; in sight in any case. */
  private place(): void {
    const { left, top, bottom } = this.button.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = this.menu;
    const below = bottom + GAP + offsetHeight < innerHeight;
    this.menu.style.left = `${Math.max(GAP, Math.min(left, innerWidth - offsetWidth - GAP))}px`;
    this.menu.style.top = `${below ? bottom + GAP : Math.max(GAP, top - GAP - offsetHeight)}px`;
  }
}

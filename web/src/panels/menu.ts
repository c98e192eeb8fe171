/** A button and the menu it opens, which closes by Escape or a click elsewhere. */
import { make, makeButton, makeIcon } from './dom';

/** Between button and menu, and between menu and the edge of the page. */
const GAP = 8;

export interface MenuItem {
  title: string;
  hint: string;
  choose(): void;
}

export interface MenuLook {
  id: string;
  icon: string;
  label: string;
  /** What the button is for. */
  hint: string;
  /** What the menu is. */
  title: string;
}

export class Menu {
  readonly button: HTMLButtonElement;
  readonly menu: HTMLElement;

  constructor({ id, icon, label, hint, title }: MenuLook, items: readonly MenuItem[]) {
    this.button = make(
      'button',
      { type: 'button', title: hint, 'aria-label': label, popovertarget: id, 'aria-haspopup': 'true' },
      makeIcon(icon),
      make('span', {}, label),
    );
    const lines = items.map((each, i) => this.makeLine(each, i === 0));
    this.menu = make('div', { class: 'menu', id, popover: 'auto', role: 'group', 'aria-label': title }, ...lines);
    this.menu.addEventListener('toggle', () => this.place());
    // Escape is for the menu alone.
    this.menu.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') event.stopPropagation();
    });
  }

  private makeLine({ title, hint, choose }: MenuItem, first: boolean): HTMLButtonElement {
    const chosen = (): void => {
      this.menu.hidePopover();
      choose();
    };
    // Whoever opens the menu by key goes on from its first entry.
    const line = makeButton(make('strong', {}, title), chosen, { class: 'plain', autofocus: first });
    line.append(make('span', {}, hint));
    return line;
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

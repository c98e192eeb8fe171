/** A button and the menu it opens, which closes by Escape or a click elsewhere; see also menu_keys.ts. */
import { make, makeButton, makeIcon } from './dom';
import './menu.css';

/** Between button and menu, and between menu and the edge of the page. */
const GAP = 8;

export interface MenuItem {
  title: string;
  hint: string;
  choose(): void;
  disabled?: boolean;
  /** Controls at the end of the line: settings of the command. */
  beside?: readonly HTMLElement[];
}

/** Lines that belong together, below a heading. */
interface MenuGroup {
  title: string;
  items: readonly MenuItem[];
}

interface MenuLook {
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

  constructor({ id, icon, label, hint, title }: MenuLook, content: readonly (MenuItem | MenuGroup)[]) {
    this.button = make(
      'button',
      { type: 'button', title: hint, 'aria-label': label, popovertarget: id, 'aria-haspopup': 'true' },
      makeIcon(icon),
      make('span', {}, label),
    );
    this.menu = make('div', { class: 'menu', id, popover: 'auto', role: 'group', 'aria-label': title });
    this.setContent(content);
    // Opened by key, the menu has the focus on its first entry. Set only then: while a page in a frame of another site
    // loads, browsers complain of autofocus.
    this.menu.addEventListener('beforetoggle', () =>
      this.menu.querySelector('button')?.toggleAttribute('autofocus', true),
    );
    this.menu.addEventListener('toggle', () => this.#place());
  }

  setContent(content: readonly (MenuItem | MenuGroup)[]): void {
    this.menu.replaceChildren(
      ...content.map((each) => ('items' in each ? this.#makeGroup(each) : this.#makeLine(each))),
    );
    if (this.menu.matches(':popover-open')) this.#place();
  }

  #makeGroup({ title, items }: MenuGroup): HTMLElement {
    return make('section', {}, make('h3', {}, title), ...items.map((each) => this.#makeLine(each)));
  }

  #makeLine({ title, hint, choose, disabled = false, beside = [] }: MenuItem): HTMLElement {
    const chosen = (): void => {
      this.menu.hidePopover();
      choose();
    };
    const item = makeButton(make('strong', {}, title), chosen, { class: 'plain', disabled });
    item.append(make('span', {}, hint));
    return make('div', { class: 'line' }, item, ...beside);
  }

  /** Below the button, or above it where there is more room; always within the window. */
  #place(): void {
    const { left, top, bottom } = this.button.getBoundingClientRect();
    // With parts of pixels, as Firefox has them.
    const { width, height } = this.menu.getBoundingClientRect();
    const below = bottom + GAP + height < innerHeight;
    this.menu.style.left = `${Math.max(GAP, Math.min(left, innerWidth - Math.ceil(width) - GAP))}px`;
    this.menu.style.top = `${below ? bottom + GAP : Math.max(GAP, top - GAP - height)}px`;
  }
}

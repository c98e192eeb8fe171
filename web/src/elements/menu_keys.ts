/** Keys of menus that are open, as menus have them elsewhere. They come after the first picture. */
import { make } from './dom';

/** Of a shortcut in what a line is for, in any language. */
const SHORTCUT = /\s?[(（]Ctrl[^)）]*[)）]/;

export function listenForMenus(): void {
  document.querySelectorAll<HTMLElement>('.menu .plain > span').forEach(setShortcutApart);
  // In the capture phase: before what else Escape ends.
  addEventListener('keydown', pressKey, { capture: true });
}

function pressKey(event: KeyboardEvent): void {
  const { target } = event;
  const isOther = event.ctrlKey || event.metaKey || event.altKey || !(target instanceof Element);
  if (isOther || (event.key !== 'Escape' && target.matches('input,select'))) return;
  const menu = document.querySelector<HTMLElement>('.menu:popover-open');
  const isHandled = menu ? pressIn(menu, event.key) : openFrom(target, event.key);
  if (!isHandled) return;
  event.preventDefault();
  event.stopPropagation();
}

function pressIn(menu: HTMLElement, key: string): boolean {
  if (key === 'Escape') {
    menu.hidePopover();
    buttonOf(menu)?.focus();
    return true;
  }
  const items = [...menu.querySelectorAll<HTMLButtonElement>('.line > button:enabled')];
  const at = items.indexOf(document.activeElement as HTMLButtonElement);
  const { length } = items;
  const next = {
    ArrowDown: (at + 1) % length,
    ArrowUp: (Math.max(at, 0) + length - 1) % length,
    Home: 0,
    End: length - 1,
  }[key];
  if (next === undefined) return false;
  items[next]?.focus();
  return true;
}

/** The arrow down opens the menu of the button that has the focus, at its first line. */
function openFrom(target: Element, key: string): boolean {
  const menu = document.getElementById(target.getAttribute('popovertarget') ?? '');
  if (key !== 'ArrowDown' || !menu?.matches('.menu')) return false;
  menu.showPopover();
  return true;
}

function buttonOf(menu: HTMLElement): HTMLElement | null {
  return document.querySelector<HTMLElement>(`[popovertarget="${menu.id}"]`);
}

/** So that it does not show where there are no keys, see late_sections.css. */
function setShortcutApart(hint: HTMLElement): void {
  const words = hint.textContent;
  const [shortcut] = SHORTCUT.exec(words) ?? [];
  if (shortcut !== undefined)
    hint.replaceChildren(words.replace(shortcut, ''), make('span', { class: 'keys' }, shortcut));
}

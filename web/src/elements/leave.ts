/** What goes while it has the focus. */

/** The picture, the first canvas of the page, takes the focus of what is about to go: it would fall to the page, where keys do
 *  nothing, and the next Tab would begin at its top.
 *  @param to what takes it in place of the picture. */
export function leave(element: Element, to: HTMLElement | null = document.querySelector('canvas')): void {
  if (element.contains(document.activeElement)) to?.focus({ preventScroll: true });
}

/** @param to likewise. */
export function setHidden(element: HTMLElement, isHidden: boolean, to?: HTMLElement): void {
  // Before: what is hidden has lost it already.
  if (isHidden) leave(element, to);
  element.hidden = isHidden;
}

/** @param to likewise. */
export function setDisabled(button: HTMLButtonElement, isDisabled: boolean, to?: HTMLElement): void {
  if (isDisabled) leave(button, to);
  button.disabled = isDisabled;
}

export function takeAway(element: Element): void {
  leave(element);
  element.remove();
}

/** Shows the line of a notice, or takes it away. */
export function showLine(notice: Element, line: Element, isShown: boolean): void {
  if (isShown === notice.contains(line)) return;
  if (!isShown) leave(line);
  notice.replaceChildren(...(isShown ? [line] : []));
}

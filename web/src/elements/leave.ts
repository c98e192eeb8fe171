/** What goes while it has the focus. */

/** The picture, the first canvas of the page, takes the focus of what is about to go: it would fall to the page, where keys do
 *  nothing, and the next Tab would begin at its top. */
export function leave(element: Element): void {
  if (element.contains(document.activeElement)) document.querySelector('canvas')?.focus({ preventScroll: true });
}

export function setHidden(element: HTMLElement, isHidden: boolean): void {
  // Before: what is hidden has lost it already.
  if (isHidden) leave(element);
  element.hidden = isHidden;
}

/** Shows the line of a notice, or takes it away. */
export function showLine(notice: Element, line: Element, isShown: boolean): void {
  if (isShown === notice.contains(line)) return;
  if (!isShown) leave(line);
  notice.replaceChildren(...(isShown ? [line] : []));
}

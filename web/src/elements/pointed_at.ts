/** While the pointer is over it, or it has the focus. */
export function whilePointedAt(element: HTMLElement, begin: () => void, end: () => void): void {
  for (const event of ['pointerenter', 'focusin']) element.addEventListener(event, begin);
  for (const event of ['pointerleave', 'focusout']) element.addEventListener(event, end);
}

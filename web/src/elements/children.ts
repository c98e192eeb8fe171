/** Lists whose lines come and go. */

/** Makes these the children of a list. Those that stay are not taken out, which would cost them the focus, or the click of a
 *  pointer that is down. */
export function setChildren(list: Element, children: readonly Element[]): void {
  const stays = new Set(children);
  for (const each of [...list.children]) if (!stays.has(each)) each.remove();
  children.forEach((each, i) => {
    const there = list.children[i] ?? null;
    if (there !== each) list.insertBefore(each, there);
  });
}

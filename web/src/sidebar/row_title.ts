/** The title of a row of the list of handles: pressed it selects them; a double click or F2 renames them. */
import { make, makeButton } from '../elements/dom';
import type { KeyRow } from '../elements/keys';
import { panelWords } from '../language/panels';

export const ROW_KEYS: readonly KeyRow[] = [{ keys: ['F2'], does: 'rename' }];

interface TitleEvents {
  /** `adds`: beside what is selected already. */
  select(adds: boolean): void;
  rename(): void;
}

export function makeRowTitle(title: Node, { select, rename }: TitleEvents): HTMLButtonElement {
  const button = makeButton(make('i', { class: 'mark' }), () => {}, {
    class: 'plain name',
    title: panelWords.handles.renameHint,
  });
  button.append(title);
  button.addEventListener('click', ({ detail, shiftKey, ctrlKey, metaKey }) => {
    // The second click of two belongs to renaming.
    if (detail < 2) select(shiftKey || ctrlKey || metaKey);
  });
  button.addEventListener('dblclick', rename);
  button.addEventListener('keydown', ({ key }) => {
    if (key === 'F2') rename();
  });
  return button;
}

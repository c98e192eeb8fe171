/** While a file is dragged over the window: that it can be dropped, and what is taken. */
import type { FormatInfo } from '../../../wasm/chebnet';
import { make, setText } from '../elements/dom';
import { dragged } from '../files/dragged';
import { MODEL_FORMATS } from '../files/model_formats';
import { panelWords } from '../language/panels';
import './drop_place.css';

/** A file that is held over the page is told of again and again, by every engine sooner than this. */
const PATIENCE_MS = 1000;

/** Watches for files from now on.
 *  @param formats the core's; they may become known later. */
export function watchForFiles(root: HTMLElement, formats: () => readonly FormatInfo[]): void {
  const kinds = make('span');
  // A popover, since a file can be dropped over a dialog, too.
  const place = make(
    'div',
    { class: 'drop-place', popover: 'manual', role: 'status' },
    make('div', {}, make('strong', {}, panelWords.drop.here), kinds),
  );
  root.append(place);
  const show = (): void => {
    setText(kinds, panelWords.drop.taken([...formats(), ...MODEL_FORMATS].map(({ title }) => title)));
    place.showPopover();
  };
  let timer = 0;
  const hide = (): void => {
    clearTimeout(timer);
    place.hidePopover();
  };
  addEventListener('dragover', (event) => {
    if (!dragged(event)?.types.some((type) => type === 'Files')) return;
    if (!place.matches(':popover-open')) show();
    clearTimeout(timer);
    // Not every end of a drag is told.
    timer = window.setTimeout(hide, PATIENCE_MS);
  });
  addEventListener('dragleave', ({ relatedTarget }) => {
    if (relatedTarget === null) hide(); // It left the window.
  });
  addEventListener('drop', hide);
  addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') hide();
  });
}

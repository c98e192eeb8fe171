/** The keys that work wherever the focus is, but in a field for text or a dialog. The sheet of keys is made from this table. */
import type { App, AppServices } from './app/app';
import { isApplied } from './elements/dom';
import { chordOf, type KeyRow } from './elements/keys';
import { areSingleKeysOn, isSingleKey } from './elements/single_keys';

interface PageKey extends KeyRow {
  /** In a field for text too, or in one for a number that has been applied. */
  inFields?: 'always' | 'applied';
  run(app: App, services: AppServices): void;
}

export const PAGE_KEYS: readonly PageKey[] = [
  { keys: ['Ctrl+Z', '⌘+Z'], does: 'undo', inFields: 'applied', run: (app) => app.undo() },
  { keys: ['Ctrl+Shift+Z', '⌘+Shift+Z', 'Ctrl+Y'], does: 'redo', inFields: 'applied', run: (app) => app.redo() },
  { keys: ['Ctrl+S', '⌘+S'], does: 'save', inFields: 'always', run: (_, services) => services.saveProject() },
  { keys: ['Ctrl+O', '⌘+O'], does: 'open', inFields: 'always', run: (_, services) => services.pickFile() },
  { keys: ['Ctrl+A', '⌘+A'], does: 'selectAll', run: (app) => app.handles.selectAll() },
  { keys: ['L'], does: 'selecting', run: (app) => app.handles.toggleSelecting() },
  {
    keys: ['Esc'],
    does: 'deselect',
    run: (app) => {
      // It is there while a solve takes long.
      const stop = document.querySelector<HTMLElement>('.stop:not([hidden])');
      if (app.canCancelOpening) app.cancelOpening();
      else if (stop) stop.click();
      else app.handles.escape();
    },
  },
  { keys: ['Delete', 'Backspace'], does: 'remove', run: (app) => app.handles.removeSelected() },
  { keys: ['P'], does: 'patch', run: (app) => app.handles.around((surroundings) => surroundings.takePatch()) },
  { keys: ['I'], does: 'isolate', run: (app) => app.handles.around((surroundings) => surroundings.isolate()) },
  // As in other programs for shapes: grab, rotate, scale.
  {
    keys: ['G'],
    does: 'translate',
    run: (app) => {
      app.handles.setMode('translate');
      // In the picture, the first canvas of the page, arrow keys move it, too.
      document.querySelector('canvas')?.focus();
    },
  },
  { keys: ['R'], does: 'rotate', run: (app) => app.handles.setMode('rotate') },
  { keys: ['S'], does: 'scale', run: (app) => app.handles.setMode('scale') },
  // As on the number pad of programs for shapes.
  { keys: ['1'], does: 'front', run: (app) => app.frameAll('front') },
  { keys: ['3'], does: 'side', run: (app) => app.frameAll('side') },
  { keys: ['7'], does: 'top', run: (app) => app.frameAll('top') },
  { keys: ['5'], does: 'parallel', run: (app) => app.setView({ parallel: !app.opening?.document.view.parallel }) },
  { keys: ['?'], does: 'keys', run: (_, services) => services.showKeys() },
];

/** What a key of the whole page does; null: nothing. */
export function commandOf(event: KeyboardEvent): PageKey['run'] | null {
  const isModal = document.querySelector('dialog:modal') !== null;
  if (event.defaultPrevented || isModal) return null;
  const chord = chordOf(event);
  if (isSingleKey(chord) && !areSingleKeysOn()) return null;
  const row = PAGE_KEYS.find(({ keys, inFields }) => keys.includes(chord) && worksIn(inFields, event));
  return row?.run ?? null;
}

function worksIn(fields: PageKey['inFields'], event: KeyboardEvent): boolean {
  return fields === 'always' || !isTyping(event) || (fields === 'applied' && isApplied(event.target));
}

/** In a field for text the keys belong to the text, in a list of choices those without Ctrl do. */
function isTyping({ target, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (target instanceof HTMLInputElement) return !['checkbox', 'radio', 'range', 'button'].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLSelectElement && !ctrlKey && !metaKey);
}

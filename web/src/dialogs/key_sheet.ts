/** The dialog that lists all keyboard shortcuts. */
import type { KeyRow } from '../elements/keys';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeButton, makeSwitch } from '../elements/dom';
import { areSingleKeysOn, setSingleKeys } from '../elements/single_keys';
import './dialog.css';
import './key_sheet.css';

const TEXT = panelWords.keys;

export interface KeyTable {
  where: keyof typeof TEXT.where;
  rows: readonly KeyRow[];
}

export function showKeySheet(root: HTMLElement, tables: readonly KeyTable[]): void {
  const close = makeButton(TEXT.close, () => dialog.close(), { class: 'primary' });
  const single = makeSwitch(TEXT.single, setSingleKeys);
  single.box.checked = areSingleKeysOn();
  const dialog = make(
    'dialog',
    { class: 'file keys', 'aria-labelledby': 'keys-title' },
    make('h2', { id: 'keys-title' }, words.keys.title),
    single.row,
    // Arrow keys scroll what has the focus.
    make(
      'div',
      { class: 'body', tabindex: 0, autofocus: true, 'aria-labelledby': 'keys-title' },
      ...tables.flatMap(makeTable),
    ),
    make('div', { class: 'buttons' }, close),
  );
  dialog.addEventListener('close', () => dialog.remove());
  dialog.addEventListener('keydown', (event) => {
    if (event.key !== '?') return;
    event.preventDefault();
    dialog.close();
  });
  root.append(dialog);
  dialog.showModal();
}

function makeTable({ where, rows }: KeyTable): HTMLElement[] {
  const list = rows.map(({ keys, does }) =>
    make('div', {}, make('dt', {}, TEXT.does[does]), make('dd', {}, ...keys.filter(isHere).flatMap(makeKey))),
  );
  return [make('h3', {}, TEXT.where[where]), make('dl', { class: 'facts' }, ...list)];
}

/** Macs have ⌘ where others have Ctrl. */
function isHere(key: string): boolean {
  const isMac = /Mac|iPhone|iPad/.test(navigator.userAgent);
  return isMac ? !key.startsWith('Ctrl+') : !key.startsWith('⌘');
}

function makeKey(keys: string, i: number): (Node | string)[] {
  const held = keys === '+' ? ['+'] : keys.split('+');
  const caps = held.flatMap((key, k) => [...(k > 0 ? [' + '] : []), make('kbd', {}, key)]);
  return i > 0 ? [` ${TEXT.or} `, ...caps] : caps;
}

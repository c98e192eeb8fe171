/** A net is being changed: how far that is, and a way to stop it. Seen only if it takes a while; the net waits meanwhile. */
import type { Changing } from '../change/changing';
import type { ChangedNet } from '../change/change_protocol';
import { make, makeButton, setText } from '../elements/dom';
import { chordOf } from '../elements/keys';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';
import './dialog.css';
import './change_dialog.css';

const TEXT = dialogWords.change;

export class ChangeDialog {
  readonly #progress = make('p', { class: 'progress', role: 'status' }, TEXT.starting);
  readonly #dialog: HTMLDialogElement;

  /** @param root its parent. */
  constructor(root: HTMLElement) {
    const heading = make('h2', { id: 'change-title' }, TEXT.title);
    this.#dialog = make(
      'dialog',
      { class: 'file change', 'aria-labelledby': heading.id },
      heading,
      make('div', { class: 'body' }, this.#progress),
      make(
        'div',
        { class: 'buttons' },
        makeButton(TEXT.stop, () => this.#dialog.close()),
      ),
    );
    this.#dialog.addEventListener('keydown', (event) => this.#pressKey(event));
    root.append(this.#dialog);
    this.#dialog.showModal();
  }

  /** What comes of it; null: it was stopped. */
  async until(changing: Changing): Promise<ChangedNet | null> {
    this.#dialog.addEventListener('close', () => changing.stop());
    try {
      return await changing.result;
    } finally {
      // So that the focus goes back to where it was.
      this.#dialog.close();
      this.#dialog.remove();
    }
  }

  /** What undo takes back is the change itself. */
  #pressKey(event: KeyboardEvent): void {
    if (!['Ctrl+Z', '⌘+Z'].includes(chordOf(event))) return;
    event.preventDefault();
    this.#dialog.close();
  }

  setProgress(iterations: number): void {
    setText(this.#progress, TEXT.progress(iterations.toLocaleString(words.locale)));
  }
}

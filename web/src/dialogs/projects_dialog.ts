/** The projects that this browser keeps: pictures to open, names to change, copies, and a way back from deleting. */
import { setChildren } from '../elements/children';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import { messageOf } from '../failure';
import { words } from '../language/language';
import { dialogWords } from '../language/dialogs';
import { type ProjectLine, ProjectRow, type RowParts } from './project_row';
import './dialog.css';
import './projects_dialog.css';

const TEXT = dialogWords.projects;

export interface ProjectParts extends Pick<RowParts, 'picture' | 'longestName'> {
  list(): Promise<ProjectLine[]>;
  /** The one that is open. */
  present: string;
  open(id: string): Promise<void>;
  keepPresent(): Promise<void>;
  rename(id: string, name: string): Promise<void>;
  copy(id: string, name: string): Promise<void>;
  /** Returns what brings it back. */
  delete(id: string): Promise<() => Promise<void>>;
}

export class ProjectsDialog {
  readonly #dialog: HTMLDialogElement;
  readonly #list = make('ul', { class: 'kept' });
  readonly #said = make('p', { role: 'status' });
  readonly #back = makeButton(TEXT.back, () => {}, { hidden: true });
  readonly #close = makeButton(TEXT.close, () => this.#dialog.close(), { class: 'primary', autofocus: true });
  /** The net that is open, before anything of it was kept. */
  readonly #notKept = make(
    'li',
    { class: 'present' },
    make('p', {}, TEXT.notKept),
    makeButton(TEXT.keep, () => this.#change(() => this.#parts.keepPresent())),
  );
  /** By the ids of their projects. */
  readonly #rows = new Map<string, ProjectRow>();
  readonly #parts: ProjectParts;
  #takeBack: (() => Promise<void>) | null = null;

  constructor(root: HTMLElement, parts: ProjectParts) {
    this.#parts = parts;
    const heading = make('h2', { id: 'projects-title' }, TEXT.title);
    this.#back.addEventListener('click', () => this.#try(() => this.#bringBack()));
    this.#dialog = make(
      'dialog',
      { class: 'file projects', 'aria-labelledby': heading.id },
      heading,
      make('div', { class: 'body' }, this.#list),
      make('div', { class: 'said' }, this.#said, this.#back),
      make('div', { class: 'buttons' }, this.#close),
    );
    // The page's shortcuts are off while the dialog is open.
    this.#dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.#dialog.addEventListener('close', () => this.#dialog.remove());
    root.append(this.#dialog);
    this.#dialog.showModal();
    this.#try(() => this.#refresh());
  }

  async #refresh(): Promise<void> {
    const lines = await this.#parts.list();
    const isKept = lines.some(({ id }) => id === this.#parts.present);
    const rows = lines.map((line) => this.#rowOf(line).element);
    setChildren(this.#list, isKept ? rows : [this.#notKept, ...rows]);
    // What has only just come into the page is drawn in its colour.
    for (const line of lines) this.#rowOf(line).update(line);
    if (!this.#back.hidden) return;
    setText(this.#said, lines.length > 0 ? TEXT.hint : TEXT.empty);
  }

  #rowOf({ id }: ProjectLine): ProjectRow {
    const row = this.#rows.get(id) ?? this.#makeRow(id);
    this.#rows.set(id, row);
    return row;
  }

  #makeRow(id: string): ProjectRow {
    const { present, picture, longestName, rename, copy } = this.#parts;
    return new ProjectRow({
      isPresent: id === present,
      picture,
      longestName,
      rename: (name) => this.#change(() => rename(id, name)),
      open: () => this.#try(() => this.#open(id)),
      copy: (name) => this.#change(() => copy(id, name)),
      delete: (called) => this.#try(() => this.#delete(id, called)),
    });
  }

  async #open(id: string): Promise<void> {
    await this.#parts.open(id);
    this.#dialog.close();
  }

  async #delete(id: string, called: string): Promise<void> {
    this.#takeBack = await this.#parts.delete(id);
    setText(this.#said, TEXT.deleted(called));
    this.#back.hidden = false;
    await this.#refresh();
    this.#back.focus();
  }

  async #bringBack(): Promise<void> {
    await this.#takeBack?.();
    this.#takeBack = null;
    this.#hideBack();
    await this.#refresh();
  }

  #hideBack(): void {
    setHidden(this.#back, true, this.#close);
  }

  #change(doing: () => Promise<void>): void {
    this.#hideBack();
    this.#try(async () => {
      await doing();
      await this.#refresh();
    });
  }

  /** What goes wrong is said; a browser that refuses to store something says little. */
  #try(doing: () => Promise<void>): void {
    doing().catch((error: unknown) =>
      setText(this.#said, error instanceof DOMException ? TEXT.refused : words.core.sentence(messageOf(error))),
    );
  }
}

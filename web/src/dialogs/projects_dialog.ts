/** The projects that this browser keeps: pictures to open, names to change, copies, and a way back from deleting. */
import { make, makeButton, setText } from '../elements/dom';
import { words } from '../language/language';
import { dialogWords } from '../language/dialogs';
import './dialog.css';
import './projects_dialog.css';

const TEXT = dialogWords.projects;

/** A line of the list. */
export interface ProjectLine {
  id: string;
  /** As the visitor called it; '': not yet, and then it is kept until there are newer ones. */
  name: string;
  /** What it is without a name. */
  title: string;
  date: Date | null;
  /** How opaque each pixel is. */
  picture: Uint8Array | null;
  /** Open in another tab. */
  isElsewhere: boolean;
}

export interface ProjectParts {
  list(): Promise<ProjectLine[]>;
  /** The one that is open. */
  present: string;
  /** Pixels of a picture, and characters of a name. */
  picture: { width: number; height: number };
  longestName: number;
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
      make(
        'div',
        { class: 'buttons' },
        makeButton(TEXT.close, () => this.#dialog.close(), { class: 'primary', autofocus: true }),
      ),
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
    this.#list.replaceChildren(...(isKept ? [] : [this.#presentLine()]), ...lines.map((line) => this.#line(line)));
    if (!this.#back.hidden) return;
    setText(this.#said, lines.length > 0 ? TEXT.hint : TEXT.empty);
  }

  /** The net that is open, before anything of it was kept. */
  #presentLine(): HTMLElement {
    const keep = makeButton(TEXT.keep, () => this.#change(() => this.#parts.keepPresent()));
    return make('li', { class: 'present' }, make('p', {}, TEXT.notKept), keep);
  }

  #line(line: ProjectLine): HTMLElement {
    const { id, name, title, date } = line;
    const isPresent = id === this.#parts.present;
    const isElsewhere = line.isElsewhere && !isPresent;
    const called = name || title;
    const field = make('input', {
      value: name,
      placeholder: title,
      maxlength: this.#parts.longestName,
      'aria-label': TEXT.name(called),
      spellcheck: 'false',
    });
    field.addEventListener('change', () => this.#change(() => this.#parts.rename(id, field.value.trim())));
    const when = date?.toLocaleString(words.locale, { dateStyle: 'medium', timeStyle: 'short' }) ?? '';
    const standing = isPresent ? TEXT.isOpen : isElsewhere ? TEXT.isElsewhere : '';
    const open = makeButton(TEXT.open, () => this.#try(() => this.#open(id)), {
      'aria-label': TEXT.openOne(called),
      disabled: isPresent,
    });
    const copy = makeButton(TEXT.copy, () => this.#change(() => this.#parts.copy(id, TEXT.copyOf(called))), {
      'aria-label': TEXT.copyOne(called),
    });
    const remove = makeButton(TEXT.delete, () => this.#try(() => this.#delete(line)), {
      'aria-label': TEXT.deleteOne(called),
      disabled: isPresent || isElsewhere,
    });
    return make(
      'li',
      {},
      this.#picture(line),
      make('div', { class: 'about' }, field, make('small', {}, [when, standing].filter(Boolean).join(' · '))),
      make('div', { class: 'ways' }, open, copy, remove),
    );
  }

  #picture({ picture }: ProjectLine): HTMLCanvasElement {
    const { width, height } = this.#parts.picture;
    const canvas = make('canvas', { width, height, 'aria-hidden': 'true' });
    const context = canvas.getContext('2d');
    if (picture === null || context === null) return canvas;
    // Before it is in the page it has no colour of its own.
    const colour = getComputedStyle(this.#list).color;
    const pixels = context.createImageData(width, height);
    picture.forEach((opacity, i) => (pixels.data[4 * i + 3] = opacity));
    context.putImageData(pixels, 0, 0);
    context.globalCompositeOperation = 'source-in';
    context.fillStyle = colour;
    context.fillRect(0, 0, width, height);
    return canvas;
  }

  async #open(id: string): Promise<void> {
    await this.#parts.open(id);
    this.#dialog.close();
  }

  async #delete({ id, name, title }: ProjectLine): Promise<void> {
    this.#takeBack = await this.#parts.delete(id);
    setText(this.#said, TEXT.deleted(name || title));
    this.#back.hidden = false;
    await this.#refresh();
    this.#back.focus();
  }

  async #bringBack(): Promise<void> {
    await this.#takeBack?.();
    this.#takeBack = null;
    this.#back.hidden = true;
    await this.#refresh();
  }

  #change(doing: () => Promise<void>): void {
    this.#back.hidden = true;
    this.#try(async () => {
      await doing();
      await this.#refresh();
    });
  }

  /** What a browser refuses is said. */
  #try(doing: () => Promise<void>): void {
    doing().catch(() => setText(this.#said, TEXT.refused));
  }
}

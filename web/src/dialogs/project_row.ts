/** A line in the list of projects: the same one for as long as the project is listed, whatever is said of it. */
import { make, makeButton, setText, setValue } from '../elements/dom';
import { dialogWords } from '../language/dialogs';
import { words } from '../language/language';

const TEXT = dialogWords.projects;

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

export interface RowParts {
  isPresent: boolean;
  /** Pixels of its picture, and characters of its name. */
  picture: { width: number; height: number };
  longestName: number;
  rename(name: string): void;
  open(): void;
  copy(name: string): void;
  delete(called: string): void;
}

export class ProjectRow {
  readonly element: HTMLLIElement;
  readonly #parts: RowParts;
  readonly #picture: HTMLCanvasElement;
  readonly #name: HTMLInputElement;
  readonly #about = make('small');
  readonly #open: HTMLButtonElement;
  readonly #copy: HTMLButtonElement;
  readonly #delete: HTMLButtonElement;
  /** The name, or what it is without one. */
  #called = '';

  constructor(parts: RowParts) {
    this.#parts = parts;
    this.#picture = make('canvas', { ...parts.picture, 'aria-hidden': 'true' });
    this.#name = make('input', { maxlength: parts.longestName, spellcheck: 'false' });
    this.#name.addEventListener('change', () => parts.rename(this.#name.value.trim()));
    this.#open = makeButton(TEXT.open, () => parts.open(), { disabled: parts.isPresent });
    this.#copy = makeButton(TEXT.copy, () => parts.copy(this.#copyName));
    this.#delete = makeButton(TEXT.delete, () => parts.delete(this.#called));
    this.element = make(
      'li',
      {},
      this.#picture,
      make('div', { class: 'about' }, this.#name, this.#about),
      make('div', { class: 'ways' }, this.#open, this.#copy, this.#delete),
    );
  }

  /** Of a long name as much as leaves room for what says that it is a copy. */
  get #copyName(): string {
    const room = this.#parts.longestName - TEXT.copyOf('').length;
    return TEXT.copyOf(this.#called.slice(0, room));
  }

  update({ name, title, date, picture, isElsewhere }: ProjectLine): void {
    const { isPresent } = this.#parts;
    this.#called = name || title;
    setValue(this.#name, name);
    this.#name.placeholder = title;
    this.#name.ariaLabel = TEXT.name(this.#called);
    this.#open.ariaLabel = TEXT.openOne(this.#called);
    this.#copy.ariaLabel = TEXT.copyOne(this.#called);
    this.#delete.ariaLabel = TEXT.deleteOne(this.#called);
    this.#delete.disabled = isPresent || isElsewhere;
    this.#delete.title = this.#delete.disabled ? TEXT.whileOpen : '';
    const when = date?.toLocaleString(words.locale, { dateStyle: 'medium', timeStyle: 'short' }) ?? '';
    const standing = isPresent ? TEXT.isOpen : isElsewhere ? TEXT.isElsewhere : '';
    setText(this.#about, [when, standing].filter(Boolean).join(' · '));
    if (picture) this.#draw(picture);
  }

  #draw(picture: Uint8Array): void {
    const { width, height } = this.#parts.picture;
    const context = this.#picture.getContext('2d');
    if (context === null) return;
    const pixels = context.createImageData(width, height);
    picture.forEach((opacity, i) => (pixels.data[4 * i + 3] = opacity));
    context.putImageData(pixels, 0, 0);
    context.globalCompositeOperation = 'source-in';
    context.fillStyle = getComputedStyle(this.#picture).color;
    context.fillRect(0, 0, width, height);
  }
}

/** The gallery of shapes. Their pictures come later: gallery_pictures.ts. */
import type { ShapeInfo } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { make, makeButton, makeIcon, makeSvg } from '../elements/dom';
import type { Tables } from '../net/tables';
import { MODEL_FORMATS } from '../files/model_formats';
import './gallery.css';

/** Opened by links and recipes only: as one grid without a seam it must lie folded along its crests. */
const UNSHOWN = ['torus'];

const FOLDER = 'M2 12.5v-9h4l1.5 2H14v7z';

export class Gallery {
  readonly element = make('div', { class: 'gallery', role: 'group', 'aria-label': words.gallery.label });
  readonly #fileTile = this.#makeFileTile();
  #tiles: HTMLButtonElement[] = [];
  readonly #open: (recipe: string) => void;
  readonly #openFile: () => void;

  constructor(open: (recipe: string) => void, openFile: () => void) {
    this.#open = open;
    this.#openFile = openFile;
    this.element.append(this.#fileTile);
  }

  setTables({ shapes, formats }: Tables): void {
    this.#fileTile.title = words.gallery.openFileHint([...formats, ...MODEL_FORMATS].map(({ title }) => title));
    this.#tiles = shapes.filter(({ name }) => !UNSHOWN.includes(name)).map((shape) => this.#makeTile(shape));
    this.element.replaceChildren(...this.#tiles, this.#fileTile);
  }

  /** null: what is open is from a file. */
  setCurrent(name: string | null): void {
    this.#fileTile.classList.toggle('current', name === null);
    for (const tile of this.#tiles) tile.setAttribute('aria-pressed', String(tile.dataset.shape === name));
  }

  #makeTile(shape: ShapeInfo): HTMLButtonElement {
    const picture = makeSvg('svg', { class: 'picture', 'aria-hidden': 'true' });
    const tile = makeButton(picture, () => this.#open(shape.offered), {
      'aria-pressed': 'false',
      'data-shape': shape.name,
    });
    tile.append(make('span', {}, shape.title));
    return tile;
  }

  #makeFileTile(): HTMLButtonElement {
    const tile = makeButton(makeIcon(FOLDER), () => this.#openFile());
    tile.append(make('span', {}, words.gallery.openFile));
    return tile;
  }
}

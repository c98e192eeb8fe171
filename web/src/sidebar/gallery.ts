/** The gallery of shapes, each with a thumbnail that is drawn when it is scrolled into view and the page is idle. */
import type { ShapeInfo } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { make, makeButton, makeIcon } from '../elements/dom';
import type { Tables } from '../net/tables';
import { sleep, type Idle } from './idle';
import { formatRecipe, parseRecipe } from './recipe';
import { drawThumbnail, type Wireframe } from '../elements/thumbnail';
import { MODEL_FORMATS } from '../files/model_formats';
import './gallery.css';

/** Size of the nets in thumbnails. */
const THUMBNAIL_VERTICES = 300;

/** Opened by links and recipes only: as one grid without a seam it must lie folded along its crests. */
const UNSHOWN = ['torus'];

/** A picture that has not come after this long keeps the next ones waiting no longer. */
const PATIENCE_MS = 500;

const FOLDER = 'M2 12.5v-9h4l1.5 2H14v7z';

interface Item {
  shape: ShapeInfo;
  button: HTMLButtonElement;
  canvas: HTMLCanvasElement;
  net: Wireframe | null;
}

export class Gallery {
  readonly element = make('div', { class: 'gallery', role: 'group', 'aria-label': words.gallery.label });
  readonly #fileTile = this.#makeFileTile();
  #items: Item[] = [];
  #waiting: Item[] = [];
  #drawing = false;
  #thumbnail: (recipe: string) => Promise<Wireframe> = () => Promise.reject(new Error('no shapes yet'));
  readonly #sight = new IntersectionObserver((entries) => this.#seen(entries));
  readonly #idle: Idle;
  readonly #open: (recipe: string) => void;
  readonly #openFile: () => void;

  constructor(idle: Idle, open: (recipe: string) => void, openFile: () => void) {
    this.#idle = idle;
    this.#open = open;
    this.#openFile = openFile;
    this.element.append(this.#fileTile);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#redraw());
  }

  setTables({ shapes, formats }: Tables, thumbnail: (recipe: string) => Promise<Wireframe>): void {
    this.#fileTile.title = words.gallery.openFileHint([...formats, ...MODEL_FORMATS].map(({ title }) => title));
    this.#thumbnail = thumbnail;
    this.#items = shapes.filter(({ name }) => !UNSHOWN.includes(name)).map((shape) => this.#makeItem(shape));
    this.element.replaceChildren(...this.#items.map(({ button }) => button), this.#fileTile);
    for (const { button } of this.#items) this.#sight.observe(button);
  }

  /** null: what is open is from a file. */
  setCurrent(name: string | null): void {
    this.#fileTile.classList.toggle('current', name === null);
    for (const { shape, button, canvas, net } of this.#items) {
      const pressed = String(shape.name === name);
      if (button.getAttribute('aria-pressed') === pressed) continue;
      button.setAttribute('aria-pressed', pressed);
      // Redrawn in its new colour.
      if (net) drawThumbnail(canvas, net);
    }
  }

  #makeItem(shape: ShapeInfo): Item {
    const canvas = make('canvas', { 'aria-hidden': 'true' });
    const button = makeButton(canvas, () => this.#open(shape.offered), {
      'aria-pressed': 'false',
      'data-shape': shape.name,
    });
    button.append(make('span', {}, shape.title));
    return { shape, button, canvas, net: null };
  }

  #makeFileTile(): HTMLButtonElement {
    const tile = makeButton(makeIcon(FOLDER), () => this.#openFile());
    tile.append(make('span', {}, words.gallery.openFile));
    return tile;
  }

  #seen(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      const item = this.#items.find(({ button }) => button === target);
      if (!isIntersecting || !item) continue;
      this.#sight.unobserve(target);
      this.#waiting.push(item);
    }
    if (!this.#drawing) void this.#drawWaiting();
  }

  async #drawWaiting(): Promise<void> {
    this.#drawing = true;
    for (let item = this.#waiting.shift(); item; item = this.#waiting.shift()) {
      await this.#idle.quiet();
      // One at a time, as a drag waits for those that have been asked for; but some come much later than those behind them.
      await Promise.race([this.#draw(item), sleep(PATIENCE_MS)]);
    }
    this.#drawing = false;
  }

  async #draw(item: Item): Promise<void> {
    try {
      const recipe = parseRecipe(item.shape.offered);
      recipe.values['vertices'] = THUMBNAIL_VERTICES;
      item.net = await this.#thumbnail(formatRecipe(recipe, item.shape));
      drawThumbnail(item.canvas, item.net);
    } catch {
      // Without a picture the name still opens the shape.
    }
  }

  #redraw(): void {
    for (const { canvas, net } of this.#items) if (net) drawThumbnail(canvas, net);
  }
}

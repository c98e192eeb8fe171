/** Three hints for newcomers, one after another, each beside what it is about; gone for good once followed or dismissed. */
import type { App } from '../app/app';
import { words } from '../language/language';
import type { Opening } from '../worker/opening';
import { make, makeButton, setText } from '../elements/dom';
import './hints.css';

const HINTS = ['drag', 'add', 'share'] as const;
type Hint = (typeof HINTS)[number];
const KEY = 'chebnet.hints';
/** Margins in pixels: to the target of a hint, to the edges of the page, for title and tools at its top. */
const GAP = 18;
const ROOM = 8;
const HEAD = 72;
/** Number of vertices examined to find one in the middle of the view. */
const LOOKS = 80;

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export class Hints {
  readonly #app: App;
  readonly #text = make('p');
  readonly #element = make('div', { class: 'hint', role: 'status' }, this.#text);
  readonly #done = new Set(remembered());
  readonly #root: HTMLElement;
  #shown: Hint | null = null;
  #before: Opening | null = null;
  /** The target of the hint that is shown. */
  #vertex = 0;

  constructor(app: App, root: HTMLElement) {
    this.#app = app;
    this.#root = root;
    this.#element.append(makeButton(words.hints.done, () => this.#dismiss()));
    if (HINTS.every((hint) => this.#done.has(hint))) return;
    app.on('frame', () => this.#watch());
    app.on('settled', () => {
      this.#watch();
      this.#show();
    });
  }

  /** The hint is not shown again. */
  done(hint: Hint): void {
    if (this.#done.has(hint)) return;
    this.#done.add(hint);
    remember(this.#done);
    if (this.#shown !== hint) return;
    this.#shown = null;
    this.#element.remove();
  }

  #dismiss(): void {
    if (this.#shown) this.done(this.#shown);
    this.#show();
  }

  /** Detects from the document that a handle was moved or added. */
  #watch(): void {
    const [before, now] = [this.#before, this.#app.opening];
    this.#before = now;
    if (!before || !now || before.net !== now.net) return;
    const [old, present] = [before.document.handles, now.document.handles];
    if (present.length > old.length) this.done('add');
    else if (present.length === old.length && present.some(({ target }, i) => target !== old[i]!.target))
      this.done('drag');
  }

  #show(): void {
    const next = HINTS.find((hint) => !this.#done.has(hint) && this.#findVertex(hint));
    if (next === undefined || this.#shown === next) return;
    this.#shown = next;
    setText(this.#text, words.hints[next]);
    this.#root.append(this.#element);
    this.#follow();
  }

  /** Whether its target exists. */
  #findVertex(hint: Hint): boolean {
    const { opening } = this.#app;
    if (opening === null) return false;
    const free = opening.document.handles.filter(({ anchor, hidden }) => !anchor && !hidden);
    if (hint === 'drag') this.#vertex = free.at(-1)?.vertex ?? -1;
    if (hint === 'add') this.#vertex = this.#middleVertex(opening);
    return this.#vertex >= 0;
  }

  #middleVertex({ net, document }: Opening): number {
    const view = window.document.getElementById('view')!.getBoundingClientRect();
    const [x, y] = [(view.left + view.right) / 2, (view.top + view.bottom) / 2];
    const step = Math.max(1, Math.floor(net.info.vertices / LOOKS));
    const taken = new Set(document.handles.map(({ vertex }) => vertex));
    let best = { vertex: -1, distance: Infinity };
    for (let vertex = 0; vertex < net.info.vertices; vertex += step) {
      const place = this.#app.screenPosition(vertex);
      const distance = Math.hypot(place.x - x, place.y - y);
      if (distance < best.distance && !taken.has(vertex)) best = { vertex, distance };
    }
    return best.vertex;
  }

  /** Keeps the hint beside its target, in every animation frame. */
  #follow(): void {
    if (this.#shown === null) return;
    const { width, height } = this.#element.getBoundingClientRect();
    const { left, right, top, bottom } = this.#place(this.#shown);
    const above = top - GAP - height;
    const x = Math.max(ROOM, Math.min(innerWidth - ROOM - width, (left + right - width) / 2));
    const y = above >= HEAD ? above : bottom + GAP;
    this.#element.style.setProperty('--x', `${Math.round(x)}px`);
    this.#element.style.setProperty('--y', `${Math.round(y)}px`);
    requestAnimationFrame(() => this.#follow());
  }

  #place(hint: Hint): Box {
    const tools = document.querySelector('.toolbar');
    if (hint === 'share' && tools) return tools.getBoundingClientRect();
    const { x, y } = this.#app.screenPosition(this.#vertex);
    return { left: x, right: x, top: y, bottom: y };
  }
}

function remembered(): Hint[] {
  try {
    const names = localStorage.getItem(KEY)?.split(' ') ?? [];
    return HINTS.filter((hint) => names.includes(hint));
  } catch {
    return []; // Storage is disabled.
  }
}

function remember(done: ReadonlySet<Hint>): void {
  try {
    localStorage.setItem(KEY, [...done].join(' '));
  } catch {
    // Storage is disabled: it is shown again on the next visit, which does no harm.
  }
}

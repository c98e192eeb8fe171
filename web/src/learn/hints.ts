/** Three hints for newcomers, one after another below the title, clear of the net; gone for good once followed or dismissed. */
import type { App } from '../app/app';
import { make, makeButton, setText } from '../elements/dom';
import { setHidden } from '../elements/leave';
import { panelWords } from '../language/panels';
import type { Opening } from '../worker/opening';
import './hints.css';

const HINTS = ['drag', 'add', 'share'] as const;
export type Hint = (typeof HINTS)[number];
const KEY = 'chebnet.hints';

export class Hints {
  readonly #app: App;
  readonly #text = make('span', { role: 'status' });
  readonly #element = make(
    'div',
    { class: 'hint', hidden: true },
    this.#text,
    makeButton(panelWords.hints.done, () => this.#dismiss(), { class: 'plain link' }),
  );
  readonly #done = new Set(remembered());
  #shown: Hint | null = null;
  #before: Opening | null = null;

  /** @param title below which they stand. */
  constructor(app: App, title: Element) {
    this.#app = app;
    if (HINTS.every((hint) => this.#done.has(hint))) return;
    title.after(this.#element);
    app.on('frame', () => this.#watch());
    app.on('settled', () => {
      this.#watch();
      this.#show();
    });
    this.#watch();
    if (app.isQuiet) this.#show();
  }

  /** The hint is not shown again. */
  done(hint: Hint): void {
    if (this.#done.has(hint)) return;
    this.#note(hint);
    if (this.#shown === hint) this.#set(null);
  }

  #note(hint: Hint): void {
    this.#done.add(hint);
    // The first drag does not wait for the disc.
    setTimeout(() => remember(this.#done));
  }

  /** The next one follows at once, on the same button. */
  #dismiss(): void {
    if (this.#shown) this.#note(this.#shown);
    this.#show();
  }

  /** Detects from the document that a handle was moved or added. While one is on its way it may come back: a lesson leaves
   *  nothing behind, and then nobody has moved it. */
  #watch(): void {
    if (this.#app.history.inGesture) return;
    const [before, now] = [this.#before, this.#app.opening];
    this.#before = now;
    if (!before || !now || before.net !== now.net) return;
    const [old, present] = [before.document.handles, now.document.handles];
    if (present.length > old.length) this.done('add');
    else if (present.length === old.length && present.some(({ target }, i) => target !== old[i]!.target))
      this.done('drag');
  }

  #show(): void {
    this.#set(HINTS.find((hint) => !this.#done.has(hint) && this.#isPossible(hint)) ?? null);
  }

  #isPossible(hint: Hint): boolean {
    const handles = this.#app.opening?.document.handles ?? [];
    return hint !== 'drag' || handles.some(({ anchor, hidden }) => !anchor && !hidden);
  }

  #set(hint: Hint | null): void {
    this.#shown = hint;
    setHidden(this.#element, hint === null);
    setText(this.#text, hint === null ? '' : panelWords.hints[hint]);
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

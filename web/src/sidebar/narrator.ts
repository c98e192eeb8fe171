/** Tells screen readers what was done to the net, once it is known what came of it, and which handles are selected. */
import type { HandleData } from '../document/document';
import { sentenceOf } from '../document/naming';
import type { HistoryView } from '../document/undo';
import { make } from '../elements/dom';
import type { Choice } from '../handles/commands';
import type { Selection } from '../handles/selection';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { Panel } from '../panels';
import { standing } from './status';
import type { FrameData } from '../worker/protocol';
import './narrator.css';

/** Changes that follow one another sooner are told together, by the last of them, in milliseconds. */
const PAUSE_MS = 300;

export class Narrator implements Panel {
  readonly element = make('div', { class: 'narrator', role: 'status' });
  #history: Pick<HistoryView, 'names' | 'present' | 'revision'> | null = null;
  #selection: Selection | null = null;
  #frame: FrameData | null = null;
  /** What is yet to be told. */
  #news: string | null = null;
  /** The solver has sent a frame since then. */
  #isAnswered = false;
  /** What was told last, where that was of a net on its way to rest: how it ends is told, too. */
  #onItsWay: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  readonly #isChanging: () => boolean;

  /** @param isChanging whether the net is yet to be solved. */
  constructor(isChanging: () => boolean) {
    this.#isChanging = isChanging;
  }

  setHistory({ names, present, revision }: HistoryView): void {
    const before = this.#history;
    this.#history = { names, present, revision };
    if (before === null || before.revision === revision) return;
    const isUndo = present < before.present && names.length === before.names.length;
    this.#tell(isUndo ? panelWords.narrator.undone(sentenceOf(names[before.present]!)) : sentenceOf(names[present]!));
  }

  setHandles(handles: readonly HandleData[], { selection, selecting }: Choice): void {
    const before = this.#selection;
    this.#selection = selection;
    if (selecting) return; // the title counts the selected handles then
    if (before === null || before === selection || selection.length === 0 || this.#news !== null) return;
    const only = selection.length === 1 ? handles.find(({ vertex }) => vertex === selection[0]) : undefined;
    const { one, several } = panelWords.changes;
    this.#tell(panelWords.narrator.selected(only ? one(only.name ?? String(only.vertex)) : several(selection.length)));
  }

  onFrame(frame: FrameData): void {
    this.#frame = frame;
    this.#isAnswered = true;
  }

  setFrame(frame: FrameData): void {
    this.#frame = frame;
    if (this.#timer === undefined) this.#say();
  }

  #tell(news: string): void {
    this.#news = news;
    this.#isAnswered = false;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#timer = undefined;
      this.#say();
    }, PAUSE_MS);
  }

  /** Not before the solver has answered with a net whose edges have their lengths, or has ended. */
  #say(): void {
    if (this.#frame === null) return;
    const isChanging = this.#isChanging();
    const state = standing(this.#frame, isChanging);
    if (this.#news !== null) {
      if (isChanging && (!this.#isAnswered || state === 'running')) return;
      this.element.textContent = panelWords.narrator.withResult(this.#news, words.status[state]);
      this.#onItsWay = isChanging ? this.#news : null;
      this.#news = null;
    } else if (this.#onItsWay !== null && !isChanging) {
      // With what was done: where this ends soon, a reader has not said the first sentence yet and leaves it out.
      this.element.textContent = panelWords.narrator.withResult(this.#onItsWay, words.status[state]);
      this.#onItsWay = null;
    }
  }
}

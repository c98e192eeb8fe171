/** Figure 3 on the page: nets are edited, and new ones made, in a worker of their own; a table tells how they compare. */
import { editScene } from '../experiments/edits';
import { type Figure, settingsOf, textOf, type Variant } from '../experiments/figures';
import type { MadeNet, NewNetRequest, NewNetResponse, TriedEdit } from '../experiments/new_net_protocol';
import { texts } from '../experiments/texts';
import { make, makeButton, setText } from '../elements/dom';
import { Failure } from '../failure';
import { words } from '../language/language';
import { count, duration, NOTHING, small } from '../language/numbers';
import './new_net_trial.css';

const TEXT = texts.newNet;

export class NewNetTrial {
  readonly element: HTMLElement;
  readonly #figure: Figure;
  readonly #titleOf: (edit: string) => string;
  readonly #failed: (error: unknown) => void;
  readonly #start = makeButton(TEXT.start, () => void this.#run().catch((error: unknown) => this.#fail(error)));
  readonly #stop = makeButton(TEXT.stop, () => this.stop(), { hidden: true });
  readonly #words = make('label', { for: 'new-net-progress' });
  readonly #progress = make('progress', { id: 'new-net-progress' });
  readonly #row = make('p', { class: 'trying', hidden: true }, this.#words, this.#progress);
  readonly #table = make('table', { hidden: true });
  // In the page from the start: screen readers announce changes of what is there.
  readonly #verdict = make('p', { role: 'status' });
  #worker: Worker | null = null;
  #tried: TriedEdit[] = [];

  /** @param titleOf an edit. @param failed is called if it cannot be tried. */
  constructor(figure: Figure, titleOf: (edit: string) => string, failed: (error: unknown) => void) {
    this.#figure = figure;
    this.#titleOf = titleOf;
    this.#failed = failed;
    this.#progress.max = figure.edits.length;
    this.element = make(
      'section',
      { class: 'new-net', 'aria-label': TEXT.label },
      make('p', { class: 'quiet' }, TEXT.about),
      make('div', { class: 'buttons' }, this.#start, this.#stop),
      this.#row,
      this.#verdict,
      this.#table,
    );
  }

  /** What has been found out stays. */
  stop(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#arrange();
  }

  async #run(): Promise<void> {
    this.#tried = [];
    this.#render();
    const worker = new Worker(new URL('../experiments/new_net_worker.ts', import.meta.url), { type: 'module' });
    this.#worker = worker;
    worker.onmessage = ({ data }: MessageEvent<NewNetResponse>) => worker === this.#worker && this.#receive(data);
    worker.onerror = ({ message }) => this.#fail(new Failure('worker_lost', message || words.page.programMissing));
    this.#progress.value = 0;
    setText(this.#words, TEXT.starting);
    this.#arrange();
    this.#stop.focus();
    worker.postMessage(await this.#request());
  }

  async #request(): Promise<NewNetRequest> {
    const [edited, deformed] = parted(this.#figure.variants);
    return {
      edits: await Promise.all(this.#figure.edits.map((edit) => editScene(edit))),
      ways: edited.map(settingsOf),
      deforming: settingsOf(deformed!),
    };
  }

  #receive(response: NewNetResponse): void {
    if (response.type === 'progress') return this.#renderProgress(response);
    if (response.type === 'error')
      return this.#fail(new Failure(response.code, words.core.failure(response.code, response.message)));
    if (response.type === 'tried') this.#tried.push(response.tried);
    this.#render();
    if (response.type !== 'ended') return;
    const isLookedAt = this.#hasFocus;
    this.stop();
    if (isLookedAt) this.#verdict.scrollIntoView();
  }

  #fail(error: unknown): void {
    this.stop();
    this.#failed(error);
  }

  /** Otherwise the visitor is doing something else meanwhile, and hears how it ends. */
  get #hasFocus(): boolean {
    return document.activeElement === this.#stop;
  }

  /** The focus goes from one button to the other with what they do. */
  #arrange(): void {
    const isBusy = this.#worker !== null;
    const hasFocus = this.#hasFocus;
    this.#start.hidden = isBusy;
    this.#stop.hidden = this.#row.hidden = !isBusy;
    if (!isBusy && hasFocus) this.#start.focus({ preventScroll: true });
  }

  #renderProgress({ edit, makes, done }: Extract<NewNetResponse, { type: 'progress' }>): void {
    const title = this.#titleOf(this.#figure.edits[edit]!);
    setText(this.#words, makes ? TEXT.making(title) : TEXT.editing(title));
    // What is tried again does not take it back.
    this.#progress.value = Math.max(this.#progress.value, edit + done);
  }

  #render(): void {
    const { edits, variants } = this.#figure;
    const [edited] = parted(variants);
    const head = [TEXT.way, TEXT.time, TEXT.singular, TEXT.distance];
    this.#table.hidden = this.#tried.length === 0;
    this.#table.replaceChildren(
      make('thead', {}, make('tr', {}, ...head.map((title) => make('th', { scope: 'col' }, title)))),
      ...this.#tried.map((tried, place) =>
        make(
          'tbody',
          {},
          make('tr', {}, make('th', { scope: 'rowgroup', colspan: 4 }, this.#titleOf(edits[place]!))),
          ...edited.map((way, i) => makeRow(textOf(way.label), tried.edited[i]!)),
          makeRow(TEXT.anew, tried.made),
        ),
      ),
    );
    setText(this.#verdict, verdict(this.#tried));
  }
}

export function hasNewNet({ variants }: Figure): boolean {
  return variants.some(({ remeshes }) => remeshes);
}

function parted(variants: readonly Variant[]): [edited: Variant[], deformed: Variant | undefined] {
  return [variants.filter(({ remeshes }) => !remeshes), variants.find(({ remeshes }) => remeshes)];
}

function makeRow(title: string, made: MadeNet | string): HTMLElement {
  const cells =
    typeof made === 'string'
      ? [make('td', { colspan: 3 }, words.core.sentence(made))]
      : cellsOf(made).map((cell) => make('td', {}, cell));
  return make('tr', {}, make('th', { scope: 'row' }, title), ...cells);
}

function cellsOf({ milliseconds, singularVertices, distance }: MadeNet): string[] {
  return [duration(milliseconds), count(singularVertices), small(distance)];
}

/** What all of them together tell. */
function verdict(all: readonly TriedEdit[]): string {
  const both = all.flatMap(({ edited, made }) => (typeof made === 'string' ? [] : [{ edited, made }]));
  if (both.length === 0) return all.length === 0 ? '' : NOTHING;
  const slower = both.map(({ edited, made }) => made.milliseconds / fastest(edited));
  return TEXT.verdict({
    slower: range(slower, (times) => count(Number(times.toPrecision(2)))),
    kept: both.map(({ edited }) => count(edited[0]!.singularVertices)),
    made: both.map(({ made }) => count(made.singularVertices)),
    edited: range(
      both.flatMap(({ edited }) => edited.map(({ distance }) => distance)),
      small,
    ),
    near: range(
      both.map(({ made }) => made.distance),
      small,
    ),
  });
}

function fastest(nets: readonly MadeNet[]): number {
  return Math.min(...nets.map(({ milliseconds }) => milliseconds));
}

function range(values: readonly number[], text: (value: number) => string): string {
  const [least, most] = [text(Math.min(...values)), text(Math.max(...values))];
  return least === most ? least : TEXT.range(least, most);
}

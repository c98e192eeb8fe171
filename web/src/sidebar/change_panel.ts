/** The net itself: finer or coarser, with another edge length, and at the chosen handles cut, shorter or longer. */
import type { PlaceName } from '../change/place';
import type { WantedChange } from '../change/subject';
import type { HandleData } from '../document/document';
import { make, makeButton, makeSection, makeSelect, setText, setValue } from '../elements/dom';
import type { Choice } from '../handles/commands';
import type { Selection } from '../handles/selection';
import { wayThrough } from '../handles/way';
import { panelWords } from '../language/panels';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import './change_panel.css';

const TEXT = panelWords.change;
const OF_ALL = ['refine', 'coarsen', 'join'] as const;
/** What is done along a line through the handle that was chosen last. */
const AT_LINE = ['cut', 'keep_larger', 'keep_smaller', 'delete_rows', 'add_row', 'insert_row', 'remove_line'] as const;
/** No net is made so many times as large or as small at once. */
const MOST_FACTOR = 1e6;

export class ChangePanel implements Panel {
  readonly element: HTMLElement;
  readonly #length = make('input', { type: 'number', step: 'any', required: true, 'aria-label': TEXT.length });
  readonly #line: ReturnType<typeof makeSelect>;
  readonly #atHandles: HTMLFieldSetElement;
  readonly #about = make('p', { class: 'quiet' });
  readonly #events: PanelEvents;
  #meanLength = 1;
  #net: OpenedNet | null = null;
  #selection: Selection = [];
  /** How many lines there are to choose from, and of which kinds. */
  #offered = '';

  constructor(events: PanelEvents) {
    this.#events = events;
    this.#line = makeSelect(TEXT.line, [], () => this.#preview(true));
    this.#line.select.addEventListener('focus', () => this.#preview(true));
    this.#line.select.addEventListener('blur', () => this.#preview(false));
    const resize = make(
      'form',
      { class: 'row' },
      make('span', {}, TEXT.length),
      this.#length,
      make('button', {}, TEXT.apply),
    );
    resize.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#ask({ way: 'resize', length: this.#length.valueAsNumber });
    });
    this.#atHandles = make(
      'fieldset',
      {},
      this.#line.row,
      make(
        'div',
        { class: 'buttons' },
        ...AT_LINE.map((way) => this.#makeLineButton(way)),
        this.#makeButton({ way: 'delete_faces', place: 'between' }),
      ),
    );
    this.element = makeSection(
      TEXT.title,
      false,
      make('div', { class: 'buttons' }, ...OF_ALL.map((way) => this.#makeButton({ way }))),
      resize,
      this.#about,
      this.#atHandles,
    );
    this.element.classList.add('changes');
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#meanLength = net.info.meanLength;
  }

  setFrame({ lengthScale }: FrameData): void {
    const length = this.#meanLength * lengthScale;
    setValue(this.#length, String(Number(length.toPrecision(6))));
    this.#length.min = String(length / MOST_FACTOR);
    this.#length.max = String(length * MOST_FACTOR);
  }

  setHandles(_handles: readonly HandleData[], { selection, onBoundary, lines }: Choice): void {
    this.#selection = selection;
    this.#atHandles.disabled = selection.length === 0;
    setText(this.#about, selection.length === 0 ? TEXT.choose : TEXT.chosen(selection.length));
    const names: PlaceName[] = [
      ...Array.from({ length: lines }, (_, line) => line),
      ...(onBoundary ? (['boundary'] as const) : []),
      ...(selection.length > 1 ? (['through', 'between'] as const) : []),
    ];
    if (this.#offered === names.join()) return;
    this.#offered = names.join();
    const before = this.#line.select.value;
    this.#line.select.replaceChildren(
      ...names.map((name) =>
        make('option', { value: name }, typeof name === 'number' ? TEXT.lineName(name) : TEXT.lines[name]),
      ),
    );
    if (names.map(String).includes(before)) this.#line.select.value = before;
  }

  get #place(): PlaceName {
    const { value } = this.#line.select;
    return value === 'boundary' || value === 'through' || value === 'between' ? value : Number(value);
  }

  #makeButton(wanted: WantedChange): HTMLButtonElement {
    return makeButton(TEXT.ways[wanted.way], () => this.#ask(wanted), { title: TEXT.hints[wanted.way] });
  }

  /** Shows the line while it is hovered or has the focus. */
  #makeLineButton(way: (typeof AT_LINE)[number]): HTMLButtonElement {
    const button = makeButton(TEXT.ways[way], () => this.#ask({ way, place: this.#place }), { title: TEXT.hints[way] });
    for (const begin of ['pointerenter', 'focus']) button.addEventListener(begin, () => this.#preview(true));
    for (const end of ['pointerleave', 'blur']) button.addEventListener(end, () => this.#preview(false));
    return button;
  }

  #preview(shown: boolean): void {
    this.#events.preview(shown ? this.#verticesOf(this.#place) : []);
  }

  #verticesOf(place: PlaceName): readonly number[] {
    if (place === 'between') return [];
    if (place !== 'through') return this.#events.handles.line(place);
    return this.#net === null ? [] : wayThrough(this.#net, this.#selection);
  }

  #ask(wanted: WantedChange): void {
    this.#events.preview([]);
    this.#events.changeNet(wanted);
  }
}

/** The net itself: finer or coarser, with another edge length, and at the chosen handles or along a line that is drawn cut,
 *  shorter or longer. */
import { type Place, type PlaceName, placeOf } from '../change/place';
import { sidesOf, stayingWithout } from '../change/sides';
import type { WantedChange, WayOfAll } from '../change/subject';
import type { HandleData } from '../document/document';
import { make, makeButton, makeSection, makeSelect, setText } from '../elements/dom';
import { NumberField } from '../elements/number_field';
import { whilePointedAt } from '../elements/pointed_at';
import type { Choice } from '../handles/commands';
import { wayThrough } from '../handles/way';
import { panelWords } from '../language/panels';
import { piecesOfVertices } from '../net/pieces';
import type { Panel, PanelEvents } from '../panels';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { LineDrawing } from './line_drawing';
import './change_panel.css';

const TEXT = panelWords.change;
const OF_ALL: readonly WayOfAll[] = ['refine', 'coarsen', 'join', 'cut_flat'];
/** What is done along a line through the handle that was chosen last. */
const AT_LINE = ['cut', 'keep_larger', 'keep_smaller', 'delete_rows', 'add_row', 'insert_row', 'remove_line'] as const;
/** What is done to the pieces with a chosen handle. */
const OF_PIECES = ['keep_pieces', 'delete_pieces'] as const;
type LineWay = (typeof AT_LINE)[number];
type LineChoice = PlaceName | 'drawn';

/** No net is made so many times as large or as small at once. */
const MOST_FACTOR = 1e6;

export class ChangePanel implements Panel {
  readonly element: HTMLElement;
  readonly #length = new NumberField({ step: 'any', required: true, 'aria-label': TEXT.length });
  readonly #line: ReturnType<typeof makeSelect>;
  readonly #atLine: HTMLFieldSetElement;
  readonly #atHandles: HTMLButtonElement[];
  /** What takes one piece of several. */
  readonly #ofPieces: HTMLButtonElement[];
  /** What keeps one side of a line. */
  readonly #keeping: HTMLButtonElement[] = [];
  readonly #drawing: LineDrawing;
  readonly #about = make('p', { class: 'quiet' });
  readonly #events: PanelEvents;
  #edgeLength = 1;
  #net: OpenedNet | null = null;
  /** Of each vertex its piece; null: there is one piece. */
  #pieces: Int32Array | null = null;
  #choice: Pick<Choice, 'selection' | 'onBoundary' | 'lines'> = { selection: [], onBoundary: false, lines: 0 };
  /** A button or the choice of a line shows what it would do. */
  #isPreviewing = false;
  /** How many lines there are to choose from, and of which kinds. */
  #offered: string | null = null;

  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.#drawing = new LineDrawing(events, () => this.#takeDrawn(), failed);
    this.#line = makeSelect(TEXT.line, [], () => this.#preview('cut'));
    this.#previewAt(this.#line.select, 'cut');
    this.#ofPieces = OF_PIECES.map((way) => this.#makeButton({ way, place: 'between' }));
    this.#atHandles = [this.#makeButton({ way: 'delete_faces', place: 'between' }), ...this.#ofPieces];
    const resize = make(
      'form',
      { class: 'row' },
      make('span', {}, TEXT.length),
      this.#length.input,
      make('button', {}, TEXT.apply),
    );
    resize.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#ask({ way: 'resize', length: this.#length.input.valueAsNumber });
    });
    this.#atLine = make(
      'fieldset',
      {},
      this.#line.row,
      make('div', { class: 'buttons' }, ...AT_LINE.map((way) => this.#makeLineButton(way)), ...this.#atHandles),
    );
    this.element = makeSection(
      TEXT.title,
      false,
      make('div', { class: 'buttons' }, ...OF_ALL.map((way) => this.#makeButton({ way }))),
      resize,
      this.#length.note,
      this.#about,
      this.#drawing.element,
      this.#atLine,
    );
    this.element.classList.add('changes');
    // Out of sight the pen would stay in hand.
    this.element.addEventListener('toggle', () => this.#drawing.putAway());
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#drawing.setNet(net);
    this.#edgeLength = net.info.edgeLength;
    const isOne = net.info.components < 2;
    this.#pieces = isOne ? null : piecesOfVertices(net);
    // What has the focus goes.
    if (isOne && this.#ofPieces.some((button) => button === document.activeElement))
      this.element.querySelector('summary')?.focus();
    for (const button of this.#ofPieces) button.hidden = isOne;
  }

  setFrame(frame: FrameData): void {
    this.#drawing.setFrame(frame);
    const length = this.#edgeLength * frame.lengthScale;
    // Limits of few digits can be said.
    const about = Number(length.toPrecision(2));
    this.#length.input.min = String(about / MOST_FACTOR);
    this.#length.input.max = String(about * MOST_FACTOR);
    this.#length.set(String(Number(length.toPrecision(6))));
  }

  setHandles(_handles: readonly HandleData[], choice: Choice): void {
    const isSame = choice.selection === this.#choice.selection;
    this.#choice = choice;
    this.#offer();
    // Of the selection before; controls that have been disabled do not tell when they lose the focus.
    if (!isSame && this.#isPreviewing) this.#preview(null);
  }

  #offer(): void {
    const { selection, onBoundary, lines } = this.#choice;
    const isDrawn = this.#drawing.ways.length > 0;
    this.#atLine.disabled = selection.length === 0 && !isDrawn;
    for (const button of this.#atHandles) button.disabled = selection.length === 0;
    setText(this.#about, selection.length === 0 ? TEXT.choose : TEXT.chosen(selection.length));
    this.#allowSides();
    this.#allowPieces();
    const names: LineChoice[] = [
      ...Array.from({ length: lines }, (_, line) => line),
      ...(onBoundary ? (['boundary'] as const) : []),
      ...(selection.length > 1 ? (['through', 'between'] as const) : []),
      ...(isDrawn ? (['drawn'] as const) : []),
    ];
    if (this.#offered === names.join()) return;
    this.#offered = names.join();
    const before = this.#line.select.value;
    const choices = names.map((name) =>
      make('option', { value: name }, typeof name === 'number' ? TEXT.lineName(name) : TEXT.lines[name]),
    );
    if (choices.length === 0) choices.push(make('option', { value: '' }, TEXT.noLine));
    this.#line.select.replaceChildren(...choices);
    if (names.map(String).includes(before)) this.#line.select.value = before;
  }

  /** The line that has just been drawn is the one that is meant, until another is chosen. */
  #takeDrawn(): void {
    this.#offer();
    if (this.#drawing.ways.length > 0) this.#line.select.value = 'drawn';
    this.#preview(null);
  }

  /** A line that parts nothing has no sides to keep. */
  #allowSides(): void {
    for (const button of this.#keeping) button.disabled = this.#isDrawnChosen && !this.#drawing.parts;
  }

  /** If all are chosen there is nothing to keep one from, and nothing would be left. */
  #allowPieces(): void {
    const { selection } = this.#choice;
    const chosen = new Set(selection.map((vertex) => this.#pieces?.[vertex]));
    const areAll = chosen.size === this.#net?.info.components;
    this.#ofPieces.forEach((button, k) => {
      button.disabled ||= areAll;
      button.title = areAll ? TEXT.allPieces : TEXT.hints[OF_PIECES[k]!];
    });
  }

  get #isDrawnChosen(): boolean {
    return this.#line.select.value === 'drawn';
  }

  get #place(): Place {
    const { value } = this.#line.select;
    if (this.#isDrawnChosen) return this.#drawing.ways;
    return value === 'boundary' || value === 'through' || value === 'between' ? value : Number(value);
  }

  #makeButton(wanted: WantedChange): HTMLButtonElement {
    return makeButton(TEXT.ways[wanted.way], () => this.#ask(wanted), { title: TEXT.hints[wanted.way] });
  }

  /** Shows what it does while it is hovered or has the focus. */
  #makeLineButton(way: LineWay): HTMLButtonElement {
    const button = makeButton(TEXT.ways[way], () => this.#ask({ way, place: this.#place }), { title: TEXT.hints[way] });
    this.#previewAt(button, way);
    if (way === 'keep_larger' || way === 'keep_smaller') this.#keeping.push(button);
    return button;
  }

  #previewAt(element: HTMLElement, way: LineWay): void {
    whilePointedAt(
      element,
      () => this.#preview(way),
      () => this.#preview(null),
    );
  }

  /** The line, and what goes with its side; null: nothing is about to be done, and a line that was drawn stays to be seen, with
   *  its smaller side faded. */
  #preview(way: LineWay | null): void {
    this.#isPreviewing = way !== null;
    this.#allowSides();
    const isShown = way !== null || this.#isDrawnChosen;
    this.#events.previewAlone(isShown ? this.#verticesOf(this.#place) : []);
    const goes = this.#goingWith(way ?? (this.#isDrawnChosen ? 'keep_larger' : 'cut'));
    this.#events.fade(this.#net !== null && goes.length > 0 ? stayingWithout(this.#net, goes) : null);
  }

  /** Faces. */
  #goingWith(way: LineWay): readonly number[] {
    if (this.#net === null || (way !== 'keep_larger' && way !== 'keep_smaller')) return [];
    const { edges = [] } = placeOf(this.#net, this.#choice.selection, this.#place);
    const [larger = [], ...others] = sidesOf(this.#net, Array.from(edges));
    if (others.length === 0) return [];
    return way === 'keep_larger' ? others.flat() : larger;
  }

  #verticesOf(place: Place): readonly number[] {
    if (typeof place === 'object') return place.flat();
    if (place === 'between') return [];
    if (place !== 'through') return this.#events.handles.line(place);
    return this.#net === null ? [] : wayThrough(this.#net, this.#choice.selection);
  }

  #ask(wanted: WantedChange): void {
    this.#drawing.putAway();
    this.#events.previewAlone([]);
    this.#events.changeNet(wanted);
  }
}

/** What a net on a surface is to be like: its surface, how fine it is, and how it lies at the seed. */
import type { Point, RemeshOptions, SurfaceReport } from '../../../wasm/chebnet';
import type { DrapeSettings, Seed } from '../drape/drape_protocol';
import { cellsOf, FEWEST_CELLS, lengthOf, MOST_CELLS } from '../drape/cells';
import { turned, turnOf } from '../drape/seed';
import { make, makeSelect, makeSwitch, setText, setValue } from '../elements/dom';
import { NumberField } from '../elements/number_field';
import { dialogWords } from '../language/dialogs';
import { panelWords } from '../language/panels';
import { count, lengthDigits } from '../language/numbers';

const TEXT = dialogWords.drape;
const DEGREE = Math.PI / 180;
/** The cells' slider goes by steps of a fortieth of their range in decades. */
const STEPS = 40;
/** What may happen where the surface ends, the usual first. */
const BORDERS = ['beyond', 'cut', 'inside'] as const;
/** How far the net may leave the surface where it locks, in edge lengths. */
const HEIGHTS = [0, 0.1, 0.25, 0.5, 1];

/** Between its families a net has any of these angles at the seed that keeps within its limit, degrees. */
const LEAST_ANGLE = 40;
/** The sharpest corner a net may have, degrees; over a whole surface no net keeps to more. */
const LIMITS = { least: 10, usual: 30, piece: 75, whole: 60 };

/** Where net lines may run as the surface ends, of a net over the whole of it. */
const LINES = ['fitting', 'always', 'outer', 'across', 'never'] as const;

/** Edges of the surface that are sharper are followed, degrees; 0: none are; null: where the net then lies better. */
const CREASES = [null, 0, 30, 45, 60];

/** How large bumps may be that make no singular vertices; 1 as usual. */
const SMOOTHINGS = [0, 1, 3, 10, 30];

interface FormEvents {
  /** The name of one of our own, or null: the visitor's. */
  surfaceChosen(own: string | null): void;
  /** One piece from a seed, or a net over the whole surface. */
  kindChanged(): void;
  changed(): void;
  shearChanged(shown: boolean): void;
}

export class DrapeForm {
  readonly element: HTMLElement;
  readonly #events: FormEvents;
  readonly #cells = slider(TEXT.cells, 0, STEPS, 1, () => this.#chooseCells());
  readonly #length = new NumberField({ step: 'any', required: true, 'aria-label': TEXT.length }, TEXT.tooShort);
  readonly #turn = slider(TEXT.direction, 0, 180, 1, () => this.#chooseTurn());
  readonly #angle = slider(TEXT.angle, LEAST_ANGLE, 180 - LEAST_ANGLE, 1, () => this.#show());
  readonly #limit = slider(TEXT.limit, LIMITS.least, LIMITS.piece, 1, () => this.#chooseLimit());
  readonly #reach = new NumberField({ min: 1, step: 1, placeholder: TEXT.toBorder });
  readonly #border = makeSelect(
    TEXT.border,
    BORDERS.map((value) => ({ value, text: TEXT.borders[value] })),
    () => this.#events.changed(),
  );
  readonly #leave = makeSelect(
    TEXT.locked,
    HEIGHTS.map((height) => ({ value: String(height), text: TEXT.leaves(height) })),
    () => this.#events.changed(),
  );
  readonly #line = makeSelect(
    TEXT.border,
    LINES.map((value) => ({ value, text: TEXT.lines[value] })),
    () => this.#events.changed(),
  );
  readonly #crease = makeSelect(
    TEXT.crease,
    CREASES.map((degrees) => ({ value: String(degrees ?? ''), text: TEXT.creases(degrees) })),
    () => this.#events.changed(),
  );
  readonly #smoothing = makeSelect(
    TEXT.smoothing,
    SMOOTHINGS.map((smoothing) => ({ value: String(smoothing), text: TEXT.smoothings(smoothing) })),
    () => this.#events.changed(),
  );
  readonly #singular = makeSelect(
    TEXT.howMany,
    (['usual', 'fewest'] as const).map((value) => ({ value, text: TEXT.howManyOf[value] })),
    () => this.#events.changed(),
  );
  readonly #shear = makeSwitch(TEXT.showShear, (shown) => this.#events.shearChanged(shown));
  readonly #kinds: ReturnType<typeof makeSelect>;
  /** What only a net from a seed has. */
  readonly #pieceRows: HTMLElement[];
  /** What only a net over the whole surface has. */
  readonly #wholeRows: HTMLElement[];
  #area = 1;
  /** The length of edges: what is in the field, unless that is refused. */
  #edge = 1;
  /** A length was asked for, not a number of cells. */
  #isByLength = false;
  #hasBorder = false;
  #seed: Seed | null = null;
  #direction: Point = [1, 0, 0];

  /** @param name of the visitor's surface; null: there is only our own.
   *  @param arms what is set of a piece beside its angle. */
  constructor(name: string | null, arms: HTMLElement, events: FormEvents) {
    this.#events = events;
    const choices = Object.entries(panelWords.guide.own).map(([value, text]) => ({ value, text }));
    const all = [...(name === null ? [] : [{ value: '', text: name }]), ...choices];
    const surfaces = makeSelect(TEXT.surface, all, (value) => events.surfaceChosen(value || null));
    this.#kinds = makeSelect(
      TEXT.kind,
      Object.entries(TEXT.kinds).map(([value, text]) => ({ value, text })),
      () => this.#chooseKind(),
    );
    this.#length.input.addEventListener('change', () => this.#chooseLength());
    this.#reach.input.addEventListener('change', () => this.#chooseReach());
    this.#angle.input.value = '90';
    this.#limit.input.value = String(LIMITS.usual);
    this.#smoothing.select.value = '1';
    this.#shear.box.checked = true;
    const length = make('label', { class: 'row' }, make('span', {}, TEXT.length), this.#length.input);
    const reach = make('label', { class: 'row' }, make('span', {}, TEXT.reach), this.#reach.input);
    this.#pieceRows = [
      this.#turn.row,
      this.#angle.row,
      arms,
      reach,
      this.#reach.note,
      this.#border.row,
      this.#leave.row,
    ];
    this.#wholeRows = [this.#line.row, this.#crease.row, this.#singular.row, this.#smoothing.row];
    this.#showRows();
    this.element = make(
      'div',
      { class: 'settings' },
      surfaces.row,
      this.#kinds.row,
      this.#cells.row,
      length,
      this.#length.note,
      this.#limit.row,
      ...this.#pieceRows,
      ...this.#wholeRows,
      this.#shear.row,
    );
    this.#show();
  }

  /** Whether a net over the whole surface is wanted. */
  get isWhole(): boolean {
    return this.#kinds.select.value === 'whole';
  }

  /** What may keep a net over the whole surface from folding: what is not as fits best yet, or else more cells. */
  get wayAgainstFolds(): 'border' | 'edges' | 'cells' {
    if (this.#hasBorder && this.#line.select.value !== 'fitting') return 'border';
    return this.#crease.select.value === '' ? 'cells' : 'edges';
  }

  /** Of a net over the whole surface. */
  readWhole(): RemeshOptions {
    const length = this.#edge;
    const crease = this.#crease.select.value;
    return {
      ...(this.#isByLength ? { length } : { cells: Math.round(cellsOf(length, this.#area)) }),
      smallestAngle: this.#limit.input.valueAsNumber * DEGREE,
      smoothing: Number(this.#smoothing.select.value),
      fewest: this.#singular.select.value === 'fewest',
      ...(crease === '' ? {} : { crease: Number(crease) * DEGREE }),
      border: this.#line.select.value as (typeof LINES)[number],
    };
  }

  /** Whether nothing that is set is refused. If something is, its field has the focus: why stands below it. */
  isAllowed(): boolean {
    const fields = this.isWhole ? [this.#length] : [this.#length, this.#reach];
    const refused = fields.find(({ value }) => value === null);
    refused?.input.focus();
    return refused === undefined;
  }

  /** Another surface, and a length that suits it. */
  setSurface({ area, boundaryLoops }: SurfaceReport, length: number): void {
    this.#area = area;
    this.#hasBorder = boundaryLoops > 0;
    this.#showRows();
    this.#seed = null;
    this.#isByLength = false;
    this.#length.input.min = lengthDigits(lengthOf(MOST_CELLS, area));
    this.#setLength(length);
  }

  setSeed(seed: Seed): void {
    this.#seed = seed;
    this.#direction = seed.direction;
    setValue(this.#turn.input, String(Math.round(turnOf(seed.direction, seed.normal) / DEGREE) % 180));
    this.#show(false);
  }

  /** Whether the direction can be chosen: along a curve it cannot. */
  setTurnable(turnable: boolean): void {
    this.#turn.input.disabled = !turnable;
  }

  setDirection(direction: Point): void {
    this.#direction = direction;
  }

  read(): Omit<DrapeSettings, 'seed' | 'cuts'> {
    const reach = this.#reach.value;
    return {
      direction: this.#direction,
      length: this.#edge,
      angle: this.#angle.input.valueAsNumber * DEGREE,
      smallestAngle: this.#limit.input.valueAsNumber * DEGREE,
      ...(reach ? { reach } : {}),
      border: this.#border.select.value as (typeof BORDERS)[number],
      leave: Number(this.#leave.select.value),
    };
  }

  /** The families cannot be closer to each other than corners may be sharp. */
  #chooseLimit(): void {
    this.#boundAngle();
    this.#show();
  }

  #boundAngle(): void {
    const least = Math.max(LEAST_ANGLE, this.isWhole ? 0 : this.#limit.input.valueAsNumber);
    // The input keeps its value within what it may be.
    this.#angle.input.min = String(least);
    this.#angle.input.max = String(180 - least);
  }

  #chooseReach(): void {
    if (this.#reach.value !== null) this.#events.changed();
  }

  #chooseKind(): void {
    // The length that a whole net came to have is none that was asked for.
    this.showMadeLength(this.#edge);
    this.#limit.input.max = String(this.isWhole ? LIMITS.whole : LIMITS.piece);
    this.#boundAngle();
    this.#show(false);
    this.#showRows();
    this.#events.kindChanged();
  }

  #showRows(): void {
    for (const row of this.#pieceRows) row.hidden = this.isWhole;
    for (const row of this.#wholeRows) row.hidden = !this.isWhole;
    if (!this.#hasBorder) this.#line.row.hidden = true;
  }

  #chooseCells(): void {
    this.#isByLength = false;
    this.#setLength(lengthOf(cellsAt(this.#cells.input.valueAsNumber), this.#area));
    this.#events.changed();
  }

  #chooseLength(): void {
    const length = this.#length.value;
    if (length === null) return;
    this.#isByLength = true;
    this.#setLength(length);
    this.#events.changed();
  }

  #setLength(length: number): void {
    this.#length.put(lengthDigits(length));
    this.#edge = this.#length.input.valueAsNumber;
    this.#cells.input.value = String(stepOf(cellsOf(length, this.#area)));
    this.#show(false);
  }

  /** Of a net over the whole surface, whose cells come out somewhat larger or smaller than those asked for. */
  showMadeLength(length: number): void {
    if (!this.#isByLength) this.#length.put(lengthDigits(length));
  }

  #chooseTurn(): void {
    if (this.#seed === null) return;
    this.#direction = turned(this.#turn.input.valueAsNumber * DEGREE, this.#seed.normal);
    this.#show();
  }

  #show(isChange = true): void {
    const cells = count(Math.round(cellsOf(this.#edge, this.#area)));
    show(this.#cells, cells);
    show(this.#turn, `${this.#turn.input.value}°`);
    show(this.#angle, `${this.#angle.input.value}°`);
    show(this.#limit, `${this.#limit.input.value}°`);
    // One piece has no direction before its first net.
    if (isChange && (this.isWhole || this.#seed !== null)) this.#events.changed();
  }
}

function cellsAt(step: number): number {
  return FEWEST_CELLS * (MOST_CELLS / FEWEST_CELLS) ** (step / STEPS);
}

function stepOf(cells: number): number {
  return Math.round((STEPS * Math.log(cells / FEWEST_CELLS)) / Math.log(MOST_CELLS / FEWEST_CELLS));
}

interface Slider {
  row: HTMLElement;
  input: HTMLInputElement;
  output: HTMLOutputElement;
}

function slider(label: string, min: number, max: number, step: number, moved: () => void): Slider {
  const input = make('input', { type: 'range', min, max, step });
  const output = make('output');
  input.addEventListener('input', moved);
  return { row: make('label', { class: 'slider' }, make('span', {}, label), input, output), input, output };
}

function show({ input, output }: Slider, text: string): void {
  setText(output, text);
  input.setAttribute('aria-valuetext', text);
}

/** What drags snap or keep to. A key held suspends it; arrow keys, which go step by step, are not attracted by other handles. */
import type { GuideSource, HandleData } from '../document/document';
import { make, makeSwitch } from '../elements/dom';
import type { KeyRow } from '../elements/keys';
import { NumberField } from '../elements/number_field';
import type { HandleCommands } from '../handles/commands';
import { borderOfNet, borderOfSurface, type Curve, throughHandles } from '../handles/curve';
import { chosen, type Selection } from '../handles/selection';
import { Snapping } from '../handles/snapping';
import { SurfacePoints } from '../handles/surface_points';
import { panelWords } from '../language/panels';
import type { OpenedNet } from '../worker/protocol';
import './snap_controls.css';

const TEXT = panelWords.drag;

export const SNAP_KEYS: readonly KeyRow[] = [
  { keys: [`Ctrl+${panelWords.keys.dragging}`, `⌘+${panelWords.keys.dragging}`], does: 'suspendSnap' },
];

/** Curves that drags can keep to. */
const CURVES = ['none', 'net', 'surface', 'handles'] as const;
type CurveName = (typeof CURVES)[number];

/** The net that is open as it lies now, and its handles. Shown with every frame of a drag: what a curve needs of them is
 *  looked for when one is chosen. */
export interface Present {
  net: OpenedNet | null;
  positions: Float64Array | null;
  handles: readonly HandleData[];
  selection: Selection;
}

export class SnapControls {
  readonly rows: HTMLElement[];
  readonly #grid = makeSwitch(TEXT.toGrid, () => this.#apply());
  readonly #handles = makeSwitch(TEXT.toHandles, () => this.#apply());
  readonly #onto = makeSwitch(TEXT.toSurface, () => this.#snapToSurface());
  readonly #spacing = new NumberField({
    min: 0,
    above: 0,
    step: 'any',
    value: 1,
    required: true,
    'aria-label': TEXT.spacing,
  });
  readonly #unit = make(
    'select',
    { 'aria-label': TEXT.unit },
    ...(['edges', 'units'] as const).map((unit) => make('option', { value: unit }, TEXT.units[unit])),
  );
  readonly #spacingRow: HTMLElement;
  readonly #curves = make(
    'select',
    { 'aria-label': TEXT.toCurve },
    ...CURVES.map((name) => make('option', { value: name }, TEXT.curves[name])),
  );
  readonly #present: Readonly<Present>;
  readonly #say: (message: string) => void;
  readonly #failed: (error: unknown) => void;
  /** As it was when it was chosen. */
  #curve: Curve | null = null;
  /** Of whole edges at rest, and by how much they have grown. */
  #restLength = 1;
  #lengthScale = 1;
  /** The surface beside the net, and where its points are, once they have been asked for. */
  #guide: GuideSource | undefined;
  #surface: SurfacePoints | null = null;
  #isSuspended = false;
  #isArrowHeld = false;
  readonly #commands: HandleCommands;

  /** @param say tells the visitor what cannot be done. */
  constructor(
    commands: HandleCommands,
    present: Readonly<Present>,
    say: (message: string) => void,
    failed: (error: unknown) => void,
  ) {
    this.#commands = commands;
    this.#present = present;
    this.#say = say;
    this.#failed = failed;
    this.#handles.row.title = TEXT.toHandlesHint;
    this.#grid.row.title = TEXT.toGridHint;
    this.#spacingRow = make(
      'div',
      {},
      make(
        'div',
        { class: 'row' },
        make('span', {}, TEXT.spacing),
        make('div', { class: 'spacing' }, this.#spacing.input, this.#unit),
      ),
      this.#spacing.note,
    );
    for (const field of [this.#spacing.input, this.#unit]) field.addEventListener('change', () => this.#apply());
    this.#onto.row.title = TEXT.toSurfaceHint;
    this.#onto.row.hidden = true;
    const curves = make(
      'label',
      { class: 'row', title: TEXT.toCurveHint },
      make('span', {}, TEXT.toCurve),
      this.#curves,
    );
    this.#curves.addEventListener('change', () => this.#keepToChosen());
    this.rows = [this.#grid.row, this.#spacingRow, this.#handles.row, this.#onto.row, curves];
    // Before the picture moves the selection at a key, and after it has ended that at its release.
    addEventListener('keydown', (event) => this.#hold(event, true), { capture: true });
    addEventListener('keyup', (event) => this.#hold(event, false));
    addEventListener('blur', () => this.#setHeld(false, false));
    this.#spacingRow.hidden = true;
  }

  /** Another net is open: a curve was of the one before. */
  setNet({ info }: OpenedNet): void {
    this.#restLength = info.edgeLength;
    this.#keepTo(null);
  }

  setLengthScale(scale: number): void {
    if (scale === this.#lengthScale) return;
    this.#lengthScale = scale;
    if (this.#isOn) this.#apply();
  }

  get #edgeLength(): number {
    return this.#restLength * this.#lengthScale;
  }

  /** @param guide beside the net that is open. */
  setGuide(guide: GuideSource | undefined): void {
    if (guide === this.#guide) return;
    this.#guide = guide;
    this.#onto.row.hidden = guide === undefined;
    if (this.#onto.box.checked) this.#snapToSurface();
  }

  #keepToChosen(): void {
    const name = this.#curves.value as CurveName;
    this.#chooseCurve(name).catch((error: unknown) => {
      if (this.#curves.value === name) this.#keepTo(null);
      this.#failed(error);
    });
  }

  async #chooseCurve(name: CurveName): Promise<void> {
    const curve = await this.#curveOf(name);
    if (this.#curves.value !== name) return;
    this.#keepTo(curve);
    if (name !== 'none' && curve === null) this.#say(TEXT.noCurve[name]);
  }

  /** Null: there is no such curve. */
  async #curveOf(name: CurveName): Promise<Curve | null> {
    const { net, positions, handles, selection } = this.#present;
    if (name === 'net') return net && positions && borderOfNet(net, positions);
    if (name === 'handles') return throughHandles(chosen(selection, handles));
    const surface = name === 'surface' ? await this.#commands.guide() : null;
    return surface && borderOfSurface(surface);
  }

  #keepTo(curve: Curve | null): void {
    this.#curve = curve;
    if (curve === null) this.#curves.value = 'none';
    this.#apply();
  }

  #snapToSurface(): void {
    this.#findSurface().catch((error: unknown) => {
      this.#onto.box.checked = false;
      this.#failed(error);
    });
  }

  async #findSurface(): Promise<void> {
    const guide = this.#guide;
    this.#surface = null;
    this.#apply();
    if (!this.#onto.box.checked || guide === undefined) return;
    const surface = await this.#commands.guide();
    if (guide !== this.#guide || surface === null) return;
    this.#surface = new SurfacePoints(surface);
    this.#apply();
  }

  #hold({ key, ctrlKey, metaKey }: KeyboardEvent, down: boolean): void {
    const isArrow = /^Arrow/.test(key);
    this.#setHeld(ctrlKey || metaKey, isArrow ? down : this.#isArrowHeld);
  }

  #setHeld(suspended: boolean, arrow: boolean): void {
    if (suspended === this.#isSuspended && arrow === this.#isArrowHeld) return;
    [this.#isSuspended, this.#isArrowHeld] = [suspended, arrow];
    if (this.#isOn) this.#apply();
  }

  get #isOn(): boolean {
    return this.#grid.box.checked || this.#handles.box.checked || this.#isOntoSurface || this.#curve !== null;
  }

  get #isOntoSurface(): boolean {
    return this.#onto.box.checked && this.#surface !== null;
  }

  #apply(): void {
    this.#spacingRow.hidden = !this.#grid.box.checked;
    const step = this.#grid.box.checked && !this.#isSuspended ? this.#step : null;
    const toHandles = this.#handles.box.checked && !this.#isSuspended && !this.#isArrowHeld;
    const onto = this.#isSuspended ? null : (this.#curve ?? (this.#isOntoSurface ? this.#surface : null));
    this.#commands.setSnapping(this.#isOn ? new Snapping(step, toHandles, this.#edgeLength, onto) : null);
  }

  /** In the net's unit; null: the field has no such number. */
  get #step(): number | null {
    const { value } = this.#spacing;
    return value === null ? null : value * (this.#unit.value === 'edges' ? this.#edgeLength : 1);
  }
}

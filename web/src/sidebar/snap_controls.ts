/** What drags snap to. A key held suspends it; arrow keys, which go step by step, are not attracted by other handles. */
import type { GuideSource } from '../document/document';
import { make, makeSwitch } from '../elements/dom';
import type { KeyRow } from '../elements/keys';
import type { HandleCommands } from '../handles/commands';
import { Snapping } from '../handles/snapping';
import { SurfacePoints } from '../handles/surface_points';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import './snap_controls.css';

const TEXT = panelWords.drag;

export const SNAP_KEYS: readonly KeyRow[] = [
  { keys: [`Ctrl+${words.keys.drag}`, `⌘+${words.keys.drag}`], does: 'suspendSnap' },
];

export class SnapControls {
  readonly rows: HTMLElement[];
  readonly #grid = makeSwitch(TEXT.toGrid, () => this.#apply());
  readonly #handles = makeSwitch(TEXT.toHandles, () => this.#apply());
  readonly #onto = makeSwitch(TEXT.toSurface, () => void this.#findSurface());
  readonly #spacing = make('input', {
    type: 'number',
    min: 0,
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
  #edgeLength = 1;
  /** The surface beside the net, and where its points are, once they have been asked for. */
  #guide: GuideSource | undefined;
  #surface: SurfacePoints | null = null;
  #isSuspended = false;
  #isArrowHeld = false;
  readonly #commands: HandleCommands;

  constructor(commands: HandleCommands) {
    this.#commands = commands;
    this.#handles.row.title = TEXT.toHandlesHint;
    this.#grid.row.title = TEXT.toGridHint;
    this.#spacingRow = make(
      'div',
      { class: 'row' },
      make('span', {}, TEXT.spacing),
      make('div', { class: 'spacing' }, this.#spacing, this.#unit),
    );
    for (const field of [this.#spacing, this.#unit]) field.addEventListener('change', () => this.#apply());
    this.#onto.row.title = TEXT.toSurfaceHint;
    this.#onto.row.hidden = true;
    this.rows = [this.#grid.row, this.#spacingRow, this.#handles.row, this.#onto.row];
    // Before the picture moves the selection at a key, and after it has ended that at its release.
    addEventListener('keydown', (event) => this.#hold(event, true), { capture: true });
    addEventListener('keyup', (event) => this.#hold(event, false));
    addEventListener('blur', () => this.#setHeld(false, false));
    this.#spacingRow.hidden = true;
  }

  /** @param edgeLength of the net that is open. */
  setEdgeLength(edgeLength: number): void {
    this.#edgeLength = edgeLength;
    this.#apply();
  }

  /** @param guide beside the net that is open. */
  setGuide(guide: GuideSource | undefined): void {
    if (guide === this.#guide) return;
    this.#guide = guide;
    this.#onto.row.hidden = guide === undefined;
    if (this.#onto.box.checked) void this.#findSurface();
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
    return this.#grid.box.checked || this.#handles.box.checked || this.#isOntoSurface;
  }

  get #isOntoSurface(): boolean {
    return this.#onto.box.checked && this.#surface !== null;
  }

  #apply(): void {
    this.#spacingRow.hidden = !this.#grid.box.checked;
    const step = this.#grid.box.checked && !this.#isSuspended ? this.#step : null;
    const toHandles = this.#handles.box.checked && !this.#isSuspended && !this.#isArrowHeld;
    const surface = this.#isOntoSurface && !this.#isSuspended ? this.#surface : null;
    this.#commands.setSnapping(this.#isOn ? new Snapping(step, toHandles, this.#edgeLength, surface) : null);
  }

  /** In the net's unit; null: the field has no such number. */
  get #step(): number | null {
    const spacing = this.#spacing.valueAsNumber;
    return spacing > 0 ? spacing * (this.#unit.value === 'edges' ? this.#edgeLength : 1) : null;
  }
}

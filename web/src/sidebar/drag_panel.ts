/** Settings of a drag: how far from the dragged handles the net moves, whether they are kept to where it can follow, and what
 *  they snap to. */
import type { ChebnetDocument } from '../document/document';
import type { HandleCommands } from '../handles/commands';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeSection, makeSwitch } from '../elements/dom';
import type { Panel } from '../panels';
import type { OpenedNet } from '../worker/protocol';
import { SnapControls } from './snap_controls';

/** Steps of the slider: at the first everything moves. */
const STEPS = 40;
/** In edge lengths. */
const NEAREST = 2;

export class DragPanel implements Panel {
  readonly element: HTMLElement;
  readonly #slider = make('input', {
    type: 'range',
    min: 0,
    max: STEPS,
    value: 0,
    title: panelWords.drag.localityHint,
  });
  readonly #output = make('output');
  #farthest = 50;
  #shown: number | undefined;
  readonly #commands: HandleCommands;
  readonly #snap: SnapControls;

  constructor(commands: HandleCommands) {
    this.#commands = commands;
    const row = make(
      'label',
      { class: 'slider locality' },
      make('span', {}, panelWords.drag.locality),
      this.#slider,
      this.#output,
    );
    this.#slider.addEventListener('input', () => this.#adjust());
    this.#slider.addEventListener('focus', () => this.#adjust());
    this.#slider.addEventListener('blur', () => commands.previewLocality(undefined));
    this.#slider.addEventListener('change', () => this.#choose());
    const within = makeSwitch(panelWords.drag.within, (on) => commands.setKeepWithin(on));
    within.row.title = panelWords.drag.withinHint;
    within.box.checked = true;
    this.#snap = new SnapControls(commands);
    const reach = makeSwitch(panelWords.drag.showReach, (on) => commands.setShowReach(on));
    reach.row.title = panelWords.drag.showReachHint;
    const axes = make('p', { class: 'quiet' }, panelWords.drag.axes);
    this.element = makeSection(words.sections.drag, false, row, within.row, reach.row, ...this.#snap.rows, axes);
    this.#write(undefined);
  }

  /** The largest radius is about half the width of such a net. */
  setNet({ info }: OpenedNet): void {
    this.#farthest = Math.max(2 * NEAREST, Math.round(Math.sqrt(info.vertices)));
    this.#update(this.#shown);
    this.#snap.setEdgeLength(info.meanLength);
  }

  setDocument({ locality }: ChebnetDocument): void {
    this.#update(locality);
  }

  #update(locality: number | undefined): void {
    this.#shown = locality;
    if (document.activeElement !== this.#slider || this.#radius() !== locality)
      this.#slider.valueAsNumber = this.#stepOf(locality);
    this.#write(locality);
  }

  #adjust(): void {
    this.#write(this.#radius());
    this.#commands.previewLocality(this.#radius());
  }

  #choose(): void {
    if (this.#radius() !== this.#shown) this.#commands.setLocality(this.#radius());
  }

  #write(locality: number | undefined): void {
    const text =
      locality === undefined
        ? panelWords.drag.everything
        : panelWords.drag.radius(locality.toLocaleString(words.locale));
    this.#output.value = text;
    this.#slider.setAttribute('aria-valuetext', text);
  }

  /** Equal steps make equal ratios, rounded to whole edges. */
  #radius(): number | undefined {
    const step = this.#slider.valueAsNumber;
    if (step === 0) return undefined;
    return Math.round(NEAREST * (this.#farthest / NEAREST) ** ((STEPS - step) / (STEPS - 1)));
  }

  #stepOf(locality: number | undefined): number {
    if (locality === undefined) return 0;
    const part = Math.log(locality / NEAREST) / Math.log(this.#farthest / NEAREST);
    return Math.min(Math.max(Math.round(STEPS - part * (STEPS - 1)), 1), STEPS);
  }
}

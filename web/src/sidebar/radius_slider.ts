/** A slider for a radius in edge lengths along the net, whose first step is none. Equal steps make equal ratios, rounded to whole
 *  edges. */
import { make } from '../elements/dom';
import { words } from '../language/language';
import { panelWords } from '../language/panels';

/** Steps of the slider beyond the first. */
const STEPS = 40;
/** In edge lengths. */
const NEAREST = 2;

interface RadiusWords {
  label: string;
  hint: string;
  /** What the first step says. */
  none: string;
}

interface RadiusEvents {
  /** While it is moved or has the focus, and undefined at the end. */
  preview(radius: number | undefined): void;
  choose(radius: number | undefined): void;
}

export class RadiusSlider {
  readonly row: HTMLElement;
  readonly #slider = make('input', { type: 'range', min: 0, max: STEPS, value: 0 });
  readonly #output = make('output');
  #farthest = 50;
  #shown: number | undefined;
  readonly #none: string;
  readonly #grows: boolean;
  readonly #events: RadiusEvents;

  /** @param grows from the first step on; otherwise it begins with the largest and shrinks. */
  constructor(name: string, { label, hint, none }: RadiusWords, grows: boolean, events: RadiusEvents) {
    this.#none = none;
    this.#grows = grows;
    this.#events = events;
    this.#slider.title = hint;
    this.row = make('label', { class: `slider ${name}` }, make('span', {}, label), this.#slider, this.#output);
    this.#slider.addEventListener('input', () => this.#adjust());
    // What is set, which may lie between steps.
    this.#slider.addEventListener('focus', () => events.preview(this.#shown));
    this.#slider.addEventListener('blur', () => {
      events.preview(undefined);
      this.update(this.#shown);
    });
    this.#slider.addEventListener('change', () => this.#choose());
    this.#write(undefined);
  }

  /** @param vertices of the net: the largest radius is about half the width of such a one. */
  setSize(vertices: number): void {
    this.#farthest = Math.max(2 * NEAREST, Math.round(Math.sqrt(vertices)));
    this.update(this.#shown);
  }

  update(radius: number | undefined): void {
    this.#shown = radius;
    if (document.activeElement !== this.#slider || this.#radius() !== radius)
      this.#slider.valueAsNumber = this.#stepOf(radius);
    this.#write(radius);
  }

  #adjust(): void {
    this.#write(this.#radius());
    this.#events.preview(this.#radius());
  }

  #choose(): void {
    if (this.#radius() !== this.#shown) this.#events.choose(this.#radius());
  }

  #write(radius: number | undefined): void {
    const text = radius === undefined ? this.#none : panelWords.drag.radius(radius.toLocaleString(words.locale));
    this.#output.value = text;
    this.#slider.setAttribute('aria-valuetext', text);
  }

  #radius(): number | undefined {
    const step = this.#slider.valueAsNumber;
    if (step === 0) return undefined;
    const part = (step - 1) / (STEPS - 1);
    return Math.round(NEAREST * (this.#farthest / NEAREST) ** (this.#grows ? part : 1 - part));
  }

  #stepOf(radius: number | undefined): number {
    if (radius === undefined) return 0;
    const part = Math.log(radius / NEAREST) / Math.log(this.#farthest / NEAREST);
    return 1 + Math.round((this.#grows ? within(part) : 1 - within(part)) * (STEPS - 1));
  }
}

function within(part: number): number {
  return Math.min(Math.max(part, 0), 1);
}

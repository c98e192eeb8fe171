/** The colour map with its ends, which can be set by hand, and below it the range of the data. */
import type { Run } from '../compare/run';
import { type ChebnetDocument, lookOf } from '../document/document';
import { cssColour, positionOn, type Scale } from '../fields/colour_map';
import { fieldOf, numbersOf, rangeOf, type ShownColouring, scaleOf } from '../fields/fields';
import { words } from '../language/language';
import { onThemeChange, readTheme } from '../view/theme';
import type { FrameData, OpenedNet } from '../worker/protocol';
import { make, setText } from '../elements/dom';
import type { Panel } from '../panels';
import './legend.css';

const STOPS = 24;

export class Legend implements Panel {
  readonly #name = make('h2');
  readonly #bar = make('div', { class: 'bar' });
  readonly #data = make('div', { class: 'data' });
  readonly #ticks = make('div', { class: 'ticks' });
  readonly #words = make('p', { class: 'words' });
  /** What it unfolds comes with the late sections: see map_ends.ts. */
  readonly ends = make('details', {}, make('summary', {}, words.legend.ends));
  readonly element: HTMLElement;
  #view: ShownColouring = { field: 'deviation', colourMap: 'paper' };
  #scale: Scale | null = null;
  /** The frame of the open net, and the one in the view, which may be that of a run. */
  #own: FrameData | null = null;
  #frame: FrameData | null = null;
  #net: OpenedNet | null = null;

  constructor() {
    this.element = make(
      'section',
      { class: 'legend', 'aria-label': words.legend.label },
      this.#name,
      this.#bar,
      make('div', { class: 'track' }, this.#data),
      this.#ticks,
      this.#words,
      this.ends,
    );
    onThemeChange(() => this.#draw());
  }

  setDocument(document: ChebnetDocument): void {
    const { field, colourMap, ends, cornerLimit } = this.#view;
    const view = lookOf(document);
    const same =
      this.#scale !== null &&
      view.field === field &&
      view.colourMap === colourMap &&
      view.ends === ends &&
      view.cornerLimit === cornerLimit;
    this.#view = view;
    if (!same) this.#draw();
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#own = this.#frame = null;
  }

  setFrame(frame: FrameData): void {
    this.#own = this.#frame = frame;
    this.#drawData();
  }

  setRuns(run: Run | null): void {
    this.#frame = run?.frame ?? this.#own;
    this.#drawData();
  }

  #drawData(): void {
    if (!this.#scale || !this.#frame || !this.#net) return;
    const field = fieldOf(this.#view.field);
    const numbers = numbersOf(field, this.#frame, this.#net);
    const [from, to] = rangeOf(numbers);
    const left = legendPosition(this.#scale, from);
    const width = Math.max(0.02, legendPosition(this.#scale, to) - left);
    this.#data.style.left = `${(100 * Math.min(left, 0.98)).toFixed(1)}%`;
    this.#data.style.width = `${(100 * width).toFixed(1)}%`;
    setText(this.#words, field.summary(numbers, this.#frame, this.#net));
  }

  #draw(): void {
    const name = this.#view.field;
    const field = fieldOf(name);
    const scale = scaleOf(this.#view, readTheme(document.documentElement));
    this.#scale = scale;
    this.#data.hidden = this.ends.hidden = field.ends === undefined;
    setText(this.#name, words.colourFields[name].title);
    const [low, high] = scale.shown;
    const stops = Array.from({ length: STOPS + 1 }, (_, i) => {
      const value = scale.logarithmic ? low * (high / low) ** (i / STOPS) : low + (high - low) * (i / STOPS);
      return cssColour(scale.colour(positionOn(scale, value)));
    });
    this.#bar.style.background = `linear-gradient(to right, ${stops.join(',')})`;
    this.#ticks.replaceChildren(
      ...scale.ticks.map(({ value, label }) => {
        const tick = make('span', {}, label);
        tick.style.left = `${100 * legendPosition(scale, value)}%`;
        return tick;
      }),
    );
    this.#drawData();
  }
}

/** Position of a value on the legend, whose range may be wider than that of the map. */
function legendPosition(scale: Scale, value: number): number {
  return positionOn({ ...scale, low: scale.shown[0], high: scale.shown[1] }, value);
}

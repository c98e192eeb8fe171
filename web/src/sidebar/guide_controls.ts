/** The surface beside the net: what it does to it and how strongly, whether it is shown, and taking it away. */
import type { ChebnetDocument, SolverOptions } from '../document/document';
import { guideTitle } from '../document/changes';
import { type ChangeName, textOf } from '../document/naming';
import { make, makeButton, makeSelect, makeSwitch, setText, setValue } from '../elements/dom';
import { panelWords } from '../language/panels';
import { makeSlider } from './slider';

const TEXT = panelWords.guide;
/** Steps of the slider: each four times as strong, the middle one as usual. */
const [STEPS, STEP] = [6, 4];

interface GuideEvents {
  setOptions(change: SolverOptions, name?: ChangeName): void;
  setHidden(hidden: boolean): void;
  putHandlesOn(): void;
  letGo(): void;
}

export class GuideControls {
  readonly element: HTMLElement;
  readonly #title = make('p');
  readonly #mode: ReturnType<typeof makeSelect>;
  readonly #weight = makeSlider(TEXT.weight, STEPS, timesText, (step) =>
    this.#events.setOptions({ guide_weight: this.#usualWeight * factorOf(step) }, ['guideWeight', timesText(step)]),
  );
  readonly #shown: ReturnType<typeof makeSwitch>;
  readonly #elsewhere = make('p', { class: 'quiet' }, TEXT.elsewhere);
  readonly #events: GuideEvents;
  #usualWeight = 1;

  constructor(events: GuideEvents) {
    this.#events = events;
    const modes = TEXT.modes.map((text, mode) => ({ value: String(mode), text }));
    this.#mode = makeSelect(TEXT.mode, modes, (mode) => events.setOptions({ guide_mode: Number(mode) }));
    this.#shown = makeSwitch(TEXT.shown, (shown) => events.setHidden(!shown));
    this.element = make(
      'div',
      { class: 'guide', role: 'group' },
      this.#title,
      this.#mode.row,
      this.#weight.row,
      this.#elsewhere,
      this.#shown.row,
      make(
        'div',
        { class: 'buttons' },
        makeButton(TEXT.putHandlesOn, () => events.putHandlesOn()),
        makeButton(TEXT.letGo, () => events.letGo()),
      ),
    );
  }

  /** @param acts whether the net's method heeds it. */
  set({ guide, options, view }: ChebnetDocument, usual: SolverOptions, acts: boolean): void {
    if (guide === undefined) return;
    this.#usualWeight = Number(usual.guide_weight ?? 1);
    const title = TEXT.title(textOf(guideTitle(guide)));
    setText(this.#title, title);
    this.element.setAttribute('aria-label', title);
    setValue(this.#mode.select, String(options.guide_mode ?? usual.guide_mode ?? 1));
    const factor = Number(options.guide_weight ?? this.#usualWeight) / this.#usualWeight;
    this.#weight.set(Math.min(Math.max(Math.round(STEPS / 2 + Math.log(factor) / Math.log(STEP)), 0), STEPS));
    for (const row of [this.#mode.row, this.#weight.row]) row.hidden = !acts;
    this.#elsewhere.hidden = acts;
    this.#shown.box.checked = view.guideHidden !== true;
  }
}

function factorOf(step: number): number {
  return STEP ** (step - STEPS / 2);
}

function timesText(step: number): string {
  return TEXT.times(Number(factorOf(step).toPrecision(2)).toString());
}

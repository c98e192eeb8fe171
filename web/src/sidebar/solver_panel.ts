/** The method and its settings, and buttons to solve, stop and reset. */
import type { OptionInfo } from '../../../wasm/chebnet';
import type { ChebnetDocument, SolverOptions } from '../document/document';
import type { HistoryView } from '../document/undo';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import { make, makeButton, makeSection, makeSwitch } from '../elements/dom';
import { setDisabled } from '../elements/leave';
import { NumberField } from '../elements/number_field';
import type { FrameData } from '../worker/protocol';
import { InitialisationChoice, MethodChoice } from './method_choice';
import type { Panel, PanelEvents } from '../panels';

/** Options shown at once; the others are folded away. */
const USUAL = ['threshold', 'max_iterations', 'p_start', 'p_end', 'adaptive_p', 'adaptive_reduction'];

interface Setting {
  option: OptionInfo;
  set(value: number | boolean): void;
  row: HTMLElement;
}

export class SolverPanel implements Panel {
  readonly element: HTMLElement;
  readonly #method = new MethodChoice(() => this.#set(this.#options));
  readonly #initialisation = new InitialisationChoice(() => this.#set(this.#options));
  readonly #usual = make('div');
  readonly #seldom = make('div');
  readonly #more = make('details', { class: 'more' }, make('summary', {}, panelWords.solver.more), this.#seldom);
  readonly #defaults: HTMLButtonElement;
  readonly #buttons: Record<'cancel' | 'undo', HTMLButtonElement>;
  #settings: Setting[] = [];
  #options: SolverOptions = {};
  readonly #events: PanelEvents;

  constructor(events: PanelEvents) {
    this.#events = events;
    this.#buttons = {
      cancel: makeButton(panelWords.solver.cancel, () => events.cancel(), { disabled: true }),
      undo: makeButton(panelWords.solver.undo, () => events.undo(), { disabled: true }),
    };
    this.#defaults = makeButton(panelWords.solver.defaults, () => this.#set({}), { class: 'plain link' });
    this.element = makeSection(
      words.sections.solver,
      false,
      make(
        'div',
        { class: 'buttons' },
        makeButton(panelWords.solver.solve, () => events.solve(), { title: panelWords.solver.solveHint }),
        this.#buttons.cancel,
        makeButton(panelWords.solver.reset, () => events.reset()),
        this.#buttons.undo,
      ),
      ...this.#method.content,
      ...this.#initialisation.content,
      this.#usual,
      this.#more,
      this.#defaults,
    );
  }

  setTables({ methods, initialisations, options }: Tables): void {
    this.#method.setTable(methods);
    this.#initialisation.setTable(initialisations);
    this.#settings = options.map((option) => this.#makeSetting(option));
    const isUsual = ({ option }: Setting) => USUAL.includes(option.name);
    this.#usual.replaceChildren(...this.#settings.filter(isUsual).map(({ row }) => row));
    this.#seldom.replaceChildren(...this.#settings.filter((each) => !isUsual(each)).map(({ row }) => row));
  }

  setDocument({ method, initialisation, options }: ChebnetDocument): void {
    this.#options = options;
    this.#method.setValue(method);
    this.#initialisation.setValue(initialisation);
    const { options: read = [] } = this.#method.chosen ?? {};
    for (const { option, set, row } of this.#settings) {
      set(options[option.name] ?? option.value);
      row.hidden = !read.includes(option.name);
    }
    this.#more.hidden = [...this.#seldom.children].every((row) => (row as HTMLElement).hidden);
    this.#defaults.hidden = Object.keys(options).length === 0;
  }

  // Neither button leaves the focus to "Solve": one more Enter would begin a solve, and what could be redone would be gone.

  setHistory({ canUndo }: HistoryView): void {
    setDisabled(this.#buttons.undo, !canUndo);
  }

  setFrame(_frame: FrameData, _framesPerSecond: number, solving: boolean): void {
    if (this.#buttons.cancel.disabled === solving) setDisabled(this.#buttons.cancel, !solving);
  }

  #makeSetting(option: OptionInfo): Setting {
    if (option.kind === 'flag') {
      const { row, box } = makeSwitch(panelWords.solver.optionName(option.name), (on) => this.#change(option, on));
      row.title = panelWords.solver.option(option);
      return { option, set: (value) => (box.checked = Boolean(value)), row };
    }
    const step = option.kind === 'integer' ? 1 : 'any';
    const { smallest: min, largest: max } = option;
    const field = new NumberField({ step, min, max, required: true });
    field.input.addEventListener('change', () => {
      if (field.value !== null) this.#change(option, field.value);
    });
    const label = make(
      'label',
      { class: 'row', title: panelWords.solver.option(option) },
      make('span', {}, panelWords.solver.optionName(option.name)),
      field.input,
    );
    return { option, set: (value) => field.set(plain(Number(value))), row: make('div', {}, label, field.note) };
  }

  #change({ name }: OptionInfo, value: number | boolean): void {
    this.#set({ ...this.#options, [name]: value });
  }

  #set(options: SolverOptions): void {
    // All options are sent: those left out would go back to their defaults.
    const all = Object.fromEntries(this.#settings.map(({ option }) => [option.name, usualValue(option)]));
    const [method, initialisation] = [this.#method.value, this.#initialisation.value];
    this.#events.setOptions({ method, initialisation, options: { ...all, ...options } });
  }
}

function usualValue({ kind, value }: OptionInfo): number | boolean {
  return kind === 'flag' ? value !== 0 : value;
}

/** 1e-6 rather than 0.000001. */
function plain(value: number): string {
  return value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential() : String(value);
}

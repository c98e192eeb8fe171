/** A form to choose methods and start a comparison. */
import type { MethodInfo } from '../../../wasm/chebnet';
import type { ComparisonRequest, StartingPoint } from '../compare/run';
import type { ChebnetDocument } from '../document/document';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import { make, makeButton, makeSection, makeSelect } from '../elements/dom';
import type { Panel } from '../panels';
import './form.css';

/** Ticked at first: the paper's method, our own, and one of each other kind. */
const USUAL = ['li2022', 'projection', 'composite_majorization', 'local_global'];

const STARTS: { value: StartingPoint; text: string }[] = [
  { value: 'rest', text: panelWords.comparison.rest },
  { value: 'present', text: panelWords.comparison.present },
];

export class ComparisonForm implements Panel {
  readonly element: HTMLElement;
  readonly #methods = make('fieldset', { class: 'methods' });
  readonly #start: HTMLSelectElement;
  readonly #run: HTMLButtonElement;
  #proposed: readonly string[] | undefined;
  readonly #compare: (request: ComparisonRequest) => void;

  constructor(compare: (request: ComparisonRequest) => void) {
    this.#compare = compare;
    this.#run = makeButton(panelWords.comparison.compare, () => this.#submit());
    const start = makeSelect(panelWords.comparison.startFrom, STARTS, () => {});
    this.#start = start.select;
    this.#methods.addEventListener('change', () => this.#updateButton());
    this.element = makeSection(
      words.sections.compare,
      false,
      make('p', { class: 'quiet' }, panelWords.comparison.about),
      this.#methods,
      start.row,
      make('div', { class: 'buttons' }, this.#run),
    );
  }

  setTables({ methods }: Tables): void {
    const choice = (method: MethodInfo) =>
      make(
        'label',
        { title: panelWords.solver.aboutMethod(method) },
        make('input', { type: 'checkbox', value: method.name, checked: USUAL.includes(method.name) }),
        words.core.method(method.name),
      );
    this.#methods.replaceChildren(make('legend', {}, panelWords.comparison.methods), ...methods.map(choice));
    this.#updateButton();
  }

  /** Ticks the methods that a document proposes, once: what the user ticks after that stays. */
  setDocument({ compare: methods }: ChebnetDocument): void {
    if (methods === this.#proposed) return;
    this.#proposed = methods;
    if (methods === undefined || methods.length === 0) return;
    for (const box of this.#methods.querySelectorAll('input')) box.checked = methods.includes(box.value);
    this.#updateButton();
  }

  #submit(): void {
    this.#compare({ methods: this.#chosen(), start: this.#start.value as StartingPoint });
  }

  #chosen(): string[] {
    return [...this.#methods.querySelectorAll('input')].filter(({ checked }) => checked).map(({ value }) => value);
  }

  #updateButton(): void {
    this.#run.disabled = this.#chosen().length === 0;
  }
}

/** Method and initialisation, each chosen from the core's table, with what it does and where it comes from. */
import type { InitialisationInfo, MethodInfo } from '../../../wasm/chebnet';
import { words } from '../language/language';
import { panelWords } from '../language/panels';
import { make, makeSelect, setValue } from '../elements/dom';
import { NumberField } from '../elements/number_field';

/** The paper does so many iterations of an initialisation. */
const USUAL_COUNT = 5;

/** A list of names, and below it the sentence and the citation of the one chosen. */
class Choice<Info extends { name: string; citation: string }> {
  readonly row: HTMLElement;
  readonly about = make('p', { class: 'quiet' });
  readonly #select: HTMLSelectElement;
  readonly #sentence: (info: Info) => string;
  #table: Info[] = [];

  constructor(label: string, sentence: (info: Info) => string, changed: () => void) {
    const { row, select } = makeSelect(label, [], changed);
    [this.row, this.#select, this.#sentence] = [row, select, sentence];
  }

  get chosen(): Info | undefined {
    return this.#table.find(({ name }) => name === this.#select.value);
  }

  setTable(table: Info[]): void {
    this.#table = table;
    this.#select.replaceChildren(
      ...table.map((info) =>
        make('option', { value: info.name, title: this.#sentence(info) }, words.core.method(info.name)),
      ),
    );
  }

  setValue(name: string): void {
    setValue(this.#select, name);
    const info = this.#table.find((each) => each.name === name);
    if (info && this.about.dataset.name !== name) this.#describe(info);
  }

  #describe(info: Info): void {
    this.about.dataset.name = info.name;
    this.about.replaceChildren(this.#sentence(info), ' ', make('cite', {}, `${info.citation}.`));
  }
}

export class MethodChoice {
  readonly content: HTMLElement[];
  readonly #choice: Choice<MethodInfo>;

  constructor(changed: () => void) {
    this.#choice = new Choice(panelWords.solver.method, panelWords.solver.aboutMethod, changed);
    this.content = [this.#choice.row, this.#choice.about];
  }

  get value(): string {
    return this.chosen?.name ?? '';
  }

  get chosen(): MethodInfo | undefined {
    return this.#choice.chosen;
  }

  setTable(table: MethodInfo[]): void {
    this.#choice.setTable(table);
  }

  setValue(method: string): void {
    this.#choice.setValue(method);
  }
}

/** Its value is text as the core reads it, e.g. `arap:5`. */
export class InitialisationChoice {
  readonly content: HTMLElement[];
  readonly #choice: Choice<InitialisationInfo>;
  readonly #count = new NumberField({ step: 1, min: 1, max: 10000, value: USUAL_COUNT, required: true });
  readonly #countRow = make(
    'div',
    {},
    make('label', { class: 'row' }, make('span', {}, panelWords.solver.count), this.#count.input),
    this.#count.note,
  );

  constructor(changed: () => void) {
    this.#choice = new Choice(panelWords.solver.initialisation, panelWords.solver.aboutInitialisation, changed);
    this.#count.input.addEventListener('change', () => this.#count.value !== null && changed());
    this.content = [this.#choice.row, this.#countRow, this.#choice.about];
  }

  get value(): string {
    const { name = '', counted = false } = this.#choice.chosen ?? {};
    return counted ? `${name}:${this.#count.value ?? USUAL_COUNT}` : name;
  }

  setTable(table: InitialisationInfo[]): void {
    this.#choice.setTable(table);
  }

  setValue(initialisation: string): void {
    const [name = '', count] = initialisation.split(':');
    this.#choice.setValue(name);
    this.#countRow.hidden = count === undefined;
    if (count !== undefined) this.#count.set(count);
  }
}

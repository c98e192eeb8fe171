/** Whether handles are edited on both sides of a plane, and of which. */
import type { Symmetry } from '../document/document';
import { AXES } from '../handles/transform';
import { panelWords } from '../language/panels';
import { makeSelect, setValue } from '../elements/dom';

const OFF = 'off';

export class SymmetryChoice {
  readonly rows: HTMLElement[];
  readonly #axis: ReturnType<typeof makeSelect>;
  readonly #through: ReturnType<typeof makeSelect>;
  readonly #chosen: (symmetry: Symmetry | undefined) => void;

  constructor(chosen: (symmetry: Symmetry | undefined) => void) {
    this.#chosen = chosen;
    const axes = AXES.map((axis) => ({ value: axis, text: panelWords.symmetry.across(axis) }));
    this.#axis = makeSelect(panelWords.symmetry.label, [{ value: OFF, text: panelWords.symmetry.off }, ...axes], () =>
      this.#choose(),
    );
    this.#through = makeSelect(
      panelWords.symmetry.through,
      [
        { value: 'centre', text: panelWords.symmetry.centre },
        { value: 'origin', text: panelWords.symmetry.origin },
      ],
      () => this.#choose(),
    );
    this.rows = [this.#axis.row, this.#through.row];
    this.set(undefined);
  }

  set(symmetry: Symmetry | undefined): void {
    setValue(this.#axis.select, symmetry?.axis ?? OFF);
    setValue(this.#through.select, symmetry?.through ?? 'centre');
    this.#through.row.hidden = symmetry === undefined;
  }

  #choose(): void {
    const [axis, through] = [this.#axis.select.value, this.#through.select.value];
    this.#chosen(axis === OFF ? undefined : ({ axis, through } as Symmetry));
  }
}

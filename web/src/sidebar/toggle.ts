import { makeButton, makeIcon } from '../elements/dom';
import { panelWords } from '../language/panels';

/** A button with two icons that turns something of a row on and off. Its name says what a press does, and of which row: whether
 *  it is pressed would contradict the first. */
export class Toggle {
  readonly button: HTMLButtonElement;
  readonly #faces: [SVGSVGElement, SVGSVGElement];
  #on = false;
  #row = '';
  readonly #labels: [string, string];

  /** `labels`: what a press does while it is off, and while it is on. */
  constructor(off: string, on: string, labels: [string, string], turned: (on: boolean) => void) {
    this.#labels = labels;
    this.#faces = [makeIcon(off), makeIcon(on)];
    this.button = makeButton(this.#faces[0], () => turned(!this.#on), { class: 'plain tool' });
    this.#turn(false, '');
  }

  /** `row`: its title. */
  set(on: boolean, row: string): void {
    if (on === this.#on && row === this.#row) return;
    this.#turn(on, row);
  }

  #turn(on: boolean, row: string): void {
    [this.#on, this.#row] = [on, row];
    const label = this.#labels[Number(on)]!;
    this.button.replaceChildren(this.#faces[Number(on)]!);
    this.button.classList.toggle('on', on);
    this.button.setAttribute('aria-label', panelWords.handles.ofRow(label, row));
    this.button.title = label;
  }
}

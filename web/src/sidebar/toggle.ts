import { makeButton, makeIcon } from '../elements/dom';

/** A toggle button with two icons. */
export class Toggle {
  readonly button: HTMLButtonElement;
  readonly #faces: [SVGSVGElement, SVGSVGElement];
  #on = false;
  readonly #labels: [string, string];

  /** `labels`: what a press does while it is off, and while it is on. */
  constructor(off: string, on: string, labels: [string, string], turned: (on: boolean) => void) {
    this.#labels = labels;
    this.#faces = [makeIcon(off), makeIcon(on)];
    this.button = makeButton(this.#faces[0], () => turned(!this.#on), { class: 'plain tool' });
    this.#turn(false);
  }

  set(on: boolean): void {
    if (on === this.#on) return;
    this.#turn(on);
  }

  #turn(on: boolean): void {
    this.#on = on;
    this.button.replaceChildren(this.#faces[Number(on)]!);
    this.button.setAttribute('aria-pressed', String(on));
    this.button.setAttribute('aria-label', this.#labels[Number(on)]!);
    this.button.title = this.#labels[Number(on)]!;
  }
}

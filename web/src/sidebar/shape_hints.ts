/** What the shapes of the gallery and the parameters of the present one are, for a pointer that rests on them. */
import type { ChebnetDocument } from '../document/document';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import type { Panel } from '../panels';

const words = panelWords.shape;

export class ShapeHints implements Panel {
  #shapes: Tables['shapes'] = [];

  /** @param element the section of shapes, whose words come before these. */
  constructor(readonly element: HTMLElement) {}

  setTables({ shapes }: Tables): void {
    this.#shapes = shapes;
    for (const shape of shapes) this.#explain(`[data-shape=${shape.name}]`, words.about(shape));
  }

  setDocument({ net }: ChebnetDocument): void {
    const name = 'recipe' in net ? net.recipe.split(':')[0] : null;
    const shape = this.#shapes.find((each) => each.name === name);
    for (const parameter of shape?.parameters ?? [])
      this.#explain(`[data-parameter=${parameter.name}]`, words.aboutParameter(shape!.name, parameter));
  }

  #explain(control: string, sentence: string): void {
    this.element.querySelector(control)?.setAttribute('title', sentence);
  }
}

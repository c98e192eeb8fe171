/** What the shapes of the gallery and the parameters of the present one are, for a pointer that rests on them; below them, what is
 *  otherwise for the size of the net. */
import { MOST_VERTICES_AT_REST } from '../document/defaults';
import type { ChebnetDocument } from '../document/document';
import { isTooLargeToRest } from '../document/too_large_to_rest';
import { make, setText } from '../elements/dom';
import { count } from '../language/numbers';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';
import type { Panel } from '../panels';
import './shape_hints.css';

const words = panelWords.shape;

/** What parameters are measured in; others are numbers alone. */
const UNITS: Record<string, string> = { reach: '°', slope: '°', bend: '°' };

export class ShapeHints implements Panel {
  #shapes: Tables['shapes'] = [];
  readonly #ofSize = make('p', { class: 'quiet', role: 'status' });

  /** @param element the section of shapes, whose words come before these. */
  constructor(readonly element: HTMLElement) {
    element.querySelector('.parameters')!.after(this.#ofSize);
  }

  setTables({ shapes }: Tables): void {
    this.#shapes = shapes;
    for (const shape of shapes) this.#explain(`[data-shape=${shape.name}]`, words.about(shape));
  }

  setDocument(document: ChebnetDocument): void {
    const { net } = document;
    setText(this.#ofSize, isTooLargeToRest(document) ? words.keepsLengths(count(MOST_VERTICES_AT_REST)) : '');
    const name = 'recipe' in net ? net.recipe.split(':')[0] : null;
    const shape = this.#shapes.find((each) => each.name === name);
    for (const parameter of shape?.parameters ?? []) {
      const slider = `[data-parameter=${parameter.name}]`;
      this.#explain(slider, words.aboutParameter(shape!.name, parameter));
      this.element.querySelector(`${slider}+output`)?.setAttribute('data-unit', UNITS[parameter.name] ?? '');
    }
  }

  #explain(control: string, sentence: string): void {
    this.element.querySelector(control)?.setAttribute('title', sentence);
  }
}

/** Which net is open: a shape of the gallery with its parameters, or a file. */
import type { ShapeInfo } from '../../../wasm/chebnet';
import type { ChebnetDocument } from '../document/document';
import { make, makeButton, makeSection, setText } from '../elements/dom';
import { words } from '../language/language';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import { Gallery } from './gallery';
import { ShapeParameters } from './shape_parameters';

export class ShapePanel implements Panel {
  readonly element: HTMLElement;
  readonly #gallery: Gallery;
  readonly #parameters: ShapeParameters;
  readonly #fileName = make('p', { class: 'quiet', hidden: true });
  #shapes: ShapeInfo[] = [];

  constructor(events: PanelEvents) {
    const open = (recipe: string): Promise<void> => events.openRecipe(recipe);
    this.#gallery = new Gallery(open, () => events.pickFile());
    this.#parameters = new ShapeParameters(open);
    const equalize = makeButton(words.equalize.command, () => events.equalize(), { title: words.equalize.commandHint });
    const drape = makeButton(words.equalize.drape, () => events.drape(), { title: words.equalize.drapeHint });
    this.element = makeSection(
      words.sections.shape,
      true,
      this.#gallery.element,
      this.#fileName,
      this.#parameters.element,
      make('div', { class: 'buttons' }, equalize, drape),
    );
  }

  setTables(tables: Tables): void {
    this.#shapes = tables.shapes;
    this.#gallery.setTables(tables);
  }

  setDocument({ net }: ChebnetDocument): void {
    const recipe = 'recipe' in net ? net.recipe : null;
    this.#gallery.setCurrent(recipe?.split(':')[0] ?? null);
    this.#parameters.setRecipe(recipe, this.#shapes);
    this.#fileName.hidden = recipe !== null;
    setText(this.#fileName, 'name' in net ? net.name : '');
  }
}

/** Along which axes handles slide. */
import type { Axes } from '../../../wasm/chebnet';
import { axesToSlide, type ChebnetDocument, type HandleData, type UpAxis } from '../document/document';
import { make, makeSelect, setValue } from '../elements/dom';
import type { HandleTraits } from '../handles/commands';
import { panelWords } from '../language/panels';
import type { Tables } from '../net/tables';

const TEXT = panelWords.slides;
/** Of handles that hold all of their coordinates, and where those selected differ. */
const NOWHERE = '';
const MIXED = 'mixed';

/** What of the document the choice depends on. */
export interface Slipway {
  up: UpAxis;
  /** Whether the method lets handles slide. */
  slides: boolean;
}

export function slipwayOf({ view, method }: ChebnetDocument, methods: Tables['methods']): Slipway {
  return { up: view.upAxis ?? 'z', slides: methods.some(({ name, slides }) => slides && name === method) };
}

export class Sliding {
  readonly rows: HTMLElement[];
  readonly #select: HTMLSelectElement;
  readonly #elsewhere = make('p', { class: 'quiet', hidden: true }, TEXT.elsewhere);
  #up: UpAxis | null = null;

  constructor(change: (traits: HandleTraits) => void) {
    const { row, select } = makeSelect(TEXT.label, [], (value) =>
      change({ slides: value === NOWHERE ? undefined : (value as Axes) }),
    );
    row.title = TEXT.hint;
    this.#select = select;
    this.rows = [row, this.#elsewhere];
  }

  set(handles: readonly HandleData[], { up, slides }: Slipway): void {
    if (up !== this.#up) this.#fill(up);
    const [first, ...others] = new Set(handles.map((each) => each.slides ?? NOWHERE));
    setValue(this.#select, others.length > 0 ? MIXED : (first ?? NOWHERE));
    this.#elsewhere.hidden = slides || (others.length === 0 && first === NOWHERE);
  }

  #fill(up: UpAxis): void {
    this.#up = up;
    const [ground, ...others] = axesToSlide(up);
    const named = (axes: Axes): string => (axes.length === 1 ? TEXT.along(axes) : TEXT.inPlane([...axes].join(', ')));
    this.#select.replaceChildren(
      make('option', { value: NOWHERE }, TEXT.nowhere),
      make('option', { value: ground! }, TEXT.ground),
      ...others.map((axes) => make('option', { value: axes }, named(axes))),
      make('option', { value: MIXED, hidden: true, disabled: true }, '—'),
    );
  }
}

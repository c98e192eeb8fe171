/** What the net is like in itself: what its quads want to be, and where it has two families of net lines, warp against weft.
 *  Under the behaviour, for options of the method `equilibrium`. */
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument, SolverOptions } from '../document/document';
import type { ChangeName } from '../document/naming';
import { make, makeSelect, setValue } from '../elements/dom';
import { panelWords } from '../language/panels';
import { hasTwoFamilies } from '../net/families';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { OpenedNet } from '../worker/protocol';
import { makeSlider } from './slider';

const TEXT = panelWords.material;
/** Steps of the slider: each makes one family four times as stiff beside the other; in the middle they are alike. */
const [STEPS, STEP] = [6, 4];
const MIDDLE = STEPS / 2;

export class RodControls implements Panel {
  readonly #quads = makeSelect(
    TEXT.quads,
    (['atRest', 'square'] as const).map((value) => ({ value, text: TEXT.choices[value] })),
    (choice) => this.#set({ square_corners: choice === 'square' }),
  );
  readonly #balance = makeSlider(TEXT.balance, STEPS, balanceText, (step) => this.#chooseBalance(step));
  readonly element = make('div', {}, this.#quads.row, this.#balance.row);
  readonly #events: PanelEvents;
  #usual: SolverOptions = {};
  #document: ChebnetDocument | null = null;
  #net: OpenedNet | null = null;
  /** Of the net; null: not known yet. */
  #hasFamilies: boolean | null = null;

  constructor(events: PanelEvents) {
    this.#events = events;
    this.#balance.row.title = TEXT.balanceHint;
  }

  setTables({ options }: Tables): void {
    this.#usual = Object.fromEntries(
      options.map(({ name, kind, value }) => [name, kind === 'flag' ? value !== 0 : value]),
    );
  }

  setNet(net: OpenedNet): void {
    this.#net = net;
    this.#hasFamilies = null;
    if (this.#document !== null) this.setDocument(this.#document);
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    const isMaterial = document.method === METHOD_AT_REST;
    this.element.hidden = !isMaterial;
    if (!isMaterial || this.#net === null) return;
    this.#hasFamilies ??= hasTwoFamilies(this.#net);
    this.#balance.row.hidden = !this.#hasFamilies;
    const { square_corners, warp_stiffness, weft_stiffness } = { ...this.#usual, ...document.options };
    setValue(this.#quads.select, square_corners ? 'square' : 'atRest');
    const ratio = Number(warp_stiffness) / Number(weft_stiffness);
    this.#balance.set(Math.min(Math.max(Math.round(MIDDLE + Math.log(ratio) / Math.log(STEP)), 0), STEPS));
  }

  /** Both together stay as stiff. */
  #chooseBalance(step: number): void {
    const warp_stiffness = STEP ** ((step - MIDDLE) / 2);
    this.#set({ warp_stiffness, weft_stiffness: 1 / warp_stiffness }, ['balance', balanceText(step)]);
  }

  #set(change: SolverOptions, name?: ChangeName): void {
    if (this.#document === null) return;
    const { method, initialisation, options } = this.#document;
    this.#events.setBehaviour({ method, initialisation, options: { ...this.#usual, ...options, ...change } }, name);
  }
}

function balanceText(step: number): string {
  const times = STEP ** Math.abs(step - MIDDLE);
  return step < MIDDLE ? `1 : ${times}` : `${times} : 1`;
}

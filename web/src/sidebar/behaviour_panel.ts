/** How the net behaves: by its lengths alone, or as material at rest, stiff or soft, how narrow its corners may get, and how
 *  long its edges are. In terms of designers, for options of the solver. */
import { METHOD_AT_REST } from '../document/defaults';
import type { ChebnetDocument, HandleData, SolverOptions, UpAxis } from '../document/document';
import type { ChangeName } from '../document/naming';
import { make, makeSection, makeSelect, setText, setValue } from '../elements/dom';
import { words } from '../language/language';
import { lengthText, limitText } from '../language/numbers';
import { lazy } from '../lazy';
import type { Tables } from '../net/tables';
import type { Panel, PanelEvents } from '../panels';
import type { OpenedNet } from '../worker/protocol';
import type { GuideControls } from './guide_controls';
import { makeSlider } from './slider';

const WITHOUT_MATERIAL = 'projection';

/** Only ratios of bending, shear and weight matter. */
const MATERIALS = {
  shape: { straight_rods: false, bending_weight: 1, shear_weight: 0.05 },
  rods: { straight_rods: true, bending_weight: 1, shear_weight: 0.05 },
  cloth: { straight_rods: true, bending_weight: 0.01, shear_weight: 0.01 },
} as const;
type Material = keyof typeof MATERIALS;
const isMaterial = (name: string): name is Material => name in MATERIALS;

const guideControls = lazy(() => import('./guide_controls'));

/** Degrees in a step of the slider. */
const DEGREES = 5;
/** Steps for a factor of ten in weight, and number of steps. */
const TENFOLD = 3;
const HEAVIEST = 9;
/** Percent by which edges can be made shorter or longer by hand. */
const MOST_GROWTH = 25;

/** The weight of an edge that bends a square net of these many vertices, held at its border, by a few hundredths of its
 *  width: a beam of n edges sinks by about g n⁴ / 50 edge lengths. */
function lightest(vertices: number): number {
  return 1.5 * Math.max(vertices, 4) ** -1.5;
}

/** Of edges, at a step of their slider. */
function scaleOf(step: number): number {
  return (100 + step - MOST_GROWTH) / 100;
}

function weightText(step: number): string {
  return step === 0 ? words.behaviour.off : words.behaviour.times(step);
}

/** Whether the net can hang by a handle: not by one that slides up and down. */
function carries({ slides }: HandleData, up: UpAxis): boolean {
  return slides?.includes(up) !== true;
}

export class BehaviourPanel implements Panel {
  readonly element: HTMLElement;
  readonly #choice: ReturnType<typeof makeSelect>;
  readonly #about = make('p', { class: 'quiet' });
  readonly #limit = makeSlider(
    words.behaviour.limit,
    60 / DEGREES,
    (step) => limitText(DEGREES * step),
    (step) => this.#set(METHOD_AT_REST, { shear_limit: DEGREES * step }),
  );
  readonly #weight = makeSlider(words.behaviour.weight, HEAVIEST, weightText, (step) => this.#chooseWeight(step));
  readonly #length = makeSlider(
    words.behaviour.length,
    2 * MOST_GROWTH,
    (step) => lengthText(scaleOf(step)),
    (step) => this.#set(this.#document!.method, { length_scale: scaleOf(step) }),
  );
  readonly #unheld = make('p', { class: 'quiet', role: 'status' });
  readonly #guidePlace = make('div', { hidden: true });
  #guide: GuideControls | null = null;
  readonly #events: PanelEvents;
  readonly #failed: (error: unknown) => void;
  #usual: SolverOptions = {};
  #document: ChebnetDocument | null = null;
  #lightest = lightest(2000);

  constructor(events: PanelEvents, failed: (error: unknown) => void) {
    this.#events = events;
    this.#failed = failed;
    const texts = words.behaviour.choices;
    const choices = (['lengths', 'shape', 'rods', 'cloth', 'own'] as const).map((value) => ({
      value,
      text: texts[value],
    }));
    this.#choice = makeSelect(words.behaviour.choice, choices, (name) => this.#choose(name));
    this.#limit.row.title = words.behaviour.limitHint;
    this.#weight.row.title = words.behaviour.weightHint;
    this.element = makeSection(
      words.sections.behaviour,
      true,
      this.#choice.row,
      this.#about,
      this.#limit.row,
      this.#weight.row,
      this.#unheld,
      this.#length.row,
      this.#guidePlace,
    );
  }

  setTables({ options }: Tables): void {
    this.#usual = Object.fromEntries(
      options.map(({ name, kind, value }) => [name, kind === 'flag' ? value !== 0 : value]),
    );
  }

  setNet({ info }: OpenedNet): void {
    this.#lightest = lightest(info.vertices);
    if (this.#document !== null) this.setDocument(this.#document);
  }

  setDocument(document: ChebnetDocument): void {
    this.#document = document;
    const behaviour = this.#behaviour();
    setValue(this.#choice.select, behaviour);
    this.#choice.select.querySelector<HTMLOptionElement>('[value=own]')!.hidden = behaviour !== 'own';
    this.#about.textContent = words.behaviour.about[behaviour];
    const isMaterial = document.method === METHOD_AT_REST;
    for (const { row } of [this.#limit, this.#weight]) row.hidden = !isMaterial;
    this.#limit.set(Math.round(Number(this.#option('shear_limit')) / DEGREES));
    this.#weight.set(this.#weightStep());
    this.#setLength(Number(this.#option('length_scale') ?? 1));
    const up = this.#option('y_up') ? 'y' : 'z';
    const falls = isMaterial && this.#weightStep() > 0 && !document.handles.some((handle) => carries(handle, up));
    setText(this.#unheld, falls ? words.behaviour.unheld : '');
    this.#guidePlace.hidden = document.guide === undefined;
    if (document.guide) this.#setGuide().catch(this.#failed);
  }

  async #setGuide(): Promise<void> {
    const { GuideControls } = await guideControls();
    this.#guide ??= this.#createGuide(GuideControls);
    if (this.#document?.guide) this.#guide.set(this.#document, this.#usual, this.#document.method === METHOD_AT_REST);
  }

  #createGuide(Controls: typeof GuideControls): GuideControls {
    const guide = new Controls({
      setOptions: (change, name) => this.#set(METHOD_AT_REST, change, name),
      setHidden: (guideHidden) => this.#events.setView({ guideHidden }),
      putHandlesOn: () => this.#events.putHandlesOnGuide(),
      letGo: () => this.#events.letGoOfGuide(),
    });
    this.#guidePlace.append(guide.element);
    return guide;
  }

  #option(name: string): number | boolean | undefined {
    return this.#document?.options[name] ?? this.#usual[name];
  }

  #behaviour(): Material | 'lengths' | 'own' {
    if (this.#document?.method !== METHOD_AT_REST)
      return this.#document?.method === WITHOUT_MATERIAL ? 'lengths' : 'own';
    const fits = (material: Material) =>
      Object.entries(MATERIALS[material]).every(([name, value]) => this.#option(name) === value);
    return (['shape', 'rods', 'cloth'] as const).find(fits) ?? 'own';
  }

  #choose(name: string): void {
    const change: ChangeName = ['behaviour', { behaviour: name }];
    if (name === 'lengths') this.#set(WITHOUT_MATERIAL, {}, change);
    else if (isMaterial(name)) this.#set(METHOD_AT_REST, MATERIALS[name], change);
  }

  #chooseWeight(step: number): void {
    const gravity = step === 0 ? 0 : Number((this.#lightest * 10 ** ((step - 1) / TENFOLD)).toPrecision(3));
    this.#set(METHOD_AT_REST, { gravity }, ['weight', String(step)]);
  }

  /** "Let edges grow" finds what lies between the steps, or beyond them. */
  #setLength(scale: number): void {
    const step = Math.min(Math.max(Math.round(100 * (scale - 1)), -MOST_GROWTH), MOST_GROWTH) + MOST_GROWTH;
    this.#length.set(step, lengthText(scale));
  }

  #weightStep(): number {
    const gravity = Number(this.#option('gravity') ?? 0);
    if (gravity <= 0) return 0;
    return Math.min(Math.max(Math.round(1 + TENFOLD * Math.log10(gravity / this.#lightest)), 1), HEAVIEST);
  }

  /** `name`: what the history calls it, if it is more than the options. */
  #set(method: string, change: SolverOptions, name?: ChangeName): void {
    if (this.#document === null) return;
    const { initialisation, options } = this.#document;
    this.#events.setBehaviour({ method, initialisation, options: { ...this.#usual, ...options, ...change } }, name);
  }
}

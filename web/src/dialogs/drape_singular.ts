/** Which singular vertices a net over a whole surface is to have: those of the last net, pinned ones, and regions without
 *  any. What is changed holds for the next net. */
import type { Point, RemeshOptions, SurfacePlace } from '../../../wasm/chebnet';
import type { Ray, RemeshedNet, ShownSurface } from '../drape/drape_protocol';
import type { ForbiddenDisc, SingularDot, SingularMarks } from '../drape/singular_dots';
import { make, makeButton, makeSelect, makeSwitch, setText } from '../elements/dom';
import { setDisabled, setHidden } from '../elements/leave';
import { dialogWords } from '../language/dialogs';
import { sayInSight } from './say_in_sight';

const TEXT = dialogWords.drape.singularWishes;
/** Of edges at one that can be wished for. */
const VALENCES = [3, 5, 6] as const;
type Valence = (typeof VALENCES)[number];
const REGULAR = 4;
/** Of a region, in edges of the net. */
const RADII = [2, 3, 4, 6, 8, 12];
const USUAL_RADIUS = 3;
/** What becomes of a click on the surface. */
type Tool = 'none' | 'add' | 'forbid';

interface SingularEvents {
  shown(marks: SingularMarks): void;
  /** Whether clicks on the surface set points. */
  pointingChanged(pointing: boolean): void;
  /** Where that is on the surface, for a mark; null: for a new one. */
  placeWanted(at: Point | Ray, mark: number | null, revision: number): void;
  /** Of the next net, about. */
  edgeLength(): number;
  /** A mark has been chosen in the list, not in the picture: it may have to be turned to the eye. */
  faced(place: SurfacePlace): void;
}

interface State {
  dots: readonly SingularDot[];
  discs: readonly ForbiddenDisc[];
  only: boolean;
}

const NOTHING: State = { dots: [], discs: [], only: false };

export class DrapeSingular {
  readonly #events: SingularEvents;
  readonly #list = make('select', { 'aria-label': TEXT.list });
  readonly #add = makeButton(TEXT.add, () => this.#choose('add'), { 'aria-pressed': 'false' });
  readonly #forbid = makeButton(TEXT.forbid, () => this.#choose('forbid'), { 'aria-pressed': 'false' });
  readonly #remove = makeButton(TEXT.remove, () => this.remove(), { disabled: true });
  readonly #undo = makeButton(TEXT.undo, () => this.undo(), { disabled: true });
  readonly #valence = makeSelect(
    TEXT.valence,
    VALENCES.map((valence) => ({ value: String(valence), text: TEXT.edges(valence) })),
    () => this.#setValence(),
  );
  readonly #radius = makeSelect(
    TEXT.radius,
    RADII.map((radius) => ({ value: String(radius), text: TEXT.edgeLengths(radius) })),
    () => this.#setRadius(),
  );
  readonly #only = makeSwitch(TEXT.only, (only) => this.#setOnly(only));
  // In the page from the start: screen readers announce changes of what is there.
  readonly #words = make('p', { class: 'quiet', role: 'status' });
  readonly #balance = make('p', { class: 'refusal', role: 'status', hidden: true });
  readonly element = make(
    'div',
    { class: 'cuts wishes', role: 'group', 'aria-label': TEXT.title, hidden: true },
    make('h3', {}, TEXT.title),
    make('label', { class: 'row' }, make('span', {}, TEXT.list), this.#list),
    this.#add,
    this.#forbid,
    this.#remove,
    this.#undo,
    this.#valence.row,
    this.#radius.row,
    this.#only.row,
    this.#words,
    this.#balance,
  );
  #state = NOTHING;
  /** Of the marks' numbers: with another one, a number may mean another mark. */
  #revision = 0;
  #isBusy = false;
  /** What undo goes back to. */
  #before: State[] = [];
  #selected: number | null = null;
  #tool: Tool = 'none';
  /** What 4 − edges of all singular vertices adds up to; null: anything. */
  #sum: number | null = null;

  constructor(events: SingularEvents) {
    this.#events = events;
    this.#list.addEventListener('change', () => this.#chooseInList());
    this.#radius.select.value = String(USUAL_RADIUS);
    this.#say(TEXT.howTo);
  }

  /** What the next net is to have. */
  read(): Required<Pick<RemeshOptions, 'singular' | 'forbidden' | 'only'>> {
    const { dots, discs, only } = this.#state;
    return {
      singular: dots
        .filter(({ isPinned }) => isPinned)
        .map(({ place, valence }) => ({ point: place.position, valence: valence as Valence })),
      forbidden: discs.map(({ place, radius }) => ({ centre: place.position, radius })),
      only,
    };
  }

  show(shown: boolean): void {
    this.element.hidden = !shown;
    if (!shown) this.#setTool('none');
    this.#show();
  }

  /** The picture is for something else. */
  rest(): void {
    this.#setTool('none');
    this.choose(null);
  }

  /** Clicks on the surface set nothing any more; false: they have not. */
  abandon(): boolean {
    const wasPointing = this.#tool !== 'none';
    this.#setTool('none');
    return wasPointing;
  }

  /** A net is being made: what it is to have stays. */
  setBusy(busy: boolean): void {
    this.#isBusy = busy;
    this.element.toggleAttribute('inert', busy);
    if (busy) this.#setTool('none');
  }

  /** Of another surface. */
  reset({ report }: ShownSurface): void {
    const isOne = report.components === 1 && report.boundaryLoops === 0;
    this.#sum = isOne ? REGULAR * (2 - 2 * report.genus) : null;
    this.#before = [];
    this.#selected = null;
    this.#setTool('none');
    this.#put(NOTHING);
  }

  /** Pinned ones stay where they are wished for; the others are those that the net has besides. */
  setNet({ singular, kept }: RemeshedNet): void {
    const pinned = this.#state.dots.filter(({ isPinned }) => isPinned);
    const others = new Set(singular);
    pinned.forEach(({ place, valence }, i) => {
      if (!kept.vertices[i]) return;
      const alike = [...others].filter((each) => each.valence === valence);
      const nearest = alike.sort((a, b) => distance(a, place) - distance(b, place))[0];
      if (nearest) others.delete(nearest);
    });
    const free = [...others].map(({ position, normal, valence }) => ({
      place: { position, normal },
      valence,
      isPinned: false,
    }));
    this.#selected = null;
    this.#before = [];
    this.#put({ ...this.#state, dots: [...pinned, ...free] });
    this.#say(
      this.#state.dots.length === 0
        ? TEXT.needsNone
        : TEXT.kept(kept.vertices.filter((each) => !each).length, sum(kept.intruders), kept.others),
    );
  }

  choose(mark: number | null): void {
    this.#selected = mark;
    const dot = this.#dot(mark);
    if (dot && isWishable(dot.valence)) this.#valence.select.value = String(dot.valence);
    this.#show();
  }

  /** A mark is taken hold of. */
  begin(): void {
    if (!this.#isBusy) this.#remember();
  }

  /** It is let go of where it was before. */
  back(): void {
    if (this.#isBusy) return;
    const before = this.#before.pop();
    if (before) this.#put(before);
  }

  move(mark: number, at: Ray): void {
    if (!this.#isBusy) this.#events.placeWanted(at, mark, this.#revision);
  }

  point(at: Point | Ray): void {
    if (!this.#isBusy) this.#events.placeWanted(at, null, this.#revision);
  }

  setPlace(place: SurfacePlace, mark: number | null, revision: number): void {
    if (this.#isBusy) return;
    if (mark === null) this.#addAt(place);
    else if (revision === this.#revision) this.#moveTo(place, mark);
  }

  /** The one that is chosen. */
  remove(): void {
    const mark = this.#selected;
    if (mark === null || this.#isBusy) return;
    this.#remember();
    const { dots, discs, only } = this.#state;
    const dot = this.#dot(mark);
    this.#selected = null;
    if (!dot) return this.#put({ dots, only, discs: discs.filter((_, i) => i !== mark - dots.length) });
    const others = dots.filter((each) => each !== dot);
    const disc = { place: dot.place, radius: this.#wantedRadius() };
    this.#put({ dots: others, only, discs: dot.isPinned ? discs : [...discs, disc] });
    this.#say(only ? TEXT.taken : dot.isPinned ? TEXT.released : TEXT.removed);
  }

  undo(): void {
    if (this.#isBusy) return;
    const before = this.#before.pop();
    this.#selected = null;
    if (before) this.#put(before);
  }

  #dot(mark: number | null): SingularDot | undefined {
    return mark === null ? undefined : this.#state.dots[mark];
  }

  #wantedRadius(): number {
    return Number(this.#radius.select.value) * this.#events.edgeLength();
  }

  #addAt(place: SurfacePlace): void {
    if (this.#tool === 'none') return;
    this.#remember();
    const { dots, discs, only } = this.#state;
    if (this.#tool === 'add') {
      const dot = { place, valence: Number(this.#valence.select.value), isPinned: true };
      // The pinned ones first: so they keep their order when there is another net.
      const pinned = dots.filter(({ isPinned }) => isPinned);
      this.#selected = pinned.length;
      this.#put({ discs, only, dots: [...pinned, dot, ...dots.filter(({ isPinned }) => !isPinned)] });
      this.#say(TEXT.added);
    } else {
      this.#selected = dots.length + discs.length;
      this.#put({ dots, only, discs: [...discs, { place, radius: this.#wantedRadius() }] });
      this.#say(TEXT.forbidden);
    }
  }

  #moveTo(place: SurfacePlace, mark: number): void {
    const { dots, discs, only } = this.#state;
    if (mark >= dots.length)
      return this.#change({
        dots,
        only,
        discs: discs.map((disc, i) => (i === mark - dots.length ? { ...disc, place } : disc)),
      });
    this.#change({ discs, only, dots: dots.map((dot, i) => (i === mark ? pinned({ ...dot, place }) : dot)) });
    this.#say(TEXT.moved);
  }

  #setValence(): void {
    const mark = this.#selected;
    if (!this.#dot(mark)) return;
    this.#remember();
    const valence = Number(this.#valence.select.value);
    const dots = this.#state.dots.map((dot, i) => (i === mark ? { ...dot, valence, isPinned: true } : dot));
    this.#put({ ...this.#state, dots });
  }

  #setRadius(): void {
    const { dots, discs } = this.#state;
    if (this.#selected === null || this.#selected < dots.length) return;
    this.#remember();
    const mark = this.#selected - dots.length;
    const radius = this.#wantedRadius();
    this.#put({ ...this.#state, discs: discs.map((disc, i) => (i === mark ? { ...disc, radius } : disc)) });
  }

  /** If there are to be no others, those that are shown are the ones. */
  #setOnly(only: boolean): void {
    this.#remember();
    this.#put({ ...this.#state, only, dots: only ? this.#state.dots.map(pinned) : this.#state.dots });
  }

  #choose(tool: Tool): void {
    this.#setTool(this.#tool === tool ? 'none' : tool);
  }

  #setTool(tool: Tool): void {
    if (this.#tool === tool) return;
    this.#tool = tool;
    this.#add.setAttribute('aria-pressed', String(tool === 'add'));
    this.#forbid.setAttribute('aria-pressed', String(tool === 'forbid'));
    this.#show();
    this.#events.pointingChanged(tool !== 'none');
    if (tool === 'none') this.#say(TEXT.howTo);
    else sayInSight(this.#words, TEXT.click);
  }

  #chooseInList(): void {
    this.choose(this.#list.value === '' ? null : Number(this.#list.value));
    const mark = [...this.#state.dots, ...this.#state.discs][this.#selected ?? -1];
    if (mark) this.#events.faced(mark.place);
  }

  #remember(): void {
    this.#before.push(this.#state);
  }

  /** Other marks, or those of before. */
  #put(state: State): void {
    this.#revision += 1;
    this.#change(state);
  }

  /** The same marks, one of them at another place. */
  #change(state: State): void {
    this.#state = state;
    this.#show();
  }

  #show(): void {
    const { dots, discs, only } = this.#state;
    const names = [
      ...dots.map(({ valence, isPinned }, i) => TEXT.dot(i + 1, valence, isPinned)),
      ...discs.map((_, i) => TEXT.disc(i + 1)),
    ];
    const none = names.length === 0 ? TEXT.noneYet : TEXT.noneChosen;
    this.#list.replaceChildren(
      make('option', { value: '' }, none),
      ...names.map((name, i) => make('option', { value: i }, name)),
    );
    this.#list.value = this.#selected === null ? '' : String(this.#selected);
    setDisabled(this.#remove, this.#selected === null, this.#list);
    setDisabled(this.#undo, this.#before.length === 0, this.#list);
    const isDisc = this.#selected !== null && this.#selected >= dots.length;
    setHidden(this.#valence.row, this.#tool !== 'add' && (this.#selected === null || isDisc), this.#list);
    setHidden(this.#radius.row, this.#tool !== 'forbid' && !isDisc, this.#list);
    this.#only.box.checked = only;
    this.#showBalance();
    this.#events.shown(
      this.element.hidden ? { dots: [], discs: [], selected: null } : { ...this.#state, selected: this.#selected },
    );
  }

  /** What is missing to these alone. */
  #showBalance(): void {
    const { dots, only } = this.#state;
    const missing = (this.#sum ?? 0) - sum(dots.map(({ valence }) => REGULAR - valence));
    this.#balance.hidden = !only || this.#sum === null || missing === 0;
    setText(this.#balance, TEXT.missing(Math.abs(missing), missing > 0 ? 3 : 5));
  }

  #say(sentence: string): void {
    setText(this.#words, sentence);
  }
}

/** Where it stands, with a number of edges that can be wished for. */
function pinned(dot: SingularDot): SingularDot {
  const valence = isWishable(dot.valence) ? dot.valence : dot.valence < REGULAR ? 3 : 6;
  return { ...dot, valence, isPinned: true };
}

function isWishable(valence: number): valence is Valence {
  return VALENCES.some((each) => each === valence);
}

function distance({ position: [x, y, z] }: { position: Point }, place: SurfacePlace): number {
  const [a, b, c] = place.position;
  return Math.hypot(x - a, y - b, z - c);
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, each) => total + each, 0);
}

/** Pointer and keys in the picture of a surface: the sphere at the seed is dragged over the surface, the hollow one beside it around
 *  the seed, a mark to where it is wanted; while a line is drawn a click sets its next point. Arrow keys move the seed or the mark
 *  that is chosen. A drag elsewhere moves the camera. */
import type { Point } from '../../../wasm/chebnet';
import { ARROW_KEYS } from '../elements/keys';
import type { Place } from '../view/overlay';
import { HANDLE_SLACK, pointerKind, STILL } from '../view/picking';
import type { Ray, Seed } from './drape_protocol';
import { combined, dot } from './seed';
import type { SingularMarks } from './singular_dots';

export interface PictureEvents {
  /** The seed is wanted where a ray from the eye meets the surface. */
  seedMoved(ray: Ray): void;
  /** The first family is wanted along a direction. */
  turned(direction: Point): void;
  /** A drag was given up: back to where it began. */
  seedBack(seed: Seed): void;
  /** While a line is drawn: the next point, where a ray meets the surface, or the seed. */
  pointed(at: Ray | Point): void;
  cutEnded(): void;
  /** No more points, and no line through those that there are. */
  cutAbandoned(): void;
  cutUndone(): void;
  /** Its last point is wanted where a ray meets the surface: by keys, where there is no seed. */
  cutMoved(to: Ray): void;
  /** Of the marks one is chosen; null: none. */
  markChosen(mark: number | null): void;
  /** It begins to move. */
  markTaken(): void;
  /** It is wanted where a ray meets the surface. */
  markMoved(mark: number, at: Ray): void;
  /** The drag was given up: back to where it began. */
  markBack(): void;
  markRemoved(): void;
}

/** The part of the picture that gestures use. */
interface PictureContext {
  canvas: HTMLCanvasElement;
  events: PictureEvents;
  /** null: there is none. */
  seed(): Seed | null;
  /** The last point of the curve that is being drawn. */
  curveEnd(): Point | undefined;
  marks(): SingularMarks;
  /** The mark at a place of the canvas, or within so many pixels of it. */
  markAt(at: Place, slack: number): number | null;
  /** Likewise: what is dragged of the seed. */
  markerAt(at: Place, slack: number): 'seed' | 'knob' | null;
  /** Where a point of the surface is seen. */
  placeOf(position: Point): Place;
  rayThrough(place: Place): Ray;
  middle(): Place;
}

/** What is in hand, and by which pointer. */
interface Grip {
  pointer: number;
  /** To where a ray goes, through a place of the canvas. */
  moved(to: Ray, place: Place): void;
  /** It was given up. */
  back(): void;
}

/** Of one arrow key, in pixels; keys within so many milliseconds of each other make one way. */
const STEP = { small: 6, big: 30, together: 1000 };

export class PictureGestures {
  #grip: Grip | null = null;
  /** Where a pointer went down that may be a click. */
  #pressed: Place | null = null;
  #isCutting = false;
  /** Where arrow keys have led what they move, which is drawn there later. */
  #aim: { mark: number | null; at: Place; time: number } | null = null;
  /** The button whose key began what is being drawn. */
  #keysFrom: HTMLButtonElement | null = null;
  readonly #listeners = new AbortController();
  readonly #context: PictureContext;

  constructor(context: PictureContext) {
    this.#context = context;
    const { canvas } = context;
    const { signal } = this.#listeners;
    // In the capture phase of the parent: before the listeners of the camera.
    const above = canvas.parentElement!;
    above.addEventListener('pointerdown', (event) => this.#down(event), { signal, capture: true });
    above.addEventListener('pointermove', (event) => this.#move(event), { signal, capture: true });
    above.addEventListener('pointerup', (event) => this.#letGo(event), { signal, capture: true });
    above.addEventListener('pointercancel', (event) => this.#lose(event), { signal, capture: true });
    canvas.addEventListener('keydown', (event) => this.#key(event), { signal });
    window.addEventListener('keydown', (event) => this.#escape(event), { signal, capture: true });
  }

  /** See Picture. */
  setCutting(cutting: boolean): void {
    this.#isCutting = cutting;
    this.#context.canvas.style.cursor = cutting ? 'crosshair' : '';
    if (cutting) return this.#takeKeys();
    this.#pressed = null;
    this.#giveKeysBack();
  }

  /** The next arrow key begins a way of its own. */
  endWay(): void {
    this.#aim = null;
  }

  dispose(): void {
    this.#listeners.abort();
  }

  #down(event: PointerEvent): void {
    this.#aim = null;
    if (this.#grip !== null) return event.stopPropagation();
    // A second finger turns or enlarges, also if the first one has stood still.
    if (!event.isPrimary) this.#pressed = null;
    if (event.button !== 0 || !event.isPrimary) return;
    this.#pressed = this.#isCutting ? this.#place(event) : null;
    this.#grip = this.#gripOfMark(event) ?? this.#gripOfSeed(event);
    if (this.#grip === null) return;
    this.#pressed = null;
    event.stopPropagation();
    const { canvas } = this.#context;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    canvas.style.cursor = 'grabbing';
  }

  #gripOfSeed(event: PointerEvent): Grip | null {
    const { events } = this.#context;
    const marker = this.#markerAt(event);
    const before = this.#context.seed();
    if (marker === null || before === null) return null;
    return {
      pointer: event.pointerId,
      moved: (ray) => {
        const seed = this.#context.seed();
        if (marker === 'seed') events.seedMoved(ray);
        else if (seed !== null) this.#turnTo(ray, seed);
      },
      back: () => events.seedBack(before),
    };
  }

  /** A mark that is only pressed is chosen, and stays where it is. */
  #gripOfMark(event: PointerEvent): Grip | null {
    const { events } = this.#context;
    const start = this.#place(event);
    const mark = this.#markAt(event);
    const still = STILL[pointerKind(event)];
    if (mark === null) return null;
    events.markChosen(mark);
    let hasMoved = false;
    return {
      pointer: event.pointerId,
      moved: (ray, { x, y }) => {
        if (!hasMoved && Math.hypot(x - start.x, y - start.y) <= still) return;
        if (!hasMoved) events.markTaken();
        hasMoved = true;
        events.markMoved(mark, ray);
      },
      back: () => {
        if (hasMoved) events.markBack();
      },
    };
  }

  #move(event: PointerEvent): void {
    if (this.#grip === null) {
      if (event.buttons === 0) this.#hover(event);
      return;
    }
    event.stopPropagation();
    if (event.pointerId !== this.#grip.pointer) return;
    const place = this.#place(event);
    this.#grip.moved(this.#context.rayThrough(place), place);
  }

  /** Along the line from the seed to where the ray meets the plane that touches the surface there. */
  #turnTo({ origin, direction }: Ray, { position, normal }: Seed): void {
    const towards = combined(1, origin, -1, position);
    const slope = dot(direction, normal);
    if (Math.abs(slope) < 1e-3 * Math.hypot(...direction)) return;
    const arm = combined(1, towards, -dot(towards, normal) / slope, direction);
    if (Math.hypot(...arm) > 0) this.#context.events.turned(arm);
  }

  #letGo(event: PointerEvent): void {
    this.#click(event);
    if (event.pointerId !== this.#grip?.pointer) return;
    event.stopPropagation();
    this.#grip = null;
    this.#context.canvas.style.cursor = '';
  }

  /** The system uses the pointer for a gesture of its own. */
  #lose(event: PointerEvent): void {
    const grip = this.#grip;
    this.#letGo(event);
    if (event.pointerId === grip?.pointer) grip.back();
  }

  /** Sets a point of a cut, unless the camera has been moved. */
  #click(event: PointerEvent): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    if (pressed === null || event.type !== 'pointerup' || !event.isPrimary) return;
    const place = this.#place(event);
    if (Math.hypot(place.x - pressed.x, place.y - pressed.y) > STILL[pointerKind(event)]) return;
    this.#context.canvas.focus();
    this.#context.events.pointed(this.#context.rayThrough(place));
  }

  #hover(event: PointerEvent): void {
    const idle = this.#isCutting ? 'crosshair' : '';
    const isFree = this.#markerAt(event) === null && this.#markAt(event) === null;
    this.#context.canvas.style.cursor = isFree ? idle : 'grab';
  }

  /** Keys of a cut; whether this was one. */
  #cutKey(event: KeyboardEvent): boolean {
    if (!this.#isCutting) return false;
    const { events } = this.#context;
    const seed = this.#context.seed();
    const last = seed?.position ?? this.#context.curveEnd();
    const arrow = seed === null ? ARROW_KEYS[event.key] : undefined;
    if (event.key === ' ') events.pointed(last ?? this.#context.rayThrough(this.#context.middle()));
    else if (arrow && last) events.cutMoved(this.#beside(null, last, arrow, event));
    else if (event.key === 'Enter') events.cutEnded();
    else if (event.key === 'Backspace') events.cutUndone();
    else return false;
    event.preventDefault();
    return true;
  }

  /** Not from a list, whose arrow keys may be going on. */
  #takeKeys(): void {
    const button = document.activeElement;
    if (!button?.matches('button:focus-visible')) return;
    this.#keysFrom = button as HTMLButtonElement;
    this.#context.canvas.focus();
  }

  /** Unless they are elsewhere by now. */
  #giveKeysBack(): void {
    if (document.activeElement === this.#context.canvas) this.#keysFrom?.focus();
    this.#keysFrom = null;
  }

  #key(event: KeyboardEvent): void {
    if (this.#markKey(event) || this.#cutKey(event)) return;
    const arrow = ARROW_KEYS[event.key];
    const seed = this.#context.seed();
    if (!arrow || seed === null) return;
    event.preventDefault();
    this.#context.events.seedMoved(this.#beside(null, seed.position, arrow, event));
  }

  /** Keys of the mark that is chosen; whether this was one. */
  #markKey(event: KeyboardEvent): boolean {
    const { events } = this.#context;
    const { dots, discs, selected } = this.#context.marks();
    const mark = selected === null ? undefined : [...dots, ...discs][selected];
    if (selected === null || !mark) return false;
    const arrow = ARROW_KEYS[event.key];
    if (event.key === 'Delete' || event.key === 'Backspace') events.markRemoved();
    else if (arrow) {
      if (!this.#goesOn(selected, event)) events.markTaken();
      events.markMoved(selected, this.#beside(selected, mark.place.position, arrow, event));
    } else return false;
    event.preventDefault();
    return true;
  }

  /** A step of an arrow key away: from where the key before led, if it was pressed just now, for the mark may not be there yet. */
  #beside(mark: number | null, position: Point, arrow: readonly [number, number], event: KeyboardEvent): Ray {
    const step = event.shiftKey ? STEP.big : STEP.small;
    const { x, y } = this.#goesOn(mark, event)?.at ?? this.#context.placeOf(position);
    const at = { x: x + step * arrow[0], y: y + step * arrow[1] };
    this.#aim = { mark, at, time: event.timeStamp };
    return this.#context.rayThrough(at);
  }

  /** Where the key before led, if this one leads the same mark on; null: it begins a way of its own. */
  #goesOn(mark: number | null, { timeStamp }: KeyboardEvent): { at: Place } | null {
    const before = this.#aim;
    return before !== null && before.mark === mark && timeStamp - before.time < STEP.together ? before : null;
  }

  /** Wherever the focus is; browsers do not always ask before they close a dialog. */
  #escape(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || (this.#grip === null && !this.#isCutting)) return;
    event.preventDefault();
    event.stopPropagation();
    if (this.#grip === null) return this.#context.events.cutAbandoned();
    const { back } = this.#grip;
    this.#grip = null;
    back();
  }

  #markAt(event: PointerEvent): number | null {
    return this.#context.markAt(this.#place(event), HANDLE_SLACK[pointerKind(event)]);
  }

  #markerAt(event: PointerEvent): 'seed' | 'knob' | null {
    return this.#context.markerAt(this.#place(event), HANDLE_SLACK[pointerKind(event)]);
  }

  #place(event: PointerEvent): Place {
    const { left, top } = this.#context.canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }
}

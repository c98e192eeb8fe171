/** Draws lines over the picture with mouse, finger, pen or keys, instead of moving handles and camera. Two fingers, the other
 *  buttons and the wheel move the camera as before; arrow keys move a point, which Space or Enter sets down and lifts. Esc
 *  gives a stroke up, and without one puts the pen away. Loaded when it is first taken. */
import { makeSvg } from '../elements/dom';
import { ARROW_KEYS } from '../elements/keys';
import type { Place } from './overlay';
import type { Stroke } from './stroke';
import type { PenEvents } from './view';
import './pen.css';

/** Pixels that an arrow key moves the point, big with Shift. */
const STEP = { small: 6, big: 30 };

export class Pen {
  readonly #ink = makeSvg('path', { class: 'ink' });
  readonly #point = makeSvg('path', { class: 'point', d: 'M-9 0H9M0-9V9', visibility: 'hidden' });
  readonly #sheet = makeSvg(
    'svg',
    { class: 'overlay pen', role: 'application', tabindex: '0' },
    this.#ink,
    this.#point,
  );
  readonly #listeners = new AbortController();
  readonly #canvas: HTMLCanvasElement;
  readonly #begin: (at: Place) => Stroke | null;
  readonly #events: PenEvents;
  #stroke: Stroke | null = null;
  /** What began it; null: a key, or there is none. */
  #press: PointerEvent | null = null;
  /** Of the keys; null: none has been pressed yet. */
  #at: Place | null = null;

  /** @param canvas gets the gestures of the camera. @param begin a stroke; null: there is no net. */
  constructor(canvas: HTMLCanvasElement, begin: (at: Place) => Stroke | null, events: PenEvents) {
    this.#canvas = canvas;
    this.#begin = begin;
    this.#events = events;
    const { signal } = this.#listeners;
    this.#sheet.addEventListener('pointerdown', (event) => this.#down(event), { signal });
    this.#sheet.addEventListener('pointermove', (event) => this.#move(event), { signal });
    this.#sheet.addEventListener('pointerup', (event) => this.#up(event), { signal });
    this.#sheet.addEventListener('pointercancel', () => this.#giveUp(), { signal });
    this.#sheet.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    this.#sheet.addEventListener('wheel', (event) => this.#wheel(event), { signal, passive: false });
    this.#sheet.addEventListener('keydown', (event) => this.#drawByKey(event), { signal });
    window.addEventListener('keydown', (event) => this.#escape(event), { signal, capture: true });
    this.#sheet.setAttribute('aria-label', events.label);
    canvas.after(this.#sheet);
  }

  /** Its keys have a point from the start, if a key led here. */
  focus(): void {
    this.#sheet.focus();
    if (this.#sheet.matches(':focus-visible')) this.#at = this.#middle();
    this.#show();
  }

  putAway(): void {
    this.#listeners.abort();
    this.#sheet.remove();
    this.#events.putAway();
  }

  #down(event: PointerEvent): void {
    event.preventDefault();
    if (this.#press !== null) return this.#leaveToCamera(this.#press, event);
    if (event.button !== 0) return this.#leaveToCamera(event);
    if (!event.isPrimary) return;
    this.#at = null;
    this.#press = event;
    this.#sheet.setPointerCapture(event.pointerId);
    this.#stroke = this.#begin(this.#place(event));
  }

  /** By all samples since the last event, where the browser has them: a quick hand is drawn as round as it went. */
  #move(event: PointerEvent): void {
    if (event.pointerId !== this.#press?.pointerId) return;
    const samples = event.getCoalescedEvents?.() ?? [];
    for (const sample of samples.length > 0 ? samples : [event]) this.#stroke?.extend(this.#place(sample));
    this.#show();
  }

  #up(event: PointerEvent): void {
    if (event.pointerId === this.#press?.pointerId) this.#end();
  }

  #end(): void {
    const stroke = this.#stroke;
    this.#giveUp();
    if (stroke !== null) this.#events.drawn(stroke.pieces);
  }

  #giveUp(): void {
    this.#press = this.#stroke = null;
    this.#show();
  }

  /** From now on the canvas has these pointers. */
  #leaveToCamera(...events: readonly PointerEvent[]): void {
    this.#giveUp();
    for (const event of events) {
      this.#canvas.dispatchEvent(new PointerEvent(event.type, event));
      this.#canvas.setPointerCapture(event.pointerId);
    }
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    if (this.#press === null) this.#giveUp();
    this.#canvas.dispatchEvent(new WheelEvent(event.type, event));
  }

  #drawByKey(event: KeyboardEvent): void {
    const arrow = ARROW_KEYS[event.key];
    const isOwn = arrow || event.key === ' ' || event.key === 'Enter';
    if (event.ctrlKey || event.metaKey || event.altKey || event.key === 'Tab') return;
    // The view stays as it is while a line is drawn.
    if (isOwn || this.#stroke !== null) event.stopPropagation();
    if (!isOwn) return;
    event.preventDefault();
    if (this.#press !== null || (event.repeat && !arrow)) return;
    this.#at ??= this.#middle();
    if (arrow) this.#stepTo(this.#at, arrow, event.shiftKey ? STEP.big : STEP.small);
    else if (this.#stroke === null) this.#stroke = this.#begin(this.#at);
    else this.#end();
    this.#show();
  }

  #middle(): Place {
    return { x: this.#canvas.clientWidth / 2, y: this.#canvas.clientHeight / 2 };
  }

  /** Not out of the picture. */
  #stepTo({ x, y }: Place, [right, down]: readonly [number, number], step: number): void {
    const within = (value: number, most: number) => Math.min(most, Math.max(0, value));
    const { clientWidth, clientHeight } = this.#canvas;
    this.#at = { x: within(x + step * right, clientWidth), y: within(y + step * down, clientHeight) };
    this.#stroke?.extend(this.#at);
  }

  #escape(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || document.querySelector('dialog:modal') !== null) return;
    event.stopPropagation();
    event.preventDefault();
    if (this.#stroke === null) this.putAway();
    else this.#giveUp();
  }

  #show(): void {
    const places = this.#stroke?.places ?? [];
    const path = places.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L');
    this.#ink.setAttribute('d', path && `M${path}`);
    this.#point.setAttribute('visibility', this.#at ? 'visible' : 'hidden');
    if (this.#at) this.#point.setAttribute('transform', `translate(${this.#at.x} ${this.#at.y})`);
  }

  #place({ clientX, clientY }: PointerEvent): Place {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }
}

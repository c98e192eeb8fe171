/** Draws lines over the picture with mouse, finger or pen, instead of moving handles and camera. Two fingers, the other
 *  buttons and the wheel move the camera as before; Esc gives a stroke up, and without one puts the pen away. Loaded when it
 *  is first taken. */
import { makeSvg } from '../elements/dom';
import type { Place } from './overlay';
import type { Stroke } from './stroke';
import type { PenEvents } from './view';
import './pen.css';

export class Pen {
  readonly #ink = makeSvg('path', { class: 'ink' });
  readonly #sheet = makeSvg('svg', { class: 'overlay pen', 'aria-hidden': 'true' }, this.#ink);
  readonly #listeners = new AbortController();
  readonly #canvas: HTMLCanvasElement;
  readonly #begin: (at: Place) => Stroke | null;
  readonly #events: PenEvents;
  #stroke: Stroke | null = null;
  /** What began it. */
  #press: PointerEvent | null = null;

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
    window.addEventListener('keydown', (event) => this.#key(event), { signal, capture: true });
    canvas.after(this.#sheet);
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
    if (event.pointerId !== this.#press?.pointerId) return;
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
    this.#canvas.dispatchEvent(new WheelEvent(event.type, event));
  }

  #key(event: KeyboardEvent): void {
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
  }

  #place({ clientX, clientY }: PointerEvent): Place {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }
}

/** Annotations over the view: the hovered vertex, the handle to begin with, pairs of handles out of reach. */
import type { Vector2, Vector3 } from 'three';
import { words } from '../language/language';
import { apart } from '../language/numbers';
import type { FrameData } from '../worker/protocol';
import type { Found } from './gestures';
import type { HandleMarkers } from './handles';
import { Overlay, type Place, type Strain } from './overlay';

/** Margin of labels to the edges of the canvas, in pixels. */
const LABEL_ROOM = { side: 140, top: 120, bottom: 120 };
/** Most unreachable pairs drawn, the worst first. */
const SHOWN_STRAINS = 3;

/** Positions in scene and canvas. */
export interface Picture {
  readonly size: Vector2;
  readonly markers: HandleMarkers;
  /** A vertex of the net in the scene. */
  vertexPoint(vertex: number): Vector3;
  /** A point of the scene on the canvas. */
  place(point: Vector3): Place;
}

/** What is annotated. */
interface Annotated {
  /** The hovered vertex. */
  found: Found | null;
  /** Whether the handle to begin with is pointed out. */
  isFirstVisit: boolean;
  /** The handle that leads a drag. */
  dragged: number | undefined;
  /** Vertices that a button would select. */
  preview: readonly number[];
  /** The corners of cells that are not as they should be. */
  marks: readonly (readonly number[])[];
  /** What is said beside the handle that leads a drag. */
  readout: string;
  unreachable: FrameData['unreachable'];
}

export class Annotations {
  readonly overlay = new Overlay();
  readonly #picture: Picture;

  constructor(picture: Picture) {
    this.#picture = picture;
  }

  draw({ found, isFirstVisit, dragged, preview, marks, readout, unreachable }: Annotated): void {
    const { markers } = this.#picture;
    const radius = markers.screenRadius;
    this.#drawHover(found, radius);
    const suggested = isFirstVisit ? markers.suggested : null;
    const begin = suggested === null ? undefined : markers.point(suggested);
    this.overlay.setPulse(begin ? this.#picture.place(begin) : null, radius + 3);
    this.overlay.setTether(this.#tether(dragged, radius));
    this.overlay.setPreview(preview.map((vertex) => this.#vertexPlace(vertex)));
    this.overlay.setMarks(marks.map((cell) => cell.map((vertex) => this.#vertexPlace(vertex))));
    this.overlay.setReadout(readout, this.#above(dragged, radius));
    this.overlay.setStrains(this.#strains(unreachable));
  }

  #drawHover(found: Found | null, radius: number): void {
    if (!found) return this.overlay.setHover(null, 0, false);
    const { vertex, handle } = found;
    const point = (handle && this.#picture.markers.point(vertex)) || this.#picture.vertexPoint(vertex);
    this.overlay.setHover(this.#picture.place(point), handle ? radius + 4 : 8, !handle);
  }

  #tether(vertex: number | undefined, radius: number): { from: Place; to: Place } | null {
    const point = vertex === undefined ? undefined : this.#picture.markers.point(vertex);
    if (vertex === undefined || !point) return null;
    const from = this.#vertexPlace(vertex);
    const to = this.#picture.place(point);
    return Math.hypot(to.x - from.x, to.y - from.y) > 2 * radius ? { from, to } : null;
  }

  /** Beside a handle, where a hand or the arrows do not cover it. */
  #above(vertex: number | undefined, radius: number): Place | null {
    const point = vertex === undefined ? undefined : this.#picture.markers.point(vertex);
    if (!point) return null;
    const place = this.#picture.place(point);
    return this.#between(place, { x: place.x, y: place.y - 6 * radius });
  }

  #strains(unreachable: FrameData['unreachable']): Strain[] {
    const { markers } = this.#picture;
    // What follows the hand goes as far as it gets, and strains at nothing.
    const held = unreachable.filter(({ vertexA, vertexB }) => !markers.isLed(vertexA) && !markers.isLed(vertexB));
    return held.slice(0, SHOWN_STRAINS).flatMap(({ vertexA, vertexB, distance, reach }, i) => {
      const [a, b] = [markers.point(vertexA), markers.point(vertexB)];
      if (!a || !b) return [];
      const [from, to] = [this.#picture.place(a), this.#picture.place(b)];
      const text = words.view.strain(...apart(distance, reach));
      return [{ from, to, label: i === 0 ? { text, at: this.#between(from, to) } : null }];
    });
  }

  /** The middle of two places, kept on the canvas so that a label there can be read. */
  #between(a: Place, b: Place): Place {
    const { top, bottom, side } = LABEL_ROOM;
    const { size } = this.#picture;
    const clamp = (x: number, low: number, high: number) => Math.max(low, Math.min(high, x));
    return {
      x: clamp((a.x + b.x) / 2, side, size.x - side),
      y: clamp((a.y + b.y) / 2 - 8, top, size.y - bottom),
    };
  }

  #vertexPlace(vertex: number): Place {
    return this.#picture.place(this.#picture.vertexPoint(vertex));
  }
}

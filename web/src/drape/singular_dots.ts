/** Singular vertices on a surface as discs with the number of their edges, and the regions that are to have none as rings. */
import type { Point, SurfacePlace } from '../../../wasm/chebnet';
import { makeSvg } from '../elements/dom';
import type { Place } from '../view/overlay';
import { combined, cross, dot, reference } from './seed';

export interface SingularDot {
  place: SurfacePlace;
  valence: number;
  /** The visitor has put it there; otherwise the last net has it. */
  isPinned: boolean;
}

export interface ForbiddenDisc {
  place: SurfacePlace;
  /** In the surface's unit. */
  radius: number;
}

/** All of them; a mark is one, by its number: dots come first. */
export interface SingularMarks {
  dots: readonly SingularDot[];
  discs: readonly ForbiddenDisc[];
  /** null: none. */
  selected: number | null;
}

const NO_MARKS: SingularMarks = { dots: [], discs: [], selected: null };

const RADIUS = 9;
const HALO = 13;
const CORNERS = 40;

export class SingularDots {
  readonly element = makeSvg('svg', { class: 'overlay singular', 'aria-hidden': 'true' });
  #marks = NO_MARKS;
  #groups: SVGGElement[] = [];
  /** On the canvas, as they have been drawn; null: turned away. */
  #places: (Place | null)[] = [];

  get marks(): SingularMarks {
    return this.#marks;
  }

  set(marks: SingularMarks): void {
    this.#marks = marks;
    const dots = marks.dots.map(({ valence, isPinned }, i) => {
      const attributes = { class: 'dot', 'data-valence': String(valence), 'data-pinned': String(isPinned) };
      const circle = makeSvg('circle', { r: String(RADIUS) });
      const number = makeSvg('text', {}, new Text(String(valence)));
      return makeSvg('g', attributes, ...halo(marks.selected === i), circle, number);
    });
    const discs = marks.discs.map((_, i) => {
      const isSelected = marks.selected === marks.dots.length + i;
      const cross = makeSvg('path', { class: 'cross', d: 'M-4-4L4 4M-4 4L4-4' });
      return makeSvg('g', { class: 'disc' }, makeSvg('path', { class: 'rim' }), ...halo(isSelected), cross);
    });
    this.#groups = [...dots, ...discs];
    // Dots above discs.
    this.element.replaceChildren(...discs, ...dots);
  }

  /** @param at where a point of the surface is on the canvas. @param eye in the surface's coordinates. */
  draw(at: (point: Point) => Place, eye: Point): void {
    const { dots, discs } = this.#marks;
    this.#places = [...dots, ...discs].map(({ place: { position, normal } }, i) => {
      const isSeen = dot(combined(1, eye, -1, position), normal) > 0;
      const { x, y } = at(position);
      const group = this.#groups[i]!;
      group.classList.toggle('behind', !isSeen);
      const disc = discs[i - dots.length];
      if (disc) drawDisc(group, disc, at);
      const shift = `translate(${x.toFixed(1)} ${y.toFixed(1)})`;
      for (const part of group.querySelectorAll(':scope > :not(.rim)')) part.setAttribute('transform', shift);
      return isSeen ? { x, y } : null;
    });
  }

  /** The mark under a point of the canvas; null: none. */
  at({ x, y }: Place, slack: number): number | null {
    let best: number | null = null;
    let least = RADIUS + slack;
    this.#places.forEach((place, i) => {
      const distance = place === null ? Infinity : Math.hypot(place.x - x, place.y - y);
      if (distance < least) [best, least] = [i, distance];
    });
    return best;
  }
}

function halo(isSelected: boolean): SVGElement[] {
  return isSelected ? [makeSvg('circle', { class: 'halo', r: String(HALO) })] : [];
}

/** In the plane that touches the surface. */
function drawDisc(group: SVGElement, { place: { position, normal }, radius }: ForbiddenDisc, at: (p: Point) => Place) {
  const along = reference(normal);
  const across = cross(normal, along);
  const corners = Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS;
    const arm = combined(radius * Math.cos(angle), along, radius * Math.sin(angle), across);
    const { x, y } = at(combined(1, position, 1, arm));
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  });
  group.querySelector('.rim')!.setAttribute('d', `M${corners.join('L')}Z`);
}

/** The ring around a seed, in the plane that touches the surface there, and the line to the knob that turns it. */
import { makeSvg } from '../elements/dom';
import type { Place } from '../view/overlay';

const CORNERS = 48;

export class SeedRing {
  readonly #circle = makeSvg('path', { class: 'seed-ring' });
  readonly element = makeSvg('svg', { class: 'overlay', 'aria-hidden': 'true' }, this.#circle);

  /** @param at the place on the canvas at an angle from the direction of the first family. */
  draw(at: (angle: number) => Place): void {
    const text = (angle: number): string => {
      const { x, y } = at(angle);
      return `${x.toFixed(1)} ${y.toFixed(1)}`;
    };
    const corners = Array.from({ length: CORNERS }, (_, i) => text((2 * Math.PI * i) / CORNERS));
    const lines = [0, Math.PI / 2].map((angle) => `M${text(angle)}L${text(angle + Math.PI)}`);
    this.#circle.setAttribute('d', `M${corners.join('L')}Z${lines.join('')}`);
  }

  hide(): void {
    this.#circle.setAttribute('d', '');
  }
}

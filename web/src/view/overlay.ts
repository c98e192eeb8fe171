/** Annotations drawn over the view as SVG: crisp at any size, animated by the style sheet, without cost for the graphics
 *  card. Places are CSS pixels on the canvas. */

export type Place = { x: number; y: number };

export interface Strain {
  from: Place;
  to: Place;
  /** null: only the line. */
  label: { text: string; at: Place } | null;
}

const SVG = 'http://www.w3.org/2000/svg';

export class Overlay {
  readonly element = make('svg', 'overlay');
  readonly #strains = make('g', 'strains');
  readonly #tether = make('line', 'tether');
  readonly #hover = make('g', 'hover');
  readonly #ring = make('circle', 'ring');
  readonly #pulse = make('circle', 'pulse');
  readonly #outline = make('path', 'outline');
  readonly #marks = make('path', 'marks');
  readonly #preview = make('path', 'preview');
  readonly #readout = make('text', 'readout');

  constructor() {
    this.element.setAttribute('aria-hidden', 'true');
    const plus = make('path', 'plus');
    plus.setAttribute('d', 'M-3.5 0H3.5M0 -3.5V3.5');
    this.#hover.append(this.#ring, plus);
    this.element.append(
      this.#marks,
      this.#strains,
      this.#preview,
      this.#tether,
      this.#pulse,
      this.#hover,
      this.#outline,
      this.#readout,
    );
    this.setHover(null, 0, false);
    this.setPulse(null, 0);
    this.setTether(null);
    this.setOutline(null);
  }

  /** The hovered vertex; `adds`: a click would make it a handle. */
  setHover(place: Place | null, radius: number, adds: boolean): void {
    if (!show(this.#hover, place)) return;
    this.#hover.classList.toggle('adds', adds);
    this.#hover.setAttribute('transform', `translate(${place!.x} ${place!.y})`);
    this.#ring.setAttribute('r', String(radius));
  }

  /** Beckons towards the handle to drag. */
  setPulse(place: Place | null, radius: number): void {
    if (!show(this.#pulse, place)) return;
    put(this.#pulse, { cx: place!.x, cy: place!.y, r: radius });
  }

  /** A line from the vertex to its target, while the net has not followed yet. */
  setTether(ends: { from: Place; to: Place } | null): void {
    if (!show(this.#tether, ends)) return;
    putLine(this.#tether, ends!);
  }

  /** The outline being drawn around handles. */
  setOutline(corners: readonly Place[] | null): void {
    if (!show(this.#outline, corners)) return;
    const path = corners!.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L');
    this.#outline.setAttribute('d', `M${path}Z`);
  }

  /** Dots on vertices that a button would select. */
  setPreview(places: readonly Place[]): void {
    // Lines of zero length with round caps are dots.
    const path = places.map(({ x, y }) => `M${x.toFixed(1)} ${y.toFixed(1)}h0`).join('');
    if (this.#preview.getAttribute('d') !== path) this.#preview.setAttribute('d', path);
  }

  /** Cells that are not as they should be. */
  setMarks(cells: readonly (readonly Place[])[]): void {
    const path = cells
      .map((corners) => `M${corners.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`)
      .join('');
    if (this.#marks.getAttribute('d') !== path) this.#marks.setAttribute('d', path);
  }

  setReadout(text: string, at: Place | null): void {
    if (!show(this.#readout, text && at)) return;
    put(this.#readout, at!);
    this.#readout.textContent = text;
  }

  /** Pairs of handles whose targets are farther apart than the net between them is long. */
  setStrains(strains: Strain[]): void {
    if (strains.length === 0 && !this.#strains.hasChildNodes()) return;
    this.#strains.replaceChildren(
      ...strains.flatMap(({ from, to, label }) => {
        const line = make('line', 'strain');
        putLine(line, { from, to });
        if (label === null) return [line];
        const text = make('text', 'strain-label');
        put(text, label.at);
        text.textContent = label.text;
        return [line, text];
      }),
    );
  }
}

function make<Tag extends keyof SVGElementTagNameMap>(tag: Tag, name: string): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS(SVG, tag);
  element.classList.add(name);
  return element;
}

function show(element: SVGElement, something: unknown): boolean {
  element.toggleAttribute('hidden', !something);
  return Boolean(something);
}

function put(element: SVGElement, attributes: { [name: string]: number }): void {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value.toFixed(1));
}

function putLine(line: SVGElement, { from, to }: { from: Place; to: Place }): void {
  put(line, { x1: from.x, y1: from.y, x2: to.x, y2: to.y });
}

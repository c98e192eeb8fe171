/** The energy of an edge against its length, for some exponents, and where the worst edge of the net stands. */
import { energy } from '../net/energy';
import { learnWords } from '../language/learn';
import { setText } from '../elements/dom';

const SVG = 'http://www.w3.org/2000/svg';
const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [296, 168, 24, 18, 8];
/** Both exponents of the paper, drawn as a background. */
const USUAL = [2, 50];
/** From half to twice the length, and from the least energy up. */
const [LOWEST, HIGHEST] = [2, 5];

export class EnergyGraph {
  readonly element = make('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'energy', role: 'img' });
  readonly #curve = make('path', { class: 'current' });
  readonly #name = make('text', { class: 'name' });
  readonly #worst = make('circle', { r: 5, class: 'worst' });

  constructor() {
    const axes = make('path', { d: `M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH}`, class: 'axis' });
    const ticks = [0.5, 1, 2].map((r) =>
      label(x(r), HEIGHT - 4, r === 0.5 ? '½' : String(r), r === 0.5 ? 'start' : r === 2 ? 'end' : 'middle'),
    );
    const levels = [2, 3, 4, 5].map((e) => label(LEFT - 6, y(e) + 4, String(e), 'end'));
    const usual = USUAL.map((p) => make('path', { d: path(p), class: 'usual' }));
    this.element.append(axes, ...ticks, ...levels, ...usual, this.#curve, this.#name, this.#worst);
  }

  update(p: number, ratio: number): void {
    this.#curve.setAttribute('d', path(p));
    // The label: inside a wide curve, beside a narrow one, near the top of the graph.
    const r = Math.min(1.8, Math.exp(Math.acosh(HIGHEST / 2) / p));
    this.#name.setAttribute('text-anchor', r > 1.4 ? 'end' : 'start');
    place(this.#name, x(r) + (r > 1.4 ? -8 : 8), Math.max(y(energy(r, p)), TOP + 8));
    setText(this.#name, `p = ${p}`);
    const inside = Math.min(2, Math.max(0.5, ratio));
    this.#worst.setAttribute('cx', x(inside).toFixed(1));
    this.#worst.setAttribute('cy', y(Math.min(HIGHEST, energy(inside, p))).toFixed(1));
    this.element.setAttribute('aria-label', learnWords.graph(p, ratio.toPrecision(4)));
  }
}

function x(r: number): number {
  return LEFT + ((Math.log2(r) + 1) / 2) * (WIDTH - LEFT - 6);
}

function y(value: number): number {
  return HEIGHT - BOTTOM - ((value - LOWEST) / (HIGHEST - LOWEST)) * (HEIGHT - BOTTOM - TOP);
}

/** The part of the curve within the graph. */
function path(p: number): string {
  const end = Math.min(Math.LN2, Math.acosh(HIGHEST / 2) / p);
  const points = Array.from({ length: 81 }, (_, i) => Math.exp(end * (i / 40 - 1)));
  return `M${points.map((r) => `${x(r).toFixed(1)} ${y(energy(r, p)).toFixed(1)}`).join('L')}`;
}

function label(atX: number, atY: number, text: string, anchor: string): SVGTextElement {
  const element = make('text', { 'text-anchor': anchor });
  place(element, atX, atY);
  element.textContent = text;
  return element;
}

function place(element: SVGElement, atX: number, atY: number): void {
  element.setAttribute('x', atX.toFixed(1));
  element.setAttribute('y', atY.toFixed(1));
}

function make<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number>,
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

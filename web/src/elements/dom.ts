/** Helpers that build native elements; all that the panels need instead of a framework. */
import './elements.css';

export type Attributes = Record<string, string | number | boolean>;

/** An element with attributes (a boolean one is present or absent) and children. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'boolean') element.toggleAttribute(name, value);
    else element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

export function makeButton(label: string | Node, click: () => void, attributes: Attributes = {}): HTMLButtonElement {
  const button = make('button', { type: 'button', ...attributes }, label);
  button.addEventListener('click', click);
  return button;
}

/** A section that folds. */
export function makeSection(title: string, open: boolean, ...children: Node[]): HTMLDetailsElement {
  return make('details', { class: 'section', open }, make('summary', {}, title), ...children);
}

export function setSummary(section: HTMLDetailsElement, title: string): void {
  setText(section.querySelector('summary')!, title);
}

/** A choice of a few, as a select with its label. */
export function makeSelect(
  label: string,
  choices: readonly { value: string; text: string }[],
  chosen: (value: string) => void,
): { row: HTMLLabelElement; select: HTMLSelectElement } {
  const select = make('select', {}, ...choices.map(({ value, text }) => make('option', { value }, text)));
  select.addEventListener('change', () => chosen(select.value));
  return { row: make('label', { class: 'row' }, make('span', {}, label), select), select };
}

export function makeSwitch(
  label: string,
  changed: (on: boolean) => void,
): { row: HTMLLabelElement; box: HTMLInputElement } {
  const box = make('input', { type: 'checkbox', class: 'switch' });
  box.addEventListener('change', () => changed(box.checked));
  return { row: make('label', { class: 'row' }, make('span', {}, label), box), box };
}

/** Sets the text only if it differs, which spares layout and screen readers. */
export function setText(node: Node, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

/** Sets the value of a field, unless the user may be typing there. */
export function setValue(field: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (mayBeSet(field) && field.value !== value) field.value = value;
}

/** Whether it is without the focus, or what was typed there has been applied. */
export function mayBeSet(field: HTMLElement): boolean {
  return document.activeElement !== field || isApplied(field);
}

/** Of a field for a number, that what it holds has been taken, and nothing typed since. */
export function setApplied(field: HTMLElement, applied: boolean): void {
  field.toggleAttribute('data-applied', applied);
}

export function isApplied(field: EventTarget | null): boolean {
  return field instanceof HTMLElement && field.hasAttribute('data-applied');
}

const SVG = 'http://www.w3.org/2000/svg';

export function makeSvg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string>,
  ...children: Node[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A line drawing on a 16 by 16 grid. */
export function makeIcon(path: string): SVGSVGElement {
  return makeSvg('svg', { viewBox: '0 0 16 16', class: 'icon', 'aria-hidden': 'true' }, makeSvg('path', { d: path }));
}

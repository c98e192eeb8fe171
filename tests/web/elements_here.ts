/** Elements enough for a panel to be made of, without a browser: they nest, hold a value, take the focus and hear events. */
import { vi } from 'vitest';

export class ElementHere extends EventTarget {
  readonly tag: string;
  readonly dataset: Record<string, string> = {};
  readonly style = { setProperty(): void {} };
  readonly classList = { add(): void {}, toggle(): void {} };
  readonly validity = { valid: true };
  hidden = false;
  disabled = false;
  readonly #document: DocumentHere;
  #value = '';
  #text = '';
  #children: ElementHere[] = [];
  #parent: ElementHere | null = null;

  constructor(document: DocumentHere, tag: string) {
    super();
    this.#document = document;
    this.tag = tag;
  }

  setAttribute(name: string, value: string): void {
    if (name === 'value') this.#value = value;
    if (name.startsWith('data-')) this.dataset[name.slice('data-'.length)] = value;
  }

  toggleAttribute(name: string, on: boolean): void {
    if (name === 'hidden' || name === 'disabled') this[name] = on;
  }

  append(...parts: (ElementHere | string)[]): void {
    for (const part of parts) {
      if (typeof part === 'string') this.#text += part;
      else this.#take(part);
    }
  }

  replaceChildren(...parts: (ElementHere | string)[]): void {
    for (const child of this.#children) child.#parent = null;
    [this.#children, this.#text] = [[], ''];
    this.append(...parts);
  }

  #take(child: ElementHere): void {
    this.#children.push(child);
    child.#parent = this;
  }

  /** Beside it, to which nothing here pays attention. */
  after(): void {}

  remove(): void {
    this.#parent?.replaceChildren(...this.#parent.#children.filter((each) => each !== this));
    this.#parent = null;
  }

  hasChildNodes(): boolean {
    return this.#children.length > 0;
  }

  /** Of no selector that a panel asks for while it is made. */
  matches(): boolean {
    return false;
  }

  contains(other: ElementHere | null): boolean {
    return other !== null && (other === this || this.contains(other.#parent));
  }

  get isSeen(): boolean {
    return !this.hidden && (this.#parent?.isSeen ?? true);
  }

  get textContent(): string {
    return this.#text + this.#children.map(({ textContent }) => textContent).join('');
  }

  set textContent(text: string) {
    this.replaceChildren(text);
  }

  /** Of a choice the first of what is offered, unless another was chosen. */
  get value(): string {
    const offered = this.#children.map(({ value }) => value);
    return this.tag !== 'select' || offered.includes(this.#value) ? this.#value : (offered[0] ?? '');
  }

  set value(value: string) {
    this.#value = value;
  }

  get valueAsNumber(): number {
    return Number(this.#value);
  }

  set valueAsNumber(value: number) {
    this.#value = String(value);
  }

  getBoundingClientRect(): Pick<DOMRect, 'left' | 'top' | 'right' | 'bottom'> {
    return { left: 0, top: 0, right: 0, bottom: 0 };
  }

  focus(): void {
    this.#document.activeElement = this;
  }

  setCustomValidity(): void {}

  blur(): void {
    if (this.#document.activeElement === this) this.#document.activeElement = null;
  }

  scrollIntoView(): void {
    this.#document.scrolledTo = this;
  }

  tell(event: string): void {
    this.dispatchEvent(new Event(event));
  }
}

export class DocumentHere {
  #active: ElementHere | null = null;
  scrolledTo: ElementHere | null = null;
  readonly #made: ElementHere[] = [];
  /** The picture. */
  readonly canvas = this.createElement('canvas');

  createElement(tag: string): ElementHere {
    const element = new ElementHere(this, tag);
    this.#made.push(element);
    return element;
  }

  createElementNS(_: string, tag: string): ElementHere {
    return this.createElement(tag);
  }

  querySelector(selector: string): ElementHere | null {
    return selector === 'canvas' ? this.canvas : null;
  }

  /** None is anywhere on the page. */
  querySelectorAll(): ElementHere[] {
    return [];
  }

  /** What is hidden or disabled loses the focus. */
  get activeElement(): ElementHere | null {
    return this.#active?.isSeen && !this.#active.disabled ? this.#active : null;
  }

  set activeElement(element: ElementHere | null) {
    this.#active = element;
  }

  /** All of a kind that were ever made, the newest first. */
  all(tag: string): ElementHere[] {
    return this.#made.filter((each) => each.tag === tag).reverse();
  }

  button(text: string): ElementHere {
    return this.all('button').find(({ textContent }) => textContent === text)!;
  }
}

/** In place of the document of a browser, until globals are given back. */
export function documentHere(): DocumentHere {
  const document = new DocumentHere();
  vi.stubGlobal('document', document);
  return document;
}

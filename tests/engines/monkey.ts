/** Somebody who has no idea of the page: random pointer, keys, wheel, undo, files and links; the same for the same seed,
 *  as far as the page is as fast. */
import { setTimeout as sleep } from 'node:timers/promises';
import { random } from '../web/random';
import type { Visitor } from './visitor';

declare global {
  interface Window {
    /** False when the page was left, and came back out of the browser's memory. */
    caged?: boolean;
  }
}

const WIDTH = 1280;
const HEIGHT = 800;

const KEYS = [
  ...[
    'Tab',
    'Tab',
    'Enter',
    'Escape',
    ' ',
    'Home',
    'End',
    'ArrowLeft',
    'ArrowRight',
    'ArrowUp',
    'ArrowDown',
    'Delete',
    'Backspace',
  ],
  ...['g', 'r', 's', 'l', '?', '=', '-', '.', '0', '1', '5', '9', 'e'],
  ...['Control+a', 'Control+s', 'Control+o', 'Control+z', 'Control+y', 'Shift+ArrowUp', 'Shift+Tab'],
];

/** Their choice loads the page anew. */
const LANGUAGES = ['BUTTON English', 'BUTTON 中文'];

/** A net of quads, a few of whose corners may be elsewhere. */
function gridObj(size: number, shift: () => number): string {
  const at = (i: number, j: number) => i * size + j + 1;
  const range = [...Array(size).keys()];
  const vertices = range.flatMap((i) => range.map((j) => `v ${i + shift()} ${j + shift()} ${shift()}`));
  const inner = range.slice(1);
  const faces = inner.flatMap((i) =>
    inner.map((j) => `f ${at(i - 1, j - 1)} ${at(i, j - 1)} ${at(i, j)} ${at(i - 1, j)}`),
  );
  return [...vertices, ...faces, ''].join('\n');
}

export class Monkey {
  readonly #visitor: Visitor;
  readonly #random: () => number;
  readonly #links = ['#experiment=long-edges', '#v1=AAAA', '#v9=AAAA', '#none', '#v1=%00%ff', '#experiment=<b>'];
  /** So many pages of the visitor's are behind and before this one. */
  #behind = 0;
  #ahead = 0;
  #count = 0;
  /** The newest last. */
  readonly #done: string[] = [];

  constructor(visitor: Visitor, seed: number) {
    this.#visitor = visitor;
    this.#random = random(seed);
  }

  get count(): number {
    return this.#count;
  }

  /** What it did last, for whoever wonders what broke the page. */
  get story(): string {
    return this.#done.slice(-40).join('\n');
  }

  async act(): Promise<void> {
    try {
      await this.#visitor.run(cage);
      await this.#act();
    } catch (error) {
      // Another language loads the page anew, and so do the steps back and forward over it. What is done meanwhile has no
      // page to go to, which drivers take ill.
      await sleep(2000);
      await this.#visitor.waitForNet();
      if (await this.#isCaged()) throw error;
    }
  }

  #isCaged(): Promise<boolean> {
    return this.#visitor.run(() => window.caged === true).catch(() => false);
  }

  async #act(): Promise<void> {
    const acts: [share: number, name: string, act: () => Promise<unknown>][] = [
      [6, 'drag a handle', () => this.#dragHandle()],
      [5, 'press and move', () => this.#scribble()],
      [8, 'use a control', () => this.#useControl()],
      [6, 'keys', () => this.#type()],
      [3, 'wheel', () => this.#turnWheel()],
      [3, 'undo and redo', () => this.#undo()],
      [2, 'drop a file', () => this.#dropFile()],
      [2, 'follow a link', () => this.#followLink()],
      [2, 'back or forward', () => this.#travel()],
      [1, 'keep a link', () => this.#keepLink()],
      [1, 'resize', () => this.#resize()],
    ];
    let left = this.#random() * acts.reduce((sum, [share]) => sum + share, 0);
    const [, name, act] = acts.find(([share]) => (left -= share) < 0) ?? acts[0]!;
    this.#count += 1;
    this.#done.push(`${this.#count} ${name}`);
    await act();
  }

  // ------------------------------------------------------------------------------------------------------------ pointer

  async #dragHandle(): Promise<void> {
    const place = await this.#visitor.run((share) => {
      const handles = window.chebnet.handles();
      const handle = handles[Math.floor(share * handles.length)];
      return handle === undefined ? null : window.chebnet.screenPosition(handle.vertex);
    }, this.#random());
    if (place !== null && Number.isFinite(place.x + place.y))
      await this.#dragFrom(clamp(place.x, WIDTH), clamp(place.y, HEIGHT));
  }

  async #scribble(): Promise<void> {
    const held = this.#choose(['', '', '', 'Shift', 'Control', 'Alt']);
    if (held) await this.#visitor.driver.pressKey(held);
    await this.#dragFrom(this.#below(WIDTH), this.#below(HEIGHT));
    if (held) await this.#visitor.driver.releaseKey(held);
  }

  async #dragFrom(x: number, y: number): Promise<void> {
    const { driver } = this.#visitor;
    const reach = this.#choose([3, 60, 300, 2000]);
    await driver.movePointer(x, y);
    await driver.pressButton();
    for (let i = this.#below(6); i > 0; --i) {
      await driver.movePointer(
        clamp(x + (this.#random() - 0.5) * reach, WIDTH),
        clamp(y + (this.#random() - 0.5) * reach, HEIGHT),
      );
    }
    if (this.#random() < 0.1) await this.#visitor.press(this.#choose(['Escape', 'Control+z', 'Delete']));
    await driver.releaseButton();
  }

  async #useControl(): Promise<void> {
    const found = await this.#visitor.run(findControl, this.#random(), this.#random());
    if (found === null) return;
    this.#done.push(`  ${found.name}`);
    if (found.x < 0 || found.y < 0 || found.x >= WIDTH || found.y >= HEIGHT) return;
    await this.#visitor.click(found.x, found.y);
    if (LANGUAGES.includes(found.name)) await this.#awaitReload();
    if (found.takesText)
      for (const key of ['Control+a', ...this.#numberKeys(), 'Enter']) await this.#visitor.press(key);
  }

  async #awaitReload(): Promise<void> {
    for (let i = 0; i < 50 && (await this.#isCaged()); ++i) await sleep(100);
    await this.#visitor.waitForNet();
  }

  #numberKeys(): string[] {
    return [...this.#choose(['1', '0', '-3', '1e9', '0.001', '17', 'x', '250'])];
  }

  #turnWheel(): Promise<void> {
    return this.#visitor.driver.turnWheel(this.#below(2000) - 1000);
  }

  // --------------------------------------------------------------------------------------------------------------- keys

  async #type(): Promise<void> {
    for (let i = 1 + this.#below(4); i > 0; --i) {
      const key = this.#choose(KEYS);
      this.#done.push(`  ${key}`);
      await this.#visitor.press(key);
    }
  }

  async #undo(): Promise<void> {
    const key = this.#choose(['Control+z', 'Control+z', 'Control+Shift+z']);
    for (let i = 1 + this.#below(6); i > 0; --i) await this.#visitor.press(key);
  }

  // ---------------------------------------------------------------------------------------------------- files and links

  #dropFile(): Promise<void> {
    const even = () => gridObj(3 + this.#below(12), () => 0);
    const shaky = () => gridObj(3 + this.#below(12), () => this.#random() * 0.3);
    const file = this.#choose<[string, () => string]>([
      ['even.obj', even],
      ['shaky.obj', shaky],
      ['cut.obj', () => shaky().slice(0, this.#below(400))],
      ['empty.off', () => ''],
      ['noise.ply', () => String.fromCharCode(...Array.from({ length: 200 }, () => this.#below(128)))],
      ['picture.obj', () => '<svg xmlns="http://www.w3.org/2000/svg"/>'],
      ['project.json', () => '{"chebnet":1,"nets":[],"states":[]}'],
      ['nan.obj', () => even().replace('v 1 1', 'v nan 1e400')],
    ]);
    this.#done.push(`  ${file[0]}`);
    return this.#visitor.dropFile(file[0], file[1]());
  }

  async #followLink(): Promise<void> {
    const link = this.#choose(this.#links);
    this.#done.push(`  ${link.slice(0, 60)}`);
    const isOther = await this.#visitor.run((hash) => {
      const before = location.hash;
      location.hash = hash;
      return location.hash !== before;
    }, link);
    if (!isOther) return;
    this.#behind += 1;
    this.#ahead = 0;
  }

  async #travel(): Promise<void> {
    const forward = this.#random() < 0.4;
    if (forward ? this.#ahead === 0 : this.#behind === 0) return;
    this.#behind += forward ? 1 : -1;
    this.#ahead -= forward ? 1 : -1;
    await this.#visitor.run((by) => history.go(by), forward ? 1 : -1);
  }

  async #keepLink(): Promise<void> {
    const link = await this.#visitor.run(() => window.chebnet.link().catch(() => '#'));
    this.#links.splice(
      this.#below(this.#links.length),
      this.#links.length > 20 ? 1 : 0,
      new URL(link, 'http://host').hash,
    );
  }

  async #resize(): Promise<void> {
    const [width, height] = this.#choose<[number, number]>([
      [700, 500],
      [390, 800],
      [1280, 300],
    ]);
    await this.#visitor.driver.resize(width, height);
    await this.#visitor.driver.resize(WIDTH, HEIGHT);
  }

  // ------------------------------------------------------------------------------------------------------------- chance

  #below(end: number): number {
    return Math.floor(this.#random() * end);
  }

  #choose<T>(choices: readonly T[]): T {
    return choices[this.#below(choices.length)]!;
  }
}

function clamp(x: number, end: number): number {
  return Math.min(Math.max(Math.round(x), 0), end - 1);
}

/** Runs in the page. No driver can answer the window in which a file is chosen, and none follows to another tab. */
function cage(): void {
  if (window.chebnet === undefined) throw new Error('the page is not there yet');
  const first = window.caged === undefined;
  window.caged = true;
  if (!first) return;
  addEventListener('pagehide', () => (window.caged = false));
  const click = HTMLInputElement.prototype.click;
  HTMLInputElement.prototype.click = function (this: HTMLInputElement) {
    if (this.type === 'file') this.dispatchEvent(new Event('cancel'));
    else click.call(this);
  };
  const stay = (event: Event) =>
    event.target instanceof Element && event.target.closest('a[target]') && event.preventDefault();
  addEventListener('click', stay, true);
}

/** Runs in the page: something that can be used, in sight; lists are chosen from at once. */
function findControl(share: number, choice: number): { name: string; x: number; y: number; takesText: boolean } | null {
  const scope = document.querySelector('dialog:modal') ?? document;
  const controls = [...scope.querySelectorAll<HTMLElement>('button, summary, input, select, a[href], [role=slider]')];
  const usable = controls.filter((each) => each.checkVisibility() && (each as HTMLButtonElement).disabled !== true);
  const control = usable[Math.floor(share * usable.length)];
  if (control === undefined) return null;
  control.scrollIntoView({ block: 'nearest', behavior: 'instant' });
  const { left, top, width, height } = control.getBoundingClientRect();
  const name = `${control.tagName} ${(control.ariaLabel ?? control.textContent ?? '').trim().replace(/\s+/g, ' ').slice(0, 60)}`;
  if (control instanceof HTMLSelectElement) {
    control.selectedIndex = Math.floor(choice * control.options.length);
    for (const kind of ['input', 'change']) control.dispatchEvent(new Event(kind, { bubbles: true }));
    return null;
  }
  const takesText = control instanceof HTMLInputElement && ['text', 'number', 'search'].includes(control.type);
  return { name, x: left + width / 2, y: top + height / 2, takesText };
}

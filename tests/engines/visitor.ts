/** Somebody who visits the page in a window of any engine. */
import { mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { afterAll, afterEach, beforeAll, expect, vi } from 'vitest';
import type { Scripting, Stats } from '../../web/src/scripting';
import { close, isAsAtFirst, type PageState, stateOfPage } from '../browser/put_away';
import { DIST, serve } from '../browser/site';
import type { Driver, Engine } from './driver';
import { ENGINE, startEngine } from './engines';

const OUTPUT = fileURLToPath(new URL('../output', import.meta.url));
mkdirSync(OUTPUT, { recursive: true });

/** What a busy machine may take, ms. */
export const PATIENCE = { timeout: 60_000, interval: 50 };

/** A file that was the same so often has been written. */
const LOOKS = 4;

/** The page as it was at first. */
interface First {
  project: Uint8Array;
  state: PageState;
}

type Point = readonly [x: number, y: number];

/** For one file of tests: an engine and the site while they run. After each test its windows close, and no page in them
 *  may have complained; one that is to be shared stays, if the test passed. */
export function visitors(root = () => DIST) {
  let engine: Engine;
  let site: Awaited<ReturnType<typeof serve>>;
  const present: Visitor[] = [];
  let shared: { visitor: Visitor; first: First } | null = null;

  beforeAll(async () => {
    [engine, site] = await Promise.all([startEngine(), serve(root)]);
  });
  afterEach(async ({ task }) => {
    const ended = present.splice(0);
    const complaints = (await Promise.all(ended.map((visitor) => visitor.complaints()))).flat();
    const stays = task.result?.state !== 'fail' && complaints.length === 0 ? shared?.visitor : undefined;
    await Promise.all(ended.filter((visitor) => visitor !== stays).map(({ driver }) => driver.close()));
    if (stays === undefined) shared = null;
    expect(complaints).toEqual([]);
  });
  afterAll(async () => {
    await shared?.visitor.driver.close();
    await engine.close();
    site.close();
  });

  /** Opens any page of the site. */
  async function open(link: string): Promise<Visitor> {
    const visitor = new Visitor(await engine.newWindow());
    present.push(visitor);
    await visitor.driver.goto(new URL(link, site.address).href);
    return visitor;
  }

  /** Opens the page, or a link into it, and waits for the net. */
  async function arrive(link = ''): Promise<Visitor> {
    const visitor = await open(link);
    await visitor.waitForNet();
    return visitor;
  }

  /** As in tests/browser/page.ts: one visit for tests that need not be the first thing a visitor does. In WebKit an arrival
   *  takes ten seconds of a processor. */
  async function share(): Promise<Visitor> {
    if (shared && (await shared.visitor.putAway(shared.first))) {
      present.push(shared.visitor);
      return shared.visitor;
    }
    await shared?.visitor.driver.close();
    const visitor = await arrive();
    shared = { visitor, first: await visitor.asAtFirst() };
    return visitor;
  }

  return { open, arrive, share, address: () => site.address, closeSite: () => site.close() };
}

export class Visitor {
  /** What the test makes the page complain of. */
  expected: RegExp | null = null;

  constructor(readonly driver: Driver) {}

  async complaints(): Promise<string[]> {
    const all = await this.driver.complaints();
    return all.filter((each) => !this.expected?.test(each));
  }

  /** Runs a function in the page; it may use nothing from around it, and take and give plain data only. */
  async run<Given extends unknown[], Result>(
    code: (...given: Given) => Result | Promise<Result>,
    ...given: Given
  ): Promise<Result> {
    return (await this.driver.evaluate(`(${code})(...${JSON.stringify(given)})`)) as Result;
  }

  // ------------------------------------------------------------------------------------------------- window.chebnet

  async waitForNet(): Promise<void> {
    await vi.waitUntil(
      () => this.run(() => window.chebnet !== undefined && window.chebnet.stats().vertices > 0),
      PATIENCE,
    );
    await this.settled();
  }

  settled(): Promise<void> {
    return this.run(() => window.chebnet.settled());
  }

  async openNet(net: Parameters<Scripting['open']>[0]): Promise<void> {
    await this.run((each) => window.chebnet.open(each), net);
    await this.settled();
  }

  stats(): Promise<Stats> {
    return this.run(() => window.chebnet.stats());
  }

  async positions(): Promise<Float64Array> {
    return Float64Array.from(await this.run(() => Array.from(window.chebnet.positions())));
  }

  /** The vertices of the handles, in their order. */
  handles(): Promise<number[]> {
    return this.run(() => window.chebnet.handles().map(({ vertex }) => vertex));
  }

  // --------------------------------------------------------------------------------------------- pointer and keyboard

  async click(x: number, y: number): Promise<void> {
    await this.driver.movePointer(x, y);
    await this.driver.pressButton();
    await this.driver.releaseButton();
  }

  /** Where a vertex is on the screen, once the view has come to rest: it may still be on its way to a net just opened. */
  async placeInSight(vertex: number): Promise<{ x: number; y: number }> {
    const place = () => this.run((v) => window.chebnet.screenPosition(v), vertex);
    let before = await place();
    for (;;) {
      await sleep(100);
      const now = await place();
      if (Math.hypot(now.x - before.x, now.y - before.y) < 0.5) return now;
      before = now;
    }
  }

  /** Drags the handle at a vertex across the screen and waits for the net. */
  async drag(vertex: number, [dx, dy]: Point, atEnd?: () => Promise<void>): Promise<void> {
    const { x, y } = await this.placeInSight(vertex);
    const steps = 5;
    await this.driver.movePointer(x, y);
    await this.driver.pressButton();
    for (let i = 1; i <= steps; ++i) await this.driver.movePointer(x + (dx * i) / steps, y + (dy * i) / steps);
    await atEnd?.();
    await this.driver.releaseButton();
    await this.settled();
  }

  /** Keys held together, e.g. `Control+z`. */
  async press(chord: string): Promise<void> {
    const keys = chord.split('+');
    for (const key of keys) await this.driver.pressKey(key);
    for (const key of keys.reverse()) await this.driver.releaseKey(key);
  }

  /** Clicks what is called so, once it is there and at rest: a button, a link, the summary of a section, a field. */
  async clickOn(name: string): Promise<void> {
    const [x, y] = await this.#placeOf(name);
    await this.click(x, y);
  }

  async #placeOf(name: string): Promise<Point> {
    let before = '';
    const place = await vi.waitUntil(async () => {
      const now = await this.run(placeOf, name);
      const atRest = now !== null && String(now) === before;
      before = String(now);
      return atRest ? now : null;
    }, PATIENCE);
    return place;
  }

  /** Chooses from a list. No engine lets a driver into the list itself. */
  choose(label: string, value: string): Promise<void> {
    return this.run(
      (name, wanted) => {
        const lists = [...document.querySelectorAll('select')];
        const list = lists.find((each) =>
          (each.ariaLabel ?? each.labels[0]?.textContent ?? '').trim().startsWith(name),
        )!;
        list.value = wanted;
        list.dispatchEvent(new Event('input', { bubbles: true }));
        list.dispatchEvent(new Event('change', { bubbles: true }));
      },
      label,
      value,
    );
  }

  // ----------------------------------------------------------------------------------------------------- what is seen

  /** The text of what is seen, once it contains this. */
  async read(expected: string | RegExp, selector = 'body'): Promise<string> {
    let text = '';
    const holds = () => (typeof expected === 'string' ? text.includes(expected) : expected.test(text));
    const look = async () => {
      text = await this.run(
        (each) => [...document.querySelectorAll<HTMLElement>(each)].map(({ innerText }) => innerText).join('\n'),
        selector,
      );
      return holds();
    };
    await vi.waitUntil(look, PATIENCE).catch(() => expect(text).toMatch(expected));
    return text;
  }

  async picture(name: string): Promise<void> {
    writeFileSync(join(OUTPUT, `${ENGINE}-${name}.png`), await this.driver.screenshot());
  }

  // ------------------------------------------------------------------------------------------------------------ files

  /** Drops a file on the picture. */
  dropFile(name: string, content: Uint8Array | string): Promise<void> {
    return this.run(
      (fileName, base64) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], fileName));
        document
          .getElementById('view')!
          .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
      },
      name,
      Buffer.from(content).toString('base64'),
    );
  }

  /** What the page saves while something is done to it. */
  async saved(doing: () => Promise<void>): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> }> {
    const folder = this.driver.downloads;
    await doing();
    let before = '';
    let looks = 0;
    const name = await vi.waitUntil(() => {
      // While a file is written it has another name, or is beside one that has; it grows, and takes its own name at the end.
      const [file = '', ...others] = readdirSync(folder);
      const size = statSync(join(folder, file), { throwIfNoEntry: false })?.size ?? 0;
      const isThere = others.length === 0 && size > 0 && !/^$|\.(part|wkdownload)$/.test(file);
      looks = isThere && `${file} ${size}` === before ? looks + 1 : 0;
      before = `${file} ${size}`;
      return looks >= LOOKS ? file : undefined;
    }, PATIENCE);
    const bytes = Uint8Array.from(readFileSync(join(folder, name)));
    rmSync(join(folder, name));
    return { name, bytes };
  }

  // ------------------------------------------------------------------------------------------------- as it was at first

  /** Until all sections of the sidebar are there: nothing of the page itself is on its way any more. */
  async waitForSections(): Promise<void> {
    await vi.waitUntil(() => this.run(() => document.querySelector('.group') !== null), PATIENCE);
  }

  async asAtFirst(): Promise<First> {
    await this.waitForSections();
    const { bytes } = await this.saved(() => this.press('Control+s'));
    return { project: bytes, state: await this.run(stateOfPage) };
  }

  /** See tests/browser/put_away.ts. */
  async putAway({ project, state }: First): Promise<boolean> {
    await this.driver.movePointer(0, 0);
    await this.run(close, state);
    await this.dropFile('first.chebnet.json', project);
    await this.read('The project is open.');
    await this.settled();
    const isBack = async () => isAsAtFirst(await this.run(stateOfPage), state);
    return vi.waitUntil(isBack, { timeout: 3000 }).catch(() => false);
  }
}

/** Runs in the page: the middle of what is called so and can be clicked, scrolled into sight; null while it is not there. */
function placeOf(name: string): [number, number] | null {
  const clickable = 'button, a[href], summary, input, label, [role=button], [role=menuitem]';
  const nameOf = (element: Element) =>
    (element.ariaLabel ?? element.querySelector('strong')?.textContent ?? element.textContent ?? '')
      .trim()
      .replace(/\s+/g, ' ');
  const elements = [...document.querySelectorAll<HTMLButtonElement>(clickable)];
  const found = elements.filter(
    (element) => element.checkVisibility() && element.disabled !== true && nameOf(element) === name,
  );
  // What opened last lies on top.
  const element = found.at(-1);
  if (element === undefined) return null;
  element.scrollIntoView({ block: 'nearest', behavior: 'instant' });
  const { left, top, width, height } = element.getBoundingClientRect();
  return [left + width / 2, top + height / 2];
}

/**
 * The page under a monkey, in each engine. `tests/run` gives it a moment; `tests/engines/run_monkey --minutes 10` as long as
 * one likes. Of what it did, the last is told when something breaks; CHEBNET_SEED repeats it.
 */
import { expect, test } from 'vitest';
import { distance } from '../browser/geometry';
import { printedSeed } from '../web/random';
import { ENGINE } from './engines';
import { Monkey } from './monkey';
import { browserMemory } from './processes';
import { visitors } from './visitor';
import type { Visitor } from './visitor';

/** A search goes on for so long with new seeds; none is wanted: the same few acts each time, however fast the machine is. */
const MINUTES =
  process.env['CHEBNET_MONKEY_MINUTES'] === undefined ? undefined : Number(process.env['CHEBNET_MONKEY_MINUTES']);
const ACTS = 60;
const SEED = MINUTES === undefined ? 1 : undefined;
/** Between two looks at how the page is: acts, or s. */
const ROUND = MINUTES === undefined ? ACTS / 3 : Math.min(30, MINUTES * 20);
/** What may be taken more at the end than after the first round: by pages, for scripts and WebAssembly; and by the browser as
 *  a whole, with pictures. Firefox's main process, where no page can free anything, has been seen to grow beyond what bounds
 *  the others. */
const LARGEST_GROWTH = { pages: 250e6, all: ENGINE === 'firefox' ? 1000e6 : 400e6 };
/** What the solver's WebAssembly may take, which gives none back. Seen: 29e6, in 300 acts; large nets take more. */
const LARGEST_MODULE = 256e6;
const SMALL = 'vault:vertices=600';

const { arrive } = visitors();

/** Runs in the page: what a pointer at the handle of a vertex points at. */
function thingAt(vertex: number): string | undefined {
  const { x, y } = window.chebnet.screenPosition(vertex);
  const thing = document.elementFromPoint(x, y);
  return thing instanceof HTMLCanvasElement ? thing.tagName : thing?.outerHTML.slice(0, 300);
}

/** Whatever is under way gives way to a small net, which can be dragged. */
async function expectResponsive(visitor: Visitor): Promise<void> {
  for (let i = 0; i < 3; ++i) await visitor.press('Escape');
  await visitor.run(() => document.querySelectorAll('details[open]').forEach((each) => each.removeAttribute('open')));
  await visitor.run((recipe) => window.chebnet.open({ recipe }), SMALL);
  await visitor.run(() => window.chebnet.setOptions({ method: 'projection', threshold: 1e-6 }));
  await visitor.settled();
  const vertex = (await visitor.handles()).at(-1)!;
  const placeOf = async () => (await visitor.positions()).subarray(3 * vertex, 3 * vertex + 3);
  const before = await placeOf();
  expect(await visitor.run(thingAt, vertex)).toBe('CANVAS');
  // A step back or forward that was on its way may have brought another net meanwhile.
  const dragged = async () => {
    await visitor.drag(vertex, [-40, -30]);
    return distance(await placeOf(), before);
  };
  await expect.poll(dragged).toBeGreaterThan(0);
}

test('under a monkey nothing breaks, memory stays bounded, and in the end the net can be dragged', {
  timeout: 60_000 * ((MINUTES ?? 1) + 3),
}, async () => {
  const visitor = await arrive();
  const monkey = new Monkey(visitor, printedSeed(`Monkey in ${ENGINE}`, SEED));
  const memory: ReturnType<typeof browserMemory>[] = [];
  const modules: number[] = [];
  const begin = Date.now();
  const passed = () => (MINUTES === undefined ? monkey.count : (Date.now() - begin) / 1000);
  const enough = MINUTES === undefined ? ACTS : 60 * MINUTES;
  try {
    while (passed() < enough) {
      const roundEnd = passed() + ROUND;
      while (passed() < roundEnd) await monkey.act();
      await expectResponsive(visitor);
      expect(await visitor.driver.complaints()).toEqual([]);
      memory.push(browserMemory());
      modules.push((await visitor.stats()).memory);
    }
  } catch (error) {
    console.log(`What the monkey did last:\n${monkey.story}`);
    await visitor.picture('monkey');
    throw error;
  }
  for (const part of ['pages', 'all'] as const) {
    const bytes = memory.map((each) => each[part]);
    const list = bytes.map((each) => Math.round(each / 1e6)).join(' ');
    console.log(`Monkey in ${ENGINE}: ${monkey.count} acts; memory in MB, ${part}: ${list}`);
    expect(bytes.at(-1)! - bytes[0]!).toBeLessThan(LARGEST_GROWTH[part]);
  }
  console.log(`Monkey in ${ENGINE}: WebAssembly in MB: ${modules.map((each) => Math.round(each / 1e6)).join(' ')}`);
  expect(Math.min(...modules)).toBeGreaterThan(0);
  expect(Math.max(...modules)).toBeLessThan(LARGEST_MODULE);
});

/** The page itself never holds up the visitor for longer than a small piece of fixed work, on a net of 15,000 vertices. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { load } from '../wasm/load';
import { dragBy } from './geometry';
import { MOVING, OUTPUT, visits } from './page';
import { mainThreadTasks, yardstick } from './tasks';

const { arrive, browser } = visits();

function median(values: number[]): number {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
}

test.each(['vault:vertices=4000', 'vault:vertices=15000'])('%s', async (recipe) => {
  const { script } = await arrive('', MOVING);
  const editor = (await load()).openRecipe(recipe);
  const dragged = editor.suggestedHandles.at(-1)!;
  editor.dispose();
  await script.open({ recipe });
  await script.settled();

  const framesPerSecond: number[] = [];
  const solverMs: number[] = [];
  const during = async () => {
    const stats = await script.stats();
    framesPerSecond.push(stats.framesPerSecond);
    solverMs.push(stats.milliseconds);
  };
  const { own, clock, unmeasured } = await mainThreadTasks(browser(), async () => {
    for (const [dx, dy] of [
      [-40, -30],
      [30, 20],
    ] as const) {
      await dragBy(script, dragged, [dx, dy], { during });
    }
    await script.settled();
  });
  const figures = {
    recipe,
    longestTaskMs: Math.max(...own),
    longestTaskByTheClockMs: Math.max(...clock),
    tasks: own.length,
    unmeasured,
    framesPerSecond: median(framesPerSecond),
    solverMs: median(solverMs),
  };
  console.log(figures);
  writeFileSync(join(OUTPUT, `figures-${recipe.replace(/\W+/g, '-')}.json`), `${JSON.stringify(figures, null, 2)}\n`);

  expect(own.length).toBeGreaterThan(100);
  expect(unmeasured).toBeLessThan(10);
  expect(figures.longestTaskMs).toBeLessThan(0.5 * yardstick());
});

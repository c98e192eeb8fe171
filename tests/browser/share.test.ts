/** Links: what one visitor copies, another one sees. */
import { expect, test } from 'vitest';
import { load } from '../wasm/load';
import { distance, dragBy } from './geometry';
import { visits } from './page';

const { address, arrive } = visits();

test('a copied link shows the same scene', async () => {
  const recipe = 'vault:vertices=1000';
  const reference = (await load()).openRecipe(recipe);
  const dragged = reference.suggestedHandles.at(-1)!;
  const { meanLength, vertices } = reference.info;

  const sender = await arrive();
  await sender.script.open({ recipe });
  await dragBy(sender.script, dragged, [-60, -40]);
  await sender.script.settled();
  await sender.page.getByRole('button', { name: /copy link|share/i }).first().click();
  await sender.page.waitForTimeout(500);
  const link = await sender.page.evaluate(() => navigator.clipboard.readText());
  console.log(`link of ${link.length} characters`);
  expect(link.startsWith(`${address()}#`)).toBe(true);
  expect(link.length).toBeLessThan(8000);

  const receiver = await arrive(link);
  await receiver.script.settled();
  const [sent, received] = [await sender.script.positions(), await receiver.script.positions()];
  expect(received).toHaveLength(3 * vertices);
  const errors = Array.from({ length: vertices }, (_, v) =>
    distance(sent.subarray(3 * v, 3 * v + 3), received.subarray(3 * v, 3 * v + 3)),
  );
  expect(Math.max(...errors)).toBeLessThan(1e-4 * meanLength);
  expect((await receiver.script.stats()).handles).toBe((await sender.script.stats()).handles);
  const [here, there] = [await sender.script.screenPosition(dragged), await receiver.script.screenPosition(dragged)];
  expect(Math.hypot(here.x - there.x, here.y - there.y)).toBeLessThan(3);
});

const BROKEN = [
  ['of another site', '#nonsense'],
  ['of a future version', '#v=999&d=AAAA'],
  ['cut inside a character', '#%E0%A4%A'],
  ['of noise', `#${'A'.repeat(5000)}`],
] as const;

test.each(BROKEN)('a link %s shows the first net and says so', async (_, hash) => {
  const usual = await (await arrive()).script.stats();
  const { page, script } = await arrive(hash);
  const said = () => page.locator('[role=alert], [role=status]').allInnerTexts();
  await expect.poll(said).toContainEqual(expect.stringMatching(/link/i));
  const { vertices, handles } = await script.stats();
  expect({ vertices, handles }).toEqual({ vertices: usual.vertices, handles: usual.handles });
});

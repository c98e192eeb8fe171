/** Handles that follow the one in hand, with a mouse and keys. */
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { sharesAround } from '../../web/src/handles/influence';
import { describe as describeNet } from '../../web/src/worker/opened_net';
import { load } from '../wasm/load';
import { dragBy, vertexAt } from './geometry';
import type { Script, Visit } from './page';
import { OUTPUT, visits } from './page';

const SHAPE = 'vault:vertices=500';
const net = (await load()).openRecipe(SHAPE);
const crown = net.suggestedHandles.at(-1)!;

const { arrive, share } = visits();
let visit: Visit;
let script: Script;
const handles = () => visit.page.evaluate(() => window.chebnet.handles());
const press = (keys: string) => visit.page.keyboard.press(keys);
const slider = () => visit.page.getByRole('slider', { name: /^Followers/ });
const said = () => visit.page.locator('.influence output').textContent();
const picture = (name: string) => visit.page.screenshot({ path: join(OUTPUT, `influence-${name}.png`) });

/** With handles all over the vault, some edges apart. */
async function open() {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  const parts = [0.25, 0.375, 0.5, 0.625, 0.75];
  const spread = parts.flatMap((u) => parts.map((v) => vertexAt(net.restPositions, u, v)));
  await visit.page.evaluate(
    ([corners, others]) =>
      window.chebnet.setHandles([
        ...corners!.map((vertex) => ({ vertex, anchor: true })),
        ...others!.map((vertex) => ({ vertex, anchor: false })),
      ]),
    [[...net.suggestedHandles.slice(0, -1)], [...new Set([...spread, crown])]],
  );
  await script.settled();
  await visit.page.locator('summary', { hasText: /^Dragging/ }).click();
}

/** By keys, until it says so. */
async function chooseRadius(text: string) {
  await slider().focus();
  for (let i = 0; i < 40 && (await said()) !== text; i++) await press('ArrowRight');
  expect(await said()).toBe(text);
}

const target = async (vertex: number) => (await handles()).find((each) => each.vertex === vertex)!.target;

/** How far each handle has come. */
async function moves(before: { vertex: number; target: [number, number, number] }[]) {
  const now = new Map((await handles()).map((each) => [each.vertex, each.target]));
  return before.map(({ vertex, target: was }) => ({ vertex, by: now.get(vertex)!.map((x, i) => x - was[i]!) }));
}

test('follow by their share, as is shown before and during the drag; undo takes it back, and the choice; a link has it', async () => {
  await open();
  const { x, y } = await script.screenPosition(crown);
  await visit.page.mouse.click(x, y);
  await chooseRadius('6 edges');
  await picture('preview');
  const before = await handles();
  const shares = sharesAround(describeNet(net), [crown], 6);
  await dragBy(script, crown, [2, 10], { atEnd: () => picture('drag').then(() => {}) });
  await script.settled();
  await picture('after');
  const all = await moves(before);
  const way = all.find(({ vertex }) => vertex === crown)!.by;
  expect(Math.hypot(...way)).toBeGreaterThan(0.05);
  for (const { vertex, by } of all) {
    const share = before.find((each) => each.vertex === vertex)!.anchor ? 0 : shares[vertex]!;
    const off = by.map((each, i) => each - share * way[i]!);
    // Two at the ends of a straight part of the net hold each other.
    expect(Math.hypot(...off)).toBeLessThan(0.15 * Math.hypot(...way));
  }
  expect(all.filter(({ by }) => Math.hypot(...by) > 1e-6).length).toBeGreaterThan(5);
  expect((await visit.page.evaluate(() => window.chebnet.stats())).maxDeviation).toBeLessThan(1e-6);

  const link = await visit.page.evaluate(() => window.chebnet.link());
  await press('Control+z');
  await expect.poll(handles).toEqual(before);
  await press('Control+z');
  await expect.poll(said).toBe('none');
  visit = await arrive(link.slice(link.indexOf('#')));
  ({ script } = visit);
  await expect.poll(said).toBe('6 edges');
  const opened = await handles();
  await dragBy(script, crown, [0, -6]);
  await script.settled();
  expect((await moves(opened)).filter(({ by }) => Math.hypot(...by) > 1e-6).length).toBeGreaterThan(5);
});

test('follow arrow keys, and keys that keep to an axis', async () => {
  await open();
  await chooseRadius('6 edges');
  const before = await handles();
  const { x, y } = await script.screenPosition(crown);
  await visit.page.mouse.click(x, y);
  await press('ArrowDown');
  await script.settled();
  const far = async () => (await moves(before)).filter(({ by }) => Math.hypot(...by) > 1e-6).length;
  await expect.poll(far).toBeGreaterThan(5);
  await press('Control+z');
  await expect.poll(handles).toEqual(before);

  await visit.page.mouse.move(x, y);
  await visit.page.mouse.down();
  await visit.page.mouse.move(x - 4, y + 10, { steps: 4 });
  await press('z');
  const start = before.find(({ vertex }) => vertex === crown)!.target;
  await expect.poll(async () => (await target(crown)).slice(0, 2)).toEqual(start.slice(0, 2));
  const during = await moves(before);
  for (const { by } of during) expect(by.slice(0, 2)).toEqual([0, 0]);
  expect(during.filter(({ by }) => by[2]! < -1e-6).length).toBeGreaterThan(5);
  await picture('axis');
  await press('Escape');
  await expect.poll(handles).toEqual(before);
  await visit.page.mouse.up();
});

test('side by side they bend with the net, every edge of which keeps its length', async () => {
  visit = await share();
  ({ script } = visit);
  await script.open({ recipe: SHAPE });
  const { x, y } = await script.screenPosition(crown);
  await visit.page.mouse.click(x, y);
  await press('p');
  await expect.poll(async () => (await handles()).length).toBeGreaterThan(20);
  const selected = visit.page.getByTitle(/^\d\d handles selected$/);
  await selected.waitFor();
  await press('Escape');
  await selected.waitFor({ state: 'hidden' });
  await visit.page.locator('summary', { hasText: /^Dragging/ }).click();
  await chooseRadius('4 edges');
  await script.settled();
  const before = await handles();
  const strains = async () => expect(await visit.page.locator('svg.overlay .strain').count()).toBe(0);
  await dragBy(script, crown, [0, -16], { during: strains, atEnd: () => picture('patch').then(() => {}) });
  await script.settled();
  await visit.page.getByText('the net reaches no farther').waitFor({ state: 'detached' });
  const shares = sharesAround(describeNet(net), [crown], 4);
  const all = await moves(before);
  const up = all.find(({ vertex }) => vertex === crown)!.by[2]!;
  expect(up).toBeGreaterThan(0.1);
  const rise = (which: (share: number) => boolean) => {
    const those = all.filter(({ vertex }) => vertex !== crown && which(shares[vertex]!));
    return those.reduce((sum, { by }) => sum + by[2]! / up, 0) / those.length;
  };
  expect(rise((share) => share > 0.6)).toBeGreaterThan(0.5);
  expect(rise((share) => share > 0.05 && share < 0.3)).toBeLessThan(0.5);
  expect((await visit.page.evaluate(() => window.chebnet.stats())).maxDeviation).toBeLessThan(1e-6);
});
